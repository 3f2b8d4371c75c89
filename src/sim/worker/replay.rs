//! What was recorded is looked at again: scrubbed, stepped through, replayed, and gone on from.
//!
//! The live run stands still meanwhile. Looking changes nothing of it: only what is to be done to the world that is
//! shown makes that one the live one, and drops the frames that came after.

use super::playback::Playback;
use crate::sim::recording::{RecordedFrame, Recording, RestoredRun};
use crate::sim::runner::Runner;
use crate::sim::status::RecordingStatus;
use std::sync::Arc;

/// The recording and what is shown of it.
#[derive(Default)]
pub(super) struct Replaying {
    recording: Recording,
    /// The run at the frame that is shown; none at the live end.
    shown: Option<RestoredRun>,
    /// The ghost in that frame.
    ghost: Option<RestoredRun>,
    /// Whether the simulation goes on where the replay ends.
    goes_on: bool,
    /// Whether the simulation ran when the first frame was shown.
    resumes: bool,
    /// How often the simulation continued from an earlier frame, and what became of the later ones.
    continued: (u64, String),
}

/// Where the simulation continues.
pub(super) struct Continuation {
    pub(super) restored: RestoredRun,
    /// When [s].
    pub(super) time: f64,
    /// Number of the frame.
    pub(super) frame: usize,
    /// Later frames that were dropped.
    pub(super) dropped: usize,
}

impl Replaying {
    /// Whether an earlier frame is shown.
    pub(super) fn is_active(&self) -> bool {
        self.shown.is_some()
    }

    /// The run at the frame that is shown.
    pub(super) fn shown(&self) -> Option<&Runner> {
        self.shown.as_ref().map(|shown| &shown.runner)
    }

    /// The ghost in that frame.
    pub(super) fn ghost(&self) -> Option<&Runner> {
        self.ghost.as_ref().map(|ghost| &ghost.runner)
    }

    /// Whether what is shown was put together from another state of the document than the live run.
    pub(super) fn is_of_another_scene(&self, live: Option<&Arc<Runner>>) -> bool {
        let builds = self.shown.as_ref().zip(live);
        builds.is_some_and(|(shown, live)| !Arc::ptr_eq(&shown.build, live))
    }

    /// What is kept.
    pub(super) fn recording(&self) -> &Recording {
        &self.recording
    }

    /// Keeps a frame.
    pub(super) fn record(&mut self, frame: RecordedFrame) {
        self.recording.push(frame);
    }

    /// Keeps at most so much from now on [bytes].
    pub(super) fn set_limit(&mut self, limit: usize) {
        self.recording.set_limit(limit);
    }

    /// Back to the live run with nothing kept.
    pub(super) fn clear(&mut self, playback: &mut Playback) {
        self.return_to_live(playback);
        self.recording.clear();
    }

    /// Shows a frame and holds the simulation.
    pub(super) fn enter(&mut self, index: usize, playback: &mut Playback) {
        if !self.is_active() {
            self.resumes = playback.is_playing();
        }
        playback.set_playing(false);
        self.show(index);
    }

    fn show(&mut self, index: usize) {
        let Some(frame) = self.recording.frame(index) else { return };
        frame.world.restore_into(&mut self.shown);
        match &frame.ghost {
            Some(stored) => stored.restore_into(&mut self.ghost),
            None => self.ghost = None,
        }
    }

    /// Back to the live run, which stands as it was left.
    pub(super) fn leave(&mut self) {
        self.shown = None;
        self.ghost = None;
    }

    /// Back to the live run, which runs on if it did before.
    pub(super) fn return_to_live(&mut self, playback: &mut Playback) {
        if self.is_active() {
            playback.set_playing(self.resumes);
            self.leave();
        }
    }

    /// Holds, now and after the replay.
    pub(super) fn hold(&mut self, playback: &mut Playback) {
        playback.set_playing(false);
        self.resumes = false;
    }

    /// Chooses whether the simulation goes on where the replay ends.
    pub(super) fn set_goes_on(&mut self, goes_on: bool) {
        self.goes_on = goes_on;
    }

    /// Whether there is a frame after the one that is shown.
    pub(super) fn has_later(&self) -> bool {
        self.later().is_some()
    }

    fn later(&self) -> Option<usize> {
        self.recording.after(self.shown()?.world().time())
    }

    /// From the frame that is shown to the next; at the last one the live run is back. False where there is none.
    pub(super) fn step(&mut self, has_live: bool) -> bool {
        let Some(index) = self.later() else { return false };
        let is_last = index + 1 == self.recording.len();
        // After a failure there is no live run, and the last frame is all there is.
        if is_last && has_live {
            self.leave();
        } else {
            self.show(index);
        }
        true
    }

    /// One frame of a replay that runs.
    pub(super) fn advance(&mut self, has_live: bool, playback: &mut Playback) {
        let moved = self.step(has_live);
        if !moved && self.goes_on && has_live {
            self.leave();
        } else if !moved || (!self.is_active() && !self.goes_on) {
            self.hold(playback);
        }
    }

    /// Ends the replay where the simulation is to continue, and drops the later frames; none where no frame is shown,
    /// or none is kept any longer.
    pub(super) fn continue_here(&mut self, playback: &mut Playback) -> Option<Continuation> {
        let restored = self.shown.take()?;
        self.leave();
        playback.set_playing(playback.is_playing() || self.resumes);
        let time = restored.runner.world().time();
        let frame = self.recording.nearest(time)?;
        let dropped = self.recording.drop_after(frame);
        Some(Continuation { restored, time, frame, dropped })
    }

    /// Notes that the simulation has continued, and what became of later frames.
    pub(super) fn note_continued(&mut self, time: f64, dropped: usize, in_present_scene: bool) {
        if dropped == 0 {
            return;
        }
        let with = if in_present_scene { " with the present scene" } else { "" };
        let later = if dropped == 1 { "1 later frame was".to_owned() } else { format!("{dropped} later frames were") };
        self.continued.0 += 1;
        self.continued.1 = format!("Went on from {time:.2} s{with}: {later} dropped");
    }

    /// What the window is told of the recording.
    pub(super) fn status(&self, live: Option<&Arc<Runner>>) -> RecordingStatus {
        let [edits, breaks] = self.recording.marks();
        let [bytes, limit] = self.recording.memory();
        RecordingStatus {
            span: self.recording.span(),
            frames: self.recording.len(),
            numbers: self.recording.numbers(),
            in_replay: self.is_active(),
            of_another_scene: self.is_of_another_scene(live),
            bytes,
            limit,
            edits,
            breaks,
            continued: self.continued.clone(),
        }
    }
}
