//! The air or water that bodies move in.

use super::context::{Context, Step};
use super::drives::{key_button, point_at};
use super::field::{NumberField, vector};
use crate::edit::Command;
use crate::scene::{Drivable, Wind};
use egui::Ui;

const DENSITY: NumberField = NumberField::new("Density", "kg/m³", 0.0..=1e5, Some(1.2), "1.2 of air, 1000 of water");
const DRAG: NumberField = NumberField::new(
    "Drag",
    "",
    0.0..=100.0,
    Some(1.1),
    "Drag coefficient of a plate across the flow, half of it for each side",
);

/// Shows the wind of the scene, or what begins one.
pub(super) fn wind_section(ui: &mut Ui, cx: &mut Context) {
    let before = cx.scene().wind.clone();
    let mut wind = before.clone();
    let mut step = Step::Present;
    let mut is_there = wind.is_some();
    let tooltip = "Air or water pushes on the surfaces of solid bodies, as they move through it or it past them";
    if ui.checkbox(&mut is_there, "Air or water").on_hover_text(tooltip).changed() {
        wind = is_there.then(Wind::default);
        step = Step::Own;
    }
    if let Some(wind) = &mut wind {
        let fields = ui.scope(|ui| {
            ui.horizontal(|ui| {
                ui.label("Velocity");
                if before.is_some() {
                    key_button(ui, cx, &Drivable::Wind);
                }
            });
            vector(ui, "", "m/s", &mut wind.velocity, "Where its drive is 1, or where it has none; world axes");
        });
        point_at(ui, cx, fields.response.rect, &Drivable::Wind);
        DENSITY.show(ui, &mut wind.density);
        DRAG.show(ui, &mut wind.drag);
    }
    if wind != before {
        cx.edit(&Command::SetWind(wind), step);
    }
}
