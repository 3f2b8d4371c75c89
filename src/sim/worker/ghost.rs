//! Another scene that runs in step with the document's.

use super::build::guarded;
use crate::scene::Scene;
use crate::sim::recording::StoredState;
use crate::sim::runner::Runner;
use std::sync::Arc;

/// The ghost that is wanted, and the one that runs.
#[derive(Default)]
pub(super) struct GhostRun {
    wanted: Option<Arc<Scene>>,
    /// Whether that has changed since the ghost was put together.
    is_stale: bool,
    ghost: Option<Ghost>,
}

struct Ghost {
    scene: Arc<Scene>,
    start: Arc<Runner>,
    runner: Runner,
}

impl Ghost {
    /// Goes on from where the live run is.
    fn join(&mut self, live: &Runner) {
        self.runner = (*self.start).clone();
        // At the start of the scene nothing is taken over: an adopted state is the same only up to round-off.
        if live.world().time() > 0.0 || live.is_held() {
            self.runner.adopt(live);
        }
    }

    /// Brings it forward to a time [s], in whole frames of its own.
    fn advance_to(&mut self, time: f64) {
        // Half a frame of leeway: both clocks may round differently.
        let frame = self.runner.world().plan().frame_seconds;
        while !self.runner.all_stopped() && self.runner.world().time() + 0.5 * frame < time {
            self.runner.advance_frame();
        }
    }
}

impl GhostRun {
    /// Chooses the scene that is to run from now on; none ends the ghost.
    pub(super) fn choose(&mut self, scene: Option<Arc<Scene>>) {
        self.wanted = scene;
        self.is_stale = true;
    }

    /// Whether one is wanted.
    pub(super) fn is_wanted(&self) -> bool {
        self.wanted.is_some()
    }

    /// Ends the ghost that is no longer wanted; gives the scene of the one that is wanted in its place, to be put
    /// together.
    pub(super) fn replace(&mut self) -> Option<Arc<Scene>> {
        if !std::mem::take(&mut self.is_stale) {
            return None;
        }
        let runs = self.ghost.as_ref().map(|ghost| &ghost.scene);
        if runs.is_some() && runs == self.wanted.as_ref() {
            return None;
        }
        self.ghost = None;
        self.wanted.clone()
    }

    /// Starts a ghost where the live run is, so that the two part only by what their scenes differ in.
    pub(super) fn start(&mut self, scene: Arc<Scene>, fresh: Runner, live: Option<&Runner>) {
        let mut ghost = Ghost { scene, start: Arc::new(fresh.clone()), runner: fresh };
        if let Some(live) = live {
            ghost.join(live);
        }
        self.ghost = Some(ghost);
    }

    /// Back to the start, as the live run goes there.
    pub(super) fn restart(&mut self) {
        if let Some(ghost) = &mut self.ghost {
            ghost.runner = (*ghost.start).clone();
        }
    }

    /// Brings it to where the live run is [s]. One that fails is given up.
    ///
    /// # Errors
    /// What the failure was.
    pub(super) fn advance_to(&mut self, time: f64) -> Result<(), String> {
        let Some(ghost) = &mut self.ghost else { return Ok(()) };
        let advanced = guarded(|| ghost.advance_to(time));
        if advanced.is_err() {
            self.ghost = None;
        }
        advanced
    }

    /// Goes along to an earlier frame, from which `live` goes on: to where it was then, or to where the live run is if
    /// there was another ghost or none.
    pub(super) fn continue_from(&mut self, stored: Option<&StoredState>, live: &Runner) {
        let Some(ghost) = &mut self.ghost else { return };
        match stored.filter(|stored| stored.is_of(&ghost.start)) {
            Some(stored) => stored.restore(&mut ghost.runner),
            None => ghost.join(live),
        }
    }

    /// The present state, to go on from later.
    pub(super) fn stored(&self) -> Option<StoredState> {
        self.ghost.as_ref().map(|ghost| StoredState::new(&ghost.start, &ghost.runner))
    }

    /// The moving world.
    pub(super) fn runner(&self) -> Option<&Runner> {
        self.ghost.as_ref().map(|ghost| &ghost.runner)
    }

    /// The moving world, to work on it.
    pub(super) fn runner_mut(&mut self) -> Option<&mut Runner> {
        self.ghost.as_mut().map(|ghost| &mut ghost.runner)
    }
}
