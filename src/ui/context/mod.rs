//! What every panel and tool of the window is given: the document, the newest published state, what is selected, the
//! theme, and the ways to ask for something.
//!
//! How it works. A panel owns what it alone needs and is shown with a [`Context`]. What it changes of the document goes
//! through [`Context::edit`], what it asks of the simulation through [`Context::ask`]: both take effect at once. What
//! concerns other panels is left as a [`Request`], which the window carries out as soon as the panel has been shown.
//!
//! Why not otherwise. Panels that can reach each other end in an object that knows everything; edits that wait for the
//! end of the frame would let a tool go on from a document that is not there any more.

mod active;
mod chosen_keys;
mod document;
mod gestures;
mod lifts;
mod preview;
mod queries;
mod request;
mod selection;
mod simulation;
mod status;

pub(crate) use active::ActiveBody;
pub(crate) use chosen_keys::ChosenKeys;
pub(crate) use document::OpenDocument;
pub(crate) use gestures::{Gestures, Step};
pub(crate) use lifts::{Lift, Lifts};
pub(crate) use preview::PatternPreview;
pub(crate) use request::Request;
pub(crate) use selection::{ChosenPin, Selection};
pub(crate) use simulation::{Ghost, Grabbed, Simulation};
pub(crate) use status::{EffectNote, Severity, StatusLine};

use super::action::ActionStates;
use super::navigation::Navigation;
use super::theme::Tone;
use crate::edit::Command;
use crate::scene::{Assets, Drivable, Drive, Scene};
use crate::sim::SimCommand;
use crate::solver::snapshot::Snapshot;
use std::collections::VecDeque;
use std::convert::Infallible;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// So much of what was said is kept.
const LOG: usize = 500;

/// What panels and tools share.
pub(super) struct Context {
    /// The open document.
    pub document: OpenDocument,
    /// The running simulation.
    pub simulation: Simulation,
    /// The body that is drawn into and whose properties are shown.
    pub active: ActiveBody,
    /// What of it is selected.
    pub selection: Selection,
    /// The selected keys of drives.
    pub keys: ChosenKeys,
    /// What a drive can move whose field is under the pointer.
    pub pointed: Option<Drivable>,
    /// Light or dark.
    pub tone: Tone,
    /// Whose gestures move the cameras.
    pub navigation: Navigation,
    /// What is said at the foot of the window.
    pub status: StatusLine,
    /// Which actions can be asked for in this frame, and which switches are on.
    pub actions: ActionStates,
    /// The pattern that is chosen, before it is there.
    pub pattern: PatternPreview,
    /// The bodies as they would be placed, while one is moved, in place of the simulation.
    pub placed: Option<Arc<Snapshot>>,
    /// Whether something is open over the window.
    pub has_dialog: bool,
    /// What is said in the result view about what is seen there.
    pub caption: Option<&'static str>,
    /// What is said at a body about what the last change does to it.
    pub effect: Option<EffectNote>,
    /// Whether the ghost is shown beside the scene, not within it.
    pub ghost_beside: bool,
    log: VecDeque<String>,
    begun: Instant,
    lifts: Lifts,
    gestures: Gestures,
    requests: VecDeque<Request>,
}

impl Context {
    /// The context of a window in which nothing has happened yet.
    pub(super) fn new(document: OpenDocument, simulation: Simulation, tone: Tone) -> Self {
        Self {
            document,
            simulation,
            active: ActiveBody::default(),
            selection: Selection::default(),
            keys: ChosenKeys::default(),
            pointed: None,
            tone,
            navigation: Navigation::default(),
            status: StatusLine::default(),
            actions: ActionStates::default(),
            pattern: PatternPreview::default(),
            placed: None,
            has_dialog: false,
            caption: None,
            effect: None,
            ghost_beside: false,
            log: VecDeque::new(),
            begun: Instant::now(),
            lifts: Lifts::default(),
            gestures: Gestures::default(),
            requests: VecDeque::new(),
        }
    }

    /// The document as it is now.
    pub(super) fn scene(&self) -> &Arc<Scene> {
        self.document.scene()
    }

    /// Says something at the foot of the window.
    pub(super) fn say(&mut self, severity: Severity, text: impl Into<String>) {
        let text = text.into();
        if self.log.len() == LOG {
            self.log.pop_front();
        }
        self.log.push_back(format!("{:9.2} s {severity:?}: {text}", self.begun.elapsed().as_secs_f64()));
        self.status.message = Some((severity, text));
        self.status.of_scene = false;
    }

