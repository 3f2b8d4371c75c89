//! Explicit Euler.

use super::integrator::Integrator;
use super::stability::greatest_step_of;
use crate::solver::dynamics::Dynamics;
use crate::solver::linear_algebra::vectors::axpy;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// `x += dt v; v += dt a(x, v)`, both from the start of the step: order 1. Undamped oscillations always grow.
#[derive(Clone, Debug, Default)]
pub(crate) struct ExplicitEuler {
    accelerations: Vec<DVec3>,
}

impl Integrator for ExplicitEuler {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        dynamics.start(time, state);
        dynamics.accelerations(state, &mut self.accelerations);
        axpy(dt, &state.velocities, &mut state.positions);
        axpy(dt, &self.accelerations, &mut state.velocities);
        dynamics.constrain(time + dt, state);
    }

    fn stable_step(&self, omega: f64, damping: f64) -> f64 {
        greatest_step_of(&[1.0], omega, damping)
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        // Its buffers carry nothing from step to step.
        Box::new(Self::default())
    }
}
