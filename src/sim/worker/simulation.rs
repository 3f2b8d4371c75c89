//! The simulation of a document: what moves, and how it is put together anew when the document changes.

use super::build::{Tell, build};
use super::comparison::side_by_side;
use super::models::NewestModels;
use super::motion::Motion;
use super::queue::EarlyCommands;
use super::shared::Outlet;
use super::stop::Stop;
use crate::bake::Baked;
use crate::scene::{Assets, Scene};
use crate::sim::command::SimCommand;
use crate::sim::runner::Runner;
use crate::sim::taken::MotionTaker;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A stage of the work on a scene is shown once the last one that was is this old: what goes sooner could not be read.
const READABLE: Duration = Duration::from_millis(200);

/// A document and its motion.
pub(super) struct Simulation {
    scene: Arc<Scene>,
    assets: Arc<Assets>,
    newest: NewestModels,
    pub(super) motion: Motion,
    /// Ends the work on a scene.
    stop: Stop,
    /// What is heard while that goes on.
    early: EarlyCommands,
    /// Whether the scene is not what was put together last: the work on it was stopped.
    is_stale: bool,
    /// Whether no motion is to be kept: nothing of this document has been put together yet.
    is_new: bool,
}

impl Simulation {
    /// Of a scene that is still to be put together.
    pub(super) fn new(scene: Arc<Scene>, assets: Arc<Assets>, playing: bool, outlet: Outlet, stop: Stop) -> Self {
        let motion = Motion::new(Arc::clone(&scene), playing, outlet, stop.clone());
        let (newest, early) = (NewestModels::default(), EarlyCommands::default());
        Self { scene, assets, newest, motion, stop, early, is_stale: false, is_new: true }
    }

    /// Hearing some commands while a scene is put together.
    pub(super) fn with_early(self, early: EarlyCommands) -> Self {
        Self { early, ..self }
    }

    /// Heeding the models that come into the document.
    pub(super) fn with_models(self, newest: NewestModels) -> Self {
        Self { newest, ..self }
    }

    /// Puts the scene together and shows its start.
    pub(super) fn start(&mut self) {
        self.rebuild(false);
        self.motion.record_series();
        self.motion.publish();
    }

    /// Does what was asked for; it stands for so many documents.
    pub(super) fn handle(&mut self, command: SimCommand, documents: u64) {
        self.motion.status.edits += documents;
        match command {
            SimCommand::Edit(scene) => self.edit(scene),
            SimCommand::Open(scene, assets) => self.open(scene, assets),
            SimCommand::Reset => self.reset(),
            SimCommand::Compare { integrators, dt } => {
                self.motion.replay.leave();
                self.motion.comparison.choose(integrators, dt);
                self.start_comparison();
            }
            SimCommand::Ghost(scene) => {
                self.motion.runs.ghost.choose(scene);
                self.rebuild_ghost();
            }
            SimCommand::Take(MotionTaker(sender)) => {
                let motion = self.motion.taken(&self.scene, &self.models()).filter(|_| {
                    // What is there was put together of another scene otherwise.
                    !self.is_stale && !self.is_new && self.motion.status.failure.is_none()
                });
                // Who asked may be gone by now.
                sender.send(motion).ok();
            }
            of_motion => self.motion.handle(&of_motion),
        }
    }

    /// Does what has waited until everything was heard: a ghost that was wanted during a replay, which may have ended
    /// by itself, and where something was asked for the numbers of the present frame.
    pub(super) fn settle(&mut self, was_asked: bool) {
        self.rebuild_ghost();
        if was_asked {
            self.motion.record_series();
        }
    }

    fn edit(&mut self, scene: Arc<Scene>) {
        // What only looks otherwise moves as it did.
        let moves_alike = !self.is_stale && self.scene.moves_like(&scene);
        if moves_alike {
            self.scene = scene;
        } else {
            self.change(scene);
        }
    }

    /// Puts another scene together, whatever it differs in; the motion goes on.
    pub(super) fn change(&mut self, scene: Arc<Scene>) {
        self.scene = scene;
        self.motion.continue_here();
        self.rebuild(true);
    }

    fn open(&mut self, scene: Arc<Scene>, assets: Arc<Assets>) {
        (self.scene, self.assets) = (scene, assets);
        self.is_new = true;
        self.motion.forget(Arc::clone(&self.scene));
        self.rebuild(false);
        self.motion.record_series();
    }

    fn reset(&mut self) {
        if self.is_stale {
            self.rebuild(false);
        } else {
            self.start_comparison();
            if !self.motion.restart() {
                self.rebuild(false);
            }
        }
        self.motion.record_series();
    }

    /// Puts the scene together. After an edit the motion goes on; where that fails or is stopped, what was there before
    /// does.
    fn rebuild(&mut self, keeps_motion: bool) {
        let scene = Arc::clone(&self.scene);
        self.is_stale = false;
        self.motion.status.stopped = false;
        match self.build(&scene) {
            Ok(Some(baked)) => {
                self.motion.take_up(scene, baked, keeps_motion && !self.is_new);
                self.is_new = false;
                self.start_comparison();
            }
            Ok(None) => self.note_stopped(),
            Err(problem) => self.motion.status.failure = Some(problem),
        }
    }

    /// The scene is not what was put together last.
    fn note_stopped(&mut self) {
        self.is_stale = true;
        // Where something newer made it pointless there is nothing to be said.
        self.motion.status.stopped = self.stop.is_asked();
    }

    /// Puts the ghost together if another one is wanted. While an earlier frame is shown it waits.
    fn rebuild_ghost(&mut self) {
        let Some(scene) = self.motion.replace_ghost() else { return };
        match self.build(&scene) {
            Ok(Some(baked)) => self.motion.runs.start_ghost(scene, Runner::new(baked)),
            Ok(None) if self.stop.is_asked() => self.motion.note_no_ghost("putting it together was stopped"),
            Ok(None) => {}
            Err(problem) => self.motion.note_no_ghost(&problem),
        }
    }

    fn start_comparison(&mut self) {
        let Some(chosen) = self.motion.comparison.replace() else { return };
        let (scene, assets) = (Arc::clone(&self.scene), self.models());
        match self.told(|tell| side_by_side(&scene, &assets, &chosen, tell)) {
            Ok(Some(runs)) => self.motion.compare(runs),
            Ok(None) => self.note_stopped(),
            Err(problem) => self.motion.status.failure = Some(problem),
        }
    }

    /// Bakes a scene with the document's models.
    fn build(&mut self, scene: &Scene) -> Result<Option<Baked>, String> {
        let assets = self.models();
        self.told(|tell| build(scene, &assets, tell))
    }

    /// The document's models, with those that came into it since it was opened.
    fn models(&self) -> Arc<Assets> {
        self.newest.get().unwrap_or_else(|| Arc::clone(&self.assets))
    }

    /// Shows what is being worked on, and ends it where it is no longer wanted.
    fn told<T>(&mut self, work: impl FnOnce(&mut Tell<'_>) -> T) -> T {
        let motion = &mut self.motion;
        let mut shown = Instant::now();
        let built = work(&mut |name, stage| {
            motion.status.baking = Some(format!("{name}: {stage}"));
            let mut is_news = false;
            while let Some(command) = self.early.next() {
                is_news = true;
                if matches!(command, SimCommand::Reset) {
                    motion.restart();
                } else {
                    motion.handle(&command);
                }
            }
            if is_news || shown.elapsed() > READABLE {
                shown = Instant::now();
                motion.publish();
            }
            if self.stop.is_set() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        motion.status.baking = None;
        built
    }
}
