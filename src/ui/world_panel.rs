//! The right panel, and its second tab: gravity, room, panels, pins, impulse, time step.

use super::app::{App, PropertyTab};
use super::field::{Field, vector};
use super::theme::{self, GRID, SIDE_WIDTH};
use crate::draw::Bounds;
use crate::edit::Command;
use crate::scene::{
    Automatic, Axis, Extra, HeightKey, Manual, Panel as Plate, PanelMotion, Pin, Region, Room, Selector, Side, TimeStep,
};
use crate::sim::SimCommand;
use egui::{CollapsingHeader, ComboBox, Panel, ScrollArea, Ui};
use glam::DVec3;

/// A length of the room or of a panel.
const fn length(label: &'static str, tooltip: &'static str) -> Field {
    Field::new(label, "m", -1000.0..=1000.0, None, tooltip)
}

const GRAVITY: Field =
    Field::new("Gravity", "m/s²", -100.0..=100.0, Some(-9.81), "g, upwards; enters every particle's force as m g");
const FRICTION: Field = Field::new(
    "Friction",
    "",
    0.0..=10.0,
    Some(0.4),
    "Coulomb's coefficient: the tangential force is at most this times the normal one",
);
const CONTACT_DAMPING: Field = Field::new(
    "Contact damping",
    "",
    0.0..=1.0,
    Some(0.0),
    "Share of critical damping in the normal direction: 0 bounces fully, 1 hardly at all",
);
const PANEL_MASS: Field = Field::new("Mass", "kg", 1e-6..=1e6, Some(1.0), "Matters only when the panel falls");
const DT: Field =
    Field::new("DT", "s", 1e-7..=1.0, None, "Time step, as it is given; beyond a body's limit it may diverge");
const SAFETY: Field =
    Field::new("Safety", "", 0.01..=1.0, Some(0.6), "Share of the stable step that is used; less keeps energy better");
/// A panel is this much wider than what it presses on, and stands this share of its height above it.
const PANEL_REACH: f64 = 1.5;
const PANEL_GAP: f64 = 0.3;
/// Layers of the lattice that a new pin holds.
const PINNED_LAYERS: u32 = 1;

impl App {
    pub(super) fn right_panel(&mut self, ui: &mut Ui) {
        Panel::right("properties").default_size(SIDE_WIDTH).frame(theme::panel(ui)).show(ui, |ui| {
            ui.set_min_width(ui.available_width());
            ui.add_space(GRID);
            ui.horizontal(|ui| {
                // All of them stand beside each other.
                ui.spacing_mut().item_spacing.x = 0.5 * GRID;
                ui.spacing_mut().button_padding.x = 0.75 * GRID;
                ui.selectable_value(&mut self.tab, PropertyTab::Body, "Material");
                ui.selectable_value(&mut self.tab, PropertyTab::World, "World");
                ui.selectable_value(&mut self.tab, PropertyTab::Comparison, "Compare");
                ui.selectable_value(&mut self.tab, PropertyTab::Patterns, "Patterns")
                    .on_hover_text("Layouts of fibres to start from, and your own");
            });
            ui.separator();
            // Each tab, and a pattern that is chosen, begins at its own top.
            let place = (self.tab, self.lays_pattern());
            ScrollArea::vertical().id_salt(place).auto_shrink(false).show(ui, |ui| match self.tab {
                PropertyTab::Body => self.body_tab(ui),
                PropertyTab::World => self.world_tab(ui),
                PropertyTab::Comparison => self.comparison_tab(ui),
                PropertyTab::Patterns => self.patterns_tab(ui),
            });
        });
    }

