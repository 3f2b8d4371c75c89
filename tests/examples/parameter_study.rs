//! A study of one parameter: how far a clamped rod sags for how soft it is. `cargo run --example parameter_study`.
//!
//! The command line does the same for a scene file: `sinew sweep SCENE --vary /bodies/0/material/young_modulus=...`.
#![allow(clippy::print_stdout, reason = "an example talks to whoever runs it")]

use sinew::bake::bake;
use sinew::scene::{Assets, Axis, Body, Material, Measure, MeasureKind, Pin, Region, Scene, Side};
use sinew::sim::Runner;
use sinew::solver::MeasureValue;
use std::error::Error;

/// Particle spacing, length and thickness of the rod [m]: 27 layers by 3 by 3.
const SPACING: f64 = 0.006;
const LENGTH: f64 = 27.0 * SPACING;
const THICKNESS: f64 = 3.0 * SPACING;

/// From the last layer that is clamped, the third, to the end [m].
const FREE: f64 = LENGTH - 2.5 * SPACING;

/// Density [kg/m³] and gravity [m/s²], little enough for the sag to be in proportion.
const DENSITY: f64 = 1000.0;
const GRAVITY: f64 = 0.5;

/// A rod along X, clamped at its first three layers, and how its last one sags.
fn scene(young_modulus: f64) -> Scene {
    // The damping that settles the first bending mode fastest: ω = 3.516 sqrt(E I / (ρ A)) / L².
    let omega = 3.516 * (young_modulus / DENSITY / 12.0).sqrt() * THICKNESS / (FREE * FREE);
    let rod = Body::cuboid("rod", [LENGTH, THICKNESS, THICKNESS])
        .with_material(Material::new(young_modulus, 0.33, DENSITY).with_damping(0.0, 2.0 * omega))
        .with_region(Region::layers("root", Axis::X, Side::Min, 3))
        .with_region(Region::layers("tip", Axis::X, Side::Max, 1))
        .with_pin(Pin::new("clamp", "root"));
    Scene::new("Rod")
        .with_gravity([0.0, -GRAVITY, 0.0])
        .with_frame_rate(omega)
        .with_body(rod)
        .with_measure(Measure::new("sag", "rod", MeasureKind::mean_displacement("tip")))
}

/// How far the tip has sagged once everything rests [mm].
fn sag(young_modulus: f64) -> Result<f64, Box<dyn Error>> {
    let scene = scene(young_modulus);
    scene.validate()?;
    let mut runner = Runner::new(bake(&scene, &Assets::default())?);
    while !runner.at_rest() && runner.world().frame() < 400 {
        runner.advance_frame();
    }
    match runner.world().measures()[0] {
        MeasureValue::Vector(moved) => Ok(-moved.y),
        MeasureValue::Scalar(_) => Err("a displacement is a vector".into()),
    }
}

/// Runs the example.
///
/// # Errors
/// A scene that cannot be used.
pub fn main() -> Result<(), Box<dyn Error>> {
    println!("Young's modulus       sag    of Euler and Bernoulli's");
    let mut last: Option<(f64, f64)> = None;
    for young_modulus in [5e5, 1e6, 2e6] {
        let sag = sag(young_modulus)?;
        // ρ A g L⁴ / (8 E I), with A = h² and I = h⁴ / 12.
        let theory = 1e3 * 1.5 * DENSITY * GRAVITY * FREE.powi(4) / (young_modulus * THICKNESS * THICKNESS);
        println!("{:10.1e} Pa {:9.3} mm {:14.2}", young_modulus, sag, sag / theory);
        // Three layers are few, and a rod this thick gives by shear as well.
        assert!((sag / theory - 1.0).abs() < 0.1, "{sag} mm, not {theory} mm");
        if let Some((softer, more)) = last {
            let share = sag * young_modulus / (more * softer);
            assert!((share - 1.0).abs() < 0.01, "twice as stiff, but {share} times half the sag");
        }
        last = Some((young_modulus, sag));
    }
    println!("Twice as stiff, half the sag.");
    Ok(())
}
