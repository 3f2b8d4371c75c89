//! Bodies are pulled by the pointer.

use super::{Window, button, open, scene, until, view};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2};
use glam::DVec3;
use sinew::test_support::ui::App;

pub(super) const CUBE: &str = r#"{"version": 1, "gravity": [0, 0, 0], "bodies": [{
    "id": "cube", "shape": {"box": {"size": [0.04, 0.04, 0.04]}},
    "material": {"young_modulus": 1e5, "mass": {"per_particle": 4e-4}, "support_radius": 0.02,
        "damping": {"pair": 20, "air": 5}}
}]}"#;

const RING: &str = r#"{"version": 1, "gravity": [0, -9.81, 0], "room": {"floor": -5}, "two_layer": [{"id": "ring", "shape": {"ring": {}},
    "air_drag": 2, "pins": []}]}"#;

fn center(app: &App) -> DVec3 {
    let particles = &app.published().snapshot.bodies[0].particles;
    particles.iter().sum::<DVec3>() / particles.len() as f64
}

pub(super) fn press(window: &mut Window, at: Pos2) {
    window.event(Event::PointerMoved(at));
    window.step();
    button(window, at, PointerButton::Primary, true);
    window.step();
}

pub(super) fn move_to(window: &mut Window, from: Pos2, to: Pos2) {
    for k in 1..=10 {
        window.event(Event::PointerMoved(from.lerp(to, k as f32 / 10.0)));
        window.step();
    }
}

/// Shows frames until the body hardly moves any more.
fn come_to_rest(window: &mut Window) {
    let (mut last, mut time) = (DVec3::INFINITY, f64::NEG_INFINITY);
    until(window, |app| {
        if app.published().status.time < time + 0.05 {
            return false;
        }
        let moved = center(app).distance(last);
        (last, time) = (center(app), app.published().status.time);
        moved < 5e-4
    });
}

#[test]
fn a_drag_moves_the_body_where_the_pointer_goes_and_release_lets_go() {
    let mut window = open(scene(CUBE));
    let start = center(window.state());
    let rect = view(&window, "Result");
    let (from, to) = (rect.center(), rect.center() + Vec2::new(150.0, 0.0));
    press(&mut window, from);
    move_to(&mut window, from, to);
    // To the right on the screen, as the camera stands: along X and away from Z.
    let right = DVec3::new(0.85, 0.0, -0.53);
    let (body, vertex, target) = window.state().grabbed().expect("it is held");
    let held = move |app: &App| app.published().snapshot.bodies[body].surface()[vertex];
    until(&mut window, |app| held(app).distance(target) < 2e-3);
    assert!((center(window.state()) - start).dot(right) > 1e-3, "the body has come along");
    come_to_rest(&mut window);
    button(&window, to, PointerButton::Primary, false);
    window.step();
    window.step();
    // What is let go drifts on without being pulled back: no spring is left.
    let drift = center(window.state());
    let time = window.state().published().status.time;
    until(&mut window, |app| app.published().status.time > time + 0.1);
    assert!((center(window.state()) - drift).length() < 5e-3, "no spring is left");
    assert!(window.state().grabbed().is_none());
}

#[test]
fn p_leaves_the_point_pinned() {
    let mut window = open(scene(CUBE));
    let rect = view(&window, "Result");
    let (from, to) = (rect.center(), rect.center() + Vec2::new(0.0, -120.0));
    press(&mut window, from);
    move_to(&mut window, from, to);
    window.key_press_modifiers(Modifiers::NONE, Key::P);
    window.step();
    button(&window, to, PointerButton::Primary, false);
    window.step();
    until(&mut window, |app| center(app).y > 0.003);
    let time = window.state().published().status.time;
    until(&mut window, |app| app.published().status.time > time + 1.0);
    let held = center(window.state());
    let time = window.state().published().status.time;
    until(&mut window, |app| app.published().status.time > time + 0.5);
    assert!(held.distance(center(window.state())) < 1e-3, "it stays where it was pinned");
    assert!(held.y > 0.003, "{held}");
}

#[test]
fn a_drag_beside_the_body_pulls_nothing() {
    let mut window = open(scene(CUBE));
    let start = center(window.state());
    let rect = view(&window, "Result");
    let from = rect.left_bottom() + Vec2::new(30.0, -30.0);
    press(&mut window, from);
    move_to(&mut window, from, rect.center());
    let time = window.state().published().status.time;
    until(&mut window, |app| app.published().status.time > time + 0.2);
    assert!(center(window.state()).distance(start) < 1e-9);
}

