//! The second backward difference formula.

use super::integrator::Integrator;
use super::tr_bdf2;
use crate::solver::dynamics::Dynamics;
use crate::solver::implicit::{Stage, Stepper};
use crate::solver::state::ParticleState;
use glam::DVec3;

/// `x' = (4 x - x_before) / 3 + 2/3 dt v'`, and v' alike with a': order 2, one stage a step, stable at any step; takes
/// energy of what it does not resolve. Where the step before does not lead here, such as after a blow, it starts with a
/// step of TR-BDF2.
#[derive(Clone, Default)]
pub(crate) struct Bdf2 {
    stepper: Stepper,
    before: Option<History>,
}

/// The step before: where it began and where it ended.
#[derive(Clone)]
struct History {
    dt: f64,
    start: [Vec<DVec3>; 2],
    end: [Vec<DVec3>; 2],
}

impl Integrator for Bdf2 {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        let start = [state.positions.clone(), state.velocities.clone()];
        let before = self.before.take().filter(|before| before.end == start);
        let Self { stepper, .. } = self;
        stepper.step(dynamics, state, time, dt, &mut |stages, dynamics, state, time, dt| {
            let Some(History { start: [x, v], .. }) = before.as_ref().filter(|before| before.dt == dt) else {
                return tr_bdf2::attempt(stages, dynamics, state, time, dt);
            };
            let between = |now: &[DVec3], before: &[DVec3]| -> Vec<DVec3> {
                now.iter().zip(before).map(|(&now, &before)| (4.0 * now - before) / 3.0).collect()
            };
            let (positions, velocities) = (between(&state.positions, x), between(&state.velocities, v));
            let h = 2.0 / 3.0 * dt;
            let end = Stage { time: time + dt, h, positions: &positions, velocities: &velocities, is_end: true };
            stages.solve(dynamics, state, &end)
        });
        let end = [state.positions.clone(), state.velocities.clone()];
        self.before = Some(History { dt, start, end });
    }

    fn stable_step(&self, _omega: f64, _damping: f64) -> f64 {
        f64::INFINITY
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        Box::new(self.clone())
    }
}