    /// What was said so far, the newest last, with when that was.
    pub(super) fn log(&self) -> impl Iterator<Item = &str> {
        self.log.iter().map(String::as_str)
    }

    /// Says something that is true as long as the scene is what it is.
    pub(super) fn say_of_scene(&mut self, severity: Severity, text: impl Into<String>) {
        self.say(severity, text);
        self.status.of_scene = true;
    }

    /// Asks something of the simulation.
    pub(super) fn ask(&self, command: SimCommand) {
        self.simulation.ask(command);
    }

    /// Asks for something that concerns other panels.
    pub(super) fn request(&mut self, request: Request) {
        self.requests.push_back(request);
    }

    /// What was asked for first and is not carried out yet.
    pub(super) fn next_request(&mut self) -> Option<Request> {
        self.requests.pop_front()
    }

    /// Puts models in by what lies in the document's folder, for the simulation too; none where that fails.
    pub(super) fn add_models<T, E>(&mut self, change: impl FnOnce(&mut Assets, &Path) -> Result<T, E>) -> Result<T, E> {
        let made = self.document.change_assets(change)?;
        self.simulation.set_models(&self.document);
        Ok(made)
    }

    /// Takes models into the document that were read elsewhere.
    pub(super) fn take_in_models(&mut self, read: Assets) {
        let Ok(()) = self.add_models(|assets, _| {
            assets.take_in(read);
            Ok::<(), Infallible>(())
        });
    }

    /// Changes the document; changes of one gesture are one step of undo.
    pub(super) fn edit(&mut self, command: &Command, step: Step) {
        let gesture = match step {
            Step::Own => self.gestures.begin(),
            Step::Present => self.gestures.present(),
            Step::Of(gesture) => gesture,
        };
        let before = Arc::clone(self.scene());
        let active = self.active_id();
        match self.document.editor.apply_in(command, Some(gesture)) {
            Ok(()) if Arc::ptr_eq(&before, self.scene()) => {}
            Ok(()) => self.hand_over(active),
            Err(error) => self.say(Severity::Error, error.to_string()),
        }
        if step == Step::Own {
            // What is dragged next is another step.
            self.gestures.begin();
        }
    }

    /// Draws into another body from now on.
    pub(super) fn activate(&mut self, index: usize) {
        self.active.index = index;
        self.take_model();
        self.forget_selection();
    }

    /// Takes over how the active body looks at rest, once the simulation has put it together.
    pub(super) fn take_model(&mut self) {
        self.active.take_model(self.simulation.published());
    }

    /// Nothing is selected any more: another body or document is drawn into.
    pub(super) fn forget_selection(&mut self) {
        self.selection = Selection::default();
        self.keys.clear();
        self.lifts.clear();
    }

    /// Begins a gesture: what is changed from now on is another step of undo. Gives its number.
    pub(super) fn begin_gesture(&mut self) -> u64 {
        self.gestures.begin()
    }

    /// Gives a gesture up: the document is as it was before it.
    pub(super) fn abandon(&mut self, gesture: u64) {
        let active = self.active_id();
        if self.document.editor.abandon(gesture) {
            self.hand_over(active);
        }
    }

    /// Takes the last change back.
    pub(super) fn undo(&mut self) {
        let active = self.active_id();
        if self.document.editor.undo() {
            self.hand_over(active);
        }
    }

    /// Makes the last change that was taken back again.
    pub(super) fn redo(&mut self) {
        let active = self.active_id();
        if self.document.editor.redo() {
            self.hand_over(active);
        }
    }

    /// The active body's identifier.
    fn active_id(&self) -> Option<String> {
        self.scene().any_body(self.active.index).map(|body| body.id().to_owned())
    }

    /// Gives the present document to the simulation, which goes on from its present motion. The body that was active
    /// stays that under its new number; where it is gone, another one is.
    fn hand_over(&mut self, active: Option<String>) {
        let place = active.and_then(|id| self.scene().all_bodies().position(|body| body.id() == id));
        if place != Some(self.active.index) {
            let last = self.scene().all_bodies().count().saturating_sub(1);
            self.active.index = place.unwrap_or(self.active.index.min(last));
            if place.is_none() {
                self.forget_selection();
            }
        }
        self.forget_what_is_gone();
        let scene = Arc::clone(self.scene());
        self.keys.keep(|of| match of.drive(&scene) {
            Some(Drive::Keyframes(keys)) => keys.keys.len(),
            _ => 0,
        });
        self.simulation.edit(&self.document);
    }
}
