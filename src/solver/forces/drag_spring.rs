//! The spring by which a body is dragged.

use super::{Force, StepLimit};
use crate::solver::energy::Energies;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// A spring without length from one particle to a point, damped in every direction: `f = MKS (target - x) - MKD v`.
#[derive(Clone, Debug, PartialEq)]
pub struct DragSpring {
    /// The particle that is held.
    pub particle: usize,
    /// Where it is pulled to [m].
    pub target: DVec3,
    /// Stiffness MKS [N/m].
    pub stiffness: f64,
    /// Damping MKD [N s/m].
    pub damping: f64,
    /// When it lets go [s].
    pub until: f64,
}

impl DragSpring {
    /// Of the particles, the one nearest to a point.
    pub fn nearest(positions: &[DVec3], target: DVec3) -> usize {
        let distance = |i: &usize| positions[*i].distance_squared(target);
        (0..positions.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    }
}

impl Force for DragSpring {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        if time < self.until {
            let i = self.particle;
            forces[i] += self.stiffness * (self.target - state.positions[i]) - self.damping * state.velocities[i];
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        if time < self.until {
            energies.springs += 0.5 * self.stiffness * state.positions[self.particle].distance_squared(self.target);
        }
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        let mass = state.masses[self.particle];
        StepLimit { frequency_squared: self.stiffness / mass, damping_rate: self.damping / mass }
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
