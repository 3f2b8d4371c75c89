//! Von Mises' equivalent strain and stress of the matrix at its particles, for whoever looks at it.

use super::elasticity::corotated_strain;
use super::force::{CHUNK, MatrixForce};
use crate::solver::rotation::nearest_rotation;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

impl MatrixForce {
    /// Equivalent strain [1] at every particle of a body at `positions` [m].
    pub fn von_mises_strains(&self, positions: &[DVec3]) -> Vec<f64> {
        (0..positions.len())
            .into_par_iter()
            .with_min_len(CHUNK)
            .map(|i| {
                let f = self.deformation_gradient(i, positions);
                let rotation = DMat3::from_quat(nearest_rotation(f, self.rotation(i)));
                von_mises_strain(corotated_strain(f, rotation))
            })
            .collect()
    }

    /// Equivalent stress [Pa] at every particle of a body at `positions` [m].
    pub fn von_mises_stresses(&self, positions: &[DVec3]) -> Vec<f64> {
        // The deviator of the stress is 2 mu times that of the strain, whatever lambda is.
        let stiffness = 3.0 * self.reference.elasticity.mu;
        let strains = self.von_mises_strains(positions).into_iter().enumerate();
        strains.map(|(i, strain)| stiffness * self.reference.stiffening(i) * strain).collect()
    }
}

/// `sqrt(2/3 e' : e')` of a symmetric strain, e' its deviator.
pub(super) fn von_mises_strain(strain: DMat3) -> f64 {
    let third = (strain.x_axis.x + strain.y_axis.y + strain.z_axis.z) / 3.0;
    let deviator = strain - DMat3::from_diagonal(DVec3::splat(third));
    let square = deviator.x_axis.length_squared() + deviator.y_axis.length_squared() + deviator.z_axis.length_squared();
    (square / 1.5).sqrt()
}
