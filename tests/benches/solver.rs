//! Force evaluations and stroke lifting, one thread: `cargo bench`.
//!
//! Divan prints times per evaluation; items per second are particles (matrix), structure particles (fibres), springs or
//! faces (two-layer bodies). The matrix in f32 against f64 comes last, or alone by `cargo bench --bench solver
//! precision`.
#![allow(clippy::print_stdout, reason = "a benchmark's results")]

mod precision;

use divan::Bencher;
use divan::counter::ItemsCount;
use glam::{DMat3, DQuat, DVec2, DVec3};
use sinew::bake::bake;
use sinew::geometry::Cuboid;
use sinew::geometry::Kernel;
use sinew::scene::{Assets, Scene};
use sinew::sketch::{LiftOptions, Stroke, View, lift};
use sinew::solver::Force;
use sinew::solver::ParticleState;
use sinew::solver::World;
use sinew::test_support::geometry::fill_box;
use sinew::test_support::solver::Neighbourhood;
use sinew::test_support::solver::{Elasticity, MatrixForce};
use std::sync::Arc;

fn main() {
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().expect("the first pool of this process");
    divan::main();
    // Under `cargo bench` without a filter, or with this one.
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments == ["--bench"] || arguments.iter().any(|argument| argument == "precision") {
        precision::print_ratios();
    }
}

const D: f64 = 0.006;

/// A block of layers at the paper's spacing with four vertical fibres of one vertex a layer.
fn block(layers: [u32; 3], rest_shape: &str) -> World {
    bake(&block_scene(layers, rest_shape), &Assets::default()).expect("a world").world
}

fn block_scene([x, y, z]: [u32; 3], rest_shape: &str) -> Scene {
    let d = D;
    let size = [f64::from(x) * d, f64::from(y) * d, f64::from(z) * d];
    let fibres: Vec<serde_json::Value> = [[-0.012, -0.012], [-0.012, 0.012], [0.012, -0.012], [0.012, 0.012]]
        .iter()
        .enumerate()
        .map(|(k, [x, z])| {
            let vertices: Vec<[f64; 3]> =
                (0..=y).map(|layer| [*x, (f64::from(layer) - 0.5 * f64::from(y)) * d, *z]).collect();
            serde_json::json!({
                "id": format!("f{k}"), "source": {"vertices": vertices}, "rest_shape": rest_shape,
                "stiffness": {"paper": {"kb": 5e5, "ks": 2.5e5}}
            })
        })
        .collect();
    let scene = serde_json::json!({
        "version": 1, "gravity": [0, 0, 0],
        "bodies": [{
            "id": "block", "shape": {"box": {"size": size}}, "fibres": fibres,
            "initial": {"angular_velocity": [300, 500, -200]},
            "material": {"young_modulus": 5e7, "mass": {"per_particle": 4e-4}, "support_radius": 0.015}
        }]
    });
    serde_json::from_value(scene).expect("a scene")
}

/// The forces of a block, and its particles slightly out of their places.
fn deformed_block(layers: [u32; 3], rest_shape: &str) -> (Vec<Box<dyn Force>>, ParticleState) {
    let world = block(layers, rest_shape);
    let parts = world.bodies()[0].parts();
    let mut state = parts.state.clone();
    deform(&mut state.positions);
    (parts.forces.clone(), state)
}

fn deform(positions: &mut [DVec3]) {
    for x in positions {
        *x += 1e-4 * DVec3::new((300.0 * x.y).sin(), (200.0 * x.z).sin(), (250.0 * x.x).sin());
    }
}

const SIZES: [[u32; 3]; 4] = [[7, 12, 7], [13, 14, 15], [22, 22, 22], [37, 37, 37]];

fn evaluate(bencher: Bencher<'_, '_>, force: &mut dyn Force, state: &ParticleState, items: usize) {
    let mut forces = vec![DVec3::ZERO; state.len()];
    bencher.counter(ItemsCount::new(items)).bench_local(|| force.add_forces(0.0, state, divan::black_box(&mut forces)));
}

#[divan::bench(args = SIZES, sample_count = 20)]
fn matrix(bencher: Bencher<'_, '_>, layers: [u32; 3]) {
    let (mut forces, state) = deformed_block(layers, "straight");
    evaluate(bencher, forces[0].as_mut(), &state, state.len());
}

/// The matrix by its other evaluation.
#[divan::bench(args = SIZES, sample_count = 20)]
fn matrix_by_pairs(bencher: Bencher<'_, '_>, layers: [u32; 3]) {
    let shape = Cuboid { center: DVec3::ZERO, size: D * DVec3::from_array(layers.map(f64::from)) };
    let sample = fill_box(&shape, D, DMat3::IDENTITY);
    let n = sample.points.len();
    let mut positions = sample.points.clone();
    deform(&mut positions);
    let state = ParticleState { positions, velocities: vec![DVec3::ZERO; n], masses: vec![4e-4; n] };
    let neighbourhood = Neighbourhood::on_lattice(&sample, Kernel::new(2.5 * D), D.powi(3)).expect("no thin part");
    let elasticity = Elasticity::new(5e7, 0.33, D);
    let matrix_fraction = vec![1.0; n].into();
    let force = MatrixForce::new(
        Arc::new(neighbourhood),
        sample.points.into(),
        elasticity,
        D.powi(3),
        matrix_fraction,
        DQuat::IDENTITY,
    );
    evaluate(bencher, &mut force.with_pair_list(), &state, n);
}

