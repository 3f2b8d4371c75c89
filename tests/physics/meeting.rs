//! Contact between bodies of both kinds, and with the room.

use crate::common::{block, in_space, runner};
use crate::two_layer::{after, ball, ring, segment, two_layer, with};
use glam::DVec3;
use serde_json::{Value, json};
use sinew::scene::Scene;
use sinew::sim::Runner;

fn momenta(runner: &Runner) -> (DVec3, DVec3) {
    let states = || runner.world().bodies().iter().map(sinew::solver::Body::state);
    (
        states().map(sinew::solver::ParticleState::linear_momentum).sum(),
        states().map(sinew::solver::ParticleState::angular_momentum).sum(),
    )
}

fn center(runner: &Runner, index: usize) -> DVec3 {
    runner.world().bodies()[index].state().center()
}

/// Two bodies that fly at each other along X from `distance` apart, a little askew.
fn head_on(one: Value, other: Value, distance: f64) -> Scene {
    let at =
        |x: f64, v: f64, y: f64| json!({"placement": {"translation": [x, y, 0]}, "initial": {"velocity": [v, 0, 0]}});
    let half = 0.5 * distance;
    two_layer(
        &[with(one, at(-half, 3.0, 0.0)), with(other, at(half, -2.0, 0.3))],
        json!({"room": {"friction": 0}, "time": {"frames_per_second": 120}}),
    )
}

#[test]
fn two_bodies_that_collide_part_again_and_keep_their_momentum() {
    for (one, other) in [(ball(1), ball(2)), (ring(), ring()), (ball(2), ring()), (segment(), ball(1))] {
        let scene = head_on(one.clone(), other.clone(), 6.0);
        let before = momenta(&runner(&scene));
        let runner = after(&scene, 2.5);
        let now = momenta(&runner);
        let size = 36.0 * 3.0;
        // A ring is held in its plane, which takes what is pushed out of it.
        let free = if one["shape"]["ring"].is_object() || other["shape"]["ring"].is_object() {
            (DVec3::new(1.0, 1.0, 0.0), DVec3::Z)
        } else {
            (DVec3::ONE, DVec3::ONE)
        };
        let (linear, angular) = ((now.0 - before.0) * free.0, (now.1 - before.1) * free.1);
        assert!(linear.length() < 1e-11 * size, "{one} {other}: {linear}");
        assert!(angular.length() < 1e-4 * size, "{one} {other}: {angular}");
        let speed = |index: usize| runner.world().bodies()[index].state().linear_momentum().x;
        assert!(speed(0) < 0.9 * 3.0 * runner.world().bodies()[0].state().mass(), "{one} {other}: they met");
        println!("{one} {other}: {} {}, {:?}", center(&runner, 0), center(&runner, 1), runner.world().divergence());
        // A segment is thrown aside, but stays on its side.
        assert!(center(&runner, 1).x - center(&runner, 0).x > 0.5, "{one} {other}: neither went through the other");
    }
}

#[test]
fn fibre_solids_collide_too() {
    let mut left = block([5, 5, 5], 2e5);
    left.initial.velocity = [0.5, 0.0, 0.0];
    let mut right = block([5, 5, 5], 5e5);
    right.id = "right".into();
    right.placement.translation = [0.035, 0.003, 0.001];
    let mut scene = in_space(left);
    scene.bodies.push(right);
    scene.room.friction = 0.0;
    let before = momenta(&runner(&scene));
    let runner = after(&scene, 0.1);
    let now = momenta(&runner);
    assert!((now.0 - before.0).length() < 1e-13, "{} {}", before.0, now.0);
    assert!((now.1 - before.1).length() < 1e-12, "{} {}", before.1, now.1);
    let velocity = |index: usize| {
        let state = runner.world().bodies()[index].state();
        state.linear_momentum().x / state.mass()
    };
    println!("{} m/s, {} m/s", velocity(0), velocity(1));
    // Of equal masses the second takes over most of the motion, but for what makes both ring.
    assert!(velocity(1) > 0.3 && velocity(0) < 0.2);
}

