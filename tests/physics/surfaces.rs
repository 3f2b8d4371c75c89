//! Fibre solids meet by their surfaces: flat ones are flat, what is frictionless slides, and nothing is gained or lost.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{Axis, Body, Motion, Rotation, Scene, Side};
use sinew::sim::Runner;
use sinew::solver::ParticleState;

const G: f64 = 9.81;

fn named(id: &str, layers: [u32; 3], young_modulus: f64, at: [f64; 3]) -> Body {
    Body { id: id.into(), ..block(layers, young_modulus) }.with_translation(at)
}

fn run(runner: &mut Runner, seconds: f64) {
    let until = runner.world().time() + seconds - 1e-9;
    while runner.world().time() < until {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    }
}

fn velocity(runner: &Runner, index: usize) -> DVec3 {
    let state = runner.world().bodies()[index].state();
    state.linear_momentum() / state.mass()
}

fn energy(runner: &Runner) -> f64 {
    let world = runner.world();
    world.bodies().iter().map(|body| body.energies(world.time()).total()).sum()
}

fn momenta(runner: &Runner) -> [DVec3; 2] {
    let states = || runner.world().bodies().iter().map(sinew::solver::Body::state);
    [states().map(ParticleState::linear_momentum).sum(), states().map(ParticleState::angular_momentum).sum()]
}

#[test]
fn a_frictionless_box_slides_down_a_frictionless_slab() {
    let degrees: f64 = 10.0;
    let mut slab = named("slab", [24, 2, 5], 2e5, [0.0; 3]);
    slab.regions = vec![layers("below", Axis::Y, Side::Min, 1)];
    slab.pins = vec![pin("below", &ALL, Motion::Fixed)];
    let mut scene = in_space(slab);
    // Off the slab's lattice, so that balls on balls would hold it.
    scene.bodies.push(named("box", [3, 3, 3], 2e5, [-0.0505, 2.0 * D, 0.0013]));
    for body in &mut scene.bodies {
        body.material.damping.pair = 200.0;
    }
    let (sin, cos) = degrees.to_radians().sin_cos();
    scene.gravity = [G * sin, -G * cos, 0.0];
    scene.room.friction = 0.0;
    scene.room.contact_damping = 0.2;
    let mut runner = runner(&scene);
    run(&mut runner, 0.1);
    let before = velocity(&runner, 1).x;
    run(&mut runner, 0.2);
    let found = (velocity(&runner, 1).x - before) / 0.2;
    println!("{found} m/s², {} expected", G * sin);
    assert!((found / (G * sin) - 1.0).abs() < 0.01, "{found} m/s²");
}

/// Two boxes that fly at each other at `speed` [m/s], turned by `degrees` and a little askew.
fn pair(degrees: f64, speed: f64, friction: f64) -> Scene {
    let mut left = named("left", [4, 4, 4], 2e5, [0.0; 3]);
    left.initial.velocity = [speed, 0.0, 0.0];
    let mut right = named("right", [4, 4, 4], 5e5, [0.045, 0.004, 0.002]);
    right.placement.rotation = Rotation::about([0.3, 0.2, 1.0], degrees);
    let mut scene = in_space(left);
    scene.bodies.push(right);
    scene.room.friction = friction;
    scene.room.contact_damping = 0.0;
    scene
}

#[test]
fn bodies_that_collide_keep_both_momenta_with_friction_too() {
    for (degrees, speed, friction) in [(0.0, 0.5, 0.6), (20.0, 1.0, 0.3), (45.0, 0.7, 2.0)] {
        let mut runner = runner(&pair(degrees, speed, friction));
        let before = momenta(&runner);
        run(&mut runner, 0.12);
        let after = momenta(&runner);
        let [linear, angular] = [0, 1].map(|k| (after[k] - before[k]).length());
        let size = before[0].length();
        let own = |state: &ParticleState| state.angular_momentum() - state.center().cross(state.linear_momentum());
        let spin: f64 = runner.world().bodies().iter().map(|body| own(body.state()).length()).sum();
        println!(
            "{degrees} degrees: {:e} of P, {:e} of P R; spin {:e} of P R",
            linear / size,
            angular / (size * 0.024),
            spin / (size * 0.024)
        );
        assert!(velocity(&runner, 1).x > 0.1 * speed, "they have met");
        assert!(spin > 1e-3 * size * 0.024, "they have set each other turning");
        assert!(linear < 1e-13 * size, "{linear} N s of {size}");
        assert!(angular < 1e-12 * size * 0.024, "{angular} N m s");
    }
}

#[test]
fn an_undamped_pair_keeps_its_energy() {
    for (degrees, speed) in [(0.0, 0.5), (10.0, 2.0), (27.0, 1.0), (45.0, 0.3), (63.0, 3.0), (80.0, 1.5)] {
        let mut runner = runner(&pair(degrees, speed, 0.0));
        let before = energy(&runner);
        let mut most = f64::NEG_INFINITY;
        for _ in 0..20 {
            run(&mut runner, 0.004 / speed);
            most = most.max(energy(&runner));
        }
        let after = energy(&runner);
        println!("{degrees} degrees, {speed} m/s: {} after, {} at the most", after / before, most / before);
        assert!(velocity(&runner, 1).x > 0.1 * speed, "they have met");
        assert!(after > 0.99 * before && after < (1.0 + 1e-4) * before, "{after} J of {before} J");
    }
}

#[test]
fn friction_takes_energy_and_never_gives_any() {
    for (degrees, speed, friction) in [(0.0, 0.5, 0.6), (30.0, 1.0, 0.3)] {
        let mut runner = runner(&pair(degrees, speed, friction));
        let before = energy(&runner);
        run(&mut runner, 0.08 / speed);
        let after = energy(&runner);
        println!("{degrees} degrees, {speed} m/s: {}", after / before);
        assert!(velocity(&runner, 1).x > 0.1 * speed, "they have met");
        assert!(after < before && after > 0.5 * before, "{after} J of {before} J");
    }
}
