//! The questions about a person's own patterns, and how they look.

use super::question::PatternQuestion;
use crate::ui::theme::GRID;
use egui::{Key, TextEdit, Ui};

/// Longest name and line of a pattern [letters].
const TITLE_LENGTH: usize = 40;
const LINE_LENGTH: usize = 120;

/// Asks about a pattern; whether it is to be done, once that is clear.
pub(crate) fn ask(ui: &mut Ui, question: &mut PatternQuestion) -> Option<bool> {
    ui.set_width(360.0);
    let (verb, tooltip) = match question {
        PatternQuestion::Keep { title, does, fibres } => {
            ui.heading("Save as pattern");
            let fibres = if *fibres == 1 { "The fibre is".to_owned() } else { format!("{fibres} fibres are") };
            ui.label(format!("{fibres} kept as shares of the body's box, to be fitted to others."));
            line(ui, "Name", "What it is called", title, TITLE_LENGTH);
            line(ui, "What it does", "A line for the gallery; may be left empty", does, LINE_LENGTH);
            ("Save pattern", "Keeps it under Yours")
        }
        PatternQuestion::Rename { title, .. } => {
            ui.heading("Rename pattern");
            line(ui, "Name", "What it is called", title, TITLE_LENGTH);
            ("Rename", "Gives it this name")
        }
        PatternQuestion::Delete { title, .. } => {
            ui.heading("Delete this pattern?");
            ui.label(format!(
                "{title} is removed from your patterns for good. Fibres that it made stay in their scenes."
            ));
            ("Delete pattern", "Removes its file")
        }
    };
    ui.add_space(GRID);
    let (named, may_enter) = match question {
        PatternQuestion::Keep { title, .. } | PatternQuestion::Rename { title, .. } => (!title.trim().is_empty(), true),
        // Nothing is deleted by a key that was still held down.
        PatternQuestion::Delete { .. } => (true, false),
    };
    let entered = named && may_enter && ui.input(|input| input.key_pressed(Key::Enter));
    let mut answer = entered.then_some(true);
    ui.horizontal(|ui| {
        if ui.add_enabled(named, egui::Button::new(verb)).on_hover_text(tooltip).clicked() {
            answer = Some(true);
        }
        if ui.button("Cancel").on_hover_text("Leaves everything as it is").clicked() {
            answer = Some(false);
        }
    });
    answer
}

/// A line of text with its name; the first one has the keys.
fn line(ui: &mut Ui, label: &str, tooltip: &str, text: &mut String, length: usize) {
    let name = ui.label(label);
    let typed = ui.add(TextEdit::singleline(text).desired_width(f32::INFINITY).char_limit(length));
    let typed = typed.labelled_by(name.id).on_hover_text(tooltip);
    if ui.memory(|memory| memory.focused().is_none()) {
        typed.request_focus();
    }
}
