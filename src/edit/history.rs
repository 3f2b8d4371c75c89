//! The open document and its history.

use super::Command;
use crate::scene::{Scene, SceneError};
use std::sync::Arc;
use thiserror::Error;

/// A change that cannot be made; the document is as it was.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum EditError {
    /// What the change refers to is not there.
    #[error("{0}")]
    Missing(String),
    /// The document would hold a value that cannot be used.
    #[error(transparent)]
    Invalid(#[from] SceneError),
}

/// A step of the history: what it is called and the document before it (undo) or after it (redo).
#[derive(Clone, Debug)]
struct HistoryEntry {
    name: String,
    scene: Arc<Scene>,
    gesture: Option<u64>,
}

/// Steps that are kept.
const DEPTH: usize = 500;

/// An open document: the only way to change it is a [`Command`].
#[derive(Clone, Debug)]
pub struct Editor {
    scene: Arc<Scene>,
    /// What its file holds; none where that is something else, or there is no file.
    saved: Option<Arc<Scene>>,
    undo: Vec<HistoryEntry>,
    redo: Vec<HistoryEntry>,
    /// What could be done again before the gesture that made the last change, in case that is given up.
    lost: Vec<HistoryEntry>,
}

impl Editor {
    /// Opens a document.
    pub fn new(scene: Scene) -> Self {
        let scene = Arc::new(scene);
        Self { saved: Some(Arc::clone(&scene)), scene, undo: Vec::new(), redo: Vec::new(), lost: Vec::new() }
    }

    /// The document.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Makes a change. A change that leaves the document as it was is no step.
    ///
    /// # Errors
    /// What the change refers to is missing, or the document would not validate; it is as it was then.
    pub fn apply(&mut self, command: &Command) -> Result<(), EditError> {
        self.apply_in(command, None)
    }

    /// Makes a change as part of a gesture: all changes of one gesture, such as one drag of a slider, are one step.
    ///
    /// # Errors
    /// As [`Self::apply`].
    pub fn apply_in(&mut self, command: &Command, gesture: Option<u64>) -> Result<(), EditError> {
        let mut scene = (*self.scene).clone();
        command.apply(&mut scene).map_err(EditError::Missing)?;
        scene.validate()?;
        if scene == *self.scene {
            return Ok(());
        }
        let before = std::mem::replace(&mut self.scene, Arc::new(scene));
        let lost = std::mem::take(&mut self.redo);
        let name = command.name();
        if self.undo.last().is_some_and(|step| gesture.is_some() && step.gesture == gesture && step.name == name) {
            return Ok(());
        }
        self.lost = lost;
        self.undo.push(HistoryEntry { name, scene: before, gesture });
        if self.undo.len() > DEPTH {
            self.undo.remove(0);
        }
        Ok(())
    }

    /// Gives up a gesture that is still the last thing that happened: the document is what it was before it, and what
    /// could be done again then still can. False if it changed nothing.
    pub fn abandon(&mut self, gesture: u64) -> bool {
        let Some(step) = self.undo.pop_if(|step| step.gesture == Some(gesture)) else { return false };
        self.scene = step.scene;
        self.redo = std::mem::take(&mut self.lost);
        true
    }

    /// What undo would take back.
    pub fn undo_name(&self) -> Option<&str> {
        self.undo.last().map(|step| step.name.as_str())
    }

    /// The document before the last change; none where nothing was changed.
    pub fn before_last(&self) -> Option<&Arc<Scene>> {
        self.undo.last().map(|step| &step.scene)
    }

    /// What redo would do again.
    pub fn redo_name(&self) -> Option<&str> {
        self.redo.last().map(|step| step.name.as_str())
    }

    /// Takes the last change back; false if there is none.
    pub fn undo(&mut self) -> bool {
        let Some(step) = self.undo.pop() else { return false };
        let after = std::mem::replace(&mut self.scene, Arc::clone(&step.scene));
        self.redo.push(HistoryEntry { scene: after, gesture: None, ..step });
        true
    }

    /// Makes the last change that was taken back again; false if there is none.
    pub fn redo(&mut self) -> bool {
        let Some(step) = self.redo.pop() else { return false };
        let before = std::mem::replace(&mut self.scene, Arc::clone(&step.scene));
        self.undo.push(HistoryEntry { scene: before, gesture: None, ..step });
        true
    }

    /// Whether there are changes since the document was opened or saved.
    pub fn is_changed(&self) -> bool {
        let is_saved = |saved: &Arc<Scene>| Arc::ptr_eq(&self.scene, saved) || self.scene == *saved;
        !self.saved.as_ref().is_some_and(is_saved)
    }

    /// Remembers the present document as the saved one. The history stays.
    pub fn mark_saved(&mut self) {
        self.saved = Some(Arc::clone(&self.scene));
    }

    /// Remembers that no file holds the document, whatever becomes of it until it is saved: it was recovered, or its
    /// file was changed or removed by another program.
    pub fn mark_unsaved(&mut self) {
        self.saved = None;
    }
}
