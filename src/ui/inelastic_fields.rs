//! What does not spring back, as numbers that can be changed: of a material, and of a fibre.

use super::field::NumberField;
use crate::scene::{Fibre, Material, Plasticity, Viscosity, YieldPast};
use egui::{CollapsingHeader, RichText, Ui};

const SHEAR: NumberField = NumberField::new(
    "Viscosity",
    "Pa s",
    0.0..=1e12,
    Some(0.0),
    "Against a change of shape: jelly against rubber. Where it is longer than the step over Young's modulus, the step shrinks",
);
const BULK: NumberField =
    NumberField::new("of volume", "Pa s", 0.0..=1e12, Some(0.0), "Viscosity against a change of volume");
const YIELD_STRESS: NumberField =
    NumberField::new("Yield stress", "Pa", 1.0..=1e12, None, "Stress at which a pulled bar yields (von Mises)");
const HARDENING: NumberField = NumberField::new(
    "Hardening",
    "Pa",
    0.0..=1e12,
    Some(0.0),
    "By how much the yield stress grows over the plastic strain",
);
const CREEP_TIME: NumberField = NumberField::new(
    "Creep time",
    "s",
    0.0..=1e6,
    Some(0.0),
    "Time in which a stress above the yield stress fades; 0 for at once",
);
const YIELD_CURVATURE: NumberField =
    NumberField::new("Bent by", "°/m", 1e-3..=1e9, None, "Curvature away from the rest shape past which it stays bent");
const YIELD_TENSION: NumberField = NumberField::new(
    "Pulled by",
    "N",
    1e-9..=1e12,
    None,
    "Force of an edge, the volume fraction included, past which it stays long or short",
);

/// Share of Young's modulus that a matrix yields at when it is first told to.
const FIRST_YIELD: f64 = 0.02;
/// Curvature [degrees/m], and share of its axial rigidity, that a fibre yields at when it is first told to.
const FIRST_CURVATURE: f64 = 300.0;
const FIRST_TENSION: f64 = 0.02;

/// Shows how a material resists being strained fast, and how it yields; folded away where it does neither.
pub(super) fn inelastic_fields(ui: &mut Ui, material: &mut Material) {
    let is_used = material.viscosity.is_some() || material.plasticity.is_some();
    CollapsingHeader::new("Viscosity and yield").default_open(is_used).show(ui, |ui| flow_fields(ui, material));
}

fn flow_fields(ui: &mut Ui, material: &mut Material) {
    let mut viscosity = material.viscosity.clone().unwrap_or_default();
    if SHEAR.show(ui, &mut viscosity.shear) | BULK.show(ui, &mut viscosity.bulk) {
        let is_none = viscosity == Viscosity::default();
        material.viscosity = (!is_none).then_some(viscosity);
    }
    let mut yields = material.plasticity.is_some();
    if ui.checkbox(&mut yields, "Yields").on_hover_text("Dents stay; Reset mends them").changed() {
        material.plasticity = yields.then(|| Plasticity::new(FIRST_YIELD * material.young_modulus));
    }
    if let Some(plasticity) = &mut material.plasticity {
        YIELD_STRESS.show(ui, &mut plasticity.yield_stress);
        HARDENING.show(ui, &mut plasticity.hardening);
        CREEP_TIME.show(ui, &mut plasticity.creep_time);
        let text = "Bent, thin parts spring back 1.3 to 1.7 times as far as theory has it: what is to keep a pose takes a \
                    fibre that yields";
        ui.label(RichText::new(text).weak().small());
    }
}

/// Shows what a fibre yields past.
pub(super) fn yield_fields(ui: &mut Ui, fibre: &mut Fibre) {
    if fibre.activation.is_some() {
        return;
    }
    let (ea, _) = fibre.stiffness.rigidity(0.0);
    let first_tension = (FIRST_TENSION * fibre.volume_fraction * ea).max(1e-6);
    let mut past = fibre.yields.clone().unwrap_or_default();
    let before = past.clone();
    CollapsingHeader::new("Yield").default_open(fibre.yields.is_some()).show(ui, |ui| {
        limit(ui, "Stays bent", &mut past.curvature_degrees_per_metre, FIRST_CURVATURE, &YIELD_CURVATURE);
        limit(ui, "Stays long", &mut past.tension, first_tension, &YIELD_TENSION);
    });
    if past != before {
        let is_none = YieldPast { extra: past.extra.clone(), ..YieldPast::default() } == past && past.extra.is_empty();
        fibre.yields = (!is_none).then_some(past);
    }
}

/// A limit that may be there or not, `first` when it is switched on.
fn limit(ui: &mut Ui, name: &str, value: &mut Option<f64>, first: f64, field: &NumberField) {
    let mut is_on = value.is_some();
    if ui.checkbox(&mut is_on, name).on_hover_text(field.tooltip).changed() {
        *value = is_on.then_some(first);
    }
    if let Some(value) = value {
        field.show(ui, value);
    }
}
