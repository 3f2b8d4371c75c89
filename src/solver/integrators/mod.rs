//! Integrators: one file an integrator. Any of them steps any body.

mod backward_euler;
mod explicit_euler;
mod leap_frog;
mod midpoint;
mod rk4;
mod stability;
mod symplectic_euler;
mod verlet;

pub use backward_euler::BackwardEuler;
pub use explicit_euler::ExplicitEuler;
pub use leap_frog::LeapFrog;
pub use midpoint::Midpoint;
pub use rk4::Rk4;
pub use symplectic_euler::SymplecticEuler;
pub use verlet::Verlet;

use stability::{greatest_step, greatest_step_of, spectral_radius};

use super::dynamics::Dynamics;
use super::state::ParticleState;
use glam::DVec3;

/// A way to step a body through time.
pub trait Integrator: Send + Sync {
    /// Advances `state` from `time` to `time + dt` [s].
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64);

    /// Greatest step [s] at which an oscillation of angular frequency `omega` [rad/s] with damping rate `damping`
    /// [1/s] does not grow; for those that let every undamped oscillation grow, a step at which it grows slowly.
    fn stable_step(&self, omega: f64, damping: f64) -> f64;

    /// A copy in a box, which steps on as this one would, bit for bit.
    fn clone_box(&self) -> Box<dyn Integrator>;
}

impl Clone for Box<dyn Integrator> {
    fn clone(&self) -> Self {
        self.clone_box()
    }
}

/// `field += scale * rate`.
fn advance(field: &mut [DVec3], rate: &[DVec3], scale: f64) {
    for (value, &rate) in field.iter_mut().zip(rate) {
        *value += scale * rate;
    }
}
