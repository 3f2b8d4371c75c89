//! Contact of particles with planes: penalty that only pushes, with Coulomb friction.

use super::force::{Force, StepLimit};
use crate::solver::energy::Energies;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// How a particle, a ball of the law's radius, is pushed out of what it touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactLaw {
    /// Radius of a particle [m]; half the spacing, so that the skin rests on the surface.
    pub radius: f64,
    /// Stiffness kc [N/m].
    pub stiffness: f64,
    /// Normal damping cc [N s/m].
    pub damping: f64,
    /// Coulomb friction coefficient.
    pub friction: f64,
    /// Slope of the friction force below its Coulomb limit [N s/m].
    pub sticking: f64,
}

impl ContactLaw {
    /// Force [N] on a particle at signed distance `gap` [m] from a surface with outward `normal`, moving at `velocity`
    /// [m/s] relative to it: `N = max(0, kc d - cc vn)` and `|Ft| = min(friction N, ct |vt|)`.
    pub(crate) fn force(&self, gap: f64, normal: DVec3, velocity: DVec3) -> DVec3 {
        let depth = self.radius - gap;
        if depth <= 0.0 {
            return DVec3::ZERO;
        }
        let normal_speed = velocity.dot(normal);
        let push = (self.stiffness * depth - self.damping * normal_speed).max(0.0);
        let slip = velocity - normal_speed * normal;
        let speed = slip.length();
        let drag = (self.friction * push).min(self.sticking * speed);
        let tangential = if speed > 0.0 { slip * (-drag / speed) } else { DVec3::ZERO };
        push * normal + tangential
    }

    /// Elastic energy [J] at signed distance `gap` [m].
    pub(crate) fn energy(&self, gap: f64) -> f64 {
        let depth = (self.radius - gap).max(0.0);
        0.5 * self.stiffness * depth * depth
    }
}

/// A plane; bodies stay on the side its normal points to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point on it [m].
    pub point: DVec3,
    /// Unit normal into the free side.
    pub normal: DVec3,
}

/// Contact with fixed planes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Contact {
    /// The planes.
    pub planes: Vec<Plane>,
    /// How they push.
    pub law: ContactLaw,
}

impl Force for Contact {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        for plane in &self.planes {
            for (i, force) in forces.iter_mut().enumerate() {
                let gap = (state.positions[i] - plane.point).dot(plane.normal);
                *force += self.law.force(gap, plane.normal, state.velocities[i]);
            }
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        for plane in &self.planes {
            for x in &state.positions {
                energies.contact += self.law.energy((*x - plane.point).dot(plane.normal));
            }
        }
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        let lightest = state.masses.iter().copied().fold(f64::INFINITY, f64::min);
        StepLimit {
            frequency_squared: self.law.stiffness / lightest,
            damping_rate: self.law.damping.max(self.law.sticking) / lightest,
        }
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
