//! Rigid things that bodies touch: those that are there, and another one.

use super::context::{Context, Request, Step};
use super::dialogs::{Dialog, PathPurpose};
use super::field::{NumberField, vector};
use super::motion_fields::motion_fields;
use super::room_section::FRICTION;
use crate::draw::Bounds;
use crate::edit::Command;
use crate::scene::{Assets, Collider, ColliderMesh, ColliderShape, Drivable};
use egui::{RichText, Ui};
use glam::DVec3;
use std::path::Path;

const SIZE: NumberField = NumberField::new("Radius", "m", 1e-4..=1000.0, None, "Radius of the collider");
/// A new collider is this share of what is there, and lies this share of that below it.
const SHARE: f64 = 0.5;
const GAP: f64 = 0.05;

/// Shows every collider of the scene.
pub(super) fn colliders_section(ui: &mut Ui, cx: &mut Context) {
    let before = cx.scene().colliders.clone();
    let mut colliders = before.clone();
    let mut step = Step::Present;
    let mut gone = None;
    for (index, collider) in colliders.iter_mut().enumerate() {
        ui.push_id(index, |ui| {
            ui.horizontal(|ui| {
                let chosen = cx.selection.collider() == Some(&collider.id);
                if ui.selectable_label(chosen, RichText::new(collider.title()).strong()).clicked() {
                    cx.selection.choose_collider(collider.id.clone());
                }
                if ui.button("Remove").on_hover_text("Takes this collider away").clicked() {
                    gone = Some(index);
                }
            });
            show_collider(ui, collider);
            let of = Drivable::Collider(collider.id.clone());
            motion_fields(ui, cx, &mut collider.motion, &of);
        });
        ui.separator();
    }
    if let Some(index) = gone {
        colliders.remove(index);
        step = Step::Own;
    }
    if let Some(added) = new_collider(ui, cx, &colliders) {
        cx.selection.choose_collider(added.id.clone());
        colliders.push(added);
        step = Step::Own;
    }
    if colliders != before {
        cx.edit(&Command::SetColliders(colliders), step);
    }
}

/// A collider that a person wants added.
fn new_collider(ui: &mut Ui, cx: &mut Context, others: &[Collider]) -> Option<Collider> {
    let mut added = None;
    let menu = ui.menu_button("Add a collider", |ui| {
        for (name, tooltip) in [
            ("Sphere", "A ball below what is there"),
            ("Box", "A box below what is there"),
            ("Capsule", "A cylinder with round ends below what is there"),
            ("Plane", "Everything below a height; turned, a slope"),
        ] {
            if ui.button(name).on_hover_text(tooltip).clicked() {
                added = Some(usual_collider(name, cx, others));
                ui.close();
            }
        }
        let tooltip = "A model that bodies touch: solid where it is closed, a thin shell where it has holes";
        if ui.button("Mesh file…").on_hover_text(tooltip).clicked() {
            cx.request(Request::Open(Dialog::path(PathPurpose::Collider, cx.document.path.as_deref())));
            ui.close();
        }
    });
    menu.response.on_hover_text("Adds a rigid thing that bodies touch");
    added
}

/// A name that no other has.
fn new_id(others: &[Collider]) -> (String, usize) {
    let taken = |n: &usize| others.iter().any(|collider| collider.id == format!("collider-{n}"));
    let number = (1..=others.len() + 1).find(|n| !taken(n)).unwrap_or(1);
    (format!("collider-{number}"), number)
}

/// Below the middle of everything that is there, a share as large.
fn usual_collider(kind: &str, cx: &Context, others: &[Collider]) -> Collider {
    let bodies = cx.simulation.published().snapshot.bodies.iter();
    let bounds = Bounds::of(bodies.flat_map(|body| body.particles.iter().copied()))
        .unwrap_or(Bounds { min: DVec3::new(-0.05, 0.0, -0.05), max: DVec3::new(0.05, 0.1, 0.05) });
    let size = SHARE * (bounds.max - bounds.min).max_element().max(1e-3);
    let (id, number) = new_id(others);
    let (collider, height) = match kind {
        "Sphere" => (Collider::sphere(id, 0.5 * size), size),
        "Box" => (Collider::cuboid(id, [size; 3]), size),
        "Capsule" => (Collider::capsule(id, 0.25 * size, 0.5 * size), size),
        _ => (Collider::plane(id), 0.0),
    };
    let top = bounds.center().with_y(bounds.min.y - GAP * size);
    let translation = top - 0.5 * height * DVec3::Y;
    Collider { name: format!("{kind} {number}"), ..collider.with_translation(translation.to_array()) }
}

fn show_collider(ui: &mut Ui, collider: &mut Collider) {
    match &mut collider.shape {
        ColliderShape::Sphere(of) => {
            SIZE.show(ui, &mut of.radius);
        }
        ColliderShape::Box(of) => {
            for (label, extent) in ["Width, X", "Height, Y", "Depth, Z"].into_iter().zip(&mut of.size) {
                NumberField { label, tooltip: "Extent of the collider", ..SIZE }.show(ui, extent);
            }
        }
        ColliderShape::Capsule(of) => {
            SIZE.show(ui, &mut of.radius);
            let tooltip = "Length of the cylinder between the round ends";
            NumberField { label: "Length", range: 0.0..=1000.0, tooltip, ..SIZE }.show(ui, &mut of.length);
        }
        ColliderShape::Plane => {}
        ColliderShape::Mesh(of) => {
            ui.weak(&of.path);
            let tooltip = "Holds bodies in as a thin shell, though it is closed";
            ui.checkbox(&mut of.hollow, "Hollow").on_hover_text(tooltip);
        }
    }
    FRICTION.show(ui, &mut collider.friction);
    vector(ui, "Position", "m", &mut collider.placement.translation, "Where its own origin is at the start");
    let rotation = &mut collider.placement.rotation;
    let mut axis = rotation.axis;
    vector(ui, "Axis of its turn", "", &mut axis, "Of any length but zero");
    if axis.iter().any(|part| part.abs() > 1e-9) {
        rotation.axis = axis;
    }
    let tooltip = "How far it is turned about that axis at the start, right-handed";
    NumberField::new("Turned by", "°", -360.0..=360.0, Some(0.0), tooltip).show(ui, &mut rotation.degrees);
}

/// Adds the model of a file, which was read, as a collider; the scene names it by `path`.
pub(super) fn add_mesh(cx: &mut Context, file: &Path, path: String, read: Assets) {
    let mut colliders = cx.scene().colliders.clone();
    let (id, _) = new_id(&colliders);
    cx.take_in_models(read);
    let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    cx.selection.choose_collider(id.clone());
    colliders.push(Collider { name, ..Collider::new(id, ColliderMesh::new(path)) });
    cx.edit(&Command::SetColliders(colliders), Step::Own);
}
