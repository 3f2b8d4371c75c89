//! Two-layer bodies against the figures of the formulation: counts, rest states, drag, collapse, density, momenta.

use crate::common::runner;
use glam::DVec3;
use serde_json::{Value, json};
use sinew::io::scene_from_json;
use sinew::scene::Scene;
use sinew::sim::Runner;
use sinew::solver::Body;
use sinew::solver::SpringKind;

/// A scene of two-layer bodies: the fields of each beside its id, b0, b1, ...; no gravity and no room unless given.
pub fn two_layer(bodies: &[Value], rest: Value) -> Scene {
    let mut scene = json!({"version": 1, "gravity": [0, 0, 0]});
    scene["two_layer"] = bodies.iter().cloned().collect();
    for (index, body) in scene["two_layer"].as_array_mut().unwrap().iter_mut().enumerate() {
        body["id"] = json!(format!("b{index}"));
    }
    if let Value::Object(rest) = rest {
        scene.as_object_mut().unwrap().extend(rest);
    }
    scene_from_json(&scene.to_string()).unwrap()
}

/// `body` with fields replaced.
pub fn with(mut body: Value, fields: Value) -> Value {
    if let Value::Object(fields) = fields {
        body.as_object_mut().unwrap().extend(fields);
    }
    body
}

pub fn segment() -> Value {
    json!({"shape": {"segment": {}}, "integrator": "rk4"})
}

pub fn ring() -> Value {
    json!({"shape": {"ring": {}}, "integrator": "rk4"})
}

pub fn ball(subdivisions: u32) -> Value {
    json!({"shape": {"ball": {"subdivisions": subdivisions}}, "integrator": "rk4"})
}

pub fn after(scene: &Scene, seconds: f64) -> Runner {
    let mut runner = runner(scene);
    for _ in 0..runner.frames_for(seconds) {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    }
    runner
}

fn body(runner: &Runner, index: usize) -> &Body {
    &runner.world().bodies()[index]
}

/// Mean distance of particles from the centre [m].
fn radius(body: &Body, particles: std::ops::Range<usize>) -> f64 {
    let center = body.state().center();
    let count = particles.len() as f64;
    body.state().positions[particles].iter().map(|x| x.distance(center)).sum::<f64>() / count
}

/// Enclosed volume [m³], or area [m²].
fn volume(body: &Body) -> f64 {
    body.parts().layers.as_ref().unwrap().outer_surface.as_ref().unwrap().volume(&body.state().positions)
}

#[test]
fn counts_after_n_subdivisions() {
    for n in 0..=5_u32 {
        let scene = two_layer(&[ball(n)], json!({}));
        let baked = crate::common::baked(&scene);
        let parts = baked.world.bodies()[0].parts();
        let (vertices, edges) = (4_usize.pow(n + 1) + 2, 12 * 4_usize.pow(n));
        assert_eq!(parts.state.len(), 2 * vertices);
        let layers = parts.layers.as_ref().unwrap();
        let count = |kind| layers.springs.groups().iter().find(|group| group.kind == kind).unwrap().springs.len();
        assert_eq!(count(SpringKind::Structural), 2 * edges);
        assert_eq!(count(SpringKind::Radius), vertices);
        assert_eq!((count(SpringKind::ShearLeft), count(SpringKind::ShearRight)), (edges, edges));
        assert_eq!(parts.skin.as_ref().unwrap().triangles().len(), 8 * 4_usize.pow(n));
    }
    let springs = |body: Value| {
        let baked = crate::common::baked(&two_layer(&[body], json!({})));
        baked.world.bodies()[0].parts().layers.as_ref().unwrap().springs.ends().len()
    };
    assert_eq!((springs(ball(1)), springs(ring()), springs(segment())), (210, 50, 1));
    assert_eq!(springs(json!({"shape": {"ring": {"sides": 7, "single_layer": true}}})), 7);
}

#[test]
fn the_ring_rests_at_the_equilibrium_of_springs_and_gas() {
    let runner = after(&two_layer(&[ring()], json!({})), 30.0);
    let body = body(&runner, 0);
    let (outer, inner, area) = (radius(body, 0..10), radius(body, 10..20), volume(body));
    println!("Ro {outer:.9}, Ri {inner:.9}, V {area:.6}");
    assert!((outer - 2.002_292_221).abs() < 1e-8 && (inner - 1.002_248_736).abs() < 1e-8);
    assert!((area - 11.782_667).abs() < 1e-6);
    // All in the plane of X and Y.
    assert!(body.state().positions.iter().all(|x| x.z == 0.0));
}

