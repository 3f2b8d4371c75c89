//! The body at rest, which strains are measured against, and the sums of the module's head as they are written there.

use super::elasticity::Elasticity;
use crate::solver::neighbourhood::{Neighbourhood, outer};
use crate::solver::rotation::nearest_rotation;
use glam::{DMat3, DQuat, DVec3};
use std::sync::Arc;

/// The reference configuration of a body and its material: all that the force depends on beside the positions,
/// whichever way it is evaluated.
#[derive(Clone)]
pub(super) struct ReferenceConfiguration {
    pub(super) neighbourhood: Arc<Neighbourhood>,
    /// Rest positions X [m], model frame.
    pub(super) positions: Arc<[DVec3]>,
    pub(super) elasticity: Elasticity,
    /// Volume V of a particle [m³].
    pub(super) volume: f64,
    /// Matrix fraction of every particle, `s_i = 1 - l_i`, times the stiffening there and the share of V that it counts
    /// as.
    pub(super) matrix_weight: Arc<[f64]>,
    /// By how much the matrix is stiffer at every particle than `elasticity`; nowhere unless given.
    pub(super) stiffening: Option<Arc<[f64]>>,
    /// Share of V that every particle counts as; all of it unless given.
    pub(super) volume_shares: Option<Arc<[f64]>>,
}

impl ReferenceConfiguration {
    /// Deformation gradient F of particle i and the sum L of its residuals, by the plain sums.
    pub(super) fn deformation_gradient(&self, i: usize, positions: &[DVec3]) -> (DMat3, DVec3) {
        let (mut moment, mut sum) = (DMat3::ZERO, DVec3::ZERO);
        for (j, bond) in self.neighbourhood.bonds(i) {
            let x = positions[j] - positions[i];
            moment += outer(x, bond.weighted_offset);
            sum += bond.weight * x;
        }
        let f = moment * self.neighbourhood.inverse_moment[i];
        (f, sum - f * self.neighbourhood.weighted_sum[i])
    }

    /// By how much the matrix is stiffer at particle i than [`Self::elasticity`].
    pub(super) fn stiffening(&self, i: usize) -> f64 {
        self.stiffening.as_ref().map_or(1.0, |stiffening| stiffening[i])
    }

    /// Share of V that particle i counts as.
    pub(super) fn volume_share(&self, i: usize) -> f64 {
        self.volume_shares.as_ref().map_or(1.0, |shares| shares[i])
    }

    /// What the matrix fraction at particle i is multiplied by.
    pub(super) fn weight(&self, i: usize) -> f64 {
        self.stiffening(i) * self.volume_share(i)
    }

    /// Matrix fraction at particle i times the share of V that it counts as.
    pub(super) fn matrix_share(&self, i: usize) -> f64 {
        match &self.stiffening {
            None => self.matrix_weight[i],
            Some(stiffening) => self.matrix_weight[i] / stiffening[i],
        }
    }

    /// Elastic and zero-energy energy of particle i [J], whose rotation is near `start`.
    pub(super) fn energy(&self, i: usize, positions: &[DVec3], start: DQuat) -> (f64, f64) {
        let scale = self.matrix_weight[i] * self.volume;
        let (elastic, zero_energy) = self.densities(i, positions, start);
        (scale * elastic, scale * zero_energy)
    }

    /// The same for each volume of matrix [J/m³].
    pub(super) fn densities(&self, i: usize, positions: &[DVec3], start: DQuat) -> (f64, f64) {
        let Elasticity { residual_penalty: a, sum_penalty: beta, .. } = self.elasticity;
        let (f, residual_sum) = self.deformation_gradient(i, positions);
        let rotation = nearest_rotation(f, start);
        let (_, density) = self.elasticity.stress(f, DMat3::from_quat(rotation));
        let offsets = self.neighbourhood.offsets(i);
        let residuals: f64 = self
            .neighbourhood
            .bonds(i)
            .zip(offsets)
            .map(|((j, bond), (_, offset))| bond.weight * (positions[j] - positions[i] - f * offset).length_squared())
            .sum();
        (density, 0.5 * (a * residuals + beta * residual_sum.length_squared()))
    }
}
