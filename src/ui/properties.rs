//! The right panel's first tab: what the active body is made of and how it is stepped.

use super::app::App;
use super::field::Field;
use super::theme::GRID;
use crate::edit::Command;
use crate::scene::{IntegratorKind, Mass, Material, PressureIn, TwoLayer};
use egui::{ComboBox, RichText, Ui};
use std::ops::RangeInclusive;

const YOUNG: Field = Field::new(
    "Young's modulus",
    "Pa",
    1e2..=1e10,
    Some(1e5),
    "E: stiffness of the matrix; enters lambda and mu of the corotated stress (eq. 1)",
);
const POISSON: Field = Field::new(
    "Poisson's ratio",
    "",
    0.0..=0.49,
    Some(0.33),
    "nu: how much it thins when pulled; enters lambda and mu",
);
const DENSITY: Field = Field::new(
    "Density",
    "kg/m³",
    1.0..=1e5,
    Some(1000.0),
    "Mass of the shape by its volume; the stable step grows with its root",
);
const PARTICLE_MASS: Field =
    Field::new("Particle mass", "kg", 1e-9..=1e3, Some(4e-4), "Mass of each material particle; the paper uses 4e-4");
const PAIR_DAMPING: Field =
    Field::new("Damping", "1/s", 0.0..=1e5, Some(0.0), "Radial, between neighbours; keeps linear and angular momentum");
const AIR_DRAG: Field =
    Field::new("Air drag", "1/s", 0.0..=1e5, Some(0.0), "Acceleration against the velocity, a = -c v");
const SUPPORT_RADIUS: Field = Field::new(
    "Support radius",
    "m",
    1e-4..=10.0,
    None,
    "h: reach of the kernel W (eq. 13); particles lie D / h times it apart, so this samples the shape anew",
);
const SPACING_RATIO: Field = Field::new(
    "Spacing D / h",
    "",
    0.3..=0.6,
    Some(0.4),
    "Particle spacing over support radius; this samples the shape anew",
);

/// A parameter of two-layer bodies with the paper's default (sec. 4.2.1).
const fn parameter(
    label: &'static str,
    unit: &'static str,
    range: RangeInclusive<f64>,
    default: f64,
    tooltip: &'static str,
) -> Field {
    Field::new(label, unit, range, Some(default), tooltip)
}

const KS: Field = parameter("KS", "N/m", 0.0..=1e7, 800.0, "Stiffness of structural springs, f = KS (L - L0)");
const KD: Field = parameter("KD", "N s/m", 0.0..=1e5, 15.0, "Damping of structural springs along their length");
const RKS: Field =
    parameter("RKS", "N/m", 0.0..=1e7, 700.0, "Stiffness of radius and shear springs between the layers");
const RKD: Field = parameter("RKD", "N s/m", 0.0..=1e5, 50.0, "Damping of radius and shear springs");
const MKS: Field = parameter("MKS", "N/m", 0.0..=1e6, 150.0, "Stiffness of the spring by which it is dragged");
const MKD: Field = parameter("MKD", "N s/m", 0.0..=1e5, 25.0, "Damping of the spring by which it is dragged");
const PRESSURE: Field = parameter("PRESSURE", "J", -1e6..=1e6, 20.0, "nRT of the enclosed gas, P = nRT / V");
const MASS: Field = parameter(
    "MASS",
    "kg",
    1e-9..=1e6,
    1.0,
    "Mass of a particle of the outer layer, and of the inner one unless given",
);
const INNER_MASS: Field = parameter("Inner mass", "kg", 1e-9..=1e6, 1.0, "Mass of a particle of the inner layer");

pub(super) const INTEGRATORS: [(IntegratorKind, &str); 7] = [
    (IntegratorKind::LeapFrog, "Leap-frog"),
    (IntegratorKind::ExplicitEuler, "Explicit Euler"),
    (IntegratorKind::Midpoint, "Midpoint"),
    (IntegratorKind::Rk4, "Runge-Kutta 4"),
    (IntegratorKind::SymplecticEuler, "Symplectic Euler"),
    (IntegratorKind::Verlet, "Verlet"),
    (IntegratorKind::BackwardEuler, "Backward Euler"),
];