#[test]
fn a_dragged_body_hangs_by_its_weight_over_mks() {
    let drag = json!({"drags": [{"target": [0, 3, 0]}], "air_drag": 1.0});
    for (body_at, mass) in [(ring(), 20.0), (ball(1), 36.0), (segment(), 2.0)] {
        let scene = two_layer(&[with(body_at, drag.clone())], json!({"gravity": [0, -9.81, 0]}));
        let runner = after(&scene, 60.0);
        let held = body(&runner, 0).state().positions.iter().map(|x| x.distance(DVec3::new(0.0, 3.0, 0.0)));
        let extension = held.fold(f64::INFINITY, f64::min);
        let expected = mass * 9.81 / 150.0;
        println!("{mass} kg: {extension:.6} m");
        assert!((extension / expected - 1.0).abs() < 1e-6, "{extension}, not {expected}");
    }
}

#[test]
fn a_body_that_is_let_go_returns_to_rest() {
    let dragged = with(ring(), json!({"drags": [{"target": [0, 3, 0], "until": 2.0}], "air_drag": 1.0}));
    let runner = after(&two_layer(&[dragged], json!({"gravity": [0, -9.81, 0], "room": {"floor": -3}})), 30.0);
    let body = body(&runner, 0);
    assert!(body.state().kinetic_energy() < 1e-12);
    let lowest = body.state().positions.iter().map(|x| x.y).fold(f64::INFINITY, f64::min);
    // Two particles carry the weight: each sinks by M g / 2 kc.
    assert!((lowest + 3.0 + 20.0 * 9.81 / 2.0 / 5000.0).abs() < 1e-6, "{lowest}");
}

#[test]
fn a_picked_point_is_held_by_the_weight_over_mks_and_let_go_falls_to_rest() {
    // A ball still rolls off the vertex on which it lands.
    for (body_of, left) in [(ring(), 1e-9), (ball(2), 0.05)] {
        let scene = two_layer(
            &[with(body_of, json!({"air_drag": 1.0}))],
            json!({"gravity": [0, -9.81, 0], "room": {"floor": -20}}),
        );
        let mut runner = runner(&scene);
        let held = body(&runner, 0);
        let top = (0..held.parts().layers.as_ref().unwrap().outer)
            .max_by(|&a, &b| held.state().positions[a].y.total_cmp(&held.state().positions[b].y))
            .unwrap();
        let (point, target) = (held.point(top).unwrap(), DVec3::new(0.5, 4.0, 0.0));
        runner.body_mut(0).unwrap().grab(point, target);
        let go_on = |seconds: f64, runner: &mut Runner| {
            for _ in 0..runner.frames_for(seconds) {
                runner.advance_frame();
            }
        };
        go_on(60.0, &mut runner);
        let state = body(&runner, 0).state();
        let (extension, expected) = (state.positions[top].distance(target), state.mass() * 9.81 / 150.0);
        println!("{} kg: {extension:.6} m", state.mass());
        assert!((extension / expected - 1.0).abs() < 1e-5, "{extension}, not {expected}");
        runner.release_all();
        go_on(40.0, &mut runner);
        let state = body(&runner, 0).state();
        let carried: f64 = state.positions.iter().map(|x| 5000.0 * (-20.0 - x.y).max(0.0)).sum();
        println!("{:.2e} J left, the floor carries {carried:.4} N", state.kinetic_energy());
        assert!(state.kinetic_energy() < left && (carried / (state.mass() * 9.81) - 1.0).abs() < 1e-3);
    }
}

#[test]
fn two_layers_stand_without_gas_where_one_falls_flat() {
    let height = |single: bool| {
        let shape = json!({"shape": {"ring": {"single_layer": single}}, "pressure": 0, "integrator": "rk4"});
        let scene = two_layer(&[shape], json!({"gravity": [0, -9.81, 0], "room": {"floor": -3}}));
        let runner = after(&scene, 10.0);
        let ys = body(&runner, 0).state().positions.iter().map(|x| x.y);
        (ys.clone().fold(f64::NEG_INFINITY, f64::max) - ys.fold(f64::INFINITY, f64::min)) / 4.0
    };
    let (two, one) = (height(false), height(true));
    println!("height over diameter: two layers {two:.3}, one {one:.3}");
    assert!((two - 0.90).abs() < 0.01 && one < 0.005);
}

