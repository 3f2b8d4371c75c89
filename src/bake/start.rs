//! Where the particles of a body start, and how fast.

use crate::scene::{Initial, Placement};
use crate::solver::state::ParticleState;
use glam::DVec3;

/// A point of the model frame in the world [m].
pub(super) fn to_world(placement: &Placement, x: DVec3) -> DVec3 {
    placement.rotation.quaternion() * x + DVec3::from_array(placement.translation)
}

/// The points under the deformation of the start, about their centre.
pub(super) fn deformed(initial: &Initial, points: &[DVec3]) -> impl Iterator<Item = DVec3> {
    let center = points.iter().sum::<DVec3>() / points.len() as f64;
    let [row0, row1, row2] = initial.deformation.map(DVec3::from_array);
    let undeformed = initial.deformation == Initial::default().deformation;
    points.iter().map(move |&x| {
        let y = x - center;
        if undeformed { x } else { center + DVec3::new(row0.dot(y), row1.dot(y), row2.dot(y)) }
    })
}

/// Adds the angular velocity of the start about the centre of mass.
pub(super) fn spin(state: &mut ParticleState, initial: &Initial) {
    let spin = DVec3::from_array(initial.angular_velocity.map(f64::to_radians));
    if spin != DVec3::ZERO {
        let center = state.center();
        for (v, &x) in state.velocities.iter_mut().zip(&state.positions) {
            *v += spin.cross(x - center);
        }
    }
}

/// Gives a group an impulse [N s], shared by mass.
pub(super) fn give_impulse(state: &mut ParticleState, group: &[u32], impulse: DVec3) {
    let mass: f64 = group.iter().map(|&i| state.masses[i as usize]).sum();
    for &i in group {
        state.velocities[i as usize] += impulse / mass;
    }
}
