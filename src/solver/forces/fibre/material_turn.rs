//! How the material turns around a vertex.

use crate::solver::embedding::TurnWeights;
use crate::solver::neighbourhood::outer;
use crate::solver::rotation::nearest_rotation;
use glam::{DMat3, DQuat, DVec3};

/// Turn of the material around a vertex and its stretch `R^T A`.
pub(super) fn turn_of_material(weights: &TurnWeights, positions: &[DVec3], turn: &mut DQuat) -> (DMat3, DMat3) {
    // The weights sum to zero: taken against one particle, the sum stays exact far from the origin.
    let origin = weights.weights.first().map_or(DVec3::ZERO, |&(k, _)| positions[k as usize]);
    let mut gradient = DMat3::ZERO;
    for &(k, z) in &weights.weights {
        gradient += outer(positions[k as usize] - origin, z);
    }
    polar(gradient, turn)
}

/// Rotation of a deformation gradient A, near the last one, and its stretch `R^T A`.
pub(super) fn polar(gradient: DMat3, turn: &mut DQuat) -> (DMat3, DMat3) {
    *turn = nearest_rotation(gradient, *turn);
    let r = DMat3::from_quat(*turn);
    (r, r.transpose() * gradient)
}