/// A two-layer body hangs from the pointer by a spring MKS: it comes to rest M g / MKS below it, and on the floor once
/// it is let go.
#[test]
fn a_two_layer_body_hangs_from_the_pointer_by_its_own_spring() {
    let mut window = open(scene(RING));
    super::hold(&mut window);
    // From its start, however far it has fallen by now.
    super::reset(&mut window);
    // Its uppermost particle, where the result view shows it.
    let app = window.state();
    let particles = &app.published().snapshot.bodies[0].particles[..10];
    let top = particles.iter().copied().max_by(|a, b| a.y.total_cmp(&b.y)).expect("a ring");
    let at = app.shown_at(top).expect("it is seen");
    press(&mut window, at);
    // A drag begins with a move.
    window.event(Event::PointerMoved(at + Vec2::new(0.0, -8.0)));
    window.step();
    window.step();
    let (body, vertex, target) = window.state().grabbed().expect("it is held");
    super::press_key(&mut window, Modifiers::NONE, Key::Space);
    until(&mut window, |app| app.published().status.time > 15.0);
    let held = window.state().published().snapshot.bodies[body].particles[vertex];
    // 20 particles of 1 kg on MKS = 150 N/m.
    let expected = 20.0 * 9.81 / 150.0;
    let sag = (target - held).y;
    assert!((sag - expected).abs() < 0.02 * expected, "{sag} against {expected}");
    // Let go, it falls and comes to rest on the floor.
    button(&window, at, PointerButton::Primary, false);
    window.step();
    window.step();
    assert!(window.state().grabbed().is_none());
    let particles = |app: &App| app.published().snapshot.bodies[body].particles.clone();
    let start = std::time::Instant::now();
    let rest = loop {
        assert!(start.elapsed() < super::PATIENCE, "it never comes to rest");
        let before = particles(window.state());
        let time = window.state().published().status.time;
        until(&mut window, |app| app.published().status.time > time + 0.5);
        let after = particles(window.state());
        // What still falls moves by metres, what swings by centimetres.
        if after.iter().zip(&before).all(|(a, b)| a.distance(*b) < 1e-3) {
            break after;
        }
    };
    let low = rest.iter().map(|x| x.y).fold(f64::INFINITY, f64::min);
    assert!((low + 5.0).abs() < 0.1, "{low}");
}

/// Frames of 4 ms, from the pull of the pointer until a ring that touches a wall has left it, in steps of `dt` [s].
fn frames_until_it_leaves(dt: f64) -> u32 {
    let steps = (4e-3 / dt).round();
    let mut window = open(scene(&format!(
        r#"{{"version": 1, "gravity": [0, 0, 0], "room": {{"x_max": 1.99}},
            "time": {{"step": {{"manual": {{"dt": {dt}, "substeps_per_frame": {steps}}}}}}},
            "two_layer": [{{"id": "ring", "shape": {{"ring": {{}}}}, "initial": {{"velocity": [2, 0, 0]}}}}]}}"#
    )));
    super::hold(&mut window);
    super::reset(&mut window);
    let particles = &window.state().published().snapshot.bodies[0].particles[..10];
    let farthest = particles.iter().copied().min_by(|a, b| a.x.total_cmp(&b.x)).expect("a ring");
    let at = window.state().shown_at(farthest).expect("it is seen");
    press(&mut window, at);
    move_to(&mut window, at, at - Vec2::new(40.0, 0.0));
    assert!(window.state().grabbed().is_some());
    for frame in 1..500 {
        super::advance(&mut window);
        let right = window.state().published().snapshot.bodies[0].particles.iter().map(|x| x.x);
        if right.fold(f64::NEG_INFINITY, f64::max) < 1.99 - 1e-9 {
            return frame;
        }
    }
    panic!("it never leaves the wall");
}

#[test]
fn a_ring_pulled_off_a_wall_leaves_it_when_it_does_whatever_the_step() {
    let frames = [4e-4, 1e-3, 4e-3].map(frames_until_it_leaves);
    assert!(frames[0] > 20, "it was thrown into the wall first: {frames:?}");
    assert!(frames.iter().all(|count| count.abs_diff(frames[0]) <= 1), "{frames:?}");
}
