//! What a window may want to see besides positions: a field over the world, and another scene in step with it.

use super::Loop;
use super::baking::describe;
use crate::scene::Scene;
use crate::sim::Runner;
use crate::sim::recording::Kept;
use crate::solver::body::Body;
use crate::solver::snapshot::{FieldKind, FieldSnapshot, Snapshot, TensionSnapshot};
use crate::solver::world::World;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// Share of the way by which a field's range narrows from one picture to the next: a second or so in all.
const NARROWING: f64 = 0.03;

/// What is to be seen.
#[derive(Default)]
pub(super) struct Sights {
    field: Option<FieldKind>,
    /// Upper end of the field's range.
    top: f64,
    /// Whether tensions are to be seen, and the end of their range [N].
    tension: bool,
    greatest: f64,
    /// The scene that is to run beside the document.
    wanted: Option<Arc<Scene>>,
    /// Whether that has changed since the ghost was put together.
    stale: bool,
    ghost: Option<Ghost>,
}

/// A scene in step with the document's.
struct Ghost {
    scene: Arc<Scene>,
    start: Arc<Runner>,
    runner: Runner,
}

impl Ghost {
    /// Goes on from where the world is.
    fn join(&mut self, world: &Runner) {
        self.runner = (*self.start).clone();
        // At the start of the scene nothing is taken over: an adopted state is the same only up to round-off.
        if world.world().time() > 0.0 || world.is_held() {
            self.runner.adopt(world);
        }
    }

    /// Brings it forward to a time [s], in whole frames of its own.
    fn catch_up(&mut self, time: f64) {
        // Half a frame of leeway: both clocks may round differently.
        let frame = self.runner.world().plan().frame_seconds;
        while !self.runner.all_stopped() && self.runner.world().time() + 0.5 * frame < time {
            self.runner.advance_frame();
        }
    }
}

impl Sights {
    pub(super) fn choose(&mut self, field: Option<FieldKind>) {
        self.field = field;
        self.top = 0.0;
    }

    pub(super) fn choose_tension(&mut self, on: bool) {
        self.tension = on;
        self.greatest = 0.0;
    }

    pub(super) fn want(&mut self, scene: Option<Arc<Scene>>) {
        self.wanted = scene;
        self.stale = true;
    }

    /// Ends the ghost of a document that is no longer there.
    pub(super) fn drop_ghost(&mut self) {
        self.want(None);
        self.ghost = None;
    }

    /// Back to the start, as the world goes there.
    pub(super) fn reset(&mut self) {
        self.top = 0.0;
        self.greatest = 0.0;
        if let Some(ghost) = &mut self.ghost {
            ghost.runner = (*ghost.start).clone();
        }
    }

    /// The ghost's part of a frame.
    pub(super) fn keep(&self) -> Option<Kept> {
        self.ghost.as_ref().map(|ghost| Kept::new(&ghost.start, &ghost.runner))
    }

    /// Takes the ghost along to an earlier frame, from which `world` goes on: to where it was then, or to where the world
    /// is if there was another ghost or none.
    pub(super) fn go_on(&mut self, kept: Option<&Kept>, world: &Runner) {
        let Some(ghost) = &mut self.ghost else { return };
        match kept.filter(|kept| Arc::ptr_eq(&kept.build, &ghost.start)) {
            Some(kept) => ghost.runner.go_back(&kept.state),
            None => ghost.join(world),
        }
    }

    /// The world that runs beside the document's.
    pub(super) fn world(&self) -> Option<&World> {
        self.ghost.as_ref().map(|ghost| ghost.runner.world())
    }

    /// What runs it.
    pub(super) fn runner_mut(&mut self) -> Option<&mut Runner> {
        self.ghost.as_mut().map(|ghost| &mut ghost.runner)
    }
}

impl Loop {
    /// Puts the ghost together if another one is wanted. It starts where the world is now, so that the two part only by
    /// what their scenes differ in. While an earlier frame is shown it waits.
    pub(super) fn put_ghost_together(&mut self) {
        if self.in_replay() || !std::mem::take(&mut self.sights.stale) {
            return;
        }
        let Some(scene) = self.sights.wanted.clone() else {
            self.sights.ghost = None;
            return;
        };
        if self.sights.ghost.as_ref().is_some_and(|ghost| ghost.scene == scene) {
            return;
        }
        self.sights.ghost = None;
        self.forget_ghost();
        let problem = match catch_unwind(AssertUnwindSafe(|| self.bake(&scene))) {
            Ok(Ok(baked)) => {
                let start = Arc::new(Runner::new(baked));
                let runner = (*start).clone();
                let mut ghost = Ghost { scene, start, runner };
                if let Some(world) = &self.runner {
                    ghost.join(world);
                }
                self.sights.ghost = Some(ghost);
                None
            }
            Ok(Err(problem)) => Some(problem),
            Err(panic) => Some(describe(panic.as_ref())),
        };
        self.status.baking = None;
        self.status.notes.extend(problem.map(|problem| format!("There is no ghost: {problem}")));
    }

    /// What is to be seen beside the world that is shown.
    pub(super) fn ghost(&self) -> Option<Snapshot> {
        if !self.in_replay() {
            return self.sights.ghost.as_ref().map(|ghost| ghost.runner.particles());
        }
        // In an earlier frame it is the one that was there then.
        self.sights.wanted.as_ref().and_then(|_| self.replay.ghost())
    }

    /// Brings the ghost to where the world is. One that fails is given up; the world goes on.
    pub(super) fn advance_ghost(&mut self) {
        let Some(time) = self.runner.as_ref().map(|runner| runner.world().time()) else { return };
        let Some(ghost) = &mut self.sights.ghost else { return };
        if let Err(panic) = catch_unwind(AssertUnwindSafe(|| ghost.catch_up(time))) {
            self.sights.ghost = None;
            self.status.notes.push(format!("There is no ghost: {}", describe(panic.as_ref())));
        }
    }

    /// The body of the world with this number, and the one of the same name in the ghost: what is done to one is done to
    /// both.
    pub(super) fn bodies_mut(&mut self, index: usize) -> Vec<&mut Body> {
        let body = self.runner.as_ref().and_then(|runner| runner.world().bodies().get(index));
        let Some(id) = body.map(|body| body.parts().id.clone()) else { return Vec::new() };
        let find = |runner: &Runner| runner.world().bodies().iter().position(|body| body.parts().id == id);
        let runners = self.runner.iter_mut().chain(self.sights.runner_mut());
        runners.filter_map(|runner| find(runner).and_then(|place| runner.body_mut(place))).collect()
    }

    /// The field that was asked for. Its range widens at once, so that nothing is cut off, and narrows slowly, so that
    /// colours keep their meaning through a swing.
    pub(super) fn field(&mut self) -> Option<FieldSnapshot> {
        let kind = self.sights.field?;
        let mut field = FieldSnapshot::of(self.shown()?.world(), kind);
        field.range[1] = followed(&mut self.sights.top, field.range[1]);
        Some(field)
    }

    /// The tensions, where they were asked for, over a range that widens and narrows likewise.
    pub(super) fn tension(&mut self) -> Option<TensionSnapshot> {
        let mut tension = TensionSnapshot::of(self.shown().filter(|_| self.sights.tension)?.world());
        tension.range = followed(&mut self.sights.greatest, tension.range);
        Some(tension)
    }
}

/// The end of a range that follows what it has to hold now.
fn followed(top: &mut f64, now: f64) -> f64 {
    *top = now.max(*top + NARROWING * (now - *top));
    *top
}
