//! Weight.

use super::force::Force;
use crate::solver::energy::Energies;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// Uniform gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gravity {
    /// Acceleration [m/s²].
    pub acceleration: DVec3,
}

impl Force for Gravity {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        for (force, &mass) in forces.iter_mut().zip(&state.masses) {
            *force += mass * self.acceleration;
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        let moment: DVec3 = state.positions.iter().zip(&state.masses).map(|(&x, &m)| m * x).sum();
        energies.gravity -= moment.dot(self.acceleration);
    }

    fn changes_until(&self) -> f64 {
        0.0
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(*self)
    }
}
