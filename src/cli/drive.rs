//! Running a [`Runner`] to the end that was asked for, against the clock.

use super::interruption::{Interruption, Signal};
use super::{CliError, Console};
use crate::sim::Runner;
use crate::solver::world::World;
use std::time::{Duration, Instant};

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RunEnd {
    /// All the time that was asked for has been simulated.
    Time,
    /// Everything came to rest.
    Rest,
    /// Every body was stopped.
    Stopped,
    /// A signal ended it.
    Interrupted(Signal),
}

/// A run that has ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drive {
    /// Time spent stepping, and nothing else [s].
    pub wall_seconds: f64,
    /// Why it ended.
    pub end: RunEnd,
}

/// A run that ended because a frame could not be kept.
pub(super) struct FailedRun {
    /// Time spent stepping, and nothing else [s].
    pub wall_seconds: f64,
    /// Why it could not be kept.
    pub error: Box<CliError>,
}

impl From<FailedRun> for CliError {
    fn from(run: FailedRun) -> Self {
        *run.error
    }
}

/// A frame after one that took longer is ended in the midst by an interruption; what would have to be kept for that at
/// every frame is not worth it for shorter ones.
const LONG: Duration = Duration::from_millis(200);

/// Says what has gained energy that nothing gave it and was not `told` of before.
pub(super) fn warn_unbalanced(world: &World, told: &mut Vec<String>, console: &mut Console) {
    for unbalanced in world.unbalanced() {
        let text = unbalanced.to_string();
        // A world that was put together anew has forgotten what was told of the one before.
        if !told.contains(&text) {
            console.warn(&text);
            told.push(text);
        }
    }
}

/// Advances `runner` by at most `frames` frames; `each` sees it before the first and after every frame. An interruption
/// ends it with the frame before, or with the one at hand where they are short.
///
/// # Errors
/// What `each` gives, at once.
pub(super) fn drive(
    runner: &mut Runner,
    frames: u64,
    until_rest: bool,
    interruption: &Interruption,
    each: &mut dyn FnMut(&Runner) -> Result<(), CliError>,
) -> Result<Drive, FailedRun> {
    let mut stepping = Duration::ZERO;
    let failed =
        |stepping: Duration| move |error| FailedRun { wall_seconds: stepping.as_secs_f64(), error: Box::new(error) };
    each(runner).map_err(failed(stepping))?;
    let mut end = RunEnd::Time;
    // Nothing is known of the first.
    let mut is_long = true;
    while runner.world().frame() < frames {
        if let Some(signal) = interruption.signal() {
            end = RunEnd::Interrupted(signal);
            break;
        }
        let begun = Instant::now();
        if is_long {
            // All is as it was before where it was ended: the next turn says so.
            if !runner.advance_frame_unless(&|| interruption.signal().is_some()) {
                continue;
            }
        } else {
            runner.advance_frame();
        }
        is_long = begun.elapsed() > LONG;
        stepping += begun.elapsed();
        each(runner).map_err(failed(stepping))?;
        if runner.all_stopped() {
            end = RunEnd::Stopped;
            break;
        }
        if until_rest && runner.at_rest() {
            end = RunEnd::Rest;
            break;
        }
    }
    runner.look();
    Ok(Drive { wall_seconds: stepping.as_secs_f64(), end })
}
