//! Forces: one file a force. A body is a [`ParticleState`] with a list of these.

mod air_drag;
mod contact;
pub mod fibre;
mod gravity;
pub mod matrix;
mod pair_damping;

pub use air_drag::AirDrag;
pub use contact::{Contact, ContactLaw, Plane};
pub use fibre::FibreForce;
pub use gravity::Gravity;
pub use matrix::{Elasticity, MatrixForce};
pub use pair_damping::PairDamping;

use super::energy::Energies;
use super::state::ParticleState;
use glam::DVec3;

/// What a force asks of the time step beyond what its linearisation at the start shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepLimit {
    /// Square of an angular frequency that may come into play later, such as a contact's [1/s²].
    pub frequency_squared: f64,
    /// Greatest rate of damping [1/s].
    pub damping_rate: f64,
}

/// A force on the particles of one body.
///
/// An implementor may keep scratch data between calls (warm starts), but the force must depend on time and state
/// alone, up to round-off, and must not depend on the number of threads.
pub trait Force: Send + Sync {
    /// Adds the forces [N] at `time` [s] to `forces`, one for each particle.
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]);

    /// Adds the energy [J] that the force stores; its negative gradient is the conservative part of the force.
    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies);

    /// What the force asks of the time step beyond its linearisation at the start.
    fn step_limit(&self, _state: &ParticleState) -> StepLimit {
        StepLimit::default()
    }

    /// A copy in a box; bodies are cloned to be replayed or probed.
    fn clone_box(&self) -> Box<dyn Force>;
}

impl Clone for Box<dyn Force> {
    fn clone(&self) -> Self {
        self.clone_box()
    }
}
