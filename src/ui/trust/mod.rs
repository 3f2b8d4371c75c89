//! Nothing is lost: changes are saved or given up only when that is asked for, a document outlives the program, and what
//! other programs do to its file is noticed.

mod ask;
mod keeper;
mod recent;

pub(super) use ask::{About, ask};
pub use ask::{Question, Reply};
pub use keeper::Left;
pub(super) use recent::choose_recent;

use super::app::{App, Gravity};
use super::dialogs::Dialog;
use super::gallery::Example;
use crate::io::{FileStamp, FileState, Origin, RecentFiles};
use crate::scene::Scene;
use egui::{Context, Event, ViewportCommand};
use keeper::{Errand, Keeper, Report};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a person goes on to when nothing is lost by it.
#[derive(Clone, Debug)]
pub enum Next {
    /// The built-in scene.
    New,
    /// A file.
    Open(PathBuf),
    /// A scene that ships.
    Example(&'static Example),
    /// A document that was left behind.
    Recover(Left),
    /// The end of the program.
    Quit,
}

/// What is known of the document's file and of what may be lost.
pub(super) struct Trust {
    keeper: Keeper,
    /// The document's file as it was when it was read or saved; none where it may hold anything.
    stamp: Option<FileStamp>,
    /// Number under which the file is watched.
    watch: u64,
    /// The document of which the keeper knows.
    seen: Arc<Scene>,
    /// Documents that were left behind and are still offered.
    left: Vec<Left>,
    /// What is asked, one after the other, as soon as the person's hands are free.
    waiting: Vec<Question>,
    recent: RecentFiles,
    /// Whether the window may close with changes.
    is_leaving: bool,
}

/// Why a file is not simply written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    /// Another program wrote it since it was read.
    Changed,
    /// It is another file than the document's.
    Other,
    /// A table is to be written there.
    Table,
}

impl Trust {
    /// Looks after a document, just read, that `path` belongs to.
    pub fn start(ctx: &Context, path: Option<&Path>, scene: &Arc<Scene>) -> Self {
        let repaint = ctx.clone();
        let keeper = Keeper::start(move || repaint.request_repaint());
        let mut trust = Self {
            keeper,
            stamp: None,
            watch: 0,
            seen: Arc::clone(scene),
            left: Vec::new(),
            waiting: Vec::new(),
            recent: RecentFiles::default(),
            is_leaving: false,
        };
        if let Some(path) = path {
            trust.recent.add(path);
        }
        trust.watch(path.and_then(|path| FileStamp::of(path).ok()));
        // The window may have taken its time to open.
        trust.keeper.send(Errand::Compare(Arc::clone(scene)));
        trust
    }

    /// The document's file is another one, or was read or written anew.
    pub fn watch(&mut self, stamp: Option<FileStamp>) {
        self.watch += 1;
        self.stamp.clone_from(&stamp);
        self.waiting.retain(|question| !matches!(question, Question::Reload { .. }));
        self.keeper.send(Errand::Watch(self.watch, stamp));
    }

    /// What would be lost by writing to `path`, where the document belongs to `own`; none if nothing would.
    pub fn loss(&self, path: &Path, own: Option<&Path>) -> Option<Loss> {
        if !path.exists() {
            return None;
        }
        let is_own = own.is_some_and(|own| own == path || whole(own).is_some_and(|own| whole(path) == Some(own)));
        match &self.stamp {
            _ if !is_own => Some(Loss::Other),
            Some(stamp) if stamp.state() == FileState::Same => None,
            _ => Some(Loss::Changed),
        }
    }

    /// Documents that were left behind.
    pub fn left(&self) -> &[Left] {
        &self.left
    }

    /// Files that were used, the last one first.
    pub fn recent(&self) -> &[PathBuf] {
        self.recent.paths()
    }
}

fn whole(path: &Path) -> Option<PathBuf> {
    path.canonicalize().ok()
}

/// The name of a file, for sentences.
fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

impl App {
    /// Keeps changed documents in a folder, from which they are recovered when the program ended without asking; without
    /// one nothing is kept.
    #[must_use]
    pub fn with_recovery(self, folder: impl Into<PathBuf>) -> Self {
        self.trust.keeper.send(Errand::Folder(folder.into()));
        self
    }

    /// The document's name.
    pub(super) fn document_name(&self) -> &str {
        if self.scene().name.is_empty() { "Untitled" } else { &self.scene().name }
    }

    /// Goes on to something else, after asking where that would lose changes.
    pub(super) fn leave(&mut self, ctx: &Context, next: Next) {
        if self.editor.is_changed() {
            self.dialog = Some(Dialog::Question(Question::Unsaved(next)));
        } else {
            self.go_on(ctx, next);
        }
    }

    /// Goes on to something else, whatever becomes of the changes.
    pub(super) fn go_on(&mut self, ctx: &Context, next: Next) {
        match next {
            Next::New => self.open_document(None),
            Next::Open(path) => self.open_document(Some(path)),
            Next::Example(example) => self.open_example(example),
            Next::Recover(left) => self.recover(&left),
            Next::Quit => {
                self.trust.is_leaving = true;
                self.trust.keeper.forget();
                ctx.send_viewport_cmd(ViewportCommand::Close);
            }
        }
    }

    /// Takes the scene as its file holds it, after asking where that would lose changes.
    pub(super) fn reload(&mut self) {
        let Some(path) = self.path.clone() else { return };
        if self.editor.is_changed() {
            self.dialog = Some(Dialog::Question(Question::Reload { path, is_asked: true, is_changed: true }));
        } else {
            self.open_document(Some(path));
        }
    }

