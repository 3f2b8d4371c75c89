//! What is known of the document's file and of what may be lost.

use super::offer::RecoveryOffer;
use super::question::{Loss, Question};
use super::recorder::RecordingOffer;
use super::requests::{AutosaveReport, AutosaveRequest};
use super::thread::AutosaveThread;
use crate::io::{FileStamp, FileState, IoError, Origin, is_same, is_there};
use crate::scene::Scene;
use crate::sim::JournalTail;
use crate::ui::context::{Context, OpenDocument, Severity};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Looks after the document: keeps what is not saved, notices what other programs do to its file, asks before something
/// is lost.
pub(crate) struct Autosave {
    thread: AutosaveThread,
    /// The document's file as it was when it was read or saved; none where it may hold anything.
    stamp: Option<FileStamp>,
    /// Number under which the file is watched.
    watch: u64,
    /// The document that the thread knows of.
    seen: Arc<Scene>,
    /// Documents that were left behind and are still offered.
    offers: Vec<RecoveryOffer>,
    /// Recordings that were.
    recordings: Vec<RecordingOffer>,
    /// What is asked, one after the other, as soon as the person's hands are free.
    waiting: Vec<Question>,
    /// Whether the window may close with changes.
    is_leaving: bool,
}

impl Autosave {
    /// Looks after a document, just read.
    pub(crate) fn start(ctx: &egui::Context, document: &OpenDocument) -> Self {
        let repaint = ctx.clone();
        let thread = AutosaveThread::start(move || repaint.request_repaint());
        let scene = Arc::clone(document.scene());
        let mut autosave = Self {
            thread,
            stamp: None,
            watch: 0,
            seen: Arc::clone(&scene),
            offers: Vec::new(),
            recordings: Vec::new(),
            waiting: Vec::new(),
            is_leaving: false,
        };
        autosave.watch(document.path.as_deref().and_then(|path| FileStamp::of(path).ok()));
        // The window may have taken its time to open.
        autosave.thread.send(AutosaveRequest::Compare(scene));
        autosave
    }

    /// Keeps changed documents in this folder from now on, and offers those that were left there.
    pub(crate) fn keep_in(&self, folder: PathBuf) {
        self.thread.send(AutosaveRequest::Folder(folder));
    }

    /// Keeps the recording of the motion as it grows.
    pub(crate) fn record(&self, tail: JournalTail, document: &OpenDocument) {
        self.thread.send(AutosaveRequest::Record(tail, self.origin(document)));
    }

    /// Another document is open, of which a motion begins now.
    pub(crate) fn opened(&self, document: &OpenDocument) {
        self.thread.send(AutosaveRequest::Opened(self.origin(document)));
    }

    /// The document that is open belongs elsewhere now, or its models do.
    pub(crate) fn placed(&self, document: &OpenDocument) {
        self.thread.send(AutosaveRequest::Placed(self.origin(document)));
    }

    fn origin(&self, document: &OpenDocument) -> Origin {
        Origin {
            file: document.path.clone(),
            folder: document.folder.clone(),
            doubtful: self.stamp.is_none(),
            shipped: document.is_example,
        }
    }

