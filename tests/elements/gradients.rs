//! Forces of elements are the gradients of their energies, and keep both momenta.

use crate::common::*;
use crate::{E, element, element_force, laws, stored};
use glam::{DMat3, DQuat, DVec3};
use sinew::scene::{ElementMeasure, Manual, TimeStep};
use sinew::sim::Runner;
use sinew::solver::{Force, ParticleState};

pub fn state(x: &[DVec3]) -> ParticleState {
    ParticleState { positions: x.to_vec(), velocities: vec![DVec3::ZERO; x.len()], masses: vec![1.0; x.len()] }
}

pub fn forces(force: &mut dyn Force, time: f64, x: &[DVec3]) -> Vec<DVec3> {
    let mut found = vec![DVec3::ZERO; x.len()];
    force.add_forces(time, &state(x), &mut found);
    found
}

/// Error of the forces along random directions against fourth-order differences of the energy, relative; and the sums
/// of forces and of torques, relative.
pub fn errors(force: &mut dyn Force, x: &[DVec3]) -> [f64; 3] {
    let found = forces(force, 0.0, x);
    let mut worst: f64 = 0.0;
    for salt in 0..5 {
        let way: Vec<DVec3> = (0..x.len()).map(|i| D * wobble(i, 11 + salt)).collect();
        let at = |step: f64| {
            let x: Vec<DVec3> = x.iter().zip(&way).map(|(x, way)| *x + *way * step).collect();
            stored(force, 0.0, &x).potential()
        };
        let e = 1e-3;
        let slope = (8.0 * (at(e) - at(-e)) - (at(2.0 * e) - at(-2.0 * e))) / (12.0 * e);
        let work: f64 = found.iter().zip(&way).map(|(force, way)| force.dot(*way)).sum();
        let size: f64 = found.iter().zip(&way).map(|(force, way)| force.dot(*way).abs()).sum();
        worst = worst.max((slope + work).abs() / size);
    }
    let size: f64 = found.iter().map(|force| force.length()).sum();
    let torque: DVec3 = found.iter().zip(x).map(|(force, x)| x.cross(*force)).sum();
    let arm: f64 = found.iter().zip(x).map(|(force, x)| x.length() * force.length()).sum();
    [worst, found.iter().sum::<DVec3>().length() / size, torque.length() / arm]
}

/// Particles turned, stretched and out of place.
pub fn deformed(rest: &[DVec3]) -> Vec<DVec3> {
    deformed_by(rest, 3)
}

/// The same, out of place otherwise for every `salt`.
fn deformed_by(rest: &[DVec3], salt: u64) -> Vec<DVec3> {
    let turn = DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize_or_zero(), 2.5));
    let stretch = DMat3::from_cols_array(&[1.12, 0.05, 0.0, -0.1, 1.08, 0.15, 0.05, 0.0, 1.1]);
    // The other way round in every second one.
    let stretch = if salt.is_multiple_of(2) { stretch.inverse() } else { stretch };
    rest.iter().enumerate().map(|(k, x)| turn * (stretch * *x) + 0.05 * D * wobble(k, salt)).collect()
}

#[test]
fn every_measure_under_every_law_is_a_gradient() {
    for measure in ElementMeasure::ALL {
        for (what, law) in laws(measure) {
            let body = block([4, 5, 4], E).with_element(element(measure, law));
            let world = baked(&in_space(body)).world;
            let mut force = element_force(&world.bodies()[0]);
            let rest = world.bodies()[0].state().positions.clone();
            assert!(stored(&*force, 0.0, &rest).elements.abs() < 1e-15);
            // In the first state in which it does anything.
            let found = (3..20).map(|salt| deformed_by(&rest, salt)).find(|x| stored(&*force, 0.0, x).elements != 0.0);
            let x = found.expect("it is pulled in some");
            let [gradient, sum, torque] = errors(&mut *force, &x);
            println!("{measure:?} {what}: gradient {gradient:.1e}, force {sum:.1e}, torque {torque:.1e}");
            assert!(gradient < 2e-9, "{measure:?} {what}: {gradient:e}");
            assert!(sum < 1e-14 && torque < 1e-14, "{measure:?} {what}: {sum:e}, {torque:e}");
        }
    }
}

#[test]
fn a_body_with_elements_of_every_kind_keeps_its_momenta_and_its_energy() {
    let mut body = block([4, 5, 4], E);
    for measure in ElementMeasure::ALL {
        for (what, law) in laws(measure) {
            let mut one = element(measure, law);
            one.id = format!("{measure:?} {what}");
            body = body.with_element(one);
        }
    }
    body.initial.deformation = [[1.05, 0.1, 0.0], [0.0, 0.97, 0.05], [0.0, 0.0, 1.02]];
    body.initial.angular_velocity = [60.0, -40.0, 30.0];
    body.initial.velocity = [0.5, -0.2, 0.1];
    let mut scene = in_space(body);
    let extra = std::collections::BTreeMap::new();
    scene.time.step = TimeStep::Manual(Manual { dt: 2e-5, substeps_per_frame: 200, extra });
    let mut runner = Runner::new(baked(&scene));
    let momenta = |runner: &Runner| {
        let state = runner.world().bodies()[0].state();
        let moments = state.positions.iter().zip(&state.velocities).zip(&state.masses);
        (state.linear_momentum(), moments.map(|((x, v), m)| x.cross(*v) * *m).sum::<DVec3>())
    };
    let energies = |runner: &Runner| runner.world().bodies()[0].energies(runner.world().time());
    let ((p, l), before) = (momenta(&runner), energies(&runner));
    assert!(before.elements > 0.05 * before.potential(), "{before:?}");
    (0..4).for_each(|_| runner.advance_frame());
    let ((p1, l1), after) = (momenta(&runner), energies(&runner));
    let drift = (after.total() / before.total() - 1.0).abs();
    println!(
        "momentum {:.1e}, angular {:.1e}, energy {drift:.1e}",
        p1.distance(p) / p.length(),
        l1.distance(l) / l.length()
    );
    assert!(p1.distance(p) < 1e-12 * p.length() && l1.distance(l) < 1e-11 * l.length());
    assert!(drift < 0.01, "{before:?}\n{after:?}");
}
