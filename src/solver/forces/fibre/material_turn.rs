//! How the material turns around a vertex.

use crate::solver::embedding::TurnWeights;
use crate::solver::neighbourhood::outer;
use crate::solver::rotation::{nearest_rotation, turn_stiffness};
use glam::{DMat3, DQuat, DVec3};

/// Turn of the material around a vertex and its stretch `R^T A`.
pub(in crate::solver::forces) fn turn_of_material(
    weights: &TurnWeights,
    positions: &[DVec3],
    turn: &mut DQuat,
) -> (DMat3, DMat3) {
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

/// What turns the particles around a curved bend, by the components of their `om_k Z_k` [N m]: `-R (p x Z)`, where
/// `gradient` is that of the energy by the difference of the binormal from the rest shape's turned one, `R kb0`.
pub(super) fn material_spin(r: DMat3, stretch: DMat3, rest: DVec3, gradient: DVec3) -> [DVec3; 3] {
    let moment = -rest.cross(r.transpose() * gradient);
    let p = turn_stiffness(stretch).inverse() * moment;
    [r * DVec3::X.cross(p), r * DVec3::Y.cross(p), r * DVec3::Z.cross(p)]
}
