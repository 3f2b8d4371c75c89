//! What lies, slides, hangs and lands on colliders that stand still.

use crate::common::*;
use glam::{DQuat, DVec3};
use serde_json::json;
use sinew::geometry::{Cuboid, box_surface};
use sinew::io::scene_from_json;
use sinew::scene::{Assets, Collider, ColliderMesh, IntegratorKind, Rotation, Scene};
use sinew::sim::Runner;

const G: f64 = 9.81;

/// A damped block on a box that is turned about Z.
pub fn on_a_ramp(young_modulus: f64, degrees: f64, thickness: f64) -> Scene {
    let turn = Rotation::about([0.0, 0.0, 1.0], -degrees);
    let mut body = block([5, 3, 5], young_modulus).with_rotation(turn.clone());
    body.material.damping.pair = 0.001 * young_modulus;
    body.placement.translation = (turn.quaternion() * DVec3::new(0.0, 0.5 * thickness, 0.0)).to_array();
    let ramp = Collider::cuboid("ramp", [4.0, thickness, 0.2]).with_rotation(turn);
    let mut scene = in_space(body).with_collider(ramp).with_gravity([0.0, -G, 0.0]);
    scene.room.contact_damping = 0.2;
    scene
}

pub fn run(runner: &mut Runner, seconds: f64) {
    let until = runner.world().time() + seconds - 1e-9;
    while runner.world().time() < until {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    }
}

pub fn positions(runner: &Runner) -> Vec<DVec3> {
    runner.world().bodies().iter().flat_map(|body| body.state().positions.iter().copied()).collect()
}

#[test]
fn a_block_on_a_ramp_holds_below_the_angle_of_friction() {
    for (young_modulus, degrees, thickness) in [(3e4, 8.0, 0.1), (2e5, 20.0, 0.003)] {
        let mut runner = runner(&on_a_ramp(young_modulus, degrees, thickness));
        run(&mut runner, 0.5);
        let before = positions(&runner);
        run(&mut runner, 0.5);
        let far = before.iter().zip(positions(&runner)).map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
        println!("{young_modulus:e} Pa on {degrees} degrees: {far:e} m in half a second");
        assert!(far < 2e-6, "{far} m");
        let [_, weight, _] = runner.world().force_on_collider(0).to_array();
        assert!((-weight / (G * 75.0 * 4e-4) - 1.0).abs() < 1e-3, "{weight} N");
    }
}

#[test]
fn above_it_a_block_slides_by_what_friction_leaves_of_gravity() {
    for (young_modulus, degrees) in [(2e5, 25.0), (2e5, 40.0)] {
        let mut runner = runner(&on_a_ramp(young_modulus, degrees, 0.1));
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        let down = DVec3::new(cos, -sin, 0.0);
        let speed = |runner: &Runner| {
            let state = runner.world().bodies()[0].state();
            state.linear_momentum().dot(down) / state.mass()
        };
        run(&mut runner, 0.2);
        let before = speed(&runner);
        run(&mut runner, 0.3);
        let (found, expected) = ((speed(&runner) - before) / 0.3, G * (sin - 0.4 * cos));
        println!("{young_modulus:e} Pa on {degrees} degrees: {found} m/s², {expected} expected");
        assert!((found / expected - 1.0).abs() < 0.01, "{found}, not {expected}");
    }
}

/// How deep the deepest point of a body's surface is in a collider [m], and how often one is.
fn deepest(runner: &Runner, gap: impl Fn(DVec3) -> f64) -> f64 {
    let snapshot = sinew::solver::Snapshot::of(runner.world());
    let surfaces = snapshot.bodies.iter().flat_map(|body| body.surface().into_owned());
    -surfaces.map(gap).fold(f64::INFINITY, f64::min)
}

#[test]
fn what_falls_on_a_ball_does_not_come_to_lie_in_it() {
    let mut body = block([7, 4, 7], 5e4);
    body.material.damping.pair = 30.0;
    body.initial.velocity = [0.0, -2.0, 0.0];
    let ball = Collider::sphere("ball", 0.03).with_translation([0.002, -0.034, 0.001]);
    let mut scene = in_space(body).with_collider(ball).with_gravity([0.0, -G, 0.0]);
    scene.room.floor = Some(-0.1);
    let mut runner = runner(&scene);
    let (mut worst, mut pressed) = (0.0_f64, 0.0_f64);
    while runner.world().time() < 0.2 {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none());
        let gap = |x: DVec3| x.distance(DVec3::new(0.002, -0.034, 0.001)) - 0.03;
        // A particle is a ball around its place.
        let into = positions(&runner).into_iter().map(|x| 0.5 * D - gap(x)).fold(0.0, f64::max);
        worst = worst.max(into).max(deepest(&runner, gap));
        pressed = pressed.max(-runner.world().force_on_collider(0).y);
    }
    println!("at most {:.3} D deep, pressed by {pressed} N", worst / D);
    assert!(worst < 0.2 * D && pressed > 2.0, "{} D, {pressed} N", worst / D);
}

