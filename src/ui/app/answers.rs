//! What becomes of the answers to dialogs.

use super::App;
use crate::io::{IoError, is_there};
use crate::sim::SimCommand;
use crate::ui::autosave::{Loss, Question, Reply};
use crate::ui::context::Severity;
use crate::ui::dialogs::{self, Answer, Dialog, PathPurpose};
use crate::ui::export;
use crate::ui::loading::Source;
use crate::ui::next::Next;
use std::path::PathBuf;

impl App {
    /// Shows what is open over the window and does what it comes to.
    pub(super) fn show_dialog(&mut self, ctx: &egui::Context) {
        let Some(mut dialog) = self.dialog.take() else { return };
        let (offers, recent) = ((self.autosave.offers(), self.autosave.recordings()), self.recent.paths());
        self.gallery.let_play(self.views.draws_in_software() == Some(false));
        let answer = dialogs::show(&mut dialog, ctx, &mut self.gallery, offers, recent, &self.cx);
        match (answer, dialog) {
            (Answer::None, dialog) => self.dialog = Some(dialog),
            (Answer::Do(action), _) => self.dispatch(ctx, action),
            (Answer::Path(path), Dialog::Path { purpose, next, .. }) => {
                self.path_given(ctx, (path, false), purpose, next);
            }
            (Answer::Picked(path), Dialog::Path { purpose, next, .. }) => {
                self.path_given(ctx, (path, true), purpose, next);
            }
            (Answer::Example(example), _) => self.leave(ctx, Next::Example(example)),
            (Answer::Pattern, Dialog::Pattern(question)) => self.patterns.answered(&question, &mut self.cx),
            (Answer::Transfer(answer), Dialog::Transfer(question)) => {
                let look = self.views.look(&self.cx, ctx.pixels_per_point());
                let goes_on = self.transfer.answered(ctx, question, answer, look, &mut self.cx);
                self.dialog = goes_on.map(Dialog::Transfer);
            }
            (Answer::Compute(seconds), _) => self.cx.ask(SimCommand::Compute(seconds)),
            (Answer::Preferred(preferences), dialog) => {
                self.prefer(ctx, preferences);
                self.dialog = Some(dialog);
            }
            (Answer::Loaded(loaded), Dialog::Loading(loading)) => self.loaded(&loading, *loaded),
            (Answer::Recent(path), _) => self.open_recent(ctx, path),
            (Answer::Reply(reply), Dialog::Question(question)) => self.replied(ctx, question, reply),
            // Closed, or answered by another dialog than was asked.
            (
                Answer::Closed
                | Answer::Path(_)
                | Answer::Picked(_)
                | Answer::Reply(_)
                | Answer::Loaded(_)
                | Answer::Pattern
                | Answer::Transfer(_),
                _,
            ) => {}
        }
        self.carry_out(ctx);
    }

    /// Does what a path was asked for; whether the desktop has asked already before a file is replaced.
    fn path_given(
        &mut self,
        ctx: &egui::Context,
        (path, was_asked): (PathBuf, bool),
        purpose: PathPurpose,
        next: Option<Next>,
    ) {
        match purpose {
            PathPurpose::Open => self.leave(ctx, Next::Open(path)),
            PathPurpose::Add(layers) => self.add_body_of(ctx, path, layers),
            PathPurpose::Collider => self.add_collider_of(ctx, path),
            PathPurpose::Follow => self.add_follow_of(ctx, &path),
            PathPurpose::Recording(_) | PathPurpose::Report if !was_asked && is_there(&path) => {
                let said = format!("{}: there is such a file already; give another name", path.display());
                self.cx.say(Severity::Error, said);
                self.dialog = Some(Dialog::path(purpose, Some(&path)));
            }
            PathPurpose::Report => self.report_to(ctx, path),
            PathPurpose::Recording(k) => {
                if let Some(recording) = self.autosave.recordings().get(k).cloned() {
                    self.load(ctx, Source::Recording(Box::new(recording), path));
                }
            }
            PathPurpose::Export => {
                if was_asked {
                    export::export(&mut self.cx, &path);
                } else {
                    export::export_to(&mut self.cx, path);
                }
            }
            PathPurpose::Save => {
                if was_asked {
                    self.write_then(ctx, &path, next);
                } else {
                    self.save_to(ctx, path, next);
                }
            }
        }
    }

    /// Does what a question was answered by.
    fn replied(&mut self, ctx: &egui::Context, question: Question, reply: Reply) {
        match (question, reply) {
            (Question::Unsaved(next), Reply::Save) => self.save_then(ctx, Some(next)),
            (Question::Unsaved(next), Reply::Discard) => self.go_on(ctx, next),
            (Question::Replace { path, loss: Loss::Table, .. }, Reply::Replace) => export::export(&mut self.cx, &path),
            (Question::Replace { loss: Loss::Table, .. }, Reply::SaveElsewhere) => {
                export::ask_where_to_export(&mut self.cx);
            }
            (Question::Replace { path, next, .. }, Reply::Replace) => self.write_then(ctx, &path, next),
            (Question::Replace { next, .. }, Reply::SaveElsewhere) => self.ask_where(next),
            (Question::Reload { path, .. }, Reply::Reload) => self.open_document(ctx, Some(path)),
            (Question::Outside { path, .. }, Reply::Allow) => {
                self.trust(&path);
                self.open_document(ctx, Some(path));
            }
            (Question::Outside { path, .. }, _) => {
                self.cx.say(Severity::Note, format!("{} was not opened", path.display()));
            }
            (Question::Recover, Reply::Recover(k)) => {
                if let Some(offer) = self.autosave.offers().get(k).cloned() {
                    self.leave(ctx, Next::Recover(offer));
                }
            }
            (Question::Recover, Reply::Forget(k)) => {
                let outcome = self.autosave.discard(k);
                self.discarded(outcome);
            }
            (Question::Recover, Reply::SaveRecording(k)) => {
                if let Some(offer) = self.autosave.recordings().get(k) {
                    self.dialog = Some(Dialog::path(PathPurpose::Recording(k), Some(&offer.usual_place())));
                }
            }
            (Question::Recover, Reply::ForgetRecording(k)) => {
                let outcome = self.autosave.discard_recording(k);
                self.discarded(outcome);
            }
            (Question::Recover, Reply::ForgetAll) => {
                let outcome = self.autosave.discard_all();
                self.discarded(outcome);
            }
            // Escape, and what the question does not offer.
            (
                _,
                Reply::Save
                | Reply::Discard
                | Reply::Replace
                | Reply::SaveElsewhere
                | Reply::Reload
                | Reply::Allow
                | Reply::Recover(_)
                | Reply::Forget(_)
                | Reply::SaveRecording(_)
                | Reply::ForgetRecording(_)
                | Reply::ForgetAll
                | Reply::Back,
            ) => {}
        }
    }

    /// Documents that were left behind are gone, or why not; those that are left are still offered.
    fn discarded(&mut self, outcome: Result<(), IoError>) {
        if let Err(error) = outcome {
            self.cx.say(Severity::Error, error.to_string());
        }
        if !self.autosave.offers().is_empty() || !self.autosave.recordings().is_empty() {
            self.dialog = Some(Dialog::Question(Question::Recover));
        }
    }
}
