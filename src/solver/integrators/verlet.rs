//! Velocity Verlet with a predicted velocity.

use super::integrator::Integrator;
use super::stability::{greatest_step, spectral_radius};
use crate::solver::dynamics::Dynamics;
use crate::solver::linear_algebra::vectors::axpy;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// `x += dt v + dt²/2 a; v += dt/2 (a + a')` with a' at the new position and the velocity `v + dt a`: order 2, with
/// damping too, where leap-frog falls to order 1. Two evaluations a step; without damping it moves as leap-frog.
#[derive(Clone, Debug, Default)]
pub(crate) struct Verlet {
    accelerations: Vec<DVec3>,
    at_end: Vec<DVec3>,
    predicted: ParticleState,
}

impl Integrator for Verlet {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        dynamics.start(time, state);
        dynamics.accelerations(state, &mut self.accelerations);
        self.predicted.clone_from(state);
        for (i, &a) in self.accelerations.iter().enumerate() {
            self.predicted.positions[i] += dt * (state.velocities[i] + 0.5 * dt * a);
            self.predicted.velocities[i] += dt * a;
        }
        dynamics.evaluate(time + dt, &mut self.predicted);
        dynamics.accelerations(state, &mut self.at_end);
        state.positions.clone_from(&self.predicted.positions);
        axpy(0.5 * dt, &self.accelerations, &mut state.velocities);
        axpy(0.5 * dt, &self.at_end, &mut state.velocities);
        dynamics.constrain(time + dt, state);
    }

    fn stable_step(&self, omega: f64, damping: f64) -> f64 {
        let w = omega * omega;
        greatest_step(omega, damping, |h| {
            // Columns: what becomes of a unit position and of a unit velocity.
            let column = |x: f64, v: f64| {
                let a = -w * x - damping * v;
                let moved = x + h * v + 0.5 * h * h * a;
                let end = -w * moved - damping * (v + h * a);
                (moved, v + 0.5 * h * (a + end))
            };
            let ((a, c), (b, d)) = (column(1.0, 0.0), column(0.0, 1.0));
            spectral_radius([[a, b], [c, d]])
        })
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        // Its buffers carry nothing from step to step.
        Box::new(Self::default())
    }
}
