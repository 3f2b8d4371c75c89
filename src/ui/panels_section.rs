//! Rigid panels: those that are there, and another one.

use super::context::{Context, Step};
use super::drives::{key_button, point_at};
use super::field::NumberField;
use super::motion_fields::drive_words;
use super::room_section::{FRICTION, length};
use crate::draw::Bounds;
use crate::edit::Command;
use crate::scene::{Drivable, HeightKey, Panel, PanelDrive, PanelMotion};
use egui::{DragValue, Ui};
use glam::DVec3;

const MASS: NumberField = NumberField::new("Mass", "kg", 1e-6..=1e6, Some(1.0), "Matters only when the panel falls");
/// A panel is this much wider than what it presses on, and stands this share of its height above it.
const REACH: f64 = 1.5;
const GAP: f64 = 0.3;
/// How far a panel goes up by its drive before a person says how far [m].
const USUAL_TRAVEL: f64 = 0.01;

/// Shows every panel of the scene.
pub(super) fn panels_section(ui: &mut Ui, cx: &mut Context) {
    let before = cx.scene().panels.clone();
    let mut panels = before.clone();
    let mut step = Step::Present;
    let mut gone = None;
    for (index, panel) in panels.iter_mut().enumerate() {
        ui.push_id(index, |ui| {
            ui.horizontal(|ui| {
                ui.strong(panel.title());
                if ui.button("Remove").on_hover_text("Takes this panel away").clicked() {
                    gone = Some(index);
                }
            });
            show_panel(ui, cx, panel);
        });
        ui.separator();
    }
    if let Some(index) = gone {
        panels.remove(index);
        step = Step::Own;
    }
    let tooltip = "Adds a rigid panel that falls on what lies below it and is held up by it";
    if ui.button("Add a heavy panel").on_hover_text(tooltip).clicked() {
        panels.push(usual_panel(cx, &panels));
        step = Step::Own;
    }
    if panels != before {
        cx.edit(&Command::SetPanels(panels), step);
    }
}

/// A panel over everything that is there.
fn usual_panel(cx: &Context, others: &[Panel]) -> Panel {
    let bodies = cx.simulation.published().snapshot.bodies.iter();
    let bounds = Bounds::of(bodies.flat_map(|body| body.particles.iter().copied()))
        .unwrap_or(Bounds { min: DVec3::new(-0.05, 0.0, -0.05), max: DVec3::new(0.05, 0.1, 0.05) });
    let extent = bounds.max - bounds.min;
    let width = REACH * extent.x.max(extent.z);
    let number =
        (1..=others.len() + 1).find(|n| others.iter().all(|panel| panel.id != format!("panel-{n}"))).unwrap_or(1);
    Panel {
        name: format!("Panel {number}"),
        center: [bounds.center().x, bounds.center().z],
        ..Panel::falling(format!("panel-{number}"), bounds.max.y + GAP * extent.y.max(1e-3), [width, width])
    }
}

fn show_panel(ui: &mut Ui, cx: &mut Context, panel: &mut Panel) {
    length("Height", "World Y of its underside at the start").show(ui, &mut panel.height);
    MASS.show(ui, &mut panel.mass);
    FRICTION.show(ui, &mut panel.friction);
    let extent = |label| NumberField { range: 1e-4..=1000.0, ..length(label, "Extent of the panel") };
    extent("Width, X").show(ui, &mut panel.size[0]);
    extent("Depth, Z").show(ui, &mut panel.size[1]);
    let of = Drivable::Panel(panel.id.clone());
    let fields = ui.scope(|ui| {
        ui.horizontal(|ui| {
            show_motions(ui, panel);
            key_button(ui, cx, &of);
        });
        let height = panel.height;
        match &mut panel.motion {
            PanelMotion::Falls => {}
            PanelMotion::Driven(keys) => show_heights(ui, keys, height),
            PanelMotion::Follows(follows) => show_follows(ui, follows),
        }
    });
    point_at(ui, cx, fields.response.rect, &of);
}

/// Chooses how a panel moves. What it did before is kept, so that a look at another motion loses no drive and no
/// heights.
fn show_motions(ui: &mut Ui, panel: &mut Panel) {
    let id = ui.scope_id();
    let (kept_heights, kept_drive) = (id.with(("heights", &panel.id)), id.with(("drive", &panel.id)));
    match &panel.motion {
        PanelMotion::Falls => {}
        PanelMotion::Driven(keys) => {
            ui.data_mut(|data| data.insert_temp(kept_heights, keys.clone()));
        }
        PanelMotion::Follows(follows) => {
            ui.data_mut(|data| data.insert_temp(kept_drive, follows.clone()));
        }
    }
    let falls = panel.motion == PanelMotion::Falls;
    if ui.selectable_label(falls, "Falls").on_hover_text("Falls under gravity from rest").clicked() {
        panel.motion = PanelMotion::Falls;
    }
    let driven = matches!(panel.motion, PanelMotion::Driven(_));
    let choice = ui.selectable_label(driven, "Driven").on_hover_text("Follows heights over time");
    if choice.clicked() && !driven {
        let kept: Option<Vec<HeightKey>> = ui.data(|data| data.get_temp(kept_heights));
        let usual = || [0.0, 1.0].map(|time| HeightKey::new(time, panel.height)).to_vec();
        panel.motion = PanelMotion::Driven(kept.unwrap_or_else(usual));
    }
    let follows = matches!(panel.motion, PanelMotion::Follows(_));
    let choice = ui.selectable_label(follows, "Follows").on_hover_text("Stands where a drive has it");
    if choice.clicked() && !follows {
        let drive: Option<PanelDrive> = ui.data(|data| data.get_temp(kept_drive));
        panel.motion = PanelMotion::Follows(drive.unwrap_or_else(|| PanelDrive::new(0.0, USUAL_TRAVEL)));
    }
}

/// Shows what a panel follows.
fn show_follows(ui: &mut Ui, follows: &mut PanelDrive) {
    let tooltip = "How far above its height it stands where its drive is 1; below it where negative";
    length("Travel", tooltip).show(ui, &mut follows.travel);
    ui.weak(format!("times {}", drive_words(&follows.drive)))
        .on_hover_text("Its lane is below the timeline, under Drives");
}

/// Shows the heights [m] of a panel over time; the first one that is added where there is none is `usual`.
fn show_heights(ui: &mut Ui, keys: &mut Vec<HeightKey>, usual: f64) {
    let mut gone = None;
    for (index, key) in keys.iter_mut().enumerate() {
        ui.horizontal(|ui| {
            ui.add(DragValue::new(&mut key.time).range(0.0..=1e4).speed(0.01).prefix("at ").suffix(" s"));
            ui.add(DragValue::new(&mut key.height).speed(0.001).prefix("height ").suffix(" m"));
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
        let (time, height) = keys.last().map_or((0.0, usual), |key| (key.time + 1.0, key.height));
        keys.push(HeightKey::new(time, height));
    }
}
