//! Grabbing a body by a point: a damped spring of no rest length from the point to where it is wanted.

use super::force::{Force, StepLimit};
use crate::solver::embedding::EmbeddingWeights;
use crate::solver::energy::Energies;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// A grab of one embedded point x: `f = k (target - x) - d v`, shared by the particles that carry the point.
#[derive(Clone, Debug, PartialEq)]
pub struct Grab {
    /// The point that is grabbed.
    pub point: EmbeddingWeights,
    /// Where it is pulled to [m], world.
    pub target: DVec3,
    /// Spring stiffness k [N/m].
    pub stiffness: f64,
    /// Damping d of the point's velocity [N s/m].
    pub damping: f64,
    /// When it lets go [s]; infinite for one that holds until it is taken away.
    pub until: f64,
}

/// Angular frequency [rad/s] with which a freely floating body follows the target, whatever its mass.
const FOLLOW: f64 = 25.0;

impl Grab {
    /// A grab that moves every body alike: stiffness and damping scale with its mass, and stay below what a step of
    /// `dt` [s] can take at the point.
    pub(crate) fn scaled(point: EmbeddingWeights, target: DVec3, state: &ParticleState, dt: f64) -> Self {
        let mass = state.mass();
        // Mass that a force on the point has to move at first: 1 / sum phi² / m.
        let yielding: f64 = point.weights.iter().map(|&(k, phi)| phi * phi / state.masses[k as usize]).sum();
        let at_point = 1.0 / yielding;
        Self {
            point,
            target,
            stiffness: (mass * FOLLOW * FOLLOW).min(0.2 * at_point / (dt * dt)),
            damping: (mass * FOLLOW).min(0.2 * at_point / dt),
            until: f64::INFINITY,
        }
    }

    /// What a constant of the point [N/m or N s/m] comes to over the mass that a force on it has to move at first.
    fn per_mass(&self, constant: f64, state: &ParticleState) -> f64 {
        self.point.weights.iter().map(|&(k, phi)| phi * phi * constant / state.masses[k as usize]).sum()
    }
}

impl Force for Grab {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        if time < self.until {
            let (x, v) = (self.point.gather(&state.positions), self.point.gather(&state.velocities));
            self.point.scatter(self.stiffness * (self.target - x) - self.damping * v, forces);
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        if time < self.until {
            let x = self.point.gather(&state.positions);
            energies.grab += 0.5 * self.stiffness * x.distance_squared(self.target);
        }
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        StepLimit {
            frequency_squared: self.per_mass(self.stiffness, state),
            damping_rate: self.per_mass(self.damping, state),
        }
    }

    fn changes_until(&self) -> f64 {
        if self.until.is_finite() { self.until } else { 0.0 }
    }

    fn bytes(&self) -> usize {
        size_of_val(self) + size_of_val(&*self.point.weights)
    }

    fn name(&self) -> &'static str {
        "grabs"
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