pub(super) fn integrator_name(kind: IntegratorKind) -> &'static str {
    INTEGRATORS.iter().find(|(known, _)| *known == kind).map_or("", |(_, name)| *name)
}

impl App {
    pub(super) fn body_tab(&mut self, ui: &mut Ui) {
        if let Some(body) = self.active_body().cloned() {
            let mut material = body.material.clone();
            show_material(ui, &mut material);
            if material != body.material {
                self.apply(&Command::SetMaterial { body: body.id.clone(), material });
            }
            self.integrator(ui, body.id, body.integrator);
        } else if let Some(body) = self.active_two_layer().cloned() {
            let mut changed = body.clone();
            show_two_layer(ui, &mut changed);
            if changed != body {
                self.apply(&Command::SetTwoLayer(Box::new(changed)));
            }
            self.integrator(ui, body.id, body.integrator);
        } else {
            ui.label("No body is chosen");
        }
        if let Some(baking) = &self.published.status.baking {
            ui.add_space(GRID);
            // On as many lines as it needs: a wider panel would make the views jump.
            ui.horizontal_wrapped(|ui| {
                ui.spinner();
                ui.label(format!("Putting together {baking}…"));
            });
        }
    }

    fn integrator(&mut self, ui: &mut Ui, body: String, present: IntegratorKind) {
        ui.add_space(2.0 * GRID);
        let title = ui.heading("Integrator");
        let mut chosen = present;
        let choice = ComboBox::from_id_salt("integrator").selected_text(integrator_name(present)).show_ui(ui, |ui| {
            for (kind, name) in INTEGRATORS {
                ui.selectable_value(&mut chosen, kind, name);
            }
        });
        choice.response.labelled_by(title.id);
        if chosen != present {
            self.gesture += 1;
            self.apply(&Command::SetIntegrator { body, integrator: chosen });
        }
        let Some(step) = self.published.status.bodies.get(self.active).cloned() else { return };
        let exceeded = step.dt > step.stable_dt;
        let text = format!("DT    {:.3e} s\nlimit {:.3e} s", step.dt, step.stable_dt);
        let colour = if exceeded { self.tone.error() } else { ui.visuals().text_color() };
        let set_by = self.set_by(step.limited_by.as_deref());
        let why = format!("The limit is the stable step of this integrator{set_by}");
        ui.label(RichText::new(text).monospace().color(colour)).on_hover_text(&why);
        if exceeded {
            ui.colored_label(self.tone.error(), format!("Beyond the limit{set_by}"));
        } else if let Some(pointer) = &step.limited_by {
            ui.label(RichText::new(format!("Set by {}", self.scene().with_names(pointer))).weak().small());
        }
    }

    /// What sets a stable step, to be said after it; nothing where that is not known.
    pub(super) fn set_by(&self, limited_by: Option<&str>) -> String {
        limited_by.map_or_else(String::new, |pointer| format!(", set by {}", self.scene().with_names(pointer)))
    }
}

fn show_material(ui: &mut Ui, material: &mut Material) {
    ui.heading("Material");
    YOUNG.show(ui, &mut material.young_modulus);
    POISSON.show(ui, &mut material.poisson_ratio);
    match &mut material.mass {
        Mass::Density(density) => DENSITY.show(ui, density),
        Mass::PerParticle(mass) => PARTICLE_MASS.show(ui, mass),
    };
    PAIR_DAMPING.show(ui, &mut material.damping.pair);
    AIR_DRAG.show(ui, &mut material.damping.air);
    ui.add_space(GRID);
    ui.heading("Sampling");
    SUPPORT_RADIUS.show(ui, &mut material.support_radius);
    SPACING_RATIO.show(ui, &mut material.spacing_ratio);
    ui.label(RichText::new("Fills the shape with particles anew and starts it at rest").weak().small());
}

fn show_two_layer(ui: &mut Ui, body: &mut TwoLayer) {
    ui.heading("Springs and gas");
    KS.show(ui, &mut body.ks);
    KD.show(ui, &mut body.kd);
    RKS.show(ui, &mut body.rks);
    RKD.show(ui, &mut body.rkd);
    PRESSURE.show(ui, &mut body.pressure);
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
    ui.add_space(GRID);
    ui.heading("Drag");
    MKS.show(ui, &mut body.mks);
    MKD.show(ui, &mut body.mkd);
}