/// Whole steps of a block in motion; items are particles times steps.
#[divan::bench(args = [("straight", SIZES[0]), ("as_drawn", SIZES[0]), ("as_drawn", SIZES[1])], sample_count = 20)]
fn whole_step(bencher: Bencher<'_, '_>, (rest_shape, layers): (&str, [u32; 3])) {
    let mut world = block(layers, rest_shape);
    world.advance_frame();
    let body = &world.bodies()[0];
    let items = body.steps() as usize * body.state().len();
    bencher.counter(ItemsCount::new(items)).bench_local(|| world.advance_frame());
}

/// A frame of the built-in scene as it lands, and what it takes to keep one among a hundred others.
#[divan::bench(sample_count = 20)]
fn built_in_frame(bencher: Bencher<'_, '_>) {
    let mut world = built_in();
    bencher.bench_local(|| world.advance_frame());
}

#[divan::bench(sample_count = 200)]
fn built_in_frame_kept(bencher: Bencher<'_, '_>) {
    let world = built_in();
    let mut kept = std::collections::VecDeque::new();
    bencher.bench_local(|| {
        kept.push_back(world.checkpoint());
        if kept.len() > 100 {
            kept.pop_front();
        }
    });
}

fn built_in() -> World {
    let scene: Scene = serde_json::from_str(include_str!("../../scenes/short_bar_soft.json")).expect("a scene");
    let mut world = bake(&scene, &Assets::default()).expect("a world").world;
    for _ in 0..10 {
        world.advance_frame();
    }
    world
}

/// Edges and bends of four fibres alone; items are vertices. Bends of a shape as drawn turn with the material.
#[divan::bench(args = [("straight", SIZES[0]), ("as_drawn", SIZES[0]), ("straight", SIZES[1]), ("as_drawn", SIZES[1])])]
fn four_fibres(bencher: Bencher<'_, '_>, (rest_shape, layers): (&str, [u32; 3])) {
    let (mut forces, state) = deformed_block(layers, rest_shape);
    evaluate(bencher, forces[1].as_mut(), &state, 4 * (layers[1] as usize + 1));
}

/// Springs of a two-layer ball of these subdivisions, 36 to 8,196 particles, a little out of shape and moving.
#[divan::bench(args = [1, 2, 3, 4, 5])]
fn springs(bencher: Bencher<'_, '_>, subdivisions: u32) {
    let (mut force, state) = ball(subdivisions, 0);
    // Twice the edges, a radius a vertex, two shears an edge.
    let count = 48 * 4_usize.pow(subdivisions) + 4_usize.pow(subdivisions + 1) + 2;
    evaluate(bencher, force.as_mut(), &state, count);
}

/// Gas of the same balls; items are faces.
#[divan::bench(args = [1, 2, 3, 4, 5])]
fn gas(bencher: Bencher<'_, '_>, subdivisions: u32) {
    let (mut force, state) = ball(subdivisions, 1);
    evaluate(bencher, force.as_mut(), &state, 8 * 4_usize.pow(subdivisions));
}

fn ball(subdivisions: u32, force: usize) -> (Box<dyn Force>, ParticleState) {
    let scene = serde_json::json!({
        "version": 1, "gravity": [0, 0, 0],
        "two_layer": [{"id": "ball", "shape": {"ball": {"subdivisions": subdivisions}}}]
    });
    let scene: Scene = serde_json::from_value(scene).expect("a scene");
    let baked = bake(&scene, &Assets::default()).expect("a world");
    let parts = baked.world.bodies()[0].parts();
    let mut state = parts.state.clone();
    for (x, v) in state.positions.iter_mut().zip(&mut state.velocities) {
        *v = DVec3::new((3.0 * x.y).sin(), (2.0 * x.z).sin(), (2.5 * x.x).sin());
        *x += 1e-2 * *v;
    }
    (parts.forces[force].clone(), state)
}

#[divan::bench]
fn lift_two_strokes(bencher: Bencher<'_, '_>) {
    let helix = |t: f64| DVec3::new(0.01 * (6.0 * t).cos(), 0.07 * t, 0.01 * (6.0 * t).sin());
    let stroke = |view: View| {
        let points =
            (0..=400).map(|k| view.project(helix(f64::from(k) / 400.0))).map(|p| DVec2::new(p.x, p.y)).collect();
        Stroke { view, points }
    };
    let (front, side) = (stroke(View::Front), stroke(View::Side));
    let options = LiftOptions { flip_second: false, stretch: false, model_diagonal: 0.093 };
    bencher.bench_local(|| lift(divan::black_box(&front), &side, &options));
}
