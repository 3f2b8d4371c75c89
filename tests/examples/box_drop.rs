//! Builds a scene, steps it and reads where its particles are: `cargo run --example box_drop`.
//!
//! A soft cube, three centimetres wide, falls five onto a floor.
#![allow(clippy::print_stdout, reason = "an example talks to whoever runs it")]

use sinew::bake::bake;
use sinew::scene::{Assets, Body, Material, Scene};
use sinew::sim::Runner;
use std::error::Error;

/// Half the width of the cube, and how far it falls [m].
const HALF: f64 = 0.015;
const DROP: f64 = 0.05;

/// Runs the example.
///
/// # Errors
/// A scene that cannot be used.
pub fn main() -> Result<(), Box<dyn Error>> {
    // 1. The document: what a scene file holds. Whatever is left out has a default.
    let material = Material::new(1e5, 0.33, 1000.0).with_damping(20.0, 0.0);
    let cube = Body::cuboid("cube", [2.0 * HALF; 3]).with_material(material).with_translation([0.0, HALF + DROP, 0.0]);
    let mut scene = Scene::new("Box drop").with_floor(0.0).with_frame_rate(100.0).with_body(cube);
    // A floor that does not give back all that falls on it.
    scene.room.contact_damping = 0.2;
    scene.validate()?;

    // 2. The world: particles and forces. The scene names no model, so that its assets are empty.
    let baked = bake(&scene, &Assets::default())?;

    // 3. The run, frame by frame. No clock is read: a frame is a hundredth of a second of simulated time.
    let mut runner = Runner::new(baked);
    let mut fallen = 0.0;
    println!("   time    centre    lowest particle");
    for frame in 0..=100_u32 {
        let world = runner.world();
        let state = world.bodies()[0].state();
        let lowest = state.positions.iter().map(|x| x.y).fold(f64::INFINITY, f64::min);
        if frame % 10 == 0 {
            println!("{:5.2} s {:7.1} mm {:13.1} mm", world.time(), 1e3 * state.center().y, 1e3 * lowest);
        }
        if frame == 8 {
            fallen = HALF + DROP - state.center().y;
        }
        // Particles are balls: the floor begins to push before a centre reaches it.
        assert!(lowest > 0.0, "a particle is in the floor at {} s", world.time());
        runner.advance_frame();
    }

    // It fell as anything falls, and lies on the floor now, hardly lower than it is high.
    assert!((fallen - 0.5 * 9.81 * 0.08 * 0.08).abs() < 1e-9, "it fell by {fallen} m in 0.08 s");
    let height = runner.world().bodies()[0].state().center().y;
    assert!((height - HALF).abs() < 0.1 * HALF, "the centre lies {height} m above the floor");
    println!("It lies on the floor, its centre {:.1} mm above it.", 1e3 * height);
    Ok(())
}
