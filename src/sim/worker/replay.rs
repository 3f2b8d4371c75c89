//! What was recorded is looked at again: scrubbed, stepped through, replayed, and gone on from.
//!
//! The live world stands still meanwhile. Looking changes nothing of it: only what is to be done to the world that is
//! seen makes that one the live one, and drops the frames that came after.

use super::Loop;
use crate::sim::Runner;
use crate::sim::recording::{Frame, Kept, Recording, Seen};
use crate::sim::status::RecordingStatus;
use crate::solver::snapshot::Snapshot;
use std::sync::Arc;

/// The recording and what is seen of it.
#[derive(Default)]
pub(super) struct Replay {
    pub(super) recording: Recording,
    /// The world at the frame that is shown; none at the live end.
    seen: Option<Seen>,
    /// The ghost in that frame.
    ghost: Option<Seen>,
    /// Time [s] that is to be shown: only the newest one of those that were asked for.
    pub(super) wanted: Option<f64>,
    /// Whether the simulation goes on where the replay ends.
    pub(super) goes_on: bool,
    /// Whether the simulation ran when the first frame was shown.
    resumes: bool,
    /// How often the simulation went on from an earlier frame, and what became of the later ones.
    continued: (u64, String),
}

impl Replay {
    pub(super) fn ghost(&self) -> Option<Snapshot> {
        self.ghost.as_ref().map(|seen| seen.runner.particles())
    }
}

impl Loop {
    /// Whether an earlier frame is shown.
    pub(super) fn in_replay(&self) -> bool {
        self.replay.seen.is_some()
    }

    /// The run that is shown: an earlier frame or the live one.
    pub(super) fn shown(&self) -> Option<&Runner> {
        self.replay.seen.as_ref().map(|seen| &seen.runner).or(self.runner.as_ref())
    }

    pub(super) fn shown_time(&self) -> f64 {
        // After a failure there is no live world, but what was kept before it.
        self.shown().map_or(f64::INFINITY, |runner| runner.world().time())
    }

    /// Keeps the present state as a frame.
    pub(super) fn record(&mut self) {
        let (Some(start), Some(runner)) = (&self.start, &self.runner) else { return };
        let frame = Frame::new(Kept::new(start, runner), runner, self.sights.keep(), self.grabbed);
        self.replay.recording.push(frame);
    }

    /// Nothing is kept but the start.
    pub(super) fn record_anew(&mut self) {
        self.live();
        self.look_ahead();
        self.replay.recording.clear();
        self.record();
    }

    /// Shows the frame that was asked for last.
    pub(super) fn show_wanted(&mut self) {
        let Some(time) = self.replay.wanted.take() else { return };
        if let Some(index) = self.replay.recording.nearest(time) {
            self.look_at(index);
        }
    }

    /// Shows a frame and holds the simulation.
    fn look_at(&mut self, index: usize) {
        if self.side_by_side.is_some() || index >= self.replay.recording.len() {
            return;
        }
        if !self.in_replay() {
            self.let_go();
            self.replay.resumes = self.status.playing;
        }
        self.status.playing = false;
        self.show(index);
    }

    fn show(&mut self, index: usize) {
        let Replay { recording, seen, ghost, .. } = &mut self.replay;
        let Some(frame) = recording.frame(index) else { return };
        frame.world.show(seen);
        match &frame.ghost {
            Some(kept) => kept.show(ghost),
            None => *ghost = None,
        }
    }

    /// Back to the live world, which stands as it was left.
    pub(super) fn look_ahead(&mut self) {
        self.replay.seen = None;
        self.replay.ghost = None;
        self.replay.wanted = None;
    }

    /// Back to the live world, which runs on if it did before.
    pub(super) fn live(&mut self) {
        if self.in_replay() {
            self.status.playing = self.replay.resumes;
            self.look_ahead();
        }
    }

    /// Holds, now and after a look at earlier frames.
    pub(super) fn hold(&mut self) {
        self.status.playing = false;
        self.replay.resumes = false;
    }

    /// Shows the frame before the one that is shown.
    pub(super) fn step_back(&mut self) {
        match self.replay.recording.before(self.shown_time()) {
            Some(index) => self.look_at(index),
            None => self.hold(),
        }
    }

