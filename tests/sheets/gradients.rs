//! Forces of sheets are the gradients of their energies, and keep both momenta.

use crate::common::*;
use glam::{DMat3, DQuat, DVec3};
use sinew::scene::{Body, GrainAlong, Sheet, SheetActivation, SheetRestShape, SheetStiffness};
use sinew::sim::Runner;
use sinew::solver::{EmbeddingWeights, Energies, Force, ParticleState};
use sinew::test_support::solver::{SheetForce, SheetLaw, SheetRest};
use std::sync::Arc;

/// A law without anything of its own.
pub const NOTHING: SheetLaw = SheetLaw { et: 0.0, poisson_ratio: 0.3, bending: 0.0, grain: 0.0, volume_fraction: 1.0 };

/// Triangles of a grid of `columns` x `rows` vertices whose diagonals alternate, with its directions.
pub fn grid(columns: usize, rows: usize) -> Vec<[u32; 3]> {
    let at = |i: usize, j: usize| (j * columns + i) as u32;
    let cell = |i: usize, j: usize| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        if (i + j).is_multiple_of(2) { [[a, b, d], [a, d, c]] } else { [[a, b, c], [b, d, c]] }
    };
    (0..rows - 1).flat_map(|j| (0..columns - 1).flat_map(move |i| cell(i, j))).collect()
}

/// A sheet over a grid of vertices that are particles of their own, as it rests at `x` [m].
pub fn bare(x: &[DVec3], columns: usize, law: SheetLaw, ways: [DVec3; 2]) -> SheetRest {
    let triangles: Vec<_> = grid(columns, x.len() / columns).into_iter().map(|of| (of, ways)).collect();
    let vertices = (0..x.len() as u32).map(|k| EmbeddingWeights { weights: vec![(k, 1.0)] }).collect();
    let place = |k: u32| (k as usize % columns, k as usize / columns);
    let diagonal = |a: u32, b: u32| place(a).0 != place(b).0 && place(a).1 != place(b).1;
    SheetRest::new(vertices, x, &triangles, law, diagonal)
}

pub fn state(x: &[DVec3]) -> ParticleState {
    ParticleState { positions: x.to_vec(), velocities: vec![DVec3::ZERO; x.len()], masses: vec![1.0; x.len()] }
}

pub fn energies(force: &SheetForce, x: &[DVec3]) -> Energies {
    let mut energies = Energies::default();
    force.add_energy(0.0, &state(x), &mut energies);
    energies
}

/// Error of the forces along random directions against fourth-order differences of the energy, relative; and the sums
/// of forces and of torques, relative.
fn errors(force: &mut dyn Force, x: &[DVec3], scale: f64) -> [f64; 3] {
    let mut found = vec![DVec3::ZERO; x.len()];
    force.add_forces(0.0, &state(x), &mut found);
    let energy = |x: &[DVec3]| {
        let mut energies = Energies::default();
        force.add_energy(0.0, &state(x), &mut energies);
        energies.potential()
    };
    let mut worst: f64 = 0.0;
    for salt in 0..5 {
        let way: Vec<DVec3> = (0..x.len()).map(|i| wobble(i, 11 + salt)).collect();
        let at = |step: f64| energy(&x.iter().zip(&way).map(|(x, way)| *x + *way * step).collect::<Vec<_>>());
        let e = 1e-3 * scale;
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

/// A grid that is no square one, at rest a little curved, and far from there.
fn patch() -> (Vec<DVec3>, Vec<DVec3>) {
    let rest: Vec<DVec3> = (0..20)
        .map(|k| {
            let [u, v] = [f64::from(k % 5), f64::from(k / 5)];
            DVec3::new(u + 0.1 * v, 1.3 * v, 0.15 * u * u - 0.1 * v * v)
        })
        .collect();
    let turn = DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize_or_zero(), 2.5));
    let stretch = DMat3::from_cols_array(&[1.2, 0.1, 0.0, -0.2, 0.8, 0.3, 0.1, 0.0, 1.1]);
    let moved = (0..20).map(|k| turn * (stretch * rest[k]) + 0.35 * wobble(k, 3)).collect();
    (rest, moved)
}

#[test]
fn membrane_grain_and_hinge_are_gradients() {
    let (rest, moved) = patch();
    let ways = [DVec3::X, DVec3::new(1.0, 0.7, 0.2)];
    for (what, law) in [
        ("membrane", SheetLaw { et: 40.0, ..NOTHING }),
        ("grain", SheetLaw { grain: 25.0, ..NOTHING }),
        ("hinge", SheetLaw { bending: 3.0, ..NOTHING }),
        ("all", SheetLaw { et: 40.0, grain: 25.0, bending: 3.0, poisson_ratio: 0.45, volume_fraction: 0.4 }),
    ] {
        for flat in [false, true] {
            let sheet = bare(&rest, 5, law, ways);
            let sheet = if flat { sheet.flattened() } else { sheet };
            let mut force = SheetForce::new(Arc::new([sheet]));
            let at_rest = energies(&force, &rest);
            assert!(at_rest.membrane < 1e-24 && (flat || at_rest.hinges < 1e-24), "{what}: {at_rest:?}");
            let [gradient, sum, torque] = errors(&mut force, &moved, 1.0);
            println!("{what}: gradient {gradient:.1e}, force {sum:.1e}, torque {torque:.1e}");
            assert!(gradient < 1e-8, "{what}: {gradient:e}");
            assert!(sum < 1e-14 && torque < 1e-14, "{what}: {sum:e}, {torque:e}");
        }
    }
}

