//! The stencil against the pair list: the same forces and energies by other sums.

use crate::common::*;
use glam::{DMat3, DQuat, DVec3, IVec3};
use sinew::geometry::Cuboid;
use sinew::geometry::Kernel;
use sinew::solver::Energies;
use sinew::solver::Force;
use sinew::solver::ParticleState;
use sinew::test_support::geometry::{LatticeSample, fill_box};
use sinew::test_support::solver::Neighbourhood;
use sinew::test_support::solver::{Elasticity, MatrixForce};
use std::sync::Arc;

const YOUNG_MODULUS: f64 = 2e5;

pub fn filled(size: [f64; 3], axes: DMat3) -> LatticeSample {
    fill_box(&Cuboid { center: DVec3::new(0.3, 0.1, -0.2), size: D * DVec3::from_array(size) }, D, axes)
}

pub fn turned() -> DMat3 {
    DMat3::from_axis_angle(DVec3::new(1.0, 2.0, 0.5).normalize_or_zero(), 0.6)
}

/// A ball with a hole through it and a rod that sticks out: rows with gaps, ends of every kind.
pub fn irregular(axes: DMat3) -> LatticeSample {
    let mut sample = filled([19.0, 19.0, 30.0], DMat3::IDENTITY);
    let inside = |cell: IVec3| {
        let y = cell.as_dvec3() - DVec3::new(9.2, 8.9, 9.4);
        let ball = y.length() < 9.3 && y.truncate().length() > 3.1;
        ball || (y.x - 4.0).abs() < 1.8 && y.y.abs() < 1.8 && y.z > 0.0
    };
    sample.cells.retain(|&cell| inside(cell));
    sample.axes = axes;
    sample.points = sample.cells.iter().map(|cell| DVec3::new(0.2, -0.1, 0.4) + D * (axes * cell.as_dvec3())).collect();
    sample
}

/// Both evaluations of a sample, at a ratio of spacing to support radius and some matrix fraction at every particle.
pub fn evaluations(sample: &LatticeSample, ratio: f64, varying: bool, orientation: DQuat) -> [MatrixForce; 2] {
    let volume = D.powi(3);
    let neighbourhood = Neighbourhood::on_lattice(sample, Kernel::new(D / ratio), volume).expect("no thin part");
    let matrix_fraction = |i| if varying { 0.5 + 0.5 * wobble(i, 77).x } else { 1.0 };
    let stencil = MatrixForce::new(
        Arc::new(neighbourhood),
        sample.points.as_slice().into(),
        Elasticity::new(YOUNG_MODULUS, 0.33, D),
        volume,
        (0..sample.points.len()).map(matrix_fraction).collect(),
        orientation,
    );
    assert!(stencil.is_stencil());
    let pairs = stencil.clone().with_pair_list();
    assert!(!pairs.is_stencil());
    [stencil, pairs]
}

pub fn deformed(sample: &LatticeSample, orientation: DQuat, noise: f64, salt: u64) -> ParticleState {
    let gradient = DMat3::from_cols_array(&[1.06, 0.02, 0.0, 0.05, 0.93, 0.03, -0.04, 0.0, 1.02]);
    let bend = |x: DVec3| 2.0 * DVec3::new(x.y * x.y, -x.x * x.z, x.z * x.z);
    let positions: Vec<DVec3> = sample
        .points
        .iter()
        .enumerate()
        .map(|(i, &x)| DVec3::splat(2.0) + orientation * (gradient * x + bend(x)) + noise * D * wobble(i, salt))
        .collect();
    let n = positions.len();
    ParticleState { positions, velocities: vec![DVec3::ZERO; n], masses: vec![1.0; n] }
}

pub fn forces(force: &mut MatrixForce, state: &ParticleState) -> Vec<DVec3> {
    let mut forces = vec![DVec3::ZERO; state.len()];
    force.add_forces(0.0, state, &mut forces);
    forces
}

fn energies(force: &MatrixForce, state: &ParticleState) -> Energies {
    let mut energies = Energies::default();
    force.add_energy(0.0, state, &mut energies);
    energies
}

