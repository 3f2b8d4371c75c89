//! What touches holds up to Coulomb's limit, and slides at it.

use crate::common::*;
use crate::two_layer::{segment, two_layer, with};
use glam::DVec3;
use serde_json::json;
use sinew::scene::{Axis, HeightKey, IntegratorKind, Keyframe, MeasureKind, Motion, Panel, PanelMotion, Scene, Side};
use sinew::sim::Runner;

const G: f64 = 9.81;

/// Gravity on a slope that falls along X [m/s²].
fn slope(degrees: f64) -> [f64; 3] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [G * sin, -G * cos, 0.0]
}

/// A damped block on a floor with a coefficient of friction of 0.4, whose angle is 21.8 degrees.
fn on_a_slope(layers: [u32; 3], young_modulus: f64, degrees: f64) -> Scene {
    let mut body = block(layers, young_modulus);
    body.material.damping.pair = 0.001 * young_modulus;
    let mut scene = in_space(body);
    scene.gravity = slope(degrees);
    scene.room.floor = Some(0.0);
    scene.room.friction = 0.4;
    scene.room.contact_damping = 0.2;
    scene
}

fn run(runner: &mut Runner, seconds: f64) {
    let until = runner.world().time() + seconds - 1e-9;
    while runner.world().time() < until {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    }
}

fn places(runner: &Runner) -> Vec<DVec3> {
    runner.world().bodies().iter().flat_map(|body| body.state().positions.iter().copied()).collect()
}

/// How far the particle goes that goes furthest [m], in `seconds` after some seconds in which all comes to rest.
fn moved(scene: &Scene, settling: f64, seconds: f64) -> f64 {
    let mut runner = runner(scene);
    run(&mut runner, settling);
    let before = places(&runner);
    run(&mut runner, seconds);
    before.iter().zip(places(&runner)).map(|(a, b)| a.distance(b)).fold(0.0, f64::max)
}

#[test]
fn what_lies_on_a_slope_below_the_angle_of_friction_stays() {
    for (young_modulus, degrees) in [(3e4, 8.0), (2e5, 3.0), (2e5, 15.0), (2e5, 20.0), (2e6, 20.0)] {
        let far = moved(&on_a_slope([5, 3, 5], young_modulus, degrees), 0.5, 1.0);
        println!("{young_modulus:e} Pa on {degrees} degrees: {far:e} m in a second");
        assert!(far < 2e-6, "{young_modulus} Pa on {degrees} degrees: {far} m");
    }
}

/// Ten seconds at ten angles and four stiffnesses: minutes of computing.
#[test]
#[ignore = "a long sweep: cargo test --release --test physics -- --ignored lies_on_any_slope"]
fn what_lies_on_any_slope_stays_for_ten_seconds() {
    for young_modulus in [1e4, 1e5, 1e6, 1e7] {
        for step in 0..10 {
            let degrees = 2.0 * f64::from(step) + 2.0;
            let far = moved(&on_a_slope([5, 3, 5], young_modulus, degrees), 2.0, 10.0);
            println!("{young_modulus:e} Pa on {degrees} degrees: {far:e} m in ten seconds");
            assert!(far < 1e-4, "{young_modulus} Pa on {degrees} degrees: {far} m");
        }
    }
}

#[test]
fn what_is_too_steep_slides_by_what_friction_leaves_of_gravity() {
    for (young_modulus, degrees) in [(2e5, 25.0), (2e5, 40.0), (2e6, 30.0)] {
        let mut runner = runner(&on_a_slope([5, 3, 5], young_modulus, degrees));
        let speed = |runner: &Runner| {
            let state = runner.world().bodies()[0].state();
            state.linear_momentum().x / state.mass()
        };
        run(&mut runner, 0.2);
        let before = speed(&runner);
        run(&mut runner, 0.5);
        let found = (speed(&runner) - before) / 0.5;
        let [along, into, _] = slope(degrees);
        let expected = along + 0.4 * into;
        println!("{young_modulus:e} Pa on {degrees} degrees: {found} m/s², {expected} expected");
        assert!((found / expected - 1.0).abs() < 0.01, "{found}, not {expected}");
    }
}

