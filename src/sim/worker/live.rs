//! The run of the document: what the simulation has come to.

use crate::bake::ThinPlaces;
use crate::sim::recording::{RestoredRun, StoredState};
use crate::sim::runner::Runner;
use crate::solver::body::Body;
use crate::solver::snapshot::Snapshot;
use glam::DVec3;
use std::sync::Arc;

/// The document's world as it was put together last, and as it moves.
#[derive(Default)]
pub(super) struct LiveRun {
    start: Option<Arc<Runner>>,
    runner: Option<Runner>,
    /// The runner's present state, where it is known.
    present: Option<Arc<StoredState>>,
    at_rest: Arc<Snapshot>,
    placed: Option<[DVec3; 2]>,
    thin: Arc<[ThinPlaces]>,
    held: Arc<[Vec<Vec<u32>>]>,
}

impl LiveRun {
    /// Takes up what was put together anew: from its start, or in the motion of what was there before.
    /// `thin` is where each body is too thin for its particles.
    pub(super) fn take_up(&mut self, fresh: Runner, thin: Vec<ThinPlaces>, keeps_motion: bool) {
        self.thin = thin.into();
        self.at_rest = Arc::new(Snapshot::in_model_frames(fresh.world()));
        self.placed = fresh.world().placed();
        let held = |body: &Body| body.parts().constraints.iter().map(|each| each.particles.clone()).collect();
        self.held = fresh.world().bodies().iter().map(held).collect();
        self.start = Some(Arc::new(fresh.clone()));
        let mut runner = fresh;
        if let Some(before) = self.runner.as_ref().filter(|_| keeps_motion) {
            runner.adopt(before);
        }
        self.set(Some(runner));
    }

    fn set(&mut self, runner: Option<Runner>) {
        (self.runner, self.present) = (runner, None);
    }

    /// Back to the start; false where nothing has been put together.
    pub(super) fn restart(&mut self) -> bool {
        let start = self.start.as_deref().cloned();
        self.set(start);
        self.start.is_some()
    }

    /// Gives the motion up after a failure. The start can still be trusted.
    pub(super) fn give_up(&mut self) {
        self.set(None);
    }

    /// Goes on from a run of before: in its own build where that is still the present one, and as the present one in
    /// its motion where it is not, which is what it gives.
    pub(super) fn continue_from(&mut self, restored: RestoredRun) -> bool {
        let changed = self.start.as_ref().filter(|start| !Arc::ptr_eq(start, &restored.build));
        let is_changed = changed.is_some();
        let runner = match changed {
            Some(start) => {
                let mut runner = (**start).clone();
                runner.adopt(&restored.runner);
                runner
            }
            None => restored.runner,
        };
        self.set(Some(runner));
        is_changed
    }

    /// The moving world; none before there is one and after a failure.
    pub(super) fn runner(&self) -> Option<&Runner> {
        self.runner.as_ref()
    }

    /// The moving world, to work on it.
    pub(super) fn runner_mut(&mut self) -> Option<&mut Runner> {
        self.present = None;
        self.runner.as_mut()
    }

    /// Advances by a frame, unless `stop` says in the midst of it that it is no longer wanted: false then, and all is
    /// as it was before.
    pub(super) fn advance_unless(&mut self, stop: &dyn Fn() -> bool) -> bool {
        let Some(before) = self.stored() else { return true };
        self.runner_mut().is_none_or(|runner| before.advance_unless(runner, stop))
    }

    /// Back to a state of this run.
    pub(super) fn go_back(&mut self, to: Arc<StoredState>) {
        if let Some(runner) = &mut self.runner {
            to.restore(runner);
            self.present = Some(to);
        }
    }

    /// The start as it was put together last.
    pub(super) fn start(&self) -> Option<&Arc<Runner>> {
        self.start.as_ref()
    }

    /// Every body at rest in its model frame.
    pub(super) fn at_rest(&self) -> &Arc<Snapshot> {
        &self.at_rest
    }

    /// Opposite corners of the box around all bodies where the scene places them [m].
    pub(super) fn placed(&self) -> Option<[DVec3; 2]> {
        self.placed
    }

    /// Where each body is too thin for its particles.
    pub(super) fn thin(&self) -> &Arc<[ThinPlaces]> {
        &self.thin
    }

    /// Particles that the constraints of each body hold.
    pub(super) fn held(&self) -> &Arc<[Vec<Vec<u32>>]> {
        &self.held
    }

    /// The present state, to go on from later.
    pub(super) fn stored(&mut self) -> Option<Arc<StoredState>> {
        let (start, runner) = (self.start.as_ref()?, self.runner.as_ref()?);
        let present = self.present.get_or_insert_with(|| Arc::new(StoredState::new(start, runner)));
        Some(Arc::clone(present))
    }
}