/// Holds both evaluations against each other over a few calls, so that warm starts come into play.
fn agree(what: &str, sample: &LatticeSample, ratio: f64, varying: bool) {
    let orientation = DQuat::from_axis_angle(DVec3::new(0.3, -1.0, 0.8).normalize_or_zero(), 1.1);
    let [mut stencil, mut pairs] = evaluations(sample, ratio, varying, orientation);
    for (noise, salt) in [(0.0, 1), (0.1, 2), (0.3, 3)] {
        let state = deformed(sample, orientation, noise, salt);
        let (found, expected) = (forces(&mut stencil, &state), forces(&mut pairs, &state));
        let scale = expected.iter().map(|f| f.length()).fold(0.0, f64::max);
        let error = found.iter().zip(&expected).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max) / scale;
        println!("{what}, D / h = {ratio}, noise {noise}: {error:e} of {scale:e} N");
        assert!(error < 1e-11, "{what}, D / h = {ratio}: {error:e}");
        let sum = found.iter().sum::<DVec3>().length() / found.iter().map(|f| f.length()).sum::<f64>();
        assert!(sum < 1e-13, "{what}, D / h = {ratio}: the forces add up to {sum:e}");
        let (found, expected) = (energies(&stencil, &state), energies(&pairs, &state));
        for (found, expected) in [(found.matrix, expected.matrix), (found.zero_energy, expected.zero_energy)] {
            assert!((found - expected).abs() < 1e-12 * expected, "{what}: {found} J, not {expected} J");
        }
    }
}

#[test]
fn boxes_of_any_rows_agree() {
    for size in [[7.0, 12.0, 7.0], [2.0, 2.0, 2.0], [3.0, 25.0, 3.0], [3.0, 4.0, 17.0], [95.0, 3.0, 3.0]] {
        agree(&format!("{size:?}"), &filled(size, DMat3::IDENTITY), 0.4, false);
    }
}

#[test]
fn every_support_agrees() {
    for ratio in [0.3, 0.31, 0.34, 0.36, 0.39, 0.4, 0.43, 0.47, 0.5, 0.55, 0.58, 0.6] {
        agree("box", &filled([7.0, 8.0, 7.0], DMat3::IDENTITY), ratio, true);
        agree("irregular", &irregular(DMat3::IDENTITY), ratio, true);
    }
}

#[test]
fn irregular_solids_turned_lattices_and_varying_shares_agree() {
    for varying in [false, true] {
        agree("irregular", &irregular(DMat3::IDENTITY), 0.4, varying);
        agree("irregular and turned", &irregular(turned()), 0.4, varying);
        agree("box askew", &filled([8.0, 14.0, 8.0], turned()), 0.4, varying);
    }
}

#[test]
fn an_inverted_particle_agrees() {
    let sample = filled([7.0, 12.0, 7.0], DMat3::IDENTITY);
    let [mut stencil, mut pairs] = evaluations(&sample, 0.4, false, DQuat::IDENTITY);
    let mut state = deformed(&sample, DQuat::IDENTITY, 0.1, 5);
    state.positions[200] += DVec3::new(3.0 * D, 0.5 * D, 0.0);
    let (found, expected) = (forces(&mut stencil, &state), forces(&mut pairs, &state));
    let scale = expected.iter().map(|f| f.length()).fold(0.0, f64::max);
    let error = found.iter().zip(&expected).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max) / scale;
    assert!(error < 1e-11, "{error:e}");
}

#[test]
fn the_stencil_has_the_same_bits_on_any_number_of_threads() {
    let sample = irregular(turned());
    assert!(sample.points.len() > 2000, "{} particles are too few to be split", sample.points.len());
    let state = deformed(&sample, DQuat::IDENTITY, 0.1, 9);
    let on = |threads: usize| {
        let [mut stencil, _] = evaluations(&sample, 0.4, true, DQuat::IDENTITY);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| (0..3).map(|_| forces(&mut stencil, &state)).collect::<Vec<_>>())
    };
    let bits = |runs: Vec<Vec<DVec3>>| -> Vec<u64> {
        runs.iter().flatten().flat_map(|f| f.to_array().map(f64::to_bits)).collect()
    };
    let one = bits(on(1));
    assert_eq!(one, bits(on(2)));
    assert_eq!(one, bits(on(5)));
}