    fn world_tab(&mut self, ui: &mut Ui) {
        let mut gravity = self.scene().gravity;
        GRAVITY.show(ui, &mut gravity[1]);
        if gravity != self.scene().gravity {
            self.apply(&Command::SetGravity(gravity));
        }
        let section = |title: &str| CollapsingHeader::new(title).default_open(title != "Walls");
        let mut room = self.scene().room.clone();
        section("Floor and contact").show(ui, |ui| floor(ui, &mut room));
        section("Walls").show(ui, |ui| walls(ui, &mut room));
        if room != self.scene().room {
            self.apply(&Command::SetRoom(room));
        }
        section("Panels").show(ui, |ui| self.plates(ui));
        section("Pins").show(ui, |ui| self.pins(ui));
        section("Impulse").show(ui, |ui| self.impulse(ui));
        section("Time step").show(ui, |ui| self.time_step(ui));
    }

    fn plates(&mut self, ui: &mut Ui) {
        let mut plates = self.scene().panels.clone();
        let mut gone = None;
        for (index, plate) in plates.iter_mut().enumerate() {
            ui.push_id(index, |ui| {
                ui.horizontal(|ui| {
                    ui.strong(plate.title());
                    if ui.button("Remove").on_hover_text("Takes this panel away").clicked() {
                        gone = Some(index);
                    }
                });
                show_plate(ui, plate);
            });
            ui.separator();
        }
        if let Some(index) = gone {
            plates.remove(index);
            self.gesture += 1;
        }
        let tooltip = "Adds a rigid panel that falls on what lies below it and is held up by it";
        if ui.button("Add a heavy panel").on_hover_text(tooltip).clicked() {
            plates.push(self.usual_plate(&plates));
            self.gesture += 1;
        }
        if plates != self.scene().panels {
            self.apply(&Command::SetPanels(plates));
        }
    }

    /// A panel over everything that is there.
    fn usual_plate(&self, others: &[Plate]) -> Plate {
        let points = self.published.snapshot.bodies.iter().flat_map(|body| body.particles.iter().copied());
        let bounds = Bounds::of(points)
            .unwrap_or(Bounds { min: DVec3::new(-0.05, 0.0, -0.05), max: DVec3::new(0.05, 0.1, 0.05) });
        let extent = bounds.max - bounds.min;
        let width = PANEL_REACH * extent.x.max(extent.z);
        let number =
            (1..=others.len() + 1).find(|n| others.iter().all(|plate| plate.id != format!("panel-{n}"))).unwrap_or(1);
        Plate {
            id: format!("panel-{number}"),
            name: format!("Panel {number}"),
            height: bounds.max.y + PANEL_GAP * extent.y.max(1e-3),
            center: [bounds.center().x, bounds.center().z],
            size: [width, width],
            mass: 1.0,
            friction: 0.4,
            motion: PanelMotion::Falls,
            extra: Extra::new(),
        }
    }

    fn pins(&mut self, ui: &mut Ui) {
        let Some((id, regions, pins)) = self.active_supports() else {
            ui.label("No body is chosen");
            return;
        };
        let (mut new_regions, mut new_pins) = (regions.clone(), pins.clone());
        let mut gone = None;
        for (index, pin) in new_pins.iter_mut().enumerate() {
            ui.push_id(index, |ui| {
                ui.horizontal(|ui| {
                    ui.label(format!("{}: holds \"{}\"", pin.id, pin.region));
                    if ui.button("Remove").on_hover_text("Lets go of this region").clicked() {
                        gone = Some(index);
                    }
                });
                ui.horizontal(|ui| {
                    ui.label("along");
                    for (axis, name) in [(Axis::X, "X"), (Axis::Y, "Y"), (Axis::Z, "Z")] {
                        let mut held = pin.axes.contains(&axis);
                        if ui.checkbox(&mut held, name).changed() {
                            pin.axes.retain(|old| *old != axis);
                            if held {
                                pin.axes.push(axis);
                            }
                            pin.axes.sort_by_key(|axis| axis.index());
                        }
                    }
                });
            });
        }
        // A pin that holds nothing is none.
        new_pins.retain(|pin| !pin.axes.is_empty());
        if let Some(index) = gone.filter(|index| *index < new_pins.len()) {
            new_pins.remove(index);
            self.gesture += 1;
        }
        if let Some(added) = self.new_pin(ui, &regions) {
            self.gesture += 1;
            add_pin(added, &mut new_regions, &mut new_pins);
        }
        if new_pins != pins || new_regions != regions {
            self.apply(&Command::SetPins { body: id, regions: new_regions, pins: new_pins });
        }
    }

