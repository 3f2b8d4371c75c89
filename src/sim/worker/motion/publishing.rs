//! The newest picture of what moves, with what is said of it.

use super::Motion;
use crate::sim::not_finite::NotFinite;
use crate::sim::runner::Runner;
use crate::sim::status::Published;
use crate::sim::worker::grabs::pinned_points;
use crate::solver::snapshot::Snapshot;
use std::sync::Arc;

impl Motion {
    /// Hands the newest picture over, of what is shown.
    pub(in crate::sim::worker) fn publish(&mut self) {
        let _publish = tracing::info_span!("publish").entered();
        let live = &self.runs.live;
        let mut snapshot = Snapshot::default();
        if let Some(runner) = self.replay.shown().or(live.runner()) {
            snapshot = self.views.picture(runner);
            self.status.read(runner.world());
            self.status.lost = NotFinite::of(&snapshot).map(|lost| lost.to_string());
            if self.status.lost.is_some() && !self.comparison.is_running() {
                self.playback.set_playing(false);
            }
        }
        // In an earlier frame it is the ghost that was there then.
        let ghost = if self.replay.is_active() {
            self.replay.ghost().filter(|_| self.runs.ghost.is_wanted())
        } else {
            self.runs.ghost.runner()
        };
        let mut ghost = ghost.map(Runner::particles);
        let pointer = self.grab.body().filter(|_| !self.replay.is_active());
        let pinned = self.shown().map_or_else(Vec::new, |runner| pinned_points(runner, pointer));
        let mut compared = Vec::new();
        if let Some((side_by_side, runs)) = self.comparison.picture() {
            self.status.time = side_by_side.time;
            (snapshot, ghost, compared) = (side_by_side, None, runs);
        }
        self.status.playing = self.playback.is_playing();
        if !self.is_running() {
            // Stopped bodies, and what is no number any more, come to nothing further.
            self.status.ahead = None;
        }
        [self.status.frames_per_second, self.status.real_time_factor] = self.playback.rates();
        self.status.recording = self.replay.status(live.start());
        let (at_rest, placed, thin) = (Arc::clone(live.at_rest()), live.placed(), Arc::clone(live.thin()));
        let held = Arc::clone(live.held());
        self.outlet.publish(Published {
            snapshot,
            ghost,
            at_rest,
            thin,
            placed,
            held,
            pinned,
            status: self.status.clone(),
            compared,
        });
    }
}
