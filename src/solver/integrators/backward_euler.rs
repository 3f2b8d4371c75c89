//! Backward Euler.

use super::integrator::Integrator;
use crate::solver::dynamics::Dynamics;
use crate::solver::implicit::{Stage, StageSolver, Stepper, Unconverged};
use crate::solver::state::ParticleState;

/// `v' = v + dt a(x', v'); x' = x + dt v'`: order 1, stable at any step, takes energy.
#[derive(Clone, Default)]
pub(crate) struct BackwardEuler {
    stepper: Stepper,
}

fn attempt(
    stages: &mut StageSolver,
    dynamics: &mut Dynamics<'_>,
    state: &mut ParticleState,
    time: f64,
    dt: f64,
) -> Result<(), Unconverged> {
    let (x, v) = (state.positions.clone(), state.velocities.clone());
    stages.solve(dynamics, state, &Stage { time: time + dt, h: dt, positions: &x, velocities: &v, is_end: true })
}

impl Integrator for BackwardEuler {
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
