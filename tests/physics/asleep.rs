//! Bodies at rest take no steps until something comes to move them, and then move as if they had never slept.

use crate::common::*;
use glam::DVec3;
use sinew::scene::Scene;
use sinew::sim::Runner;
use sinew::solver::{Body, Energies, Force, ParticleState};

/// Does nothing, and does not say until when.
#[derive(Clone)]
struct Watchful;

impl Force for Watchful {
    fn add_forces(&mut self, _time: f64, _state: &ParticleState, _forces: &mut [DVec3]) {}

    fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

/// Three cubes in a row: one that flies at the next, and one that stands apart.
fn row() -> Scene {
    let cube = |id: &str, x: f64, speed: f64| {
        let mut cube = block([4, 4, 4], 1e5).with_translation([x, 0.0, 0.0]).with_velocity([speed, 0.0, 0.0]);
        id.clone_into(&mut cube.id);
        cube
    };
    let mut hit = cube("hit", 0.16, 0.0);
    // Ball before ball they would part sideways by what rounding says.
    hit.placement.translation[1..].copy_from_slice(&[3e-3, 2e-3]);
    in_space(cube("flying", 0.0, 0.8)).with_body(hit).with_body(cube("apart", 0.8, 0.0))
}

fn evaluations(runner: &Runner) -> Vec<u64> {
    runner.world().bodies().iter().map(Body::evaluations).collect()
}

fn advance(runner: &mut Runner, frames: u32) {
    for _ in 0..frames {
        runner.advance_frame();
    }
}

#[test]
fn they_wake_in_time_and_move_as_if_they_had_never_slept() {
    let mut runner = runner(&row());
    let mut world = runner.world().clone();
    for body in 0..3 {
        world.body_mut(body).expect("three bodies").add_force(Box::new(Watchful));
    }
    // What to do to each other is found in the first frame.
    advance(&mut runner, 1);
    let first = evaluations(&runner);
    advance(&mut runner, 1);
    let second = evaluations(&runner);
    assert!(second[0] > first[0] && second[1..] == first[1..], "{first:?}, {second:?}");
    advance(&mut runner, 14);
    (0..16).for_each(|_| world.advance_frame());
    let after = evaluations(&runner);
    assert!(after[1] > second[1] && after[2] == second[2], "{second:?}, {after:?}");
    for (one, other) in runner.world().bodies().iter().zip(world.bodies()) {
        let (one, other) = (one.state(), other.state());
        let apart = one.positions.iter().zip(&other.positions).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        println!("moving by {}, {apart:e} m apart", one.linear_momentum() / one.mass());
        // Where a place lies between two faces, rounding says which of them it touches.
        assert!(apart < 2e-3 * D, "{apart}");
    }
    let hit = runner.world().bodies()[1].state();
    assert!(hit.linear_momentum().x > 0.3 * hit.mass(), "it was hit");
}

#[test]
fn a_blow_or_a_pull_wakes_them() {
    let mut world = runner(&row()).world().clone();
    (0..2).for_each(|_| world.advance_frame());
    let start = world.bodies()[2].state().center();
    let asleep = world.clone();
    world.body_mut(2).expect("three bodies").strike(DVec3::new(0.0, 0.01, 0.0));
    (0..3).for_each(|_| world.advance_frame());
    assert!(world.bodies()[2].state().center().y > start.y + 1e-4);
    let mut world = asleep;
    let body = world.body_mut(2).expect("three bodies");
    body.grab(body.point(0).expect("a point"), start + DVec3::Z);
    (0..3).for_each(|_| world.advance_frame());
    assert!(world.bodies()[2].state().center().z > start.z + 1e-4);
}

#[test]
fn a_world_at_rest_takes_no_steps_and_its_time_goes_on() {
    let mut runner = runner(&in_space(block([4, 4, 4], 1e5)));
    let before = evaluations(&runner);
    advance(&mut runner, 30);
    assert_eq!(evaluations(&runner), before);
    assert!((runner.world().time() - 0.5).abs() < 1e-12);
}

#[test]
fn a_stiff_body_that_begins_to_fall_does_not_sleep() {
    // So stiff that its weight is no force to speak of beside what it can bear.
    let mut scene = in_space(block([4, 4, 4], 1e10));
    scene.gravity = [0.0, -9.81, 0.0];
    scene.time.frames_per_second = 1000.0;
    let mut runner = runner(&scene);
    let start = runner.world().bodies()[0].state().center().y;
    advance(&mut runner, 20);
    let fallen = start - runner.world().bodies()[0].state().center().y;
    assert!((fallen - 0.5 * 9.81 * 0.02_f64.powi(2)).abs() < 1e-9, "{fallen}");
}
