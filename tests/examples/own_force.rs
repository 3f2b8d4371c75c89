//! A force of one's own, written outside the crate and given to a body: `cargo run --example own_force`.
//!
//! Every particle of a soft cube is pulled to the origin like a weight on a spring, in proportion to its mass. The cube
//! then swings as a whole, and theory says where it is at any time.
#![allow(clippy::print_stdout, reason = "an example talks to whoever runs it")]

use glam::DVec3;
use sinew::bake::bake;
use sinew::scene::{Assets, Body, Scene};
use sinew::solver::{Energies, Force, ParticleState};
use std::error::Error;
use std::f64::consts::TAU;

/// A pull to the world's origin, m ω² times the distance.
#[derive(Clone)]
struct Well {
    /// Square of the angular frequency ω [1/s²].
    omega_squared: f64,
}

impl Force for Well {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        for ((force, &x), &mass) in forces.iter_mut().zip(&state.positions).zip(&state.masses) {
            *force -= mass * self.omega_squared * x;
        }
    }

    /// What the force stores, so that reports balance: its negative gradient is the force. It is a field of
    /// acceleration as gravity is, and counted there.
    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        let moments = state.positions.iter().zip(&state.masses).map(|(x, mass)| mass * x.length_squared());
        energies.gravity += 0.5 * self.omega_squared * moments.sum::<f64>();
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

/// Where the cube starts [m], and how long a swing takes [s].
const START: f64 = 0.1;
const PERIOD: f64 = 0.5;

/// Runs the example.
///
/// # Errors
/// A scene that cannot be used.
pub fn main() -> Result<(), Box<dyn Error>> {
    let cube = Body::cuboid("cube", [0.03; 3]).with_translation([START, 0.0, 0.0]);
    let scene = Scene::new("Well").with_gravity([0.0; 3]).with_frame_rate(40.0 / PERIOD).with_body(cube);
    scene.validate()?;
    let mut world = bake(&scene, &Assets::default())?.world;

    let omega = TAU / PERIOD;
    let body = world.body_mut(0).ok_or("the scene has a body")?;
    body.add_force(Box::new(Well { omega_squared: omega * omega }));

    let mut before = 0.0;
    println!("   time    centre    theory    energy");
    for frame in 0..=40 {
        let (time, body) = (world.time(), &world.bodies()[0]);
        let centre = body.state().center().x;
        let theory = START * (omega * time).cos();
        let energy = body.energies(time).total();
        if frame % 5 == 0 {
            println!("{time:5.3} s {:6.2} mm {:6.2} mm {:7.4} mJ", 1e3 * centre, 1e3 * theory, 1e3 * energy);
        }
        if frame == 0 {
            before = energy;
        }
        assert!((centre - theory).abs() < 1e-3 * START, "{centre} m, not {theory} m, after {time} s");
        assert!((energy / before - 1.0).abs() < 1e-3, "{energy} J, not {before} J, after {time} s");
        world.advance_frame();
    }
    println!("A whole swing keeps to theory and to its energy within a thousandth.");
    Ok(())
}
