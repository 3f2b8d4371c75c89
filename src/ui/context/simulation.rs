//! The running simulation as the window sees it: what it published last, and what is asked of it.

use super::OpenDocument;
use crate::scene::Scene;
use crate::sim::{Journal, JournalTail, MotionTaker, Published, SimCommand, TakenMotion, TimeSeriesSet, Worker};
use glam::DVec3;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};

/// A scene that runs beside the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ghost {
    /// The document without its fibres.
    WithoutFibres,
    /// The document before the last edit.
    BeforeEdit,
}

/// A point of a body that is grabbed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grabbed {
    /// Index of the body.
    pub body: usize,
    /// Vertex of its skin.
    pub vertex: usize,
    /// Depth of the plane in which it is moved, as the camera counts it [m].
    pub depth: f64,
    /// Where to [m].
    pub target: DVec3,
}

/// The thread that simulates, and the newest state that came from it.
pub(crate) struct Simulation {
    worker: Worker,
    published: Arc<Published>,
    /// Edits sent, to know whether what is shown is up to date.
    sent_edits: u64,
    /// Edits sent up to the document that was opened last, with it.
    opened: u64,
    /// What runs in place of the document.
    instead: Option<Arc<Scene>>,
    ghost: Option<Ghost>,
    grabbed: Option<Grabbed>,
}

impl Simulation {
    /// Starts to simulate a document; `notify` is called whenever there is a new state.
    pub(crate) fn start(document: &OpenDocument, notify: impl Fn() + Send + 'static) -> Self {
        let worker = Worker::start(Arc::clone(document.scene()), Arc::clone(document.assets()), true, notify);
        Self { worker, published: Arc::default(), sent_edits: 0, opened: 0, instead: None, ghost: None, grabbed: None }
    }

    /// The newest state.
    pub(crate) fn published(&self) -> &Arc<Published> {
        &self.published
    }

    /// Takes the newest state; gives the one before where there is a new one.
    pub(crate) fn take(&mut self) -> Option<Arc<Published>> {
        let newest = self.worker.take()?;
        Some(std::mem::replace(&mut self.published, newest))
    }

    /// The journal of the motion as it grows.
    pub(crate) fn journal_tail(&self) -> JournalTail {
        self.worker.journal_tail()
    }

    /// Ends the putting together of a scene that is going on just now.
    pub(crate) fn stop_building(&self) {
        self.worker.stop_building();
    }

    /// Asks for something.
    pub(crate) fn ask(&self, command: SimCommand) {
        self.worker.send(command);
    }

    /// Runs another scene of the same bodies in place of the document, until that is changed; or the document again.
    /// The motion goes on.
    pub(crate) fn show_instead(&mut self, scene: Option<Arc<Scene>>, document: &OpenDocument) {
        let shown = scene.as_ref().unwrap_or(document.scene());
        if self.worker.send(SimCommand::Edit(Arc::clone(shown))) {
            self.sent_edits += 1;
        }
        self.instead = scene;
    }

    /// Whether something else is shown than the document.
    pub(crate) fn shows_instead(&self) -> bool {
        self.instead.is_some()
    }

    /// Hands over the document after an edit: its motion goes on.
    pub(crate) fn edit(&mut self, document: &OpenDocument) {
        self.instead = None;
        if self.worker.send(SimCommand::Edit(Arc::clone(document.scene()))) {
            self.sent_edits += 1;
        }
        self.send_ghost(document);
    }

    /// Hands over the models of the document, with those that came into it.
    pub(crate) fn set_models(&self, document: &OpenDocument) {
        self.worker.set_models(Arc::clone(document.assets()));
    }

    /// Hands over another document, which begins anew.
    pub(crate) fn open(&mut self, document: &OpenDocument) {
        self.grabbed = None;
        self.instead = None;
        if self.worker.send(SimCommand::Open(Arc::clone(document.scene()), Arc::clone(document.assets()))) {
            self.sent_edits += 1;
            self.opened = self.sent_edits;
        }
        self.send_ghost(document);
    }

    /// Whether what is shown is of the document that was opened last.
    pub(crate) fn has_opened(&self) -> bool {
        self.published.status.edits >= self.opened
    }

    /// Whether what is shown has taken up every change of the document.
    pub(crate) fn is_up_to_date(&self) -> bool {
        self.published.status.edits >= self.sent_edits
    }

    /// What runs beside the document.
    pub(crate) fn ghost(&self) -> Option<Ghost> {
        self.ghost
    }

