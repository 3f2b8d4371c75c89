//! The questions about what leaves the window, and how they are answered.

use super::answer::TransferAnswer;
use super::ask_clip::ask_clip;
use super::ask_lines::ask_lines;
use super::ask_motion::ask_motion;
use super::question::TransferQuestion;
use crate::ui::context::Context;
use egui::Ui;

/// Asks; none while nothing was answered.
pub(crate) fn ask(ui: &mut Ui, question: &mut TransferQuestion, cx: &Context) -> Option<TransferAnswer> {
    match question {
        TransferQuestion::Motion(question) => ask_motion(ui, question, cx),
        TransferQuestion::Clip(question) => ask_clip(ui, question, cx),
        TransferQuestion::Lines(question) => ask_lines(ui, question, cx),
    }
}
