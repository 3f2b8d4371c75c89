//! Whether what is being put together or computed is still wanted.
//!
//! A frame that somebody waits for is ended: all is as it was before it then, so that it is computed anew, with what
//! was asked for done. One that is nearly there is let go on, as most are.

use crate::sim::command::SimCommand;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::time::{Duration, Instant};

/// A frame may take so long whatever waits for it.
const GRACE: Duration = Duration::from_millis(120);

/// Edits that follow each other closely, as those of a slider do, let a frame take this long at most, or none would
/// ever be seen.
const GREATEST_GRACE: Duration = Duration::from_millis(600);

/// How much a command that waits minds the frame that is being computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub(super) enum Urgency {
    /// It comes after it.
    None,
    /// It ends one that came by itself: one that was asked for was asked for first.
    Before,
    /// It ends any: nothing is to move.
    Hold,
    /// Nothing is left of what it belongs to.
    Drop,
}

impl Urgency {
    /// That of a command.
    pub(super) fn of(command: &SimCommand) -> Self {
        match command {
            SimCommand::Open(..) | SimCommand::Reset => Self::Drop,
            SimCommand::Pause => Self::Hold,
            SimCommand::Edit(_)
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
            | SimCommand::Strike { .. } => Self::Before,
            // Of a drag, frames are what is wanted.
            SimCommand::MoveGrab(_)
            | SimCommand::Lead { .. }
            | SimCommand::Play
            | SimCommand::Step
            | SimCommand::Speed(_)
            | SimCommand::Field(_)
            | SimCommand::Tension(_)
            | SimCommand::Activation(_)
            | SimCommand::ContinueHere
            | SimCommand::Live
            | SimCommand::Take(_)
            | SimCommand::Memory(_) => Self::None,
        }
    }
}

/// Flags that end the putting together of a scene, and the frame that is being computed, when they are looked at next.
/// Copies share them.
#[derive(Clone, Debug, Default)]
pub(super) struct Stop(Arc<Flags>);

#[derive(Debug, Default)]
struct Flags {
    outdated: AtomicBool,
    asked: AtomicBool,
    /// The greatest [`Urgency`] of what waits.
    urgency: AtomicU8,
}

/// How long frames were let go on after all that waited.
#[derive(Clone, Copy, Debug)]
pub(super) struct Patience(Duration);

impl Default for Patience {
    fn default() -> Self {
        Self(GRACE)
    }
}

impl Patience {
    /// Has more of it with the next frame if this one was ended.
    pub(super) fn after(self, is_whole: bool) -> Self {
        if is_whole { Self::default() } else { Self((2 * self.0).min(GREATEST_GRACE)) }
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
        self.0.urgency.store(Urgency::None as u8, Ordering::SeqCst);
    }

    /// Something waits.
    pub(super) fn hurry(&self, urgency: Urgency) {
        self.0.urgency.fetch_max(urgency as u8, Ordering::SeqCst);
    }

    /// What tells of a frame that begins now whether it is to end. One that was asked for is ended by less.
    pub(super) fn of_frame(&self, was_asked: bool, patience: Patience) -> impl Fn() -> bool + use<> {
        let (flags, begun) = (Arc::clone(&self.0), Instant::now());
        move || {
            let urgency = flags.urgency.load(Ordering::SeqCst);
            let waits = |least: Urgency| urgency >= least as u8;
            waits(Urgency::Drop)
                || (waits(Urgency::Hold) && begun.elapsed() > GRACE)
                || (waits(Urgency::Before) && !was_asked && begun.elapsed() > patience.0)
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