#[test]
fn a_ball_dropped_on_a_bar_comes_to_rest_on_it() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/two_layer_ball_on_bar.json");
    let scene = sinew::io::load_scene(&path).unwrap();
    let runner = after(&scene, 2.0 * scene.time.duration);
    let bar = &runner.world().bodies()[0].state().positions;
    let top = bar.iter().map(|x| x.y).fold(f64::NEG_INFINITY, f64::max);
    let ball = runner.world().bodies()[1].state();
    let lowest = ball.positions.iter().map(|x| x.y).fold(f64::INFINITY, f64::min);
    println!("bar up to {top} m, ball from {lowest} m");
    assert!(lowest > top - 0.005 && lowest < top + 0.01, "{lowest} {top}");
    let speed = ball.velocities.iter().map(|v| v.length()).fold(0.0, f64::max);
    assert!(speed < 0.02, "{speed} m/s");
}

#[test]
fn a_panel_squeezes_a_ball_and_rests_on_it() {
    let scene = two_layer(
        &[ball(2)],
        json!({"gravity": [0, -9.81, 0], "room": {"floor": -2.0}, "panels": [
            {"id": "lid", "height": 2.2, "size": [6, 6], "mass": 200, "motion": "falls"}]}),
    );
    let runner = after(&scene, 15.0);
    let panel = &runner.world().panels()[0];
    println!("panel at {} m", panel.height);
    assert!(panel.velocity.abs() < 0.05 && panel.height > -1.5 && panel.height < 1.9);
}

/// When a body that is thrown against a wall leaves it again [s].
fn lift_off(law: &str, integrator: &str, dt: f64) -> Option<f64> {
    let body =
        with(ring(), json!({"integrator": integrator, "contact": {"law": law}, "initial": {"velocity": [2, 0, 0]}}));
    let scene = two_layer(
        &[body],
        json!({"room": {"x_max": 3}, "time": {"step": {"manual": {"dt": dt, "substeps_per_frame": 1}}}}),
    );
    let mut runner = runner(&scene);
    let mut touched = false;
    for _ in 0..(4.0 / dt) as u32 {
        runner.advance_frame();
        let far = runner.world().bodies()[0].state().positions.iter().map(|x| x.x).fold(f64::NEG_INFINITY, f64::max);
        touched |= far > 3.0 - 1e-9;
        if touched && far < 3.0 - 1e-9 {
            return Some(runner.world().time());
        }
    }
    None
}

#[test]
fn leaving_a_wall_does_not_depend_on_the_step() {
    // A push that never pulls: found within the coarsest step, by any integrator.
    for integrator in ["rk4", "midpoint", "leap_frog"] {
        let times = [4e-4, 1e-3, 4e-3].map(|dt| lift_off("penalty", integrator, dt).expect("it leaves"));
        println!("{integrator}: {times:?} s");
        assert!(times.iter().all(|time| (time - 1.052).abs() < 0.0045), "{integrator}: {times:?}");
    }
}

#[test]
fn the_papers_reset_sticks_and_for_how_long_depends_on_the_step() {
    // Put on the wall, but not stopped: what still flies into it holds the body there.
    let penalty = lift_off("penalty", "rk4", 1e-3).expect("it leaves");
    let times = [2e-4, 4e-4, 1e-3, 2e-3, 4e-3].map(|dt| lift_off("paper_reset", "rk4", dt).expect("it leaves"));
    println!("penalty {penalty} s, reset {times:?} s");
    assert!(times.iter().all(|time| time - penalty > 0.15), "{times:?}");
    // The shorter the steps the oftener it is put back: 30 ms in all, where a push differs by less than a step.
    assert!(times.windows(2).all(|pair| pair[0] > pair[1]), "{times:?}");
    assert!((times[0] - times[4] - 0.030).abs() < 0.005, "{times:?}");
}
