//! Going on to something else: asked about first where that would lose changes.

use super::App;
use crate::io::missing_files;
use crate::ui::autosave::Question;
use crate::ui::context::Severity;
use crate::ui::dialogs::Dialog;
use crate::ui::next::Next;
use egui::ViewportCommand;
use std::path::PathBuf;

impl App {
    /// Goes on to something else, after asking where that would lose changes.
    pub(super) fn leave(&mut self, ctx: &egui::Context, next: Next) {
        if self.cx.document.is_changed() {
            self.dialog = Some(Dialog::Question(Question::Unsaved(next)));
        } else {
            self.go_on(ctx, next);
        }
    }

    /// Goes on to something else, whatever becomes of the changes.
    pub(super) fn go_on(&mut self, ctx: &egui::Context, next: Next) {
        match next {
            Next::New => self.open_document(ctx, None),
            Next::Empty => self.open_empty(),
            Next::Open(path) => self.open_document(ctx, Some(path)),
            Next::Example(example) => self.open_example(example),
            Next::Recover(offer) => self.recover(ctx, &offer),
            Next::Quit => {
                self.autosave.leave();
                ctx.send_viewport_cmd(ViewportCommand::Close);
            }
        }
    }

    /// Takes the scene as its file holds it, after asking where that would lose changes.
    pub(super) fn reload(&mut self, ctx: &egui::Context) {
        let Some(path) = self.cx.document.path.clone() else { return };
        if self.cx.document.is_changed() {
            self.dialog = Some(Dialog::Question(Question::Reload { path, is_asked: true, is_changed: true }));
        } else {
            self.open_document(ctx, Some(path));
        }
    }

    /// Opens a file of those that were used.
    pub(super) fn open_recent(&mut self, ctx: &egui::Context, path: PathBuf) {
        if missing_files([path.clone()]).is_empty() {
            self.leave(ctx, Next::Open(path));
        } else {
            let said = format!("{} is no longer there; it was taken off the recent files", path.display());
            self.cx.say(Severity::Error, said);
            self.recent.drop_missing();
        }
    }

    /// What is to be looked after whether or not the window is shown.
    pub(super) fn look_after(&mut self, ctx: &egui::Context) {
        self.autosave.look_after(ctx, &mut self.cx);
        self.transfer.look_after(ctx);
        let closes = ctx.input(|input| input.viewport().close_requested());
        if closes && !self.autosave.is_leaving() && self.cx.document.is_changed() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            if ctx.input(|input| input.viewport().visible()) == Some(false) {
                ctx.send_viewport_cmd(ViewportCommand::Minimized(false));
                ctx.send_viewport_cmd(ViewportCommand::Focus);
            }
            self.leave(ctx, Next::Quit);
        }
        self.ask_what_waits(ctx);
    }

    /// Asks what nobody waits for, once nothing else is going on.
    fn ask_what_waits(&mut self, ctx: &egui::Context) {
        let is_busy = self.dialog.is_some()
            || self.views.editing().has_gesture()
            || ctx.egui_wants_keyboard_input()
            || ctx.input(|input| input.pointer.any_down());
        if !is_busy && let Some(question) = self.autosave.next_question(&mut self.cx) {
            self.dialog = Some(Dialog::Question(question));
        }
    }
}