#[test]
fn what_is_pulled_sticks_up_to_the_limit_and_then_slips_at_it() {
    let mut scene = on_a_slope([5, 3, 5], 2e5, 0.0);
    let body = &mut scene.bodies[0];
    body.regions = vec![layers("top", Axis::Y, Side::Max, 1)];
    let keys = [(0.0, 0.0), (0.2, 0.0), (1.2, 0.005)].map(|(time, x)| Keyframe::new(time, [x, 0.0, 0.0]));
    body.pins = vec![pin("top", &[Axis::X], Motion::Keyframes(keys.to_vec()))];
    scene.measures = vec![measure("pull", MeasureKind::reaction_force("top", [1.0, 0.0, 0.0]))];
    let weight = G * 75.0 * 4e-4;
    let mut runner = runner(&scene);
    run(&mut runner, 0.2);
    let foot = |runner: &Runner| {
        let positions = &runner.world().bodies()[0].state().positions;
        let rest = &runner.world().bodies()[0].parts().rest;
        let of_foot = (0..rest.len()).filter(|&i| rest[i].y < D);
        of_foot.map(|i| positions[i].x - rest[i].x).sum::<f64>() / 25.0
    };
    let (start, mut last) = (foot(&runner), 0.0);
    while runner.world().time() < 1.15 {
        runner.advance_frame();
        last = scalar(&runner, 0).abs();
        if last < 0.8 * 0.4 * weight {
            // What holds is as stiff as the contact: it gives by a share of the depth to which the weight presses.
            assert!((foot(&runner) - start).abs() < 2e-5, "{} m at {last} N", foot(&runner) - start);
        }
    }
    println!("{last} N, limit {} N, slipped {} m", 0.4 * weight, foot(&runner) - start);
    assert!(foot(&runner) - start > 1e-3);
    assert!((last / (0.4 * weight) - 1.0).abs() < 0.01, "{last} N, not {} N", 0.4 * weight);
}

#[test]
fn what_swings_on_its_hold_gains_nothing_and_comes_to_rest() {
    let mut scene = on_a_slope([5, 3, 5], 2e5, 0.0);
    scene.bodies[0].material.damping.pair = 0.0;
    scene.bodies[0].initial.velocity = [0.15, 0.0, 0.05];
    let mut runner = runner(&scene);
    let energy = |runner: &Runner| runner.world().bodies()[0].energies(runner.world().time()).total();
    let (start, mut before) = (energy(&runner), f64::INFINITY);
    for _ in 0..60 {
        runner.advance_frame();
        let now = energy(&runner);
        assert!(now < before + 1e-3 * start.abs(), "{before} J, then {now} J of {start} J");
        before = now.min(before);
    }
    let state = runner.world().bodies()[0].state();
    assert!((state.linear_momentum() / state.mass()).length() < 0.01, "{}", state.linear_momentum());
}

#[test]
fn a_segment_of_points_holds_on_a_slope() {
    let lying = with(segment(), json!({"placement": {"rotation": {"axis": [0, 0, 1], "degrees": 90}}, "damping": 2.0}));
    let mut scene = two_layer(&[lying], json!({"room": {"floor": -0.001, "friction": 0.4, "contact_damping": 0.2}}));
    scene.gravity = slope(15.0);
    let far = moved(&scene, 4.0, 2.0);
    println!("{far:e} m in two seconds");
    assert!(far < 1e-5, "{far} m");
}

#[test]
fn a_panel_holds_what_it_presses_on_the_floor() {
    // By its weight alone the floor would let it go.
    let fallen = |pressed: f64| {
        let mut scene = on_a_slope([5, 3, 5], 2e5, 35.0);
        let keys = vec![HeightKey::new(0.0, 0.018), HeightKey::new(0.1, 0.018 - pressed)];
        let panel = Panel::falling("panel", 0.018, [0.2, 0.2]);
        scene.panels = vec![Panel { friction: 0.4, motion: PanelMotion::Driven(keys), ..panel }];
        moved(&scene, 0.5, 1.0)
    };
    let (held, slid) = (fallen(0.001), fallen(0.0));
    println!("{held:e} m when pressed, {slid} m when not");
    assert!(held < 2e-6 && slid > 0.1, "{held} m when pressed, {slid} m when not");
}

#[test]
fn a_block_on_a_slab_stays_on_the_slope_with_it() {
    let mut scene = on_a_slope([9, 2, 9], 2e5, 12.0);
    let mut above = block([3, 3, 3], 2e5);
    above.id = "above".into();
    above.material.damping.pair = 200.0;
    above.placement.translation = [0.0, 2.0 * D, 0.0];
    scene.bodies.push(above);
    let far = moved(&scene, 1.0, 1.0);
    println!("{far:e} m in a second");
    assert!(far < 1e-5, "{far} m");
}

#[test]
fn an_edit_on_the_way_does_not_loosen_the_hold() {
    let scene = on_a_slope([5, 3, 5], 2e5, 20.0);
    let mut before = runner(&scene);
    run(&mut before, 0.5);
    let mut edited = scene.clone();
    edited.bodies[0].name = "Renamed".into();
    let mut after = runner(&edited);
    after.adopt(&before);
    let held = places(&after);
    run(&mut after, 0.5);
    let far = held.iter().zip(places(&after)).map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
    assert!(far < 2e-6, "{far} m");
}

#[test]
fn implicit_steps_hold_as_well() {
    for kind in [IntegratorKind::TrBdf2, IntegratorKind::BackwardEuler, IntegratorKind::Newmark] {
        let mut scene = on_a_slope([5, 3, 5], 2e5, 15.0);
        scene.bodies[0].integrator = kind.into();
        let far = moved(&scene, 0.5, 0.5);
        println!("{kind:?}: {far:e} m in half a second");
        assert!(far < 1e-5, "{kind:?}: {far} m");
    }
}
