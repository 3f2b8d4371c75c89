//! SDIRK2: two backward Euler stages of the same step.

use super::integrator::Integrator;
use crate::solver::dynamics::Dynamics;
use crate::solver::implicit::{Stage, StageSolver, Stepper, Unconverged};
use crate::solver::state::ParticleState;
use glam::DVec3;

/// Two stages of `h = (1 - 1/sqrt 2) dt`: order 2, stable at any step, and stiff oscillations end within a step. It
/// needs no force at the start. Angular momentum falls where stiff bodies turn.
#[derive(Clone, Default)]
pub(crate) struct Sdirk2 {
    stepper: Stepper,
}

fn attempt(
    stages: &mut StageSolver,
    dynamics: &mut Dynamics<'_>,
    state: &mut ParticleState,
    time: f64,
    dt: f64,
) -> Result<(), Unconverged> {
    let h = (1.0 - std::f64::consts::FRAC_1_SQRT_2) * dt;
    let (x, v) = (state.positions.clone(), state.velocities.clone());
    let first = Stage { time: time + h, h, positions: &x, velocities: &v, is_end: false };
    stages.solve(dynamics, state, &first)?;
    let rest = dt - h;
    let rates = state.velocities.iter().zip(&v);
    let (positions, velocities): (Vec<DVec3>, Vec<DVec3>) =
        rates.zip(&x).map(|((&stage, &v), &x)| (x + rest * stage, v + (rest / h) * (stage - v))).unzip();
    let second = Stage { time: time + dt, h, positions: &positions, velocities: &velocities, is_end: true };
    stages.solve(dynamics, state, &second)
}

impl Integrator for Sdirk2 {
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