    /// Has changes kept at once, from any thread, and waits for that a while.
    pub(crate) fn keeping(&self) -> impl Fn() + Send + 'static {
        self.thread.keeping()
    }

    /// The document's file is another one, or was read or written anew.
    pub(crate) fn watch(&mut self, stamp: Option<FileStamp>) {
        self.watch += 1;
        self.stamp.clone_from(&stamp);
        self.waiting.retain(|question| !matches!(question, Question::Reload { .. }));
        self.thread.send(AutosaveRequest::Watch(self.watch, stamp));
    }

    /// What would be lost by writing to `path`, where the document belongs to `own`; none if nothing would.
    pub(crate) fn loss(&self, path: &Path, own: Option<&Path>) -> Option<Loss> {
        if !is_there(path) {
            return None;
        }
        let is_own = own.is_some_and(|own| is_same(own, path));
        match &self.stamp {
            _ if !is_own => Some(Loss::Other),
            Some(stamp) if stamp.state() == FileState::Same => None,
            _ => Some(Loss::Changed),
        }
    }

    /// Documents that were left behind.
    pub(crate) fn offers(&self) -> &[RecoveryOffer] {
        &self.offers
    }

    /// Recordings that were left behind.
    pub(crate) fn recordings(&self) -> &[RecordingOffer] {
        &self.recordings
    }

    /// A recording that was left behind was saved elsewhere.
    pub(crate) fn saved_recording(&mut self, recording: &RecordingOffer) {
        // One that cannot be removed is offered again.
        if let Some(index) = self.recordings.iter().position(|offered| offered == recording) {
            self.discard_recording(index).ok();
        }
    }

    /// Removes a recording that was left behind, for good.
    ///
    /// # Errors
    /// A file that cannot be removed.
    pub(crate) fn discard_recording(&mut self, index: usize) -> Result<(), IoError> {
        if index < self.recordings.len() {
            self.recordings[index].discard()?;
            self.recordings.remove(index);
        }
        Ok(())
    }

    /// Removes a document that was left behind, for good.
    ///
    /// # Errors
    /// A file that cannot be removed.
    pub(crate) fn discard(&mut self, index: usize) -> Result<(), IoError> {
        if index < self.offers.len() {
            self.offers[index].document.discard()?;
            self.offers.remove(index);
        }
        Ok(())
    }

    /// Removes all documents and recordings that were left behind, for good.
    ///
    /// # Errors
    /// The first file that cannot be removed; it is still offered, as are those after it.
    pub(crate) fn discard_all(&mut self) -> Result<(), IoError> {
        while !self.recordings.is_empty() {
            self.discard_recording(0)?;
        }
        while !self.offers.is_empty() {
            self.discard(0)?;
        }
        Ok(())
    }

    /// The open document is now a recovered one: it is kept here before it is dropped there.
    pub(crate) fn recovered(&mut self, offer: &RecoveryOffer, document: &OpenDocument) {
        self.offers.retain(|other| other.document != offer.document);
        self.note(document);
        self.thread.send(AutosaveRequest::Recovered(offer.document.clone()));
        self.thread.send(AutosaveRequest::KeepNow);
    }

    /// Takes note of what the document is now.
    pub(crate) fn note(&mut self, document: &OpenDocument) {
        self.seen = Arc::clone(document.scene());
        if document.is_changed() {
            self.thread.keep(self.origin(document), Arc::clone(document.scene()));
        } else {
            self.thread.forget();
        }
    }

    /// The window closes, whatever becomes of the changes.
    pub(crate) fn leave(&mut self) {
        self.is_leaving = true;
        self.thread.forget();
    }

    /// Whether the window may close with changes.
    pub(crate) fn is_leaving(&self) -> bool {
        self.is_leaving
    }

    /// What is to be looked after in every frame, whether or not the window is shown.
    pub(crate) fn look_after(&mut self, ctx: &egui::Context, cx: &mut Context) {
        while let Some(report) = self.thread.report() {
            self.hear(report, cx);
        }
        if !Arc::ptr_eq(&self.seen, cx.scene()) {
            self.is_leaving = false;
            self.note(&cx.document);
        }
        let focus = |is_focused| ctx.input(|input| input.events.contains(&egui::Event::WindowFocused(is_focused)));
        if focus(true) {
            self.thread.send(AutosaveRequest::Look);
        }
        if focus(false) {
            self.thread.send(AutosaveRequest::KeepNow);
        }
    }

    fn hear(&mut self, report: AutosaveReport, cx: &mut Context) {
        match report {
            AutosaveReport::Offers(offers) => {
                if !offers.is_empty() {
                    self.waiting.push(Question::Recover);
                }
                self.offers = offers;
            }
            AutosaveReport::Recordings(recordings) => {
                if self.offers.is_empty() && !recordings.is_empty() {
                    // Nothing of a document is lost: it is said, and asked about by nobody.
                    let said = "The program ended before its window was closed: what was done to the motion until then \
                                can be saved by File, Recover unsaved…";
                    cx.say(Severity::Note, said);
                }
                self.recordings = recordings;
            }
            AutosaveReport::NotKept(error) => {
                let said = format!("Changes are not kept for recovery, save often: {error}");
                cx.say(Severity::Warning, said);
            }
            AutosaveReport::NotRecorded(error) => {
                let said = format!("What is done to the motion is not kept for a report of a fault: {error}");
                cx.say(Severity::Warning, said);
            }
            AutosaveReport::RecordedUpTo(bytes) => {
                let said = format!(
                    "The recording of the motion is {} MiB long, as long as one may be: what is done from here on is not \
                     kept for a report of a fault, until the motion starts anew",
                    bytes >> 20
                );
                cx.say(Severity::Warning, said);
            }
            AutosaveReport::File(number, _) if number != self.watch => {}
            AutosaveReport::File(_, FileState::Same) => {}
            AutosaveReport::File(_, FileState::Changed) => {
                // Saving asks from now on.
                self.stamp = None;
                let Some(path) = cx.document.path.clone() else { return };
                self.waiting.retain(|question| !matches!(question, Question::Reload { .. }));
                self.waiting.push(Question::Reload { path, is_asked: false, is_changed: false });
            }
            AutosaveReport::File(_, FileState::Missing) => {
                cx.document.mark_unsaved();
                self.note(&cx.document);
                if let Some(path) = &cx.document.path {
                    let said = format!("{} is no longer there; saving writes it anew", path.display());
                    cx.say(Severity::Warning, said);
                }
            }
        }
    }

    /// What is to be asked now that nothing else is going on; none where nothing waits.
    pub(crate) fn next_question(&mut self, cx: &mut Context) -> Option<Question> {
        if self.waiting.is_empty() {
            return None;
        }
        let mut question = self.waiting.remove(0);
        if let Question::Reload { is_changed, .. } = &mut question {
            *is_changed = cx.document.is_changed();
            // The file holds something else now, whatever is answered.
            cx.document.mark_unsaved();
            self.note(&cx.document);
        }
        Some(question)
    }
}
