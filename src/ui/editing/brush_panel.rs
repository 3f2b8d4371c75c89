//! The brush's own panel, while it is in use.

use super::state::Editing;
use crate::edit::Command;
use crate::ui::context::{Context, Step};
use crate::ui::field::NumberField;
use egui::Ui;

const RADIUS: NumberField =
    NumberField::new("Brush radius", "m", 1e-5..=10.0, None, "Beyond it the brush does nothing");
const VALUE: NumberField = NumberField::new(
    "Painted fraction",
    "",
    0.0..=1.0,
    Some(1.0),
    "l_i (eq. 18): 1 leaves no matrix there, 0 all of it whatever fibres run through",
);
const STRENGTH: NumberField =
    NumberField::new("Strength", "", 0.0..=1.0, Some(1.0), "How much of the way to that fraction one stroke goes");

/// Shows the brush's radius, value and strength, while it is in use.
pub(crate) fn brush_panel(editing: &mut Editing, ui: &mut Ui, cx: &mut Context) {
    let Some(brush) = &mut editing.brush else { return };
    ui.heading("Brush");
    RADIUS.show(ui, &mut brush.radius);
    VALUE.show(ui, &mut brush.value);
    STRENGTH.show(ui, &mut brush.strength);
    ui.label("Drag over the body in the result view.");
    let Some((body, painted)) = cx.active_body().map(|body| (body.id.clone(), !body.paint.is_empty())) else {
        return;
    };
    ui.horizontal(|ui| {
        if ui.add_enabled(painted, egui::Button::new("Clear paint")).clicked() {
            cx.edit(&Command::SetPaint { body, paint: Vec::new() }, Step::Own);
        }
        if ui.button("Done").clicked() {
            editing.brush = None;
        }
    });
}