#[test]
fn a_hinge_folds_through_half_a_turn_without_a_jump() {
    let rest = [DVec3::ZERO, DVec3::X, DVec3::new(0.5, 1.0, 0.0), DVec3::new(0.5, -1.0, 0.0)];
    let vertices = (0..4).map(|k| EmbeddingWeights { weights: vec![(k, 1.0)] }).collect();
    let triangles = [([0, 1, 2], [DVec3::X; 2]), ([1, 0, 3], [DVec3::X; 2])];
    let law = SheetLaw { bending: 1.0, ..NOTHING };
    let mut force = SheetForce::new(Arc::new([SheetRest::new(vertices, &rest, &triangles, law, |_, _| false)]));
    let mut before = 0.0;
    for degrees in 1..270 {
        let mut x = rest;
        let angle = f64::from(degrees).to_radians();
        x[3] = DVec3::new(0.5, -angle.cos(), angle.sin());
        force.add_forces(0.0, &state(&x), &mut [DVec3::ZERO; 4]);
        let energy = energies(&force, &x).hinges;
        // k = L² / (A1 + A2) = 1.
        assert!((energy - 0.5 * angle * angle).abs() < 1e-9 && energy > before, "{degrees} degrees: {energy} J");
        before = energy;
    }
}

/// A small bar with a curved sheet right through it.
fn bar(sheet: impl Fn(Sheet) -> Sheet) -> Body {
    let rows = (0..6).map(|v| {
        let row = (0..4).map(|u| {
            let [x, y] = [f64::from(u) - 1.5, f64::from(v) + 0.6];
            [D * x, D * y, D * (0.3 * x * x - 0.05 * y * y)]
        });
        row.collect()
    });
    block([4, 7, 4], 2e5).with_sheet(sheet(Sheet::grid("s", rows.collect())))
}

fn stiff() -> SheetStiffness {
    SheetStiffness::new(4e4, 0.05).with_grain(GrainAlong::Second, 2e4)
}

#[test]
fn active_sheets_in_a_solid_are_gradients() {
    let acting =
        SheetActivation { curl_degrees_per_metre: [3000.0, -1000.0], ..SheetActivation::contracting([0.3, -0.2], 1.0) };
    let bar = bar(|sheet| sheet.with_stiffness(stiff()).with_activation(acting.clone()));
    let baked = baked(&in_space(bar));
    let body = &baked.world.bodies()[0];
    let force = body.parts().forces.iter().find_map(|force| force.downcast_ref::<SheetForce>());
    let mut force = force.expect("sheets").clone();
    let x: Vec<DVec3> = body.state().positions.iter().enumerate().map(|(i, x)| *x + 0.1 * D * wobble(i, 5)).collect();
    let [gradient, sum, torque] = errors(&mut force, &x, D);
    println!("gradient {gradient:.1e}, force {sum:.1e}, torque {torque:.1e}");
    assert!(gradient < 1e-8 && sum < 1e-13 && torque < 1e-13, "{gradient:e}, {sum:e}, {torque:e}");
}

#[test]
fn sheets_keep_momenta_and_energy() {
    let mut bar = bar(|sheet| sheet.with_stiffness(stiff()).with_rest_shape(SheetRestShape::Flat));
    bar.initial.deformation = [[0.97, 0.05, 0.0], [0.0, 1.1, 0.02], [0.03, 0.0, 0.96]];
    bar.initial.velocity = [1.0, 2.0, -0.5];
    bar.initial.angular_velocity = [300.0, 500.0, -200.0];
    let mut scene = in_space(bar);
    scene.time.frames_per_second = 1000.0;
    let mut runner = Runner::new(baked(&scene));
    let figures = |runner: &Runner| {
        let body = &runner.world().bodies()[0];
        let state = body.state();
        (state.linear_momentum(), state.angular_momentum(), body.energies(runner.world().time()))
    };
    let (p, l, before) = figures(&runner);
    assert!(before.membrane > 0.05 * before.potential() && before.hinges > 0.0, "{before:?}");
    for _ in 0..20 {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
        let (p_now, l_now, now) = figures(&runner);
        let energy = (now.total() - before.total()).abs() / before.total();
        assert!((p_now - p).length() < 1e-13 * p.length(), "{p_now}");
        assert!((l_now - l).length() < 1e-12 * l.length(), "{l_now}");
        assert!(energy < 0.03, "{energy}");
    }
}
