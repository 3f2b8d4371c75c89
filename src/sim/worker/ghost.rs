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
    /// The runner's present state, where it is known.
    present: Option<Arc<StoredState>>,
}

impl Ghost {
    /// Goes on from where the live run is.
    fn join(&mut self, live: &Runner) {
        self.restart();
        // At the start of the scene nothing is taken over: an adopted state is the same only up to round-off.
        if live.world().time() > 0.0 || live.is_held() {
            self.runner.adopt(live);
        }
    }

    /// Back to the start.
    fn restart(&mut self) {
        (self.runner, self.present) = ((*self.start).clone(), None);
    }

    /// Brings it forward to a time [s], in whole frames of its own; false where `stop` ended it on the way.
    fn advance_to(&mut self, time: f64, stop: &dyn Fn() -> bool) -> bool {
        self.present = None;
        // Half a frame of leeway: both clocks may round differently.
        let frame = self.runner.world().plan().frame_seconds;
        while !self.runner.all_stopped() && self.runner.world().time() + 0.5 * frame < time {
            if !self.runner.frame_unless(stop) {
                return false;
            }
        }
        true
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
        let mut ghost = Ghost { scene, start: Arc::new(fresh.clone()), runner: fresh, present: None };
        if let Some(live) = live {
            ghost.join(live);
        }
        self.ghost = Some(ghost);
    }

    /// Back to the start, as the live run goes there.
    pub(super) fn restart(&mut self) {
        if let Some(ghost) = &mut self.ghost {
            ghost.restart();
        }
    }

    /// Brings it to where the live run is [s]; false where `stop` ended it on the way: it has to go back then. One that
    /// fails is given up.
    ///
    /// # Errors
    /// What the failure was.
    pub(super) fn advance_to(&mut self, time: f64, stop: &dyn Fn() -> bool) -> Result<bool, String> {
        let Some(ghost) = &mut self.ghost else { return Ok(true) };
        let advanced = guarded(|| ghost.advance_to(time, stop));
        if advanced.is_err() {
            self.ghost = None;
        }
        advanced
    }

    /// Goes along to an earlier frame, from which `live` goes on: to where it was then, or to where the live run is if
    /// there was another ghost or none.
    pub(super) fn continue_from(&mut self, stored: Option<&Arc<StoredState>>, live: &Runner) {
        let Some(ghost) = &mut self.ghost else { return };
        match stored.filter(|stored| stored.is_of(&ghost.start)) {
            Some(stored) => self.go_back(stored),
            None => ghost.join(live),
        }
    }

    /// The present state, to go on from later.
    pub(super) fn stored(&mut self) -> Option<Arc<StoredState>> {
        let Ghost { start, runner, present, .. } = self.ghost.as_mut()?;
        Some(Arc::clone(present.get_or_insert_with(|| Arc::new(StoredState::new(start, runner)))))
    }

    /// Back to a state of the ghost that runs.
    pub(super) fn go_back(&mut self, to: &Arc<StoredState>) {
        if let Some(ghost) = &mut self.ghost {
            to.restore(&mut ghost.runner);
            ghost.present = Some(Arc::clone(to));
        }
    }

    /// The moving world.
    pub(super) fn runner(&self) -> Option<&Runner> {
        self.ghost.as_ref().map(|ghost| &ghost.runner)
    }

    /// The moving world, to work on it.
    pub(super) fn runner_mut(&mut self) -> Option<&mut Runner> {
        self.ghost.as_mut().map(|ghost| {
            ghost.present = None;
            &mut ghost.runner
        })
    }
}
