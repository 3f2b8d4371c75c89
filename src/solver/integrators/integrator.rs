//! What an integrator is.

use crate::solver::dynamics::Dynamics;
use crate::solver::state::ParticleState;

/// A way to step a body through time.
pub trait Integrator: Send + Sync {
    /// Advances `state` from `time` to `time + dt` [s].
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64);

    /// Greatest step [s] at which an oscillation of angular frequency `omega` [rad/s] with damping rate `damping`
    /// [1/s] does not grow; for those that let every undamped oscillation grow, a step at which it grows slowly.
    fn stable_step(&self, omega: f64, damping: f64) -> f64;

    /// Whether it takes fibres implicitly, so that how stiff they are has no part in `omega`.
    fn takes_fibres(&self) -> bool {
        false
    }

    /// Memory that a copy takes beside what copies share [bytes]; by default that of the value itself, one with lists
    /// of its own adds them.
    fn bytes(&self) -> usize {
        size_of_val(self)
    }

    /// A copy in a box, which steps on as this one would, bit for bit.
    fn clone_box(&self) -> Box<dyn Integrator>;
}

impl Clone for Box<dyn Integrator> {
    fn clone(&self) -> Self {
        self.clone_box()
    }
}
