//! What becomes of the answers to dialogs.

use super::App;
use crate::ui::autosave::{Loss, Question, Reply};
use crate::ui::colliders_section::add_mesh;
use crate::ui::context::Severity;
use crate::ui::dialogs::{self, Answer, Dialog, PathPurpose};
use crate::ui::export;
use crate::ui::follows_section::add_follow;
use crate::ui::next::Next;

impl App {
    /// Shows what is open over the window and does what it comes to.
    pub(super) fn show_dialog(&mut self, ctx: &egui::Context) {
        let Some(mut dialog) = self.dialog.take() else { return };
        let (offers, recent) = (self.autosave.offers(), self.recent.paths());
        self.gallery.let_play(self.views.draws_in_software() == Some(false));
        let answer = dialogs::show(&mut dialog, ctx, &mut self.gallery, offers, recent, &self.cx);
        match (answer, dialog) {
            (Answer::None, dialog) => self.dialog = Some(dialog),
            (Answer::Do(action), _) => self.dispatch(ctx, action),
            (Answer::Path(path) | Answer::Picked(path), Dialog::Path { purpose: PathPurpose::Open, .. }) => {
                self.leave(ctx, Next::Open(path));
            }
            (Answer::Path(path) | Answer::Picked(path), Dialog::Path { purpose: PathPurpose::Collider, .. }) => {
                if let Err(error) = add_mesh(&mut self.cx, &path) {
                    self.cx.say(Severity::Error, error.to_string());
                }
            }
            (Answer::Path(path) | Answer::Picked(path), Dialog::Path { purpose: PathPurpose::Follow, .. }) => {
                if let Err(error) = add_follow(&mut self.cx, &path) {
                    self.cx.say(Severity::Error, error.to_string());
                }
            }
            (Answer::Path(path) | Answer::Picked(path), Dialog::Path { purpose: PathPurpose::Add(layers), .. }) => {
                self.add_body_of(ctx, path, layers);
            }
            (Answer::Path(path), Dialog::Path { purpose: PathPurpose::Export, .. }) => {
                export::export_to(&mut self.cx, path);
            }
            (Answer::Picked(path), Dialog::Path { purpose: PathPurpose::Export, .. }) => {
                export::export(&mut self.cx, &path);
            }
            (Answer::Example(example), _) => self.leave(ctx, Next::Example(example)),
            (Answer::Pattern, Dialog::Pattern(question)) => self.patterns.answered(&question, &mut self.cx),
            (Answer::Transfer(answer), Dialog::Transfer(question)) => {
                let look = self.views.look(&self.cx, ctx.pixels_per_point());
                let goes_on = self.transfer.answered(ctx, question, answer, look, &mut self.cx);
                self.dialog = goes_on.map(Dialog::Transfer);
            }
            (Answer::Loaded(loaded), Dialog::Loading(loading)) => self.loaded(&loading, *loaded),
            (Answer::Recent(path), _) => self.open_recent(ctx, path),
            (Answer::Path(path), Dialog::Path { next, .. }) => self.save_to(ctx, path, next),
            (Answer::Picked(path), Dialog::Path { next, .. }) => self.write_then(ctx, &path, next),
            (Answer::Reply(reply), Dialog::Question(question)) => self.replied(ctx, question, reply),
            _ => {}
        }
        self.carry_out(ctx);
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
            (Question::Recover, Reply::Recover(k)) => {
                if let Some(offer) = self.autosave.offers().get(k).cloned() {
                    self.leave(ctx, Next::Recover(offer));
                }
            }
            (Question::Recover, Reply::Forget(k)) => {
                if let Err(error) = self.autosave.discard(k) {
                    self.cx.say(Severity::Error, error.to_string());
                }
                // The others are still offered.
                if !self.autosave.offers().is_empty() {
                    self.dialog = Some(Dialog::Question(Question::Recover));
                }
            }
            _ => {}
        }
    }
}
