//! Opening and saving the document.

use super::App;
use crate::io::{FileStamp, is_same, save_scene, scene_to_json};
use crate::ui::autosave::{Question, RecoveryOffer};
use crate::ui::bodies::{Layers, add_model, paste_body};
use crate::ui::colliders_section::add_mesh;
use crate::ui::context::{ActiveBody, OpenDocument, Severity};
use crate::ui::dialogs::{Dialog, PathPurpose};
use crate::ui::document::Document;
use crate::ui::follows_section::{add_follow, leader_of};
use crate::ui::gallery::Example;
use crate::ui::loading::{Loaded, Loading, Read, Source, Unread, opened};
use crate::ui::next::Next;
use crate::ui::placed::placed;
use crate::ui::report::report;
use std::path::{Path, PathBuf};

impl App {
    /// Opens a file, or the built-in scene, whatever becomes of the changes: [`Self::leave`] asks first.
    pub(super) fn open_document(&mut self, ctx: &egui::Context, path: Option<PathBuf>) {
        if let Some(path) = path {
            let outside = self.trusted.iter().any(|trusted| is_same(trusted, &path));
            return self.load(ctx, Source::File(path, outside));
        }
        match Document::load(None) {
            Ok(document) => {
                self.take_up(document, None, false);
                self.cx.say(Severity::Note, "Opened the soft bar".to_owned());
            }
            Err(error) => self.cx.say(Severity::Error, error.to_string()),
        }
    }

    /// Lets the scene of a file read models wherever they lie for as long as the window is open.
    pub(super) fn trust(&mut self, path: &Path) {
        if !self.trusted.iter().any(|trusted| is_same(trusted, path)) {
            self.trusted.push(path.to_owned());
        }
    }

    /// Opens a document that was left behind, as changed.
    pub(super) fn recover(&mut self, ctx: &egui::Context, offer: &RecoveryOffer) {
        self.load(ctx, Source::Recovery(offer.clone()));
    }

    /// Reads a model and adds a body in its shape to the scene.
    pub(super) fn add_body_of(&mut self, ctx: &egui::Context, path: PathBuf, layers: Layers) {
        self.load(ctx, Source::Model(path, layers));
    }

    /// Reads a model and adds it to the scene as something that bodies touch.
    pub(super) fn add_collider_of(&mut self, ctx: &egui::Context, path: PathBuf) {
        let folder = self.cx.document.folder.clone();
        self.load(ctx, Source::Collider { file: path, folder });
    }

    /// Reads a motion and has the active body follow it.
    pub(super) fn add_follow_of(&mut self, ctx: &egui::Context, path: &Path) {
        let folder = self.cx.document.folder.clone();
        if let Some(leader) = leader_of(&self.cx, path) {
            self.load(ctx, Source::Leader { file: path.to_owned(), leader, folder });
        }
    }

    /// Writes what somebody needs who looks for a fault.
    pub(super) fn report_to(&mut self, ctx: &egui::Context, path: PathBuf) {
        let report = report(path, &self.cx, self.views.adapter().as_deref());
        self.load(ctx, Source::Report(Box::new(report)));
    }

    /// Says that a report was written, without these, unless it was no longer wanted.
    fn reported(&mut self, source: &Source, missing: Option<&[String]>) {
        let (Some(path), Some(missing)) = (source.file(), missing) else { return };
        let (severity, without) = match missing {
            [] => (Severity::Note, String::new()),
            [one] => (Severity::Warning, format!(" without one file: {one}")),
            [first, ..] => (Severity::Warning, format!(" without {} files: {first}", missing.len())),
        };
        self.cx.say(severity, format!("Wrote {}{without}; send it with what you did and what you saw", path.display()));
    }

    /// Reads a document and takes it up; while that goes on, what is worked on stands over the window.
    pub(super) fn load(&mut self, ctx: &egui::Context, source: Source) {
        let loading = Loading::start(source, ctx);
        match loading.at_once() {
            Some(loaded) => self.loaded(&loading, loaded),
            None => self.dialog = Some(Dialog::Loading(loading)),
        }
    }