    /// The region that a person wants pinned.
    fn new_pin(&self, ui: &mut Ui, regions: &[Region]) -> Option<Region> {
        let mut chosen = None;
        let title = ui.label("Pin a region");
        let choice = ComboBox::from_id_salt("new pin").selected_text("Choose…").show_ui(ui, |ui| {
            for region in regions {
                if ui.selectable_label(false, &region.id).clicked() {
                    chosen = Some(region.clone());
                }
            }
            if self.active_body().is_none() {
                return;
            }
            for (id, axis, side) in [
                ("bottom", Axis::Y, Side::Min),
                ("top", Axis::Y, Side::Max),
                ("left", Axis::X, Side::Min),
                ("right", Axis::X, Side::Max),
                ("back", Axis::Z, Side::Min),
                ("front", Axis::Z, Side::Max),
            ] {
                if regions.iter().all(|region| region.id != id) && ui.selectable_label(false, id).clicked() {
                    let select = Selector::Layers { axis, side, count: PINNED_LAYERS, extra: Extra::new() };
                    chosen = Some(Region { id: id.to_owned(), select, extra: Extra::new() });
                }
            }
        });
        choice.response.labelled_by(title.id);
        chosen
    }

    fn impulse(&mut self, ui: &mut Ui) {
        let tooltip = "Shared by the mass of the whole body; changes its velocity by J / M at once";
        vector(ui, "J", "N s", &mut self.impulse, tooltip);
        let strike = ui.add_enabled(self.published.snapshot.bodies.len() > self.active, egui::Button::new("Strike"));
        if strike.on_hover_text("Strikes the chosen body now; nothing of the scene changes").clicked() {
            self.ask(SimCommand::Strike { body: self.active, impulse: DVec3::from_array(self.impulse) });
        }
    }

    fn time_step(&mut self, ui: &mut Ui) {
        let mut time = self.scene().time.clone();
        let dt = self.published.status.bodies.iter().map(|body| body.dt).fold(f64::INFINITY, f64::min);
        ui.horizontal(|ui| {
            let automatic = matches!(time.step, TimeStep::Automatic(_));
            let tooltip = "Steps of a frame follow from the stable step that is measured";
            if ui.selectable_label(automatic, "Automatic").on_hover_text(tooltip).clicked() && !automatic {
                time.step = TimeStep::Automatic(Automatic::default());
            }
            let tooltip = "The step is given, whatever comes of it";
            if ui.selectable_label(!automatic, "By hand").on_hover_text(tooltip).clicked() && automatic {
                let dt = if dt.is_finite() { dt } else { 1e-3 };
                let substeps_per_frame = (1.0 / (time.frames_per_second * dt)).ceil().max(1.0) as u32;
                time.step = TimeStep::Manual(Manual { dt, substeps_per_frame, extra: Extra::new() });
            }
        });
        match &mut time.step {
            TimeStep::Automatic(step) => {
                SAFETY.show(ui, &mut step.safety);
            }
            TimeStep::Manual(step) => {
                DT.show(ui, &mut step.dt);
                ui.horizontal(|ui| {
                    ui.label("Steps a frame");
                    ui.add(egui::DragValue::new(&mut step.substeps_per_frame).range(1..=100_000));
                });
            }
        }
        for body in &self.published.status.bodies {
            let set_by = self.set_by(body.limited_by.as_deref());
            if body.dt > body.stable_dt {
                let text =
                    format!("{}: DT {:.3e} s is beyond its limit {:.3e} s{set_by}", body.name, body.dt, body.stable_dt);
                ui.colored_label(self.tone.error(), text);
            } else {
                ui.label(format!("{}: limit {:.3e} s{set_by}", body.name, body.stable_dt));
            }
        }
        if time != self.scene().time {
            self.apply(&Command::SetTime(time));
        }
    }
}