fn two_layer(bodies: &serde_json::Value) -> Scene {
    scene_from_json(&json!({"version": 1, "two_layer": bodies}).to_string()).expect("a scene")
}

#[test]
fn a_ball_of_two_layers_drapes_over_a_mesh() {
    let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::new(3.0, 0.5, 3.0) }, 0.75);
    for hollow in [false, true] {
        let mut scene = two_layer(&json!([{"id": "ball", "shape": {"ball": {"subdivisions": 2}}, "pressure": 0.0,
            "placement": {"translation": [0.35, 2.35, 0.1]}}]));
        let post = Collider::new("post", ColliderMesh { hollow, ..ColliderMesh::new("post") });
        scene = scene.with_collider(post.with_friction(1.0));
        scene.validate().expect("a valid scene");
        let mut assets = Assets::default();
        assets.insert_obstacle("post", &mesh).expect("a surface");
        let mut runner = Runner::new(sinew::bake::bake(&scene, &assets).expect("a scene that bakes"));
        let layers = runner.world().bodies()[0].parts().layers.clone().expect("layers");
        let rest = runner.world().bodies()[0].parts().rest.clone();
        let springs = layers.springs.ends().iter().filter(|ends| ends.iter().all(|&i| (i as usize) < layers.outer));
        let spacing = springs.map(|[a, b]| rest[*a as usize].distance(rest[*b as usize])).fold(f64::INFINITY, f64::min);
        let (mut worst, mut touched) = (f64::NEG_INFINITY, 0.0_f64);
        while runner.world().time() < 1.0 {
            runner.advance_frame();
            assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
            for x in positions(&runner) {
                let beyond = x.abs() - DVec3::new(1.5, 0.25, 1.5);
                worst = worst.max(-beyond.max_element());
            }
            touched = touched.max(-runner.world().force_on_collider(0).y);
        }
        println!("hollow {hollow}: at most {:.3} of the spacing deep, {touched} N", worst / spacing);
        assert!(worst < 0.2 * spacing && touched > 1.0, "{worst} m of {spacing} m, {touched} N");
    }
}

#[test]
fn long_steps_rest_on_colliders_too() {
    for kind in [IntegratorKind::BackwardEuler, IntegratorKind::TrBdf2, IntegratorKind::Rk4] {
        let mut scene = on_a_ramp(2e5, 15.0, 0.1);
        scene.bodies[0] = scene.bodies[0].clone().with_integrator(kind);
        let mut runner = runner(&scene);
        run(&mut runner, 0.4);
        let before = positions(&runner);
        run(&mut runner, 0.1);
        let far = before.iter().zip(positions(&runner)).map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
        let load = -runner.world().force_on_collider(0).y / (G * 75.0 * 4e-4);
        println!("{kind:?}: {far:e} m in a tenth of a second, {load} of the weight");
        assert!(far < 1e-5 && (load - 1.0).abs() < 0.01, "{kind:?}: {far} m, {load}");
    }
}

#[test]
fn capsules_and_planes_carry_what_lies_on_them() {
    let turn = DQuat::from_rotation_z(std::f64::consts::FRAC_PI_2);
    assert!((turn * DVec3::Y + DVec3::X).length() < 1e-12);
    let mut body = block([9, 3, 5], 2e5);
    body.material.damping.pair = 200.0;
    let bar = |id: &str, x: f64| {
        Collider::capsule(id, 0.004, 0.05)
            .with_translation([x, -0.004, 0.0])
            .with_rotation(Rotation::about([1.0, 0.0, 0.0], 90.0))
    };
    let mut scene = in_space(body).with_collider(bar("left", -0.018)).with_collider(bar("right", 0.018));
    scene = scene.with_collider(Collider::plane("ground").with_translation([0.0, -0.02, 0.0]));
    scene = scene.with_gravity([0.0, -G, 0.0]);
    scene.room.contact_damping = 0.5;
    let mut runner = runner(&scene);
    run(&mut runner, 0.6);
    let load = |index| -runner.world().force_on_collider(index).y / (G * 135.0 * 4e-4);
    println!("{} and {} of the weight on two capsules, {} on the plane", load(0), load(1), load(2));
    assert!((load(0) - 0.5).abs() < 0.02 && (load(1) - 0.5).abs() < 0.02 && load(2) == 0.0);
}
