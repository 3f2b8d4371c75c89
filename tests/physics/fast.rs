//! The matrix in f32 against the same in f64: what "fast" keeps, and to how many digits.

use crate::common::*;
use crate::stencil::{deformed, evaluations, filled, forces, irregular, turned};
use glam::{DMat3, DQuat, DVec3};
use sinew::scene::{Precision, Scene};
use sinew::solver::ParticleState;
use sinew::test_support::geometry::LatticeSample;
use sinew::test_support::solver::{EvaluationKind, MatrixForce};

/// Greatest difference of forces over the greatest force.
fn relative_error(found: &[DVec3], expected: &[DVec3]) -> f64 {
    let scale = expected.iter().map(|f| f.length()).fold(0.0, f64::max);
    found.iter().zip(expected).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max) / scale
}

fn pair_of(sample: &LatticeSample, ratio: f64, varying: bool, orientation: DQuat) -> [MatrixForce; 2] {
    let [exact, _] = evaluations(sample, ratio, varying, orientation);
    let fast = exact.clone().fast();
    assert_eq!(fast.evaluation(), EvaluationKind::Fast);
    [fast, exact]
}

/// Holds both against each other over a few calls, so that warm starts come into play.
fn agree(what: &str, sample: &LatticeSample, ratio: f64, varying: bool) {
    let orientation = DQuat::from_axis_angle(DVec3::new(0.3, -1.0, 0.8).normalize_or_zero(), 1.1);
    let [mut fast, mut exact] = pair_of(sample, ratio, varying, orientation);
    for (noise, salt) in [(0.0, 1), (0.1, 2), (0.1, 2), (0.3, 3), (0.01, 4)] {
        let state = deformed(sample, orientation, noise, salt);
        let (found, expected) = (forces(&mut fast, &state), forces(&mut exact, &state));
        let error = relative_error(&found, &expected);
        let sum = found.iter().sum::<DVec3>().length() / found.iter().map(|f| f.length()).sum::<f64>();
        println!("{what}, D / h = {ratio}, noise {noise}: {error:.1e}, forces add up to {sum:.1e}");
        assert!(error < 1e-5, "{what}, D / h = {ratio}, noise {noise}: {error:e}");
        assert!(sum < 1e-13, "{what}, D / h = {ratio}: the forces add up to {sum:e}");
    }
}

#[test]
fn forces_are_those_of_f64_to_a_hundred_thousandth() {
    for size in [[7.0, 12.0, 7.0], [2.0, 2.0, 2.0], [3.0, 25.0, 3.0], [95.0, 3.0, 3.0]] {
        agree(&format!("{size:?}"), &filled(size, DMat3::IDENTITY), 0.4, false);
    }
    for ratio in [0.3, 0.34, 0.4, 0.5, 0.6] {
        agree("irregular", &irregular(DMat3::IDENTITY), ratio, true);
    }
    agree("irregular and turned", &irregular(turned()), 0.4, true);
    agree("box askew", &filled([8.0, 14.0, 8.0], turned()), 0.4, false);
}

#[test]
fn small_strains_of_turned_bodies_are_as_exact_as_large_ones() {
    let sample = filled([7.0, 12.0, 7.0], DMat3::IDENTITY);
    let orientation = DQuat::from_axis_angle(DVec3::new(0.3, -1.0, 0.8).normalize_or_zero(), 1.1);
    let [mut fast, mut exact] = pair_of(&sample, 0.4, false, orientation);
    for strain in [1e-2, 1e-4, 1e-6] {
        let at = |(i, &x): (usize, &DVec3)| DVec3::splat(2.0) + orientation * (x + strain * D * wobble(i, 7));
        let positions: Vec<DVec3> = sample.points.iter().enumerate().map(at).collect();
        let n = positions.len();
        let state = ParticleState { positions, velocities: vec![DVec3::ZERO; n], masses: vec![1.0; n] };
        // Once for the warm start, which is as exact as the turns of the strain before.
        forces(&mut fast, &state);
        let error = relative_error(&forces(&mut fast, &state), &forces(&mut exact, &state));
        println!("strains of {strain:e}: {error:.1e}");
        assert!(error < 1e-5, "strains of {strain:e}: {error:e}");
    }
}

#[test]
fn an_inverted_particle_agrees() {
    let sample = filled([7.0, 12.0, 7.0], DMat3::IDENTITY);
    let [mut fast, mut exact] = pair_of(&sample, 0.4, false, DQuat::IDENTITY);
    let mut state = deformed(&sample, DQuat::IDENTITY, 0.1, 5);
    state.positions[200] += DVec3::new(3.0 * D, 0.5 * D, 0.0);
    let error = relative_error(&forces(&mut fast, &state), &forces(&mut exact, &state));
    assert!(error < 1e-5, "{error:e}");
}