fn add_pin(region: Region, regions: &mut Vec<Region>, pins: &mut Vec<Pin>) {
    let number = (1..=pins.len() + 1).find(|n| pins.iter().all(|pin| pin.id != format!("pin-{n}"))).unwrap_or(1);
    pins.push(Pin {
        id: format!("pin-{number}"),
        region: region.id.clone(),
        axes: vec![Axis::X, Axis::Y, Axis::Z],
        motion: crate::scene::Motion::Fixed,
        extra: Extra::new(),
    });
    if regions.iter().all(|old| old.id != region.id) {
        regions.push(region);
    }
}

/// A switch with a height or place behind it.
fn plane(ui: &mut Ui, name: &str, field: &Field, place: &mut Option<f64>, usual: f64) {
    let mut there = place.is_some();
    ui.checkbox(&mut there, name);
    *place = there.then_some(place.unwrap_or(usual));
    if let Some(place) = place {
        field.show(ui, place);
    }
}

fn floor(ui: &mut Ui, room: &mut Room) {
    plane(ui, "Floor", &length("Floor height", "World Y"), &mut room.floor, 0.0);
    FRICTION.show(ui, &mut room.friction);
    CONTACT_DAMPING.show(ui, &mut room.contact_damping);
}

fn walls(ui: &mut Ui, room: &mut Room) {
    plane(ui, "Ceiling", &length("Ceiling height", "World Y"), &mut room.ceiling, 0.5);
    plane(ui, "Left wall", &length("Left wall at X", "World X"), &mut room.x_min, -0.25);
    plane(ui, "Right wall", &length("Right wall at X", "World X"), &mut room.x_max, 0.25);
    plane(ui, "Back wall", &length("Back wall at Z", "World Z"), &mut room.z_min, -0.25);
    plane(ui, "Front wall", &length("Front wall at Z", "World Z"), &mut room.z_max, 0.25);
}

fn show_plate(ui: &mut Ui, plate: &mut Plate) {
    length("Height", "World Y of its underside at the start").show(ui, &mut plate.height);
    PANEL_MASS.show(ui, &mut plate.mass);
    FRICTION.show(ui, &mut plate.friction);
    let extent = |label| Field { range: 1e-4..=1000.0, ..length(label, "Extent of the panel") };
    extent("Width, X").show(ui, &mut plate.size[0]);
    extent("Depth, Z").show(ui, &mut plate.size[1]);
    ui.horizontal(|ui| {
        let falls = plate.motion == PanelMotion::Falls;
        if ui.selectable_label(falls, "Falls").on_hover_text("Falls under gravity from rest").clicked() {
            plate.motion = PanelMotion::Falls;
        }
        let driven = ui.selectable_label(!falls, "Driven").on_hover_text("Follows heights over time");
        if driven.clicked() && falls {
            let key = |time, height| HeightKey { time, height, extra: Extra::new() };
            plate.motion = PanelMotion::Driven(vec![key(0.0, plate.height), key(1.0, plate.height)]);
        }
    });
    let PanelMotion::Driven(keys) = &mut plate.motion else { return };
    let mut gone = None;
    for (index, key) in keys.iter_mut().enumerate() {
        ui.horizontal(|ui| {
            ui.add(egui::DragValue::new(&mut key.time).range(0.0..=1e4).speed(0.01).prefix("at ").suffix(" s"));
            ui.add(egui::DragValue::new(&mut key.height).speed(0.001).prefix("height ").suffix(" m"));
            if ui.small_button("×").on_hover_text("Removes this height").clicked() {
                gone = Some(index);
            }
        });
    }
    if let Some(index) = gone.filter(|_| keys.len() > 1) {
        keys.remove(index);
    }
    keys.sort_by(|a, b| a.time.total_cmp(&b.time));
    if ui.small_button("Add a height").clicked() {
        let (time, height) = keys.last().map_or((0.0, plate.height), |key| (key.time + 1.0, key.height));
        keys.push(HeightKey { time, height, extra: Extra::new() });
    }
}