    /// The document is now a recovered one: it is kept here before it is dropped there.
    pub(super) fn recovered(&mut self, left: &Left) {
        self.trust.left.retain(|other| other.what != left.what);
        self.note_document();
        self.trust.keeper.send(Errand::Recovered(left.what.clone()));
        self.trust.keeper.send(Errand::Hurry);
    }

    /// Tells the keeper what the document is now.
    pub(super) fn note_document(&mut self) {
        self.trust.seen = Arc::clone(self.editor.scene());
        if self.editor.is_changed() {
            let origin = Origin {
                file: self.path.clone(),
                folder: self.folder.clone(),
                doubtful: self.trust.stamp.is_none(),
                shipped: self.gallery.shipped,
            };
            self.trust.keeper.keep(origin, Arc::clone(self.editor.scene()));
        } else {
            self.trust.keeper.forget();
        }
    }

    /// What is to be looked after whether or not the window is shown.
    pub(super) fn look_after(&mut self, ctx: &Context) {
        while let Some(report) = self.trust.keeper.report() {
            self.hear(report);
        }
        if !Arc::ptr_eq(&self.trust.seen, self.editor.scene()) {
            self.trust.is_leaving = false;
            self.note_document();
        }
        if ctx.input(|input| input.events.contains(&Event::WindowFocused(true))) {
            self.trust.keeper.send(Errand::Look);
        }
        if ctx.input(|input| input.events.contains(&Event::WindowFocused(false))) {
            self.trust.keeper.send(Errand::Hurry);
        }
        if ctx.input(|input| input.viewport().close_requested()) && !self.trust.is_leaving && self.editor.is_changed() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            if ctx.input(|input| input.viewport().visible()) == Some(false) {
                ctx.send_viewport_cmd(ViewportCommand::Minimized(false));
                ctx.send_viewport_cmd(ViewportCommand::Focus);
            }
            self.leave(ctx, Next::Quit);
        }
        self.ask_what_waits(ctx);
    }

    fn hear(&mut self, report: Report) {
        match report {
            Report::Left(left) => {
                if !left.is_empty() {
                    self.trust.waiting.push(Question::Recover);
                }
                self.trust.left = left;
            }
            Report::NotKept(error) => {
                let said = format!("Changes are not kept for recovery, save often: {error}");
                self.say(Gravity::Warning, said);
            }
            Report::File(number, _) if number != self.trust.watch => {}
            Report::File(_, FileState::Same) => {}
            Report::File(_, FileState::Changed) => {
                // Saving asks from now on.
                self.trust.stamp = None;
                let Some(path) = self.path.clone() else { return };
                self.trust.waiting.retain(|question| !matches!(question, Question::Reload { .. }));
                self.trust.waiting.push(Question::Reload { path, is_asked: false, is_changed: false });
            }
            Report::File(_, FileState::Missing) => {
                self.editor.mark_unsaved();
                self.note_document();
                if let Some(path) = &self.path {
                    let said = format!("{} is no longer there; saving writes it anew", path.display());
                    self.say(Gravity::Warning, said);
                }
            }
        }
    }

    /// Asks what nobody waits for, once nothing else is going on.
    fn ask_what_waits(&mut self, ctx: &Context) {
        let is_busy = self.dialog.is_some()
            || self.editing.has_gesture()
            || ctx.egui_wants_keyboard_input()
            || ctx.input(|input| input.pointer.any_down());
        if is_busy || self.trust.waiting.is_empty() {
            return;
        }
        let mut question = self.trust.waiting.remove(0);
        if let Question::Reload { is_changed, .. } = &mut question {
            *is_changed = self.editor.is_changed();
            // The file holds something else now, whatever is answered.
            self.editor.mark_unsaved();
            self.note_document();
        }
        self.dialog = Some(Dialog::Question(question));
    }

    /// Does what a question was answered by.
    pub(super) fn replied(&mut self, ctx: &Context, question: Question, reply: Reply) {
        match (question, reply) {
            (Question::Unsaved(next), Reply::Save) => self.save_then(ctx, Some(next)),
            (Question::Unsaved(next), Reply::Discard) => self.go_on(ctx, next),
            (Question::Replace { path, loss: Loss::Table, .. }, Reply::Replace) => self.export(&path),
            (Question::Replace { loss: Loss::Table, .. }, Reply::SaveElsewhere) => self.ask_where_to_export(),
            (Question::Replace { path, next, .. }, Reply::Replace) => self.write_then(ctx, &path, next),
            (Question::Replace { next, .. }, Reply::SaveElsewhere) => self.ask_where(next),
            (Question::Reload { path, .. }, Reply::Reload) => self.open_document(Some(path)),
            (Question::Recover, Reply::Recover(k)) => {
                if let Some(left) = self.trust.left.get(k).cloned() {
                    self.leave(ctx, Next::Recover(left));
                }
            }
            (Question::Recover, Reply::Forget(k)) => {
                if k < self.trust.left.len() {
                    match self.trust.left[k].what.discard() {
                        Ok(()) => drop(self.trust.left.remove(k)),
                        Err(error) => self.say(Gravity::Error, error.to_string()),
                    }
                }
                // The others are still offered.
                if !self.trust.left.is_empty() {
                    self.dialog = Some(Dialog::Question(Question::Recover));
                }
            }
            _ => {}
        }
    }
}
