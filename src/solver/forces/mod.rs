//! Forces: one file a force. A body is a [`ParticleState`] with a list of these.

mod air_drag;
mod bricks;
mod contact;
pub mod fibre;
mod grab;
mod gravity;
pub mod matrix;
mod pair_damping;
pub mod pressure;
pub mod springs;

pub use air_drag::AirDrag;
pub use contact::{Contact, ContactLaw, Plane};
pub use fibre::FibreForce;
pub use grab::Grab;
pub use gravity::Gravity;
pub use matrix::{Elasticity, MatrixForce};
pub use pair_damping::PairDamping;
pub use pressure::Pressure;
pub use springs::Springs;

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

    /// Adds how the force [N] changes, to first order, when positions change by the first and velocities by the second
    /// field: the Hessian-vector product of implicit integrators. By central differences unless a force knows better.
    fn add_derivative(&mut self, time: f64, state: &ParticleState, change: [&[DVec3]; 2], out: &mut [DVec3]) {
        derivative_by_differences(self, time, state, change, out);
    }

    /// What is wrong with a state, where the force has no meaning in it; the body is stopped then.
    fn fault(&self, _state: &ParticleState) -> Option<&'static str> {
        None
    }

    /// Told of the state at the end of every step, `time` [s], so that a force that breaks can do so; true if it is
    /// another force from now on.
    fn end_step(&mut self, _time: f64, _state: &ParticleState) -> bool {
        false
    }

    /// Goes on from where the forces of the same body stood before an edit: what has broken stays broken.
    fn adopt(&mut self, _before: &[Box<dyn Force>]) {}

    /// What the force is called where forces are timed one by one.
    fn name(&self) -> &'static str {
        "other"
    }

    /// What has broken so far, in the order of time.
    fn breaks(&self) -> &[fibre::breaking::FibreBreak] {
        &[]
    }

    /// The elasticity of the matrix, where it is that: its strains and stresses can be looked at.
    fn matrix(&self) -> Option<&MatrixForce> {
        None
    }

    /// The fibres, where it is those: their tensions can be looked at.
    fn fibres(&self) -> Option<&FibreForce> {
        None
    }

    /// Memory that a copy takes beside what copies share [bytes], so that a recording of many can be bounded. By default
    /// that of the value itself; one with lists of its own adds them.
    fn bytes(&self) -> usize {
        size_of_val(self)
    }

    /// A copy in a box; bodies are cloned to be replayed or probed. It gives the same forces from here on, bit for bit:
    /// warm starts go along, buffers need not (see [`super::scratch::Scratch`]).
    fn clone_box(&self) -> Box<dyn Force>;
}

impl Clone for Box<dyn Force> {
    fn clone(&self) -> Self {
        self.clone_box()
    }
}

/// [`Force::add_derivative`] by central differences.
fn derivative_by_differences<F: Force + ?Sized>(
    force: &mut F,
    time: f64,
    state: &ParticleState,
    [dx, dv]: [&[DVec3]; 2],
    out: &mut [DVec3],
) {
    /// A change of this size in the largest component [m or m/s] is small against any body.
    const STEP: f64 = 1e-6;
    let largest = dx.iter().chain(dv).map(|v| v.abs().max_element()).fold(0.0, f64::max);
    if largest == 0.0 {
        return;
    }
    let step = STEP / largest;
    let mut moved = state.clone();
    let mut at = |sign: f64| {
        for i in 0..state.len() {
            moved.positions[i] = state.positions[i] + sign * step * dx[i];
            moved.velocities[i] = state.velocities[i] + sign * step * dv[i];
        }
        let mut forces = vec![DVec3::ZERO; state.len()];
        force.add_forces(time, &moved, &mut forces);
        forces
    };
    let (ahead, behind) = (at(1.0), at(-1.0));
    for ((out, ahead), behind) in out.iter_mut().zip(ahead).zip(behind) {
        *out += (ahead - behind) / (2.0 * step);
    }
}
