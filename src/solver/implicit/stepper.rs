//! What becomes of a step with a stage that was given up: halves, and below them leap-frog.

use super::balance::Balance;
use super::solver::StageSolver;
use super::stage::Unconverged;
use crate::solver::dynamics::Dynamics;
use crate::solver::integrators::{Integrator, LeapFrog};
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// One step of a scheme from `state` at a time [s] over a length [s]. Where it fails, what it leaves means nothing.
pub(in crate::solver) type Attempt<'a> =
    dyn FnMut(&mut StageSolver, &mut Dynamics<'_>, &mut ParticleState, f64, f64) -> Result<(), Unconverged> + 'a;

/// Takes steps by any implicit scheme. A copy shares its matrices.
#[derive(Clone, Default)]
pub(in crate::solver) struct Stepper {
    stages: StageSolver,
    leap_frog: Scratch<LeapFrog>,
    balance: Balance,
    /// Tries that failed, one after the other.
    failed: u32,
}

/// How often a step is halved before leap-frog takes over.
const MOST_HALVINGS: u32 = 2;
/// Share of the body's reach that a body at the room, or what of it touches the room, may go towards or away from it in
/// a step: a faster one strikes it, and a blow that no step resolves would win or lose energy by chance.
const STRIKING: f64 = 0.05;
/// Share of its stable step that leap-frog takes.
const SAFETY: f64 = 0.6;
/// After so many failures in a row leap-frog keeps every other step.
const MOST_FAILURES: u32 = 2;

impl Stepper {
    /// Steps from `time` to `time + dt` [s] by `attempt`.
    pub(in crate::solver) fn step(
        &mut self,
        dynamics: &mut Dynamics<'_>,
        state: &mut ParticleState,
        time: f64,
        dt: f64,
        attempt: &mut Attempt<'_>,
    ) {
        dynamics.make_current(time, state);
        self.balance.start(dynamics, state, time, dt);
        let rests = self.failed >= MOST_FAILURES;
        if rests || strikes(dynamics, state, time, dt) {
            self.failed -= u32::from(rests);
            self.hand_over(dynamics, state, time, dt);
            return;
        }
        let before = dynamics.fallbacks.handed_over;
        self.step_or_halve(dynamics, state, time, dt, attempt, 0);
        self.failed = if dynamics.fallbacks.handed_over == before { 0 } else { self.failed + 1 };
    }

    fn step_or_halve(
        &mut self,
        dynamics: &mut Dynamics<'_>,
        state: &mut ParticleState,
        time: f64,
        dt: f64,
        attempt: &mut Attempt<'_>,
        halvings: u32,
    ) {
        let before = state.clone();
        if self.try_step(dynamics, state, time, dt, attempt).is_ok() {
            return;
        }
        state.clone_from(&before);
        dynamics.make_outdated();
        if halvings == MOST_HALVINGS {
            self.hand_over(dynamics, state, time, dt);
            return;
        }
        dynamics.fallbacks.halved += 1;
        let half = 0.5 * dt;
        self.step_or_halve(dynamics, state, time, half, attempt, halvings + 1);
        self.step_or_halve(dynamics, state, time + half, half, attempt, halvings + 1);
    }

    /// A step that was solved, did not strike the room and gained no energy, or an error.
    fn try_step(
        &mut self,
        dynamics: &mut Dynamics<'_>,
        state: &mut ParticleState,
        time: f64,
        dt: f64,
        attempt: &mut Attempt<'_>,
    ) -> Result<(), Unconverged> {
        let start = self.balance.watches(dynamics, time).then(|| state.positions.clone());
        attempt(&mut self.stages, dynamics, state, time, dt)?;
        dynamics.make_current(time + dt, state);
        if strikes(dynamics, state, time + dt, dt) {
            return Err(Unconverged);
        }
        self.balance.end(dynamics, state, time + dt, start.as_deref())
    }

    /// Leap-frog in steps that it is stable in.
    fn hand_over(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        dynamics.fallbacks.handed_over += 1;
        let steps = (dt / (SAFETY * dynamics.explicit_dt)).ceil().max(1.0);
        for k in 0..steps as u64 {
            let done = k as f64 / steps;
            self.leap_frog.step(dynamics, state, time + done * dt, dt / steps);
        }
        self.balance.take_over(dynamics, state, time + dt);
    }
}

/// Whether the body, which touches the room or a collider or would do so at the end of a free step of `dt` [s], moves
/// along its normal too fast for such steps: what touches it, or the whole by its present speed or the one to which the
/// present forces bring it.
fn strikes(dynamics: &Dynamics<'_>, state: &ParticleState, time: f64, dt: f64) -> bool {
    if !dynamics.may_touch() {
        return false;
    }
    let most = STRIKING * dynamics.reach / dt;
    let ahead: Vec<DVec3> = state.positions.iter().zip(&state.velocities).map(|(&x, &v)| x + dt * v).collect();
    let [touching, will] = [(time, &state.positions), (time + dt, &ahead)].map(|(time, x)| dynamics.touching(time, x));
    if touching.is_empty() && will.is_empty() {
        return false;
    }
    let (whole, gains) = (state.linear_momentum() / state.mass(), dt * dynamics.acceleration_of_the_whole(state));
    let now = touching.iter().map(|touch| (touch, time, &state.positions));
    now.chain(will.iter().map(|touch| (touch, time + dt, &ahead))).any(|(&(i, what), time, positions)| {
        let Some(normal) = dynamics.normal(what, time, positions[i as usize]) else { return false };
        let speeds = [state.velocities[i as usize], whole, whole + gains];
        speeds.iter().any(|speed| speed.dot(normal).abs() > most)
    })
}
