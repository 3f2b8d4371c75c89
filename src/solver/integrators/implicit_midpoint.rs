//! Implicit midpoint.

use super::integrator::Integrator;
use crate::solver::dynamics::Dynamics;
use crate::solver::implicit::{Stage, StageSolver, Stepper, Unconverged};
use crate::solver::state::ParticleState;

/// The rates of the middle, which they lead to: `x' = x + dt v_m; v' = v + dt a(x_m, v_m)`. Order 2, no oscillation
/// grows or fades at any step, and momenta are kept; stiff ones ring on.
#[derive(Clone, Default)]
pub(crate) struct ImplicitMidpoint {
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
    let h = 0.5 * dt;
    stages.solve(dynamics, state, &Stage { time: time + h, h, positions: &x, velocities: &v, is_end: false })?;
    for (now, start) in [(&mut state.positions, x), (&mut state.velocities, v)] {
        now.iter_mut().zip(start).for_each(|(now, start)| *now = 2.0 * *now - start);
    }
    dynamics.constrain(time + dt, state);
    Ok(())
}

impl Integrator for ImplicitMidpoint {
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
