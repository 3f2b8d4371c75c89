//! The right panel's second tab: gravity, room, panels, colliders, pins, impulse, time step.

use super::colliders_section::colliders_section;
use super::conductor::conductor;
use super::context::{Context, Step};
use super::drives::keyed_field;
use super::field::{NumberField, vector};
use super::panels_section::panels_section;
use super::pins_section::pins_section;
use super::room_section::{floor_section, walls_section};
use super::time_section::time_section;
use super::wind_section::wind_section;
use crate::edit::Command;
use crate::scene::Drivable;
use crate::sim::SimCommand;
use egui::{Button, CollapsingHeader, Ui};
use glam::DVec3;

const GRAVITY: NumberField = NumberField::new(
    "Gravity",
    "m/s²",
    -100.0..=100.0,
    Some(-9.81),
    "g, upwards; enters every particle's force as m g",
);

/// What surrounds the bodies and acts on them.
pub(super) struct WorldTab {
    /// Impulse that the strike button gives [N s].
    impulse: [f64; 3],
}

impl Default for WorldTab {
    fn default() -> Self {
        Self { impulse: [0.1, 0.0, 0.0] }
    }
}

impl WorldTab {
    /// Shows the tab.
    pub(super) fn show(&mut self, ui: &mut Ui, cx: &mut Context) {
        let mut gravity = cx.scene().gravity;
        keyed_field(ui, cx, &GRAVITY, &mut gravity[1], &Drivable::Gravity);
        if gravity != cx.scene().gravity {
            cx.edit(&Command::SetGravity(gravity), Step::Present);
        }
        let blows = cx.scene().wind.is_some();
        let shares = !cx.simulation.published().status.drives.is_empty();
        let is_open = |title: &str| match title {
            "Walls" => false,
            "Wind" => blows,
            "Conductor" => shares,
            _ => true,
        };
        let section = |title: &str| CollapsingHeader::new(title).default_open(is_open(title));
        let mut room = cx.scene().room.clone();
        section("Floor and contact").show(ui, |ui| floor_section(ui, &mut room));
        section("Walls").show(ui, |ui| walls_section(ui, &mut room));
        if room != cx.scene().room {
            cx.edit(&Command::SetRoom(room), Step::Present);
        }
        section("Wind").show(ui, |ui| wind_section(ui, cx));
        section("Panels").show(ui, |ui| panels_section(ui, cx));
        section("Colliders").show(ui, |ui| colliders_section(ui, cx));
        section("Pins").show(ui, |ui| pins_section(ui, cx));
        section("Conductor").show(ui, |ui| conductor(ui, cx));
        section("Impulse").show(ui, |ui| self.impulse(ui, cx));
        section("Time step").show(ui, |ui| time_section(ui, cx));
    }

    /// An impulse that can be given to the active body.
    fn impulse(&mut self, ui: &mut Ui, cx: &Context) {
        let tooltip = "Shared by the mass of the whole body; changes its velocity by J / M at once";
        vector(ui, "J", "N s", &mut self.impulse, tooltip);
        let body = cx.active.index;
        let strike = ui.add_enabled(cx.simulation.published().snapshot.bodies.len() > body, Button::new("Strike"));
        if strike.on_hover_text("Strikes the chosen body now; nothing of the scene changes").clicked() {
            cx.ask(SimCommand::Strike { body, impulse: DVec3::from_array(self.impulse) });
        }
    }
}
