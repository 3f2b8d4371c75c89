//! The live run and the ghost beside it: what is done to a body of one is done to its like in the other.

use super::ghost::GhostRun;
use super::live::LiveRun;
use crate::scene::Scene;
use crate::sim::recording::StoredState;
use crate::sim::runner::Runner;
use crate::solver::body::Body;
use std::sync::Arc;

/// Both runs.
#[derive(Default)]
pub(super) struct Runs {
    pub(super) live: LiveRun,
    pub(super) ghost: GhostRun,
}

impl Runs {
    /// The body of the live run with this number, and the one of the same identifier in the ghost.
    pub(super) fn bodies_mut(&mut self, index: usize) -> Vec<&mut Body> {
        let body = self.live.runner().and_then(|runner| runner.world().bodies().get(index));
        let Some(id) = body.map(|body| body.parts().id.clone()) else { return Vec::new() };
        self.runners_mut().filter_map(|runner| runner.find(&id).and_then(|place| runner.body_mut(place))).collect()
    }

    /// Has a hand lead a shared drive of a body, and of its like.
    pub(super) fn lead(&mut self, index: usize, drive: &str, aim: Option<f64>) {
        let body = self.live.runner().and_then(|runner| runner.world().bodies().get(index));
        let Some(id) = body.map(|body| body.parts().id.clone()) else { return };
        for runner in self.runners_mut() {
            if let Some(place) = runner.find(&id) {
                runner.lead(place, drive, aim);
            }
        }
    }

    /// Starts the ghost of a scene where the live run is.
    pub(super) fn start_ghost(&mut self, scene: Arc<Scene>, fresh: Runner) {
        self.ghost.start(scene, fresh, self.live.runner());
    }

    /// Brings the ghost to where the live run is; false where `stop` ended it on the way.
    ///
    /// # Errors
    /// Why it was given up.
    pub(super) fn advance_ghost(&mut self, stop: &dyn Fn() -> bool) -> Result<bool, String> {
        self.live.runner().map_or(Ok(true), |live| self.ghost.advance_to(live.world().time(), stop))
    }

    /// Both as they are now, to go back to.
    pub(super) fn stored(&mut self) -> [Option<Arc<StoredState>>; 2] {
        [self.live.stored(), self.ghost.stored()]
    }

    /// Back to what was stored since the last change of both.
    pub(super) fn go_back(&mut self, [live, ghost]: [Option<Arc<StoredState>>; 2]) {
        if let Some(live) = live {
            self.live.go_back(live);
        }
        if let Some(ghost) = ghost {
            self.ghost.go_back(&ghost);
        }
    }

    /// Takes the ghost along to an earlier frame, from which the live run goes on: `stored` is the ghost's part of it.
    pub(super) fn continue_ghost_from(&mut self, stored: Option<&Arc<StoredState>>) {
        if let Some(live) = self.live.runner() {
            self.ghost.continue_from(stored, live);
        }
    }

    /// Back to the start; false where the scene has not been put together yet.
    pub(super) fn restart(&mut self) -> bool {
        self.ghost.restart();
        self.live.restart()
    }

    /// Lets go of everything that is grabbed.
    pub(super) fn release_all(&mut self) {
        self.runners_mut().for_each(Runner::release_all);
    }

    fn runners_mut(&mut self) -> impl Iterator<Item = &mut Runner> {
        self.live.runner_mut().into_iter().chain(self.ghost.runner_mut())
    }
}
