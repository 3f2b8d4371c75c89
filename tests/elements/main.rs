//! Elements: slopes against energies, momenta, laws, motion, steps, and what is said of those that do not fit.

#![allow(clippy::print_stdout, reason = "`--nocapture` shows the measured figures")]

mod acting;
mod built_in;
#[path = "../physics/common.rs"]
#[allow(dead_code, reason = "the physics tests use the rest of it")]
mod common;
mod gradients;
mod laws;
mod own;
mod rules;
mod steps;

use sinew::scene::{Element, ElementLaw, ElementMeasure, MusclePull};
use sinew::solver::{Energies, Force, ParticleState};

/// Young's modulus of the bodies [Pa].
const E: f64 = 1e5;

/// The one force of elements of a body that was put together.
fn element_force(body: &sinew::solver::Body) -> Box<dyn Force> {
    let force = body.parts().forces.iter().find(|force| force.name() == "elements");
    force.expect("a body with elements").clone()
}

/// What a force stores [J] with particles at `x` [m].
fn stored(force: &dyn Force, time: f64, x: &[glam::DVec3]) -> Energies {
    let mut energies = Energies::default();
    let state = ParticleState {
        positions: x.to_vec(),
        velocities: vec![glam::DVec3::ZERO; x.len()],
        masses: vec![1.0; x.len()],
    };
    force.add_energy(time, &state, &mut energies);
    energies
}

/// Four points in a block of 4 x 5 x 4 layers, no three of them on a line.
fn points(measure: ElementMeasure) -> Vec<[f64; 3]> {
    use crate::common::D;
    let all =
        [[-1.2, 0.9, -1.1], [1.1, 3.8, -0.9], [0.9, 1.2, 1.3], [-1.3, 3.6, 1.1]].map(|x: [f64; 3]| x.map(|x| x * D));
    let mut points = all[..measure.points()].to_vec();
    if measure == ElementMeasure::Dihedral {
        points = vec![all[0], all[3], all[1], all[2]];
    }
    points
}

/// Laws of every kind, as stiff as a good part of the matrix.
fn laws(measure: ElementMeasure) -> Vec<(&'static str, ElementLaw)> {
    use crate::common::D;
    let force = match measure {
        ElementMeasure::Length => E * D * D,
        ElementMeasure::Area => E * D,
        ElementMeasure::Volume => E,
        _ => 0.1 * E * D * D * D,
    };
    let table = if measure.is_angle() {
        vec![[-90.0, -force], [0.0, 0.0], [4.0, 0.2 * force], [90.0, 2.0 * force]]
    } else {
        vec![[0.5, -force], [1.0, 0.0], [1.2, 2.0 * force], [1.8, 2.5 * force]]
    };
    let muscle = MusclePull { force: 0.3 * force, width: 0.9, extra: std::collections::BTreeMap::new() };
    vec![
        ("spring", ElementLaw::spring(force)),
        ("tension_only", ElementLaw::tension_only(force)),
        ("muscle", ElementLaw::Muscle(muscle)),
        ("table", ElementLaw::Table(table)),
    ]
}

/// An element of a measure and a law in a block of 4 x 5 x 4 layers.
fn element(measure: ElementMeasure, law: ElementLaw) -> Element {
    Element::new("e", measure, points(measure), law)
}
