//! Opening and saving the document.

use super::app::{App, Gravity};
use super::dialogs::{Dialog, PathPurpose};
use super::document::{Document, moved};
use super::editing::Editing;
use super::gallery::{Example, shipped_assets};
use super::sketch_tool::SketchTool;
use super::trust::{Left, Next, Question};
use crate::edit::Editor;
use crate::io::{FileStamp, IoError, Origin, is_model, load_assets, save_scene};
use crate::sim::SimCommand;
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl App {
    /// Opens a file, or the built-in scene, whatever becomes of the changes: [`Self::leave`] asks first.
    pub(super) fn open_document(&mut self, path: Option<PathBuf>) {
        // Before it is read: what is written in between is found later then.
        let stamp = path.as_deref().filter(|path| !is_model(path)).and_then(|path| FileStamp::of(path).ok());
        match Document::load(path.clone()) {
            Ok(document) => {
                if let Some(path) = &path {
                    self.note_recent(path);
                }
                let name = path.map_or_else(|| "the soft bar".to_owned(), |path| path.display().to_string());
                let said = document.note.clone().unwrap_or_else(|| format!("Opened {name}"));
                self.take_up(document, stamp);
                self.say(Gravity::Note, said);
            }
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    /// Opens an example as a document without a file.
    pub(super) fn open_example(&mut self, example: &Example) {
        match Document::of_example(example) {
            Ok(document) => {
                let said = document.note.clone().unwrap_or_default();
                self.take_up(document, None);
                self.gallery.shipped = true;
                self.say(Gravity::Note, said);
            }
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    /// Opens a document that was left behind, as changed.
    pub(super) fn recover(&mut self, left: &Left) {
        let load = || {
            let scene = left.what.load()?;
            let Origin { folder, shipped, .. } = &left.what.origin;
            let assets = if *shipped { shipped_assets(&scene) } else { load_assets(&scene, folder, &mut |_| {}) };
            Ok((scene, Arc::new(assets?)))
        };
        match load() {
            Ok((scene, assets)) => {
                let origin = left.what.origin.clone();
                let said = format!("Recovered {}; save it to keep it", left.name());
                // What the file became since then is not known to be what the document grew from.
                let known = !left.is_older && !origin.doubtful;
                let stamp = origin.file.as_deref().filter(|_| known).and_then(|file| FileStamp::of(file).ok());
                self.take_up(Document { scene, assets, path: origin.file, folder: origin.folder, note: None }, stamp);
                self.gallery.shipped = origin.shipped;
                self.editor.mark_unsaved();
                self.recovered(left);
                self.say(Gravity::Note, said);
            }
            Err(error) => {
                let error: IoError = error;
                self.say(Gravity::Error, format!("{} cannot be recovered: {error}", left.name()));
            }
        }
    }

    /// Shows another document.
    fn take_up(&mut self, document: Document, stamp: Option<FileStamp>) {
        let Document { scene, assets, path, folder, .. } = document;
        self.editor = Editor::new(scene);
        self.path = path;
        self.folder = folder;
        self.assets = assets;
        // Nothing of the last document stands for this one until it is put together.
        self.model = Arc::default();
        self.display.slice = None;
        self.gallery.shipped = false;
        self.gallery.forget_welcome();
        self.patterns.forget_region();
        self.trust.watch(stamp);
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
    }

    /// Saves to the document's file, or asks for one, and goes on.
    pub(super) fn save_then(&mut self, ctx: &egui::Context, next: Option<Next>) {
        match self.path.clone() {
            Some(path) => self.save_to(ctx, path, next),
            None => self.ask_where(next),
        }
    }

    /// Asks for the file to save to before it goes on.
    pub(super) fn ask_where(&mut self, next: Option<Next>) {
        self.dialog = Some(Dialog::path(PathPurpose::Save, self.path.as_deref()).then(next));
    }

    /// Saves to a file and goes on, after asking where that would lose what the file holds.
    pub(super) fn save_to(&mut self, ctx: &egui::Context, path: PathBuf, next: Option<Next>) {
        match self.trust.loss(&path, self.path.as_deref()) {
            Some(loss) => self.dialog = Some(Dialog::Question(Question::Replace { path, loss, next })),
            None => self.write_then(ctx, &path, next),
        }
    }

    /// Saves to a file, whatever it holds, and goes on unless that fails.
    pub(super) fn write_then(&mut self, ctx: &egui::Context, path: &Path, next: Option<Next>) {
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
                self.trust.watch(FileStamp::of(path).ok());
                self.note_document();
                self.note_recent(path);
                self.say(Gravity::Note, format!("Saved {}", path.display()));
                if let Some(next) = next {
                    self.go_on(ctx, next);
                }
            }
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }
}