    /// Takes up what was read.
    pub(super) fn loaded(&mut self, loading: &Loading, loaded: Loaded) {
        let stamp = loading.stamp.clone();
        match (loaded, &loading.source) {
            (Ok(Read::Model { path, layers, opened }), _) => add_model(&path, *opened, layers, &mut self.cx),
            (Ok(Read::Collider { file, path, models }), _) => add_mesh(&mut self.cx, &file, path, models),
            (Ok(Read::Leader { leader, models }), _) => add_follow(&mut self.cx, leader, models),
            (Ok(Read::Body(brought)), _) => {
                paste_body(*brought, &mut self.cx);
                // Its models may ship from now on.
                self.autosave.placed(&self.cx.document);
            }
            (Ok(Read::Recording), Source::Recording(recording, path)) => {
                let (frames, file) = (recording.frames, path.display());
                self.autosave.saved_recording(recording);
                let said = format!("Wrote {frames} frames as {file}; `sinew replay` makes them again");
                self.cx.say(Severity::Note, said);
            }
            (Ok(Read::Recording), _) => {}
            (Ok(Read::Report(missing)), source) => self.reported(source, missing.as_deref()),
            (Ok(Read::Document(document)), Source::Recovery(offer)) => {
                self.take_up(*document, stamp, offer.document.origin.shipped);
                self.cx.document.mark_unsaved();
                self.autosave.recovered(offer, &self.cx.document);
                self.cx.say(Severity::Note, format!("Recovered {}; save it to keep it", offer.name()));
            }
            (Ok(Read::Document(document)), source) => {
                let said = source.file().map(|path| {
                    self.recent.add(path);
                    opened(&document, path)
                });
                self.take_up(*document, stamp, false);
                self.cx.say(Severity::Note, said.unwrap_or_default());
            }
            (Err(Unread::Outside(files)), source) => {
                if let Some(path) = source.file() {
                    self.dialog = Some(Dialog::Question(Question::Outside { path: path.to_owned(), files }));
                }
            }
            (Err(Unread::Problem(problem)), Source::Recovery(offer)) => {
                self.cx.say(Severity::Error, format!("{} cannot be recovered: {problem}", offer.name()));
            }
            (Err(Unread::Problem(problem)), _) => self.cx.say(Severity::Error, problem),
        }
    }

    /// Opens a scene with nothing in it but a floor.
    pub(super) fn open_empty(&mut self) {
        self.take_up(Document::empty(), None, false);
        self.cx.say(
            Severity::Note,
            "Nothing but a floor: the menu Body adds bodies, and so does a model that is dropped here",
        );
    }

    /// Opens an example as a document without a file.
    pub(super) fn open_example(&mut self, example: &Example) {
        match Document::of_example(example) {
            Ok(document) => {
                let said = document.note.clone().unwrap_or_default();
                self.take_up(document, None, true);
                self.cx.say(Severity::Note, said);
            }
            Err(error) => self.cx.say(Severity::Error, error.to_string()),
        }
    }

    /// Shows another document; the models of one that `ships` come with the program.
    fn take_up(&mut self, document: Document, stamp: Option<FileStamp>, ships: bool) {
        self.cx.document = OpenDocument::new(document);
        self.cx.document.is_example = ships;
        // Nothing of the last document stands for this one until it is put together.
        self.cx.active = ActiveBody::default();
        self.cx.forget_selection();
        self.cx.status.drawn_fibre = None;
        self.views.forget_gestures();
        self.views.options.forget_slice();
        self.patterns.forget_region();
        self.autosave.watch(stamp);
        self.autosave.opened(&self.cx.document);
        self.cx.simulation.open(&self.cx.document);
        self.views.reframe(false);
    }

    /// Saves to the document's file, or asks for one, and goes on.
    pub(super) fn save_then(&mut self, ctx: &egui::Context, next: Option<Next>) {
        match self.cx.document.path.clone() {
            Some(path) => self.save_to(ctx, path, next),
            None => self.ask_where(next),
        }
    }

    /// Asks for the file to save to before it goes on.
    pub(super) fn ask_where(&mut self, next: Option<Next>) {
        self.dialog = Some(Dialog::path(PathPurpose::Save, self.cx.document.path.as_deref()).then(next));
    }

    /// Saves to a file and goes on, after asking where that would lose what the file holds.
    pub(super) fn save_to(&mut self, ctx: &egui::Context, path: PathBuf, next: Option<Next>) {
        match self.autosave.loss(&path, self.cx.document.path.as_deref()) {
            Some(loss) => self.dialog = Some(Dialog::Question(Question::Replace { path, loss, next })),
            None => self.write_then(ctx, &path, next),
        }
    }

    /// Saves to a file, whatever it holds, and goes on unless that fails.
    pub(super) fn write_then(&mut self, ctx: &egui::Context, path: &Path, next: Option<Next>) {
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let document = &self.cx.document;
        // Models that came with the program are put beside the scene, others stay where they are.
        let scene = placed(document.scene(), &document.folder, document.is_example, &folder);
        match scene.and_then(|scene| save_scene(path, &scene).map(|()| scene)) {
            Ok(scene) => {
                self.cx.document.mark_saved();
                self.cx.document.path = Some(path.to_owned());
                // What it names it has read here.
                self.trust(path);
                self.autosave.watch(Some(FileStamp::of_written(path, scene_to_json(&scene).as_bytes())));
                self.autosave.note(&self.cx.document);
                self.autosave.placed(&self.cx.document);
                self.recent.add(path);
                self.cx.say(Severity::Note, format!("Saved {}", path.display()));
                if let Some(next) = next {
                    self.go_on(ctx, next);
                }
            }
            Err(error) => self.cx.say(Severity::Error, error.to_string()),
        }
    }
}
