//! The matrix in f32 against f64, both in turns in one run: other work on the machine slows both alike, and the least
//! of many times is what each takes.

use super::{SIZES, block_scene, deform};
use glam::DVec3;
use sinew::bake::bake;
use sinew::io::{load_assets, load_scene};
use sinew::scene::{Assets, Precision, Scene};
use sinew::solver::{Force, ParticleState};
use std::path::Path;
use std::time::Instant;

/// Evaluations of a time.
const EVALUATIONS: usize = 200_000;
/// Times of which the least counts.
const TIMES: usize = 30;

/// Prints the times of a force evaluation and their ratio: blocks of the paper's spacing, a leaf and a plant.
pub fn print_ratios() {
    println!("matrix, ns a particle and evaluation");
    println!("{:>12} {:>9} {:>8} {:>8} {:>7}", "", "particles", "exact", "fast", "ratio");
    for layers in SIZES {
        print_ratio(&format!("{}x{}x{}", layers[0], layers[1], layers[2]), block_scene(layers, "straight"), "");
    }
    for name in ["leaf", "plant"] {
        let scene = load_scene(Path::new(&format!("scenes/{name}.json"))).expect("a scene that ships");
        print_ratio(name, scene, "scenes");
    }
}

fn print_ratio(name: &str, mut scene: Scene, folder: &str) {
    let assets = load_assets(&scene, Path::new(folder), &mut |_| {}).expect("models that ship");
    let [(mut exact, state), (mut fast, _)] = [Precision::Exact, Precision::Fast].map(|precision| {
        scene.bodies[0].material.precision = precision;
        matrix(&scene, &assets)
    });
    let count = state.len();
    let mut least = [f64::INFINITY; 2];
    for _ in 0..TIMES {
        for (least, force) in least.iter_mut().zip([&mut exact, &mut fast]) {
            *least = least.min(time(force.as_mut(), &state) / count as f64 * 1e9);
        }
    }
    let [exact, fast] = least;
    println!("{name:>12} {count:>9} {exact:>8.1} {fast:>8.1} {:>7.2}", exact / fast);
}

/// The matrix force of the first body, and its particles slightly out of their places.
fn matrix(scene: &Scene, assets: &Assets) -> (Box<dyn Force>, ParticleState) {
    let world = bake(scene, assets).expect("a world").world;
    let parts = world.bodies()[0].parts();
    let mut state = parts.state.clone();
    deform(&mut state.positions);
    (parts.forces[0].clone(), state)
}

/// Seconds of an evaluation.
fn time(force: &mut dyn Force, state: &ParticleState) -> f64 {
    let mut forces = vec![DVec3::ZERO; state.len()];
    let evaluations = (EVALUATIONS / state.len()).max(1);
    let start = Instant::now();
    for _ in 0..evaluations {
        force.add_forces(0.0, state, divan::black_box(&mut forces));
    }
    start.elapsed().as_secs_f64() / evaluations as f64
}
