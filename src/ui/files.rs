//! Opening and saving the document.

use super::app::{App, Gravity};
use super::document::{Document, moved};
use super::editing::Editing;
use super::sketch_tool::SketchTool;
use crate::edit::Editor;
use crate::io::{IoError, save_scene};
use crate::sim::SimCommand;
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl App {
    /// Opens a file, or the built-in scene.
    pub(super) fn open_document(&mut self, path: Option<PathBuf>) {
        self.take_document(Document::load(path));
    }

    /// Shows a document that was read, or says why it could not be.
    pub(super) fn take_document(&mut self, read: Result<Document, IoError>) {
        match read {
            Ok(Document { scene, assets, path, folder, note }) => {
                self.editor = Editor::new(scene);
                self.path = path;
                self.folder = folder;
                self.assets = assets;
                self.gallery.shipped = false;
                self.patterns.forget_region();
                self.editing = Editing::default();
                self.tool = SketchTool::default();
                self.pull = None;
                if self.worker.send(SimCommand::Open(Arc::clone(self.editor.scene()), Arc::clone(&self.assets))) {
                    self.sent_edits += 1;
                }
                self.ask_for_ghost();
                self.active = 0;
                self.drawn_last = None;
                self.reframe(false);
                let name =
                    self.path.as_ref().map_or_else(|| "the soft bar".to_owned(), |path| path.display().to_string());
                self.say(Gravity::Note, note.unwrap_or_else(|| format!("Opened {name}")));
            }
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    /// Opens a file.
    pub fn open(&mut self, path: &Path) {
        self.open_document(Some(path.to_owned()));
    }

    /// Saves to a file.
    pub fn save(&mut self, path: &Path) {
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        // Models that came with the program are put beside the scene, others stay where they are.
        let scene = if self.gallery.shipped {
            self.with_models_in(&folder)
        } else {
            Ok(moved(self.editor.scene(), &self.folder, &folder))
        };
        match scene.and_then(|scene| save_scene(path, &scene)) {
            Ok(()) => {
                self.editor.mark_saved();
                self.path = Some(path.to_owned());
                self.say(Gravity::Note, format!("Saved {}", path.display()));
            }
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }
}