/// A linear deformation leaves no force inside, at any turn and far from the origin.
#[test]
fn linear_deformations_leave_no_force_inside() {
    let sample = filled([9.0, 11.0, 10.0], DMat3::IDENTITY);
    let [mut fast, _] = pair_of(&sample, 0.4, false, DQuat::IDENTITY);
    let gradient = DMat3::from_quat(DQuat::from_rotation_x(0.7))
        * DMat3::from_cols_array(&[1.06, 0.02, 0.0, 0.05, 0.93, 0.03, -0.04, 0.0, 1.02]);
    let positions: Vec<DVec3> = sample.points.iter().map(|&x| DVec3::splat(20.0) + gradient * x).collect();
    let n = positions.len();
    let state = ParticleState { positions, velocities: vec![DVec3::ZERO; n], masses: vec![1.0; n] };
    forces(&mut fast, &state);
    let found = forces(&mut fast, &state);
    let greatest = found.iter().map(|f| f.length()).fold(0.0, f64::max);
    let [low, high] =
        [sample.cells.iter().copied().reduce(glam::IVec3::min), sample.cells.iter().copied().reduce(glam::IVec3::max)];
    let inside = |cell: glam::IVec3| {
        let to_side = (cell - low.unwrap()).min(high.unwrap() - cell).min_element();
        to_side >= 4
    };
    let inner: Vec<f64> =
        sample.cells.iter().zip(&found).filter(|(cell, _)| inside(**cell)).map(|(_, f)| f.length()).collect();
    assert!(!inner.is_empty());
    let left = inner.into_iter().fold(0.0, f64::max) / greatest;
    println!("{left:.1e} of the greatest force is left inside");
    assert!(left < 2e-6, "{left:e}");
}

#[test]
fn a_body_at_rest_feels_nothing() {
    let sample = irregular(turned());
    let orientation = DQuat::from_rotation_y(2.0);
    let [mut fast, _] = pair_of(&sample, 0.4, true, orientation);
    let positions: Vec<DVec3> = sample.points.iter().map(|&x| DVec3::splat(3.0) + orientation * x).collect();
    let n = positions.len();
    let state = ParticleState { positions, velocities: vec![DVec3::ZERO; n], masses: vec![1.0; n] };
    let greatest = forces(&mut fast, &state).iter().map(|f| f.length()).fold(0.0, f64::max);
    // Of the size of the round-off in f64 positions, some 1e-16 m, times E D.
    assert!(greatest < 1e-11, "{greatest:e} N");
}

#[test]
fn the_same_bits_on_any_number_of_threads() {
    let sample = irregular(turned());
    assert!(sample.points.len() > 2000, "{} particles are too few to be split", sample.points.len());
    let state = deformed(&sample, DQuat::IDENTITY, 0.1, 9);
    let on = |threads: usize| -> Vec<u64> {
        let [mut fast, _] = pair_of(&sample, 0.4, true, DQuat::IDENTITY);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let runs = pool.install(|| (0..3).map(|_| forces(&mut fast, &state)).collect::<Vec<_>>());
        runs.iter().flatten().flat_map(|f| f.to_array().map(f64::to_bits)).collect()
    };
    let one = on(1);
    assert_eq!(one, on(2));
    assert_eq!(one, on(5));
}

/// A bar that is stretched, sheared, flies and spins, for some thousand steps in either precision.
fn flight(precision: Precision) -> (f64, f64, Vec<f64>) {
    let mut bar = short_bar(5e7);
    bar.material.precision = precision;
    bar.initial.deformation = [[0.97, 0.05, 0.0], [0.0, 1.1, 0.02], [0.03, 0.0, 0.96]];
    bar.initial.velocity = [1.0, 2.0, -0.5];
    bar.initial.angular_velocity = [300.0, 500.0, -200.0];
    let mut scene: Scene = in_space(bar);
    scene.time.frames_per_second = 1000.0;
    let mut runner = runner(&scene);
    let state = runner.world().bodies()[0].state();
    let (p0, l0) = (state.linear_momentum(), state.angular_momentum());
    let mut energies = Vec::new();
    for _ in 0..100 {
        runner.advance_frame();
        energies.push(runner.world().bodies()[0].energies(runner.world().time()).total());
    }
    let body = &runner.world().bodies()[0];
    assert!(body.steps() > 3000, "{} steps", body.steps());
    let state = body.state();
    let each = |f: &dyn Fn(usize) -> DVec3| (0..state.len()).map(|i| f(i).length()).sum::<f64>();
    let linear = (state.linear_momentum() - p0).length() / each(&|i| state.masses[i] * state.velocities[i]);
    let angular = (state.angular_momentum() - l0).length()
        / each(&|i| state.masses[i] * state.positions[i].cross(state.velocities[i]));
    (linear, angular, energies)
}

#[test]
fn momenta_and_energy_hardly_drift() {
    let (linear, angular, energies) = flight(Precision::Fast);
    let (_, _, exact) = flight(Precision::Exact);
    let mean = |energies: &[f64]| energies.iter().sum::<f64>() / energies.len() as f64;
    let trend = mean(&energies) / mean(&exact) - 1.0;
    println!("linear {linear:.1e}, angular {angular:.1e}, energy {trend:.1e} off that of f64");
    assert!(linear < 1e-13, "{linear:e}");
    assert!(angular < 1e-7, "{angular:e}");
    assert!(trend.abs() < 5e-3, "{trend:e}");
}
