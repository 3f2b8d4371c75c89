//! Whether what is being put together or computed is still wanted.
//!
//! A frame that somebody waits for is ended: all is as it was before it then, so that it is computed anew, with what
//! was asked for done. One that is nearly there is let go on, as most are. While edits follow each other closely, as
//! those of a slider do, frames that take longer than [`GRACE`] are not seen: each edit is, and the motion goes on once
//! the hand rests.

use crate::sim::command::SimCommand;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// What waits for a frame waits so long at most, and for the step that it is in: it is done within 0.2 s.
const GRACE: Duration = Duration::from_millis(150);

/// How long a command lets a frame go on that is being computed; any time where none is given.
fn patience(command: &SimCommand) -> Option<Duration> {
    match command {
        // Nothing is left of what it belongs to.
        SimCommand::Open(..) | SimCommand::Reset => Some(Duration::ZERO),
        SimCommand::Pause
        | SimCommand::Play
        | SimCommand::Compute(_)
        | SimCommand::Edit(_)
        | SimCommand::Grab { .. }
        | SimCommand::Release
        | SimCommand::PinGrab
        | SimCommand::Unpin { .. }
        | SimCommand::ReleaseAll
        | SimCommand::Compare { .. }
        | SimCommand::Ghost(_)
        | SimCommand::Show(_)
        | SimCommand::StepBack
        | SimCommand::Replay
        | SimCommand::Strike { .. }
        | SimCommand::Field(_)
        | SimCommand::Tension(_)
        | SimCommand::Activation(_)
        | SimCommand::ContinueHere
        | SimCommand::Live
        | SimCommand::Take(_) => Some(GRACE),
        // Of a grab and a step frames are what is wanted, and nothing is seen of the others but by frames to come.
        SimCommand::MoveGrab(_)
        | SimCommand::Lead { .. }
        | SimCommand::Step
        | SimCommand::Speed(_)
        | SimCommand::Memory(_) => None,
    }
}

/// Flags that end the putting together of a scene, and the frame that is being computed, when they are looked at next.
/// Copies share them.
#[derive(Clone, Debug, Default)]
pub(super) struct Stop(Arc<Flags>);

#[derive(Debug)]
struct Flags {
    outdated: AtomicBool,
    asked: AtomicBool,
    begun: Instant,
    /// When a frame is to end for what waits, after `begun` [µs]; never at the greatest number.
    due: AtomicU64,
}

impl Default for Flags {
    fn default() -> Self {
        Self {
            outdated: AtomicBool::new(false),
            asked: AtomicBool::new(false),
            begun: Instant::now(),
            due: AtomicU64::new(u64::MAX),
        }
    }
}

impl Stop {
    /// A newer request makes it pointless.
    pub(super) fn outdate(&self) {
        self.0.outdated.store(true, Ordering::SeqCst);
    }

    /// Somebody asks for it.
    pub(super) fn ask(&self) {
        self.0.asked.store(true, Ordering::SeqCst);
    }

    /// Nothing stops what begins now.
    pub(super) fn clear(&self) {
        self.0.outdated.store(false, Ordering::SeqCst);
        self.0.asked.store(false, Ordering::SeqCst);
        self.0.due.store(u64::MAX, Ordering::SeqCst);
    }

    /// A command waits since then.
    pub(super) fn hurry(&self, command: &SimCommand, since: Instant) {
        if let Some(patience) = patience(command) {
            let due = (since + patience).saturating_duration_since(self.0.begun).as_micros();
            self.0.due.fetch_min(due.min(u128::from(u64::MAX)) as u64, Ordering::SeqCst);
        }
    }

    /// No frame is waited for any more.
    pub(super) fn end(&self) {
        self.0.due.store(0, Ordering::SeqCst);
    }

    /// What tells of a frame whether it is to end.
    pub(super) fn of_frame(&self) -> impl Fn() -> bool + use<> {
        let flags = Arc::clone(&self.0);
        move || {
            let due = flags.due.load(Ordering::SeqCst);
            due != u64::MAX && flags.begun.elapsed().as_micros() >= u128::from(due)
        }
    }

    /// Whether it is to end.
    pub(super) fn is_set(&self) -> bool {
        self.is_asked() || self.0.outdated.load(Ordering::SeqCst)
    }

    /// Whether somebody asked for that.
    pub(super) fn is_asked(&self) -> bool {
        self.0.asked.load(Ordering::SeqCst)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    /// Whether a frame that is going on ends for a command that came so long ago.
    fn ends(command: &SimCommand, ago: Duration) -> bool {
        let since = Instant::now().checked_sub(ago).expect("the machine has run for longer");
        let stop = Stop::default();
        stop.hurry(command, since);
        stop.of_frame()()
    }

    #[test]
    fn what_waits_ends_a_frame_within_a_fifth_of_a_second_less_a_step() {
        assert!(GRACE <= Duration::from_millis(150));
        let scene = Arc::new(Scene::new(""));
        let waits = [
            SimCommand::Pause,
            SimCommand::Play,
            SimCommand::Edit(Arc::clone(&scene)),
            SimCommand::Grab { body: 0, vertex: 0, target: glam::DVec3::ZERO },
            SimCommand::Release,
            SimCommand::PinGrab,
            SimCommand::Unpin { body: 0, grab: 0 },
            SimCommand::ReleaseAll,
            SimCommand::Strike { body: 0, impulse: glam::DVec3::ZERO },
            SimCommand::Ghost(None),
            SimCommand::Show(0.0),
            SimCommand::StepBack,
            SimCommand::Replay,
            SimCommand::Field(None),
            SimCommand::ContinueHere,
            SimCommand::Live,
        ];
        for command in &waits {
            assert!(ends(command, GRACE), "{command:?}");
        }
        for command in [SimCommand::Open(scene, Arc::default()), SimCommand::Reset] {
            assert!(ends(&command, Duration::ZERO), "{command:?}");
        }
        for command in [SimCommand::Step, SimCommand::Speed(1.0), SimCommand::MoveGrab(glam::DVec3::ZERO)] {
            assert!(!ends(&command, 100 * GRACE), "{command:?}");
        }
    }
}
