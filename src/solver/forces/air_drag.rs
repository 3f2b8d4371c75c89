//! Drag of the surrounding air.

use super::force::{Force, StepLimit};
use crate::solver::energy::Energies;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// Linear drag `-c m v`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AirDrag {
    /// Rate c [1/s].
    pub rate: f64,
}

impl Force for AirDrag {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        for ((force, &velocity), &mass) in forces.iter_mut().zip(&state.velocities).zip(&state.masses) {
            *force -= self.rate * mass * velocity;
        }
    }

    fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}

    fn step_limit(&self, _state: &ParticleState) -> StepLimit {
        StepLimit { damping_rate: self.rate, ..StepLimit::default() }
    }

    fn changes_until(&self) -> f64 {
        0.0
    }

    fn name(&self) -> &'static str {
        "air drag"
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(*self)
    }
}
