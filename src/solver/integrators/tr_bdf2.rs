//! TR-BDF2: trapezoidal rule, then the second backward difference formula.

use super::integrator::Integrator;
use crate::solver::dynamics::Dynamics;
use crate::solver::implicit::{Stage, StageSolver, Stepper, Unconverged};
use crate::solver::state::ParticleState;
use glam::DVec3;

/// Trapezoidal rule to `c dt`, `c = 2 - sqrt 2`, then a backward difference over both parts: order 2, stable at any
/// step. Both stages have the same step, and so the same matrix. Stiff oscillations end within a step, slow ones hardly
/// fade; where bodies turn it keeps angular momentum best of those that do so.
#[derive(Clone, Default)]
pub(crate) struct TrBdf2 {
    stepper: Stepper,
}

/// One step; BDF2 begins with it.
pub(super) fn attempt(
    stages: &mut StageSolver,
    dynamics: &mut Dynamics<'_>,
    state: &mut ParticleState,
    time: f64,
    dt: f64,
) -> Result<(), Unconverged> {
    let c = 2.0 - std::f64::consts::SQRT_2;
    let h = 0.5 * c * dt;
    let mut accelerations = Vec::new();
    dynamics.start(time, state);
    dynamics.accelerations(state, &mut accelerations);
    let (x, v) = (state.positions.clone(), state.velocities.clone());
    let with =
        |x: &[DVec3], rate: &[DVec3]| -> Vec<DVec3> { x.iter().zip(rate).map(|(&x, &rate)| x + h * rate).collect() };
    let (positions, velocities) = (with(&x, &v), with(&v, &accelerations));
    let middle = Stage { time: time + c * dt, h, positions: &positions, velocities: &velocities, is_end: false };
    stages.solve(dynamics, state, &middle)?;
    let p = 1.0 / (c * (2.0 - c));
    let q = (1.0 - c) * (1.0 - c) * p;
    let between = |middle: &[DVec3], start: &[DVec3]| -> Vec<DVec3> {
        middle.iter().zip(start).map(|(&middle, &start)| p * middle - q * start).collect()
    };
    let (positions, velocities) = (between(&state.positions, &x), between(&state.velocities, &v));
    let end = Stage { time: time + dt, h, positions: &positions, velocities: &velocities, is_end: true };
    stages.solve(dynamics, state, &end)
}

impl Integrator for TrBdf2 {
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
