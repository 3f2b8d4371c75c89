//! Newmark's method with the average acceleration.

use super::integrator::Integrator;
use crate::solver::dynamics::Dynamics;
use crate::solver::implicit::{Stage, StageSolver, Stepper, Unconverged};
use crate::solver::state::ParticleState;

/// `x' = x + dt v + dt²/4 (a + a'); v' = v + dt/2 (a + a')`, beta 1/4 and gamma 1/2: order 2, no oscillation grows or
/// fades at any step; stiff ones ring on.
#[derive(Clone, Default)]
pub(crate) struct Newmark {
    stepper: Stepper,
}

fn attempt(
    stages: &mut StageSolver,
    dynamics: &mut Dynamics<'_>,
    state: &mut ParticleState,
    time: f64,
    dt: f64,
) -> Result<(), Unconverged> {
    let h = 0.5 * dt;
    let mut velocities = Vec::new();
    dynamics.start(time, state);
    dynamics.accelerations(state, &mut velocities);
    velocities.iter_mut().zip(&state.velocities).for_each(|(a, &v)| *a = v + h * *a);
    let positions: Vec<_> = state.positions.iter().zip(&state.velocities).map(|(&x, &v)| x + h * v).collect();
    let end = Stage { time: time + dt, h, positions: &positions, velocities: &velocities, is_end: true };
    stages.solve(dynamics, state, &end)
}

impl Integrator for Newmark {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        self.stepper.step(dynamics, state, time, dt, &mut attempt);
    }

    fn stable_step(&self, _omega: f64, _damping: f64) -> f64 {
        f64::INFINITY
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        Box::new(self.clone())
    }
}