#[test]
fn the_moment_of_inertia_tells_where_the_mass_is() {
    for (outer, inner) in [(1.0, 1.0), (0.5, 1.5), (1.5, 0.5)] {
        let body_of = with(ring(), json!({"mass": outer, "inner_mass": inner, "pressure": 0}));
        let runner = after(&two_layer(&[body_of], json!({})), 0.1);
        let ratio = body(&runner, 0).parts().layers.as_ref().unwrap().inertia_ratio(body(&runner, 0).state());
        let expected = (outer + inner / 4.0) / (outer + inner);
        assert!((ratio - expected).abs() < 1e-12, "{ratio}, not {expected}");
        assert_eq!(body(&runner, 0).state().mass(), 10.0 * (outer + inner));
    }
}

#[test]
fn masses_go_by_layer_then_by_region() {
    let balloon = with(
        ball(1),
        json!({
            "mass": 1, "inner_mass": 2, "masses": [{"region": "water", "mass": 5}],
            "regions": [{"id": "water", "select": {"box": {"min": [-2, -2, -2], "max": [2, -0.5, 2]}}}]
        }),
    );
    let runner = after(&two_layer(&[balloon], json!({})), 0.0);
    let state = body(&runner, 0).state();
    for i in 0..state.len() {
        let layer = if i < 18 { 1.0 } else { 2.0 };
        let expected = if state.positions[i].y <= -0.5 { 5.0 } else { layer };
        assert_eq!(state.masses[i], expected);
    }
    assert!(state.center().y < -0.3);
}

#[test]
fn free_flight_keeps_both_momenta() {
    let thrown = json!({"initial": {"velocity": [1, 2, 0], "angular_velocity": [0, 0, 90],
        "deformation": [[1.2, 0.1, 0], [0, 0.9, 0], [0, 0, 1]]}});
    for integrator in ["rk4", "leap_frog", "feynman", "symplectic_euler", "backward_euler", "verlet", "midpoint"] {
        for body_of in [ring(), ball(1), segment()] {
            let flying = with(with(body_of, thrown.clone()), json!({"integrator": integrator}));
            let scene =
                two_layer(&[flying], json!({"time": {"step": {"manual": {"dt": 5e-4, "substeps_per_frame": 20}}}}));
            let start = runner(&scene);
            let end = after(&scene, 1.0);
            let (before, now) = (body(&start, 0).state(), body(&end, 0).state());
            let linear = now.linear_momentum() - before.linear_momentum();
            assert!(linear.length() < 1e-9 * before.linear_momentum().length(), "{integrator}: {linear}");
            // Only leap-frog and its kin keep the angular one exactly; the others to their order.
            let angular = (now.angular_momentum() - before.angular_momentum()).length();
            let share = angular / before.angular_momentum().length();
            let allowed = match integrator {
                "leap_frog" | "feynman" | "symplectic_euler" => 1e-9,
                "rk4" => 1e-8,
                "backward_euler" => 2e-2,
                _ => 1e-4,
            };
            assert!(share < allowed, "{integrator}: {share}");
        }
    }
}

#[test]
fn gas_fills_the_space_that_is_asked_for() {
    let rest = |space: &str| {
        let runner = after(&two_layer(&[with(ring(), json!({"pressure_in": space}))], json!({})), 20.0);
        (radius(body(&runner, 0), 0..10), radius(body(&runner, 0), 10..20))
    };
    let (outer, inner, both, annulus) = (rest("outer"), rest("inner"), rest("both"), rest("annulus"));
    println!("outer {outer:?}, inner {inner:?}, both {both:?}, annulus {annulus:?}");
    assert!(inner.1 > outer.1 && both.0 > outer.0 && both.1 > inner.1);
    // Between the layers it pushes the inner one inwards, against the springs that the outer one pulls.
    assert!(annulus.1 < outer.1 && annulus.0 < outer.0 && annulus.0 > 2.0);
}

#[test]
fn a_body_that_is_turned_inside_out_is_stopped_with_that_message() {
    let scene = two_layer(
        &[json!({"shape": {"ring": {"single_layer": true}}, "integrator": "explicit_euler",
            "initial": {"deformation": [[1.05, 0, 0], [0, 0.95, 0], [0, 0, 1]]}})],
        json!({"gravity": [0, -9.81, 0], "room": {"floor": -5},
            "time": {"step": {"manual": {"dt": 0.005, "substeps_per_frame": 3}}}}),
    );
    let mut runner = runner(&scene);
    for _ in 0..300 {
        runner.advance_frame();
    }
    let message = runner.world().divergence().expect("it blows up").to_string();
    assert!(message.contains("inside out") && message.contains("/time/step/manual/dt"), "{message}");
}
