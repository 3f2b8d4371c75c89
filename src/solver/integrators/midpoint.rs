//! Explicit midpoint.

use super::integrator::Integrator;
use super::stability::greatest_step_of;
use crate::solver::dynamics::Dynamics;
use crate::solver::linear_algebra::vectors::axpy;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// Half an Euler step, then a whole step with the rates found there: order 2. Undamped oscillations grow slowly.
#[derive(Clone, Debug, Default)]
pub(crate) struct Midpoint {
    accelerations: Vec<DVec3>,
    middle: ParticleState,
}

impl Integrator for Midpoint {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        dynamics.start(time, state);
        dynamics.accelerations(state, &mut self.accelerations);
        self.middle.clone_from(state);
        axpy(0.5 * dt, &state.velocities, &mut self.middle.positions);
        axpy(0.5 * dt, &self.accelerations, &mut self.middle.velocities);
        dynamics.evaluate(time + 0.5 * dt, &mut self.middle);
        dynamics.accelerations(state, &mut self.accelerations);
        axpy(dt, &self.middle.velocities, &mut state.positions);
        axpy(dt, &self.accelerations, &mut state.velocities);
        dynamics.constrain(time + dt, state);
    }

    fn stable_step(&self, omega: f64, damping: f64) -> f64 {
        greatest_step_of(&[1.0, 0.5], omega, damping)
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        // Its buffers carry nothing from step to step.
        Box::new(Self::default())
    }
}
