//! Integrators on scenes with Table 1's values: `cargo bench --bench integrators`.
//!
//! Prints the share of real time that each reaches at 60 frames a second on one thread, and its ratio to leap-frog's,
//! all in one run and in turns. Above 1 a scene plays faster than it happens.
#![allow(clippy::print_stdout, reason = "a table is what it is for")]

use sinew::bake::bake;
use sinew::io::{load_assets, load_scene};
use sinew::scene::{IntegratorKind, Scene};
use sinew::sim::Runner;
use std::path::Path;
use std::time::Instant;

const SCENES: [&str; 9] = [
    "plant",
    "figure_08a",
    "figure_08c",
    "figure_08d",
    "leaf",
    "figure_09c",
    "long_bar",
    "short_bar",
    "figure_08c_soft",
];

const KINDS: [IntegratorKind; 3] = [IntegratorKind::LeapFrog, IntegratorKind::FibresImplicit, IntegratorKind::TrBdf2];

/// Frames of a run, the first ones of a motion.
const FRAMES: u32 = 3;
/// Runs of which the fastest counts.
const RUNS: u32 = 3;

fn main() {
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().expect("the first pool of this process");
    let names = KINDS.map(|kind| format!("{:>24}", kind.name())).join(" ");
    println!("{:>16} {names}", "");
    for name in SCENES {
        let scene = load_scene(Path::new(&format!("scenes/{name}.json"))).expect("a scene that ships");
        let runners = KINDS.map(|kind| runner(scene.clone(), kind));
        let mut best = [0.0; KINDS.len()];
        for _ in 0..RUNS {
            for (best, runner) in best.iter_mut().zip(&runners) {
                *best = f64::max(*best, share(runner.clone()));
            }
        }
        let shares = best.map(|share| format!("{share:>13.4} x {:>8.2}", share / best[0])).join(" ");
        println!("{name:>16} {shares}");
    }
}

fn runner(mut scene: Scene, kind: IntegratorKind) -> Runner {
    scene.time.frames_per_second = 60.0;
    for body in &mut scene.bodies {
        body.integrator = kind.into();
    }
    let assets = load_assets(&scene, Path::new("scenes"), &mut |_| {}).expect("models that ship");
    Runner::new(bake(&scene, &assets).expect("a world"))
}

/// Simulated over wall seconds.
fn share(mut runner: Runner) -> f64 {
    let start = Instant::now();
    for _ in 0..FRAMES {
        runner.advance_frame();
    }
    runner.world().time() / start.elapsed().as_secs_f64()
}
