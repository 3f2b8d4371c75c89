//! Looking at earlier frames, and going on from one of them.

use super::Motion;
use crate::sim::journal::Asked;
use std::sync::Arc;

impl Motion {
    /// Shows a frame, where there is one, and holds the simulation. A comparison is shown instead while there is one.
    pub(super) fn show(&mut self, frame: Option<usize>) {
        let Some(index) = frame.filter(|_| !self.comparison.is_running()) else { return };
        if !self.replay.is_active() {
            self.release();
        }
        self.replay.enter(index, &mut self.playback);
    }

    /// Starts to replay: from the frame that is shown, or from the first one where no later one is left.
    pub(super) fn start_replay(&mut self) {
        self.playback.measure_anew();
        if self.comparison.is_running() {
            return;
        }
        if !self.replay.has_later() {
            self.show(self.replay.recording().first());
        }
        self.replay.set_goes_on(false);
        self.playback.set_playing(self.replay.is_active());
    }

    /// Makes the frame that is shown the live run's state and drops the later ones; all stays as it is where none is
    /// shown.
    pub(in crate::sim::worker) fn continue_here(&mut self) {
        let Some(from) = self.replay.continue_here(&mut self.playback) else { return };
        self.owed = 0;
        if self.runs.live.runner().is_none() {
            self.status.failure = None;
        }
        let in_present_scene = self.runs.live.continue_from(from.restored);
        let scene = in_present_scene.then(|| Arc::clone(&self.scene));
        if let Some(frame) = self.replay.recording().frame(from.frame) {
            self.outlet.with_journal(|journal| {
                journal.go_back(frame.number);
                if let Some(scene) = scene {
                    journal.push(Asked::Edit(scene));
                }
                if frame.grabbed_id().is_some() {
                    journal.push(Asked::Release);
                }
            });
            self.runs.continue_ghost_from(frame.ghost.as_ref());
            // The pointer has let go of what it held then; its body may have another number now.
            self.grab.release_stored(&mut self.runs, frame.grabbed_id());
        }
        self.replay.note_continued(from.time, from.dropped, in_present_scene);
    }

    pub(super) fn limit_memory(&mut self, limit: usize) {
        let time = self.shown_time();
        self.replay.set_limit(limit);
        if self.replay.is_active() {
            self.show(self.replay.recording().nearest(time));
        }
    }
}
