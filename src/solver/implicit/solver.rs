//! A stage, solved or given up.

use super::anderson::Anderson;
use super::chord::Chord;
use super::stage::{Stage, Unconverged};
use crate::solver::dynamics::Dynamics;
use crate::solver::linear_algebra::vectors::{axpy, norm};
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// Solves stages by chord steps. A copy shares its matrices.
#[derive(Clone, Default)]
pub(in crate::solver) struct StageSolver {
    chord: Chord,
    work: Scratch<Work>,
}

/// Buffers of an iteration.
#[derive(Debug, Default)]
struct Work {
    residual: Vec<DVec3>,
    step: Vec<DVec3>,
    best: Vec<DVec3>,
    best_step: Vec<DVec3>,
    anderson: Anderson,
}

/// Force evaluations after which a stage is given up.
const MOST_EVALUATIONS: usize = 30;
/// Evaluations after which the matrix is made anew, where another can be made.
const SLOW: usize = 12;
/// In the first of them the turns follow.
const TURNING: usize = 2;
/// A step this much longer than the shortest so far goes astray.
const ASTRAY: f64 = 3.0;
/// Share of the step at the best point that is taken after one that went astray.
const CAREFUL: f64 = 0.3;
/// How often that may happen.
const MOST_RETURNS: usize = 3;

/// Share of a position that its rounding, and that of the base it is held against, may be wrong by.
const ROUND_OFF: f64 = 2.0 * f64::EPSILON;

/// Share of the forces [1] to which a stage of `h` [s] is solved, where an explicit step could be `explicit` [s]: steps
/// as short as those resolve everything and show what is left, long ones have errors of their own that are far larger.
fn tolerance(h: f64, explicit: f64) -> f64 {
    (1e-6 * (h / explicit).powi(2)).clamp(1e-10, 1e-4)
}

impl StageSolver {
    /// Solves a stage from the positions in `state`, into it. On failure `state` means nothing.
    ///
    /// # Errors
    /// [`Unconverged`]: what was reached is no solution and must not be taken for one.
    pub(in crate::solver) fn solve(
        &mut self,
        dynamics: &mut Dynamics<'_>,
        state: &mut ParticleState,
        stage: &Stage<'_>,
    ) -> Result<(), Unconverged> {
        if !self.chord.prepare(dynamics, state, stage.time, stage.h) {
            return Err(Unconverged);
        }
        let tolerance = tolerance(stage.h, dynamics.explicit_dt);
        let (mut shortest, mut returns, mut is_renewed) = (f64::INFINITY, 0, false);
        self.work.anderson.clear();
        self.work.best.clone_from(&state.positions);
        for evaluation in 0..MOST_EVALUATIONS {
            let floats = dynamics.floats(stage.time, state);
            let Residual { size, scale, round_off } = self.evaluate(dynamics, state, stage);
            // A body that nothing holds takes at least one step, which makes its momentum exact.
            if size <= (tolerance * scale).max(round_off) && (evaluation > 0 || !floats) {
                return Ok(());
            }
            if evaluation < TURNING {
                self.chord.turn(dynamics, state.len());
            }
            let Work { residual, step, best, best_step, anderson } = &mut *self.work;
            step.clone_from(residual);
            self.chord.step(dynamics, step);
            if floats {
                carry(state, residual, stage.h, step);
            }
            let length = norm(step);
            // A comparison with NaN is false, so that what is no number goes astray too.
            let is_fine = length <= ASTRAY * shortest;
            returns += usize::from(!is_fine);
            let is_lost = returns > MOST_RETURNS;
            if !is_renewed && (is_lost || evaluation >= SLOW) {
                is_renewed = true;
                state.positions.clone_from(best);
                stage.set_velocities(state);
                if self.chord.renew(dynamics, state, stage.time, stage.h) {
                    anderson.clear();
                    (shortest, returns) = (f64::INFINITY, 0);
                    continue;
                }
            }
            if is_lost {
                return Err(Unconverged);
            }
            if !is_fine {
                state.positions.clone_from(best);
                axpy(CAREFUL, best_step, &mut state.positions);
                anderson.clear();
                continue;
            }
            if length < shortest {
                shortest = length;
                best.clone_from(&state.positions);
                best_step.clone_from(step);
            }
            let taken = anderson.step(&state.positions, step);
            axpy(1.0, &taken, &mut state.positions);
        }
        Err(Unconverged)
    }

    /// The residual `M (v - vb) / h - f` [N] along free axes into the buffer; its size and what it is small against.
    fn evaluate(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, stage: &Stage<'_>) -> Residual {
        stage.set_velocities(state);
        if stage.is_end {
            dynamics.evaluate_end(stage.time, state);
        } else {
            dynamics.evaluate(stage.time, state);
        }
        let gravity = dynamics.gravity(stage.time).length();
        let Work { residual, step, .. } = &mut *self.work;
        step.clear();
        let bases = stage.positions.iter().zip(stage.velocities);
        step.extend(
            state
                .positions
                .iter()
                .zip(bases)
                .zip(&state.masses)
                .map(|((&x, (&base, &vb)), &mass)| mass / stage.h * ((x - base) / stage.h - vb)),
        );
        residual.clear();
        residual.extend(step.iter().zip(&*dynamics.net).map(|(&ma, &f)| ma - f));
        dynamics.mask(residual);
        dynamics.mask(step);
        let weight = gravity * state.masses.iter().map(|m| m * m).sum::<f64>().sqrt();
        let rest = dynamics.rest_force * (state.len() as f64).sqrt();
        let moments = state.positions.iter().zip(&state.masses).map(|(x, mass)| (mass * x.length()).powi(2));
        let round_off = ROUND_OFF * moments.sum::<f64>().sqrt() / (stage.h * stage.h);
        Residual { size: norm(residual), scale: norm(step) + weight + rest, round_off }
    }
}

/// How far a stage is from solved [N].
struct Residual {
    size: f64,
    scale: f64,
    /// What rounded positions leave of it at short steps.
    round_off: f64,
}

impl Stage<'_> {
    /// The velocities that belong to the positions.
    fn set_velocities(&self, state: &mut ParticleState) {
        for ((v, &x), &base) in state.velocities.iter_mut().zip(&state.positions).zip(self.positions) {
            *v = (x - base) / self.h;
        }
    }
}

/// Moves a step as a whole so that it leaves no residual of the whole: `sum M p / h² = -sum g`.
fn carry(state: &ParticleState, residual: &[DVec3], h: f64, step: &mut [DVec3]) {
    let whole: DVec3 = residual.iter().sum();
    let moved: DVec3 = step.iter().zip(&state.masses).map(|(&p, &mass)| mass * p).sum();
    let missing = (-h * h * whole - moved) / state.mass();
    for p in step {
        *p += missing;
    }
}
