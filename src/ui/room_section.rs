//! Floor, walls and ceiling, and how they are touched.

use super::field::NumberField;
use crate::scene::{Room, Sticking};
use egui::Ui;

/// The friction of the room and of its panels.
pub(super) const FRICTION: NumberField = NumberField::new(
    "Friction",
    "",
    0.0..=10.0,
    Some(0.4),
    "Coulomb's coefficient: the tangential force is at most this times the normal one",
);
const CONTACT_DAMPING: NumberField = NumberField::new(
    "Contact damping",
    "",
    0.0..=1.0,
    Some(0.0),
    "Share of critical damping in the normal direction: 0 bounces fully, 1 hardly at all",
);

/// A length of the room or of a panel.
pub(super) const fn length(label: &'static str, tooltip: &'static str) -> NumberField {
    NumberField::new(label, "m", -1000.0..=1000.0, None, tooltip)
}

/// Shows the floor, and how everything in the room is touched.
pub(super) fn floor_section(ui: &mut Ui, room: &mut Room) {
    plane(ui, "Floor", &length("Floor height", "World Y"), &mut room.floor, 0.0);
    FRICTION.show(ui, &mut room.friction);
    ui.horizontal(|ui| {
        ui.label("Below the limit");
        for (sticking, name, meaning) in [
            (Sticking::Spring, "Holds", "Springs along the surface: what lies on a slope stays there"),
            (Sticking::Damper, "Brakes", "Dampers alone: what is pushed creeps, as in the papers' figures"),
        ] {
            ui.selectable_value(&mut room.sticking, sticking, name).on_hover_text(meaning);
        }
    });
    CONTACT_DAMPING.show(ui, &mut room.contact_damping);
}

/// Shows the ceiling and the walls.
pub(super) fn walls_section(ui: &mut Ui, room: &mut Room) {
    plane(ui, "Ceiling", &length("Ceiling height", "World Y"), &mut room.ceiling, 0.5);
    plane(ui, "Left wall", &length("Left wall at X", "World X"), &mut room.x_min, -0.25);
    plane(ui, "Right wall", &length("Right wall at X", "World X"), &mut room.x_max, 0.25);
    plane(ui, "Back wall", &length("Back wall at Z", "World Z"), &mut room.z_min, -0.25);
    plane(ui, "Front wall", &length("Front wall at Z", "World Z"), &mut room.z_max, 0.25);
}

/// A switch with a height or place behind it.
fn plane(ui: &mut Ui, name: &str, field: &NumberField, place: &mut Option<f64>, usual: f64) {
    let mut there = place.is_some();
    ui.checkbox(&mut there, name);
    *place = there.then_some(place.unwrap_or(usual));
    if let Some(place) = place {
        field.show(ui, place);
    }
}
