//! What the matrix is like in a part of a body, for measures.

use super::elasticity::corotated_strain;
use super::force::MatrixForce;
use super::inelastic::Inelastic;
use super::von_mises::von_mises_strain;
use crate::solver::rotation::nearest_rotation;
use glam::{DMat3, DVec3};

impl MatrixForce {
    /// Mean over some particles of the strain along a unit direction of the world, or of the equivalent strain.
    pub(in crate::solver) fn mean_strain(&self, group: &[u32], along: Option<DVec3>, positions: &[DVec3]) -> f64 {
        self.mean(group, positions, |_, strain, rotation| match along {
            Some(along) => normal(strain, rotation, along),
            None => von_mises_strain(strain),
        })
    }

    /// Mean over some particles of the stress [Pa] along a unit direction of the world, or of the equivalent stress:
    /// that of the matrix itself, not thinned by its share, and of what of its strain has not yielded.
    pub(in crate::solver) fn mean_stress(
        &self,
        group: &[u32],
        along: Option<DVec3>,
        positions: &[DVec3],
        yielded: Option<&Inelastic>,
    ) -> f64 {
        let elasticity = self.reference.elasticity;
        self.mean(group, positions, |i, strain, rotation| {
            let elastic = strain - yielded.map_or(DMat3::ZERO, |inelastic| inelastic.plastic_strain(i));
            let stress = match along {
                Some(along) => {
                    let trace = elastic.x_axis.x + elastic.y_axis.y + elastic.z_axis.z;
                    2.0 * elasticity.mu * normal(elastic, rotation, along) + elasticity.lambda * trace
                }
                None => 3.0 * elasticity.mu * von_mises_strain(elastic),
            };
            self.reference.stiffening(i) * stress
        })
    }

    /// Volume of the body as it is now [m³]: of each particle its share of V times det F.
    pub(in crate::solver) fn present_volume(&self, positions: &[DVec3]) -> f64 {
        let grown = (0..positions.len())
            .map(|i| self.reference.volume_share(i) * self.deformation_gradient(i, positions).determinant());
        self.reference.volume * grown.sum::<f64>()
    }

    /// Mean of a number of the particle, its corotated strain and its rotation.
    fn mean(&self, group: &[u32], positions: &[DVec3], read: impl Fn(usize, DMat3, DMat3) -> f64) -> f64 {
        let each = group.iter().map(|&i| {
            let f = self.deformation_gradient(i as usize, positions);
            let rotation = DMat3::from_quat(nearest_rotation(f, self.rotation(i as usize)));
            read(i as usize, corotated_strain(f, rotation), rotation)
        });
        each.sum::<f64>() / group.len().max(1) as f64
    }
}

/// `n . R e R^T n` of a strain in the material's own frame.
fn normal(strain: DMat3, rotation: DMat3, along: DVec3) -> f64 {
    let own = rotation.transpose() * along;
    own.dot(strain * own)
}
