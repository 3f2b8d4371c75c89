//! When a body counts as at rest, and when it may sleep.

use super::{Body, RestScale, room_contact};
use crate::solver::forces::{Force, Gravity};
use crate::solver::state::ParticleState;
use glam::DVec3;

/// A body sleeps once its forces are this share of those of a body at rest, or of a particle's weight, and its
/// velocities likewise: it stays as it is then, and what is at rest but for that may still be about to give way as a
/// whole.
const ASLEEP: f64 = 1e-3;

impl Body {
    /// Whether nothing moves and nothing pushes: prescribed motions have ended, the largest net force on a free
    /// particle and the largest kinetic energy of a particle are below the body's rest scales.
    pub fn at_rest(&self, time: f64) -> bool {
        self.settled(time, self.parts.rest_scale)
    }

    /// Whether nothing of its own would change anything from `time` [s] on: nothing moves or pushes by far, and no
    /// force is yet to come, go or be evaluated.
    pub(in crate::solver) fn may_sleep(&self, time: f64) -> bool {
        if self.divergence.is_some() {
            return true;
        }
        let grabs = self.grabs.iter().map(|grab| grab as &dyn Force);
        let mut forces = self.parts.forces.iter().map(|force| &**force).chain(grabs);
        if !self.current || forces.any(|force| force.changes_until() > time) {
            return false;
        }
        let RestScale { force, energy } = self.parts.rest_scale;
        let gravity = self.parts.forces.iter().find_map(|force| force.downcast_ref::<Gravity>());
        let lightest = self.parts.state.masses.iter().copied().fold(f64::INFINITY, f64::min);
        let weight = gravity.map_or(0.0, |gravity| lightest * gravity.at(time).length());
        let weight = if weight > 0.0 { weight } else { f64::INFINITY };
        self.settled(time, RestScale { force: ASLEEP * force.min(weight), energy: ASLEEP * ASLEEP * energy })
    }

    fn settled(&self, time: f64, scale: RestScale) -> bool {
        if self.divergence.is_some() {
            return true;
        }
        let is_eased = room_contact(&self.parts.forces).is_some_and(|contact| contact.end() > time);
        let is_driven = self.parts.forces.iter().any(|force| force.driven_until() > time);
        if is_eased || is_driven || self.parts.constraints.iter().any(|constraint| constraint.motion.end() > time) {
            return false;
        }
        let mut free: Vec<DVec3> = (0..self.net.len()).map(|i| self.net_force(i)).collect();
        for constraint in &self.parts.constraints {
            constraint.mask(&mut free);
        }
        let ParticleState { velocities, masses, .. } = &self.parts.state;
        let force = free.iter().map(|f| f.length()).fold(0.0, f64::max);
        let energy = velocities.iter().zip(masses).map(|(v, m)| 0.5 * m * v.length_squared()).fold(0.0, f64::max);
        force < scale.force && energy < scale.energy
    }
}