    /// From the frame that is shown to the next; at the last one the live world is back. False where there is none.
    pub(super) fn step_on(&mut self) -> bool {
        let Some(index) = self.replay.recording.after(self.shown_time()) else { return false };
        let last = index + 1 == self.replay.recording.len();
        // After a failure there is no live world, and the last frame is all there is.
        if last && self.runner.is_some() {
            self.look_ahead();
        } else {
            self.show(index);
        }
        true
    }

    /// To the next frame; where there is none it is computed.
    pub(super) fn step(&mut self) {
        if self.in_replay() && self.step_on() {
            return;
        }
        if self.runner.is_some() {
            self.look_ahead();
        } else {
            self.go_on();
        }
        self.advance();
    }

    /// Starts to replay: from the frame that is shown, or from the first one where no later one is left.
    pub(super) fn start_replay(&mut self) {
        if self.side_by_side.is_some() {
            return;
        }
        let later = self.in_replay() && self.replay.recording.after(self.shown_time()).is_some();
        if !later {
            self.look_at(0);
        }
        self.replay.goes_on = false;
        self.status.playing = self.in_replay();
    }

    /// One frame of a replay.
    pub(super) fn replay_frame(&mut self) {
        let moved = self.step_on();
        if !moved && self.replay.goes_on && self.runner.is_some() {
            self.look_ahead();
        } else if !moved || (!self.in_replay() && !self.replay.goes_on) {
            self.hold();
        }
    }

    /// Makes the frame that is shown the live world's state and drops the later ones; as it is where none is shown.
    pub(super) fn go_on(&mut self) {
        let time = self.shown_time();
        let Some(seen) = self.replay.seen.take() else { return };
        self.look_ahead();
        self.status.playing |= self.replay.resumes;
        let Some(index) = self.replay.recording.nearest(time) else { return };
        let dropped = self.replay.recording.drop_after(index);
        if self.runner.is_none() {
            self.status.failure = None;
        }
        let changed = self.start.as_ref().filter(|start| !Arc::ptr_eq(start, &seen.build));
        let mut with = "";
        self.runner = Some(match changed {
            Some(start) => {
                with = " with the present scene";
                let mut runner = (**start).clone();
                runner.adopt(&seen.runner);
                runner
            }
            None => seen.runner,
        });
        if let (Some(frame), Some(runner)) = (self.replay.recording.frame(index), &self.runner) {
            self.sights.go_on(frame.ghost.as_ref(), runner);
            // The pointer has let go of what it held then; its body may have another number now.
            let bodies = seen_bodies(frame);
            self.grabbed = frame.grabbed.and_then(|body| bodies.get(body)).and_then(|id| find(runner, id));
            self.let_go();
        }
        if dropped > 0 {
            let later =
                if dropped == 1 { "1 later frame was".to_owned() } else { format!("{dropped} later frames were") };
            self.replay.continued.0 += 1;
            self.replay.continued.1 = format!("Went on from {time:.2} s{with}: {later} dropped");
        }
    }

    /// Whether what is seen was put together from another state of the document than the live world.
    pub(super) fn sees_another_scene(&self) -> bool {
        let builds = self.replay.seen.as_ref().zip(self.start.as_ref());
        builds.is_some_and(|(seen, start)| !Arc::ptr_eq(&seen.build, start))
    }

    /// What the window is told of the recording.
    pub(super) fn timeline(&self) -> RecordingStatus {
        let recording = &self.replay.recording;
        let [edits, breaks] = recording.marks();
        let [bytes, limit] = recording.memory();
        RecordingStatus {
            span: recording.span(),
            frames: recording.len(),
            in_replay: self.in_replay(),
            of_another_scene: self.sees_another_scene(),
            bytes,
            limit,
            edits,
            breaks,
            continued: self.replay.continued.clone(),
        }
    }
}

/// Identifiers of the bodies of a frame.
fn seen_bodies(frame: &Frame) -> Vec<&str> {
    frame.world.build.world().bodies().iter().map(|body| body.parts().id.as_str()).collect()
}

fn find(runner: &Runner, id: &str) -> Option<usize> {
    runner.world().bodies().iter().position(|body| body.parts().id == id)
}
