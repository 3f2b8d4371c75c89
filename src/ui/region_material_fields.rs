//! Regions of the active body with a matrix of their own.

use super::context::{Context, Step};
use super::field::NumberField;
use super::theme::GRID;
use crate::edit::Command;
use crate::scene::{Body, Mass, RegionMaterial};
use egui::{ComboBox, Ui};

const YOUNG: NumberField =
    NumberField::new("Young's modulus", "Pa", 1e2..=1e12, None, "E of the matrix in this region");
const DENSITY: NumberField = NumberField::new("Density", "kg/m³", 1.0..=1e5, None, "Mass by volume in this region");
const DAMPING: NumberField =
    NumberField::new("Damping", "1/s", 0.0..=1e5, None, "Radial, between neighbours in this region");
const TRANSITION: NumberField = NumberField::new(
    "Transition",
    "m",
    0.0..=100.0,
    Some(0.0),
    "Over what distance from the region its material passes into the body's",
);

/// Shows which regions of a body are made of something else.
pub(super) fn region_material_fields(ui: &mut Ui, cx: &mut Context, body: &Body) {
    if body.regions.is_empty() {
        return;
    }
    ui.add_space(2.0 * GRID);
    ui.heading("Regions of another material");
    let mut materials = body.region_materials.clone();
    let mut step = Step::Present;
    let mut gone = None;
    for (index, own) in materials.iter_mut().enumerate() {
        ui.push_id(("region material", index), |ui| {
            ui.horizontal(|ui| {
                ui.label(own.region.clone());
                if ui.button("Same as body").on_hover_text("Makes this region of the body's material again").clicked() {
                    gone = Some(index);
                }
            });
            own_value(ui, &YOUNG, &mut own.young_modulus, body.material.young_modulus);
            let density = if let Mass::Density(density) = body.material.mass { density } else { 1000.0 };
            own_value(ui, &DENSITY, &mut own.density, density);
            own_value(ui, &DAMPING, &mut own.damping, body.material.damping.pair);
            TRANSITION.show(ui, &mut own.transition);
        });
    }
    if let Some(index) = gone {
        materials.remove(index);
        step = Step::Own;
    }
    let title = ui.label("Another region");
    let choice = ComboBox::from_id_salt("another region").selected_text("Choose…").show_ui(ui, |ui| {
        for region in &body.regions {
            if ui.selectable_label(false, &region.id).clicked() {
                let mut own = RegionMaterial::of(&region.id);
                own.young_modulus = Some(body.material.young_modulus);
                materials.push(own);
                step = Step::Own;
            }
        }
    });
    choice.response.labelled_by(title.id);
    if materials != body.region_materials {
        cx.edit(&Command::SetRegionMaterials { body: body.id.clone(), materials }, step);
    }
}

/// A value that is the body's until it is changed.
fn own_value(ui: &mut Ui, field: &NumberField, own: &mut Option<f64>, of_body: f64) {
    let mut value = own.unwrap_or(of_body);
    if field.show(ui, &mut value) {
        *own = Some(value);
    }
}
