//! Scenes that ship, their models included, run and read.

use crate::common::runner;
use glam::DVec3;
use sinew::bake::bake;
use sinew::io::{load_assets, load_scene};
use sinew::scene::{FibreSource, Scene};
use sinew::sim::Runner;
use sinew::solver::MeasureValue;
use std::path::{Path, PathBuf};

pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")
}

pub fn scene(name: &str) -> Scene {
    load_scene(&folder().join(name)).expect("a scene that loads")
}

/// The scene with every fibre mirrored to the other side of x = 0.
pub fn mirrored(mut scene: Scene) -> Scene {
    for fibre in &mut scene.bodies[0].fibres {
        let FibreSource::Vertices(vertices) = &mut fibre.source else { panic!("drawn by strokes") };
        for vertex in vertices {
            vertex[0] = -vertex[0];
        }
    }
    scene
}

/// Runs a scene, models included, for `seconds`.
pub fn ran(scene: &Scene, seconds: f64) -> Runner {
    let mut runner = if scene.bodies.iter().any(|body| matches!(body.shape, sinew::scene::Shape::Mesh(_))) {
        let assets = load_assets(scene, &folder(), &mut |_| {}).unwrap();
        Runner::new(bake(scene, &assets).unwrap())
    } else {
        runner(scene)
    };
    for _ in 0..runner.frames_for(seconds) {
        runner.advance_frame();
    }
    assert!(runner.world().divergence().is_none(), "{}: {:?}", scene.name, runner.world().divergence());
    runner
}

fn index(runner: &Runner, name: &str) -> usize {
    runner.world().probes().iter().position(|probe| probe.name == name).expect("a measure of that name")
}

pub fn number(runner: &Runner, name: &str) -> f64 {
    match runner.reported_measures()[index(runner, name)] {
        MeasureValue::Scalar(value) => value,
        MeasureValue::Vector(value) => panic!("{name} is a vector: {value}"),
    }
}

pub fn vector(runner: &Runner, name: &str) -> DVec3 {
    match runner.reported_measures()[index(runner, name)] {
        MeasureValue::Vector(value) => value,
        MeasureValue::Scalar(value) => panic!("{name} is a number: {value}"),
    }
}
