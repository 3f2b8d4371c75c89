//! Classical Runge-Kutta.

use super::integrator::Integrator;
use super::stability::greatest_step_of;
use crate::solver::dynamics::Dynamics;
use crate::solver::linear_algebra::vectors::axpy;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// The classical Runge-Kutta method: order 4, four force evaluations a step.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rk4 {
    accelerations: Vec<DVec3>,
    stage: ParticleState,
    velocity_sum: Vec<DVec3>,
    acceleration_sum: Vec<DVec3>,
}

impl Integrator for Rk4 {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        dynamics.start(time, state);
        dynamics.accelerations(state, &mut self.accelerations);
        self.velocity_sum.clone_from(&state.velocities);
        self.acceleration_sum.clone_from(&self.accelerations);
        self.stage.clone_from(state);
        for (share, weight) in [(0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
            let h = share * dt;
            // The stage's rates are those of the stage before; its state starts from that of the step.
            for i in 0..state.len() {
                self.stage.positions[i] = state.positions[i] + h * self.stage.velocities[i];
                self.stage.velocities[i] = state.velocities[i] + h * self.accelerations[i];
            }
            dynamics.evaluate(time + h, &mut self.stage);
            dynamics.accelerations(state, &mut self.accelerations);
            axpy(weight, &self.stage.velocities, &mut self.velocity_sum);
            axpy(weight, &self.accelerations, &mut self.acceleration_sum);
        }
        axpy(dt / 6.0, &self.velocity_sum, &mut state.positions);
        axpy(dt / 6.0, &self.acceleration_sum, &mut state.velocities);
        dynamics.constrain(time + dt, state);
    }

    fn stable_step(&self, omega: f64, damping: f64) -> f64 {
        greatest_step_of(&[1.0, 0.5, 1.0 / 6.0, 1.0 / 24.0], omega, damping)
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        // Its buffers carry nothing from step to step.
        Box::new(Self::default())
    }
}
