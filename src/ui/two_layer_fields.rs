//! What a two-layer body is made of, as numbers that can be changed.

use super::active_springs_section::active_springs_section;
use super::context::Context;
use super::drives::keyed_field;
use super::field::NumberField;
use super::material_fields::AIR_DRAG;
use super::theme::GRID;
use crate::scene::{Drivable, PressureIn, TwoLayer};
use egui::Ui;
use std::ops::RangeInclusive;

/// A parameter of two-layer bodies with the paper's default (sec. 4.2.1).
const fn parameter(
    label: &'static str,
    unit: &'static str,
    range: RangeInclusive<f64>,
    default: f64,
    tooltip: &'static str,
) -> NumberField {
    NumberField::new(label, unit, range, Some(default), tooltip)
}

const KS: NumberField = parameter("KS", "N/m", 0.0..=1e7, 800.0, "Stiffness of structural springs, f = KS (L - L0)");
const KD: NumberField = parameter("KD", "N s/m", 0.0..=1e5, 15.0, "Damping of structural springs along their length");
const RKS: NumberField =
    parameter("RKS", "N/m", 0.0..=1e7, 700.0, "Stiffness of radius and shear springs between the layers");
const RKD: NumberField = parameter("RKD", "N s/m", 0.0..=1e5, 50.0, "Damping of radius and shear springs");
const MKS: NumberField = parameter("MKS", "N/m", 0.0..=1e6, 150.0, "Stiffness of the spring by which it is dragged");
const MKD: NumberField = parameter("MKD", "N s/m", 0.0..=1e5, 25.0, "Damping of the spring by which it is dragged");
const PRESSURE: NumberField = parameter("PRESSURE", "J", -1e6..=1e6, 20.0, "nRT of the enclosed gas, P = nRT / V");
const MASS: NumberField = parameter(
    "MASS",
    "kg",
    1e-9..=1e6,
    1.0,
    "Mass of a particle of the outer layer, and of the inner one unless given",
);
const INNER_MASS: NumberField = parameter("Inner mass", "kg", 1e-9..=1e6, 1.0, "Mass of a particle of the inner layer");

/// Shows the springs, gas, masses and drag of a two-layer body.
pub(super) fn two_layer_fields(ui: &mut Ui, cx: &mut Context, body: &mut TwoLayer) {
    ui.heading("Springs and gas");
    KS.show(ui, &mut body.ks);
    KD.show(ui, &mut body.kd);
    RKS.show(ui, &mut body.rks);
    RKD.show(ui, &mut body.rkd);
    keyed_field(ui, cx, &PRESSURE, &mut body.pressure, &Drivable::Pressure(body.id.clone()));
    ui.horizontal(|ui| {
        ui.label("Gas in");
        for (place, name) in [
            (PressureIn::Outer, "outer"),
            (PressureIn::Inner, "inner"),
            (PressureIn::Both, "both"),
            (PressureIn::Annulus, "between"),
        ] {
            ui.selectable_value(&mut body.pressure_in, place, name);
        }
    });
    MASS.show(ui, &mut body.mass);
    let mut own = body.inner_mass.is_some();
    ui.checkbox(&mut own, "Inner layer has a mass of its own");
    body.inner_mass = own.then(|| body.inner_mass.unwrap_or(body.mass));
    if let Some(mass) = &mut body.inner_mass {
        INNER_MASS.show(ui, mass);
    }
    AIR_DRAG.show(ui, &mut body.air_drag);
    active_springs_section(ui, cx, body);
    ui.add_space(GRID);
    ui.heading("Drag");
    MKS.show(ui, &mut body.mks);
    MKD.show(ui, &mut body.mkd);
}
