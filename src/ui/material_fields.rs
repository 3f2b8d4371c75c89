//! What a fibre solid is made of and how its shape is sampled, as numbers that can be changed.

use super::field::NumberField;
use super::inelastic_fields::inelastic_fields;
use super::material_presets::material_presets;
use super::theme::GRID;
use crate::scene::{Mass, Material};
use egui::{RichText, Ui};

const YOUNG: NumberField = NumberField::new(
    "Young's modulus",
    "Pa",
    1e2..=1e12,
    Some(1e5),
    "E: stiffness of the matrix; enters lambda and mu of the corotated stress (eq. 1)",
);
const POISSON: NumberField = NumberField::new(
    "Poisson's ratio",
    "",
    0.0..=0.49,
    Some(0.33),
    "nu: how much it thins when pulled; enters lambda and mu",
);
const DENSITY: NumberField = NumberField::new(
    "Density",
    "kg/m³",
    1.0..=1e5,
    Some(1000.0),
    "Mass of the shape by its volume; the stable step grows with its root",
);
const PARTICLE_MASS: NumberField = NumberField::new(
    "Particle mass",
    "kg",
    1e-9..=1e3,
    Some(4e-4),
    "Mass of each material particle; the paper uses 4e-4",
);
const PAIR_DAMPING: NumberField = NumberField::new(
    "Damping",
    "1/s",
    0.0..=1e5,
    Some(0.0),
    "Radial, between neighbours; keeps linear and angular momentum",
);
/// The drag of bodies of either kind.
pub(super) const AIR_DRAG: NumberField =
    NumberField::new("Air drag", "1/s", 0.0..=1e5, Some(0.0), "Acceleration against the velocity, a = -c v");
const SUPPORT_RADIUS: NumberField = NumberField::new(
    "Support radius",
    "m",
    1e-4..=10.0,
    None,
    "h: reach of the kernel W (eq. 13); particles lie D / h times it apart, so this samples the shape anew",
);
const SPACING_RATIO: NumberField = NumberField::new(
    "Spacing D / h",
    "",
    0.3..=0.6,
    Some(0.4),
    "Particle spacing over support radius; this samples the shape anew",
);

/// Shows a material.
pub(super) fn material_fields(ui: &mut Ui, material: &mut Material) {
    ui.heading("Material");
    material_presets(ui, material);
    YOUNG.show(ui, &mut material.young_modulus);
    POISSON.show(ui, &mut material.poisson_ratio);
    match &mut material.mass {
        Mass::Density(density) => DENSITY.show(ui, density),
        Mass::PerParticle(mass) => PARTICLE_MASS.show(ui, mass),
    };
    PAIR_DAMPING.show(ui, &mut material.damping.pair);
    AIR_DRAG.show(ui, &mut material.damping.air);
    inelastic_fields(ui, material);
    ui.add_space(GRID);
    ui.heading("Sampling");
    SUPPORT_RADIUS.show(ui, &mut material.support_radius);
    SPACING_RATIO.show(ui, &mut material.spacing_ratio);
    ui.label(
        RichText::new("Fills the shape anew and starts it at rest, as heavy and as stiff as it is").weak().small(),
    );
}