    /// Runs something else beside the document, or nothing. False where there is no such scene yet.
    pub(crate) fn choose_ghost(&mut self, ghost: Option<Ghost>, document: &OpenDocument) -> bool {
        self.ghost = ghost;
        let scene = self.ghost_scene(document);
        let is_there = ghost.is_none() || scene.is_some();
        self.ask(SimCommand::Ghost(scene));
        is_there
    }

    /// Tells the simulation what is to run beside the document as it is now.
    fn send_ghost(&self, document: &OpenDocument) {
        if self.ghost.is_some() {
            self.ask(SimCommand::Ghost(self.ghost_scene(document)));
        }
    }

    fn ghost_scene(&self, document: &OpenDocument) -> Option<Arc<Scene>> {
        match self.ghost? {
            Ghost::WithoutFibres => {
                let mut scene = (**self.instead.as_ref().unwrap_or(document.scene())).clone();
                for body in &mut scene.bodies {
                    body.fibres.clear();
                    body.sheets.clear();
                }
                Some(Arc::new(scene))
            }
            Ghost::BeforeEdit => {
                let before = document.editor.before_last()?;
                let Some(instead) = &self.instead else { return Some(Arc::clone(before)) };
                // In step with what is shown.
                let mut scene = (**before).clone();
                scene.time.frames_per_second = instead.time.frames_per_second;
                Some(Arc::new(scene))
            }
        }
    }

    /// Whether time runs.
    pub(crate) fn is_playing(&self) -> bool {
        self.published.status.playing
    }

    /// Whether integrators are compared in place of the scene's own motion.
    pub(crate) fn is_comparing(&self) -> bool {
        !self.published.compared.is_empty()
    }

    /// Whether an earlier frame is shown.
    pub(crate) fn is_replaying(&self) -> bool {
        self.published.status.recording.in_replay
    }

    /// Whether there are earlier frames to be seen.
    pub(crate) fn has_frames(&self) -> bool {
        !self.is_comparing() && self.published.status.recording.frames > 1
    }

    /// Asks for earlier frames; what was grabbed is let go.
    pub(crate) fn replay(&mut self, command: SimCommand) {
        self.grabbed = None;
        self.ask(command);
    }

    /// Asks for the first frame that is kept.
    pub(crate) fn show_first(&mut self) {
        if let Some([first, _]) = self.published.status.recording.span {
            self.replay(SimCommand::Show(first));
        }
    }

    /// Looks at the numbers of every frame since the start. The solver waits meanwhile: to be read, not to be worked
    /// with.
    pub(crate) fn time_series<T>(&self, read: impl FnOnce(&TimeSeriesSet) -> T) -> T {
        self.worker.time_series(read)
    }

    /// Asks for the motion as it is kept, to be written; it comes with the next frame, or once the scene is put
    /// together. None comes where that fails.
    pub(crate) fn take_motion(&self) -> Receiver<Option<TakenMotion>> {
        let (sender, receiver) = channel();
        self.ask(SimCommand::Take(MotionTaker(sender)));
        receiver
    }

    /// What was asked of the motion since its start.
    pub(crate) fn journal(&self) -> Journal {
        self.worker.journal()
    }

    /// Whether hands have led any shared drive since its start.
    pub(crate) fn was_performed(&self) -> bool {
        self.worker.was_performed()
    }

    /// What is grabbed by the pointer.
    pub(crate) fn grabbed(&self) -> Option<Grabbed> {
        self.grabbed
    }

    /// Grabs a point of a body, or nothing.
    pub(crate) fn grab(&mut self, grabbed: Option<Grabbed>) {
        self.grabbed = grabbed;
        if let Some(Grabbed { body, vertex, target, .. }) = grabbed {
            self.ask(SimCommand::Grab { body, vertex, target });
        }
    }

    /// Moves what is grabbed to a point [m].
    pub(crate) fn move_grab(&mut self, target: DVec3) {
        if let Some(grabbed) = self.grabbed.as_mut().filter(|grabbed| grabbed.target != target) {
            grabbed.target = target;
            self.ask(SimCommand::MoveGrab(target));
        }
    }

    /// Lets go of what is grabbed.
    pub(crate) fn release_grab(&mut self) {
        self.grabbed = None;
        self.ask(SimCommand::Release);
    }

    /// Leaves what is grabbed where it is held now.
    pub(crate) fn pin_grab(&mut self) {
        self.grabbed = None;
        self.ask(SimCommand::PinGrab);
    }
}
