//! The brush's own panel, while it is in use.

use super::brush::{dabs, paintable, repainted};
use super::state::{Editing, Paints};
use crate::ui::context::{Context, Step};
use crate::ui::field::NumberField;
use egui::{ComboBox, Ui};

const RADIUS: NumberField =
    NumberField::new("Brush radius", "m", 1e-5..=10.0, None, "Beyond it the brush does nothing");
const VALUE: NumberField = NumberField::new(
    "Painted fraction",
    "",
    0.0..=1.0,
    Some(1.0),
    "l_i (eq. 18): 1 leaves no matrix there, 0 all of it whatever fibres run through",
);
const SHARE: NumberField = NumberField::new(
    "Painted share",
    "",
    0.0..=1.0,
    Some(1.0),
    "How much follows there: springs pull by this share of their stiffness, and what is held hard follows from a half on",
);
const STRENGTH: NumberField =
    NumberField::new("Strength", "", 0.0..=1.0, Some(1.0), "How much of the way to that value one stroke goes");

/// Shows the brush's radius, value and strength, while it is in use.
pub(crate) fn brush_panel(editing: &mut Editing, ui: &mut Ui, cx: &mut Context) {
    let Some(brush) = &mut editing.brush else { return };
    let all = paintable(cx);
    // Another body may have been chosen since.
    if let Some((first, _)) = all.first().filter(|_| all.iter().all(|(one, _)| *one != brush.paints)) {
        brush.paints = first.clone();
    }
    ui.heading("Brush");
    if all.len() > 1 {
        let shown = all.iter().find(|(one, _)| *one == brush.paints).map_or("", |(_, name)| name);
        let menu = ComboBox::from_id_salt("paints").selected_text(shown.to_owned()).show_ui(ui, |ui| {
            for (one, name) in &all {
                ui.selectable_value(&mut brush.paints, one.clone(), name);
            }
        });
        menu.response.on_hover_text("What is painted");
    }
    RADIUS.show(ui, &mut brush.radius);
    match brush.paints {
        Paints::Fraction => VALUE.show(ui, &mut brush.value),
        Paints::Follow(_) => SHARE.show(ui, &mut brush.value),
    };
    STRENGTH.show(ui, &mut brush.strength);
    ui.label("Drag over the body in the result view.");
    let paints = brush.paints.clone();
    let Some(painted) = dabs(&paints, cx).map(|dabs| !dabs.is_empty()) else { return };
    ui.horizontal(|ui| {
        if ui.add_enabled(painted, egui::Button::new("Clear paint")).clicked()
            && let Some(command) = repainted(&paints, Vec::new(), cx)
        {
            cx.edit(&command, Step::Own);
        }
        if ui.button("Done").clicked() {
            editing.brush = None;
        }
    });
}
