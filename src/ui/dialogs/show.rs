//! Shows what is open over the window.

use super::answer::Answer;
use super::dialog::Dialog;
use super::first_scene::first_scene;
use super::palette::{help, palette};
use super::path::ask_path;
use crate::ui::action::Action;
use crate::ui::ahead::AheadAnswer;
use crate::ui::autosave::{About, RecordingOffer, RecoveryOffer, ask};
use crate::ui::context::Context;
use crate::ui::gallery::{Choice, Gallery};
use crate::ui::loading::Progress;
use crate::ui::patterns;
use crate::ui::preferences::Asked;
use crate::ui::theme::GRID;
use crate::ui::transfer::{self, TransferAnswer};
use egui::{Id, Modal};
use std::path::PathBuf;

/// Shows a dialog; gives what it came to.
pub(crate) fn show(
    dialog: &mut Dialog,
    ctx: &egui::Context,
    gallery: &mut Gallery,
    (offers, recordings): (&[RecoveryOffer], &[RecordingOffer]),
    recent: &[PathBuf],
    cx: &Context,
) -> Answer {
    let frame = egui::Frame::popup(&ctx.global_style()).inner_margin(4.0 * GRID);
    let about =
        About { name: cx.document.name(), path: cx.document.path.as_deref(), offers, recordings, tone: cx.tone };
    let modal = Modal::new(Id::unique("dialog")).frame(frame).show(ctx, |ui| match dialog {
        Dialog::Palette { text, chosen } => palette(ui, text, chosen, &cx.actions),
        Dialog::Help => help(ui, cx.navigation),
        Dialog::Preferences(preferences) => match preferences.ask(ui) {
            Some(Asked::Changed) => Answer::Preferred(*preferences),
            Some(Asked::Closed) => Answer::Closed,
            Some(Asked::Keys) => Answer::Do(Action::Help),
            None => Answer::None,
        },
        Dialog::Ahead(question) => {
            match question.ask(ui, (&cx.simulation.published().status, cx.scene().time.frame_seconds()), cx.tone) {
                Some(AheadAnswer::Compute(seconds)) => Answer::Compute(seconds),
                Some(AheadAnswer::Closed) => Answer::Closed,
                None => Answer::None,
            }
        }
        Dialog::FirstScene => first_scene(ui),
        Dialog::Path { purpose, text, browsing, .. } => ask_path(ui, *purpose, text, browsing, recent),
        Dialog::Question(question) => ask(ui, question, &about).map_or(Answer::None, Answer::Reply),
        Dialog::Examples => gallery.show(ui).map_or(Answer::None, |choice| match choice {
            Choice::Close => Answer::Closed,
            Choice::Open(example) => Answer::Example(example),
        }),
        Dialog::Loading(loading) => match loading.show(ui) {
            Progress::GoesOn => Answer::None,
            Progress::Cancelled => Answer::Closed,
            Progress::Done(loaded) => Answer::Loaded(loaded),
        },
        Dialog::Pattern(question) => match patterns::ask(ui, question) {
            None => Answer::None,
            Some(true) => Answer::Pattern,
            Some(false) => Answer::Closed,
        },
        Dialog::Transfer(question) => match transfer::ask(ui, question, cx) {
            None => Answer::None,
            Some(TransferAnswer::Closed) => Answer::Closed,
            Some(answer) => Answer::Transfer(answer),
        },
    });
    match modal.inner {
        Answer::None if modal.should_close() => Answer::Closed,
        answer => answer,
    }
}
