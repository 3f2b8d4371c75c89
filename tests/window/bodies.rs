//! Bodies are things: added, chosen, moved, turned, scaled, copied, coloured and taken away.

use super::editing::{set, type_path};
use super::pulling::CUBE;
use super::{Window, button, click, hold, is_settled, open, press_key, scene, still, until};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, OutputCommand, PointerButton, Pos2, Vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use sinew::scene::{OwnedBody, Shape};
use sinew::ui::Document;
use std::path::{Path, PathBuf};

fn key(window: &mut Window, key: Key) {
    press_key(window, Modifiers::NONE, key);
}

fn undo(window: &mut Window) {
    press_key(window, Modifiers::COMMAND, Key::Z);
}

fn choose(window: &mut Window, menu: &str, entry: &str) {
    click(window, menu);
    click(window, entry);
    settle(window);
}

fn settle(window: &mut Window) {
    window.step();
    until(window, is_settled);
    window.run_steps(2);
}

fn names(window: &Window) -> Vec<String> {
    window.state().scene().all_bodies().map(|body| body.title().to_owned()).collect()
}

fn body(window: &Window, index: usize) -> OwnedBody {
    window.state().scene().any_body(index).expect("it is there").owned()
}

/// Box around a body as the simulation has it [m].
fn around(window: &Window, index: usize) -> [DVec3; 2] {
    let particles = &window.state().published().snapshot.bodies[index].particles;
    particles.iter().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], &at| [low.min(at), high.max(at)])
}

fn middle(window: &Window, index: usize) -> DVec3 {
    let [low, high] = around(window, index);
    0.5 * (low + high)
}

fn click_at(window: &mut Window, at: Pos2) {
    button(window, at, PointerButton::Primary, true);
    window.step();
    button(window, at, PointerButton::Primary, false);
    window.run_steps(3);
}

/// Chooses a body where the result view shows its middle.
fn choose_body(window: &mut Window, index: usize) -> Pos2 {
    let at = window.state().shown_at(middle(window, index)).expect("it is seen");
    click_at(window, at);
    at
}

fn type_text(window: &mut Window, text: &str) {
    window.event(Event::Text(text.to_owned()));
    window.run_steps(2);
}

fn copied(window: &Window) -> Option<String> {
    window.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    })
}

#[test]
fn bodies_are_added_to_an_empty_scene_where_they_stand_free_and_each_is_one_step() {
    let mut window = open(scene(CUBE));
    hold(&mut window);
    choose(&mut window, "File", "New, empty Ctrl+Shift+N");
    assert!(names(&window).is_empty() && window.state().published().snapshot.bodies.is_empty());
    for (k, entry) in
        ["Add a ball", "Add a torus", "Add a two-layer ball", "Add a two-layer segment"].iter().enumerate()
    {
        choose(&mut window, "Body", entry);
        assert_eq!(window.state().published().status.failure, None, "{entry}");
        assert_eq!(window.state().published().at_rest.bodies.len(), k + 1, "{entry}");
    }
    assert_eq!(names(&window), ["Ball", "Torus", "Balloon", "Segment"]);
    assert_eq!(window.state().selected_body().as_deref(), Some("segment"), "what was added is chosen");
    let boxes: Vec<_> = (0..4).map(|index| around(&window, index)).collect();
    for (a, [low, high]) in boxes.iter().enumerate() {
        let size = (*high - *low).max_element();
        assert!((0.05..0.08).contains(&size) && low.y > 0.0, "{a}: {low} {high}");
        let clear = |[other_low, other_high]: &[DVec3; 2]| low.cmpgt(*other_high).any() || high.cmplt(*other_low).any();
        assert!(boxes.iter().enumerate().all(|(b, other)| a == b || clear(other)), "{a} touches another: {boxes:?}");
    }
    for left in (0..4).rev() {
        undo(&mut window);
        assert_eq!(names(&window).len(), left);
    }
    press_key(&mut window, Modifiers::COMMAND, Key::Y);
    assert_eq!(names(&window), ["Ball"]);
    settle(&mut window);
    assert_eq!(window.state().published().snapshot.bodies.len(), 1);
}

#[test]
fn a_body_is_chosen_by_a_click_and_moved_turned_and_scaled_each_in_one_step() {
    let mut window = open(scene(CUBE));
    hold(&mut window);
    let before = body(&window, 0);
    let at = choose_body(&mut window, 0);
    assert_eq!(window.state().selected_body().as_deref(), Some("cube"));
    // Along an axis by a number.
    key(&mut window, Key::G);
    key(&mut window, Key::X);
    type_text(&mut window, "30");
    assert_eq!(body(&window, 0), before, "nothing is changed while it goes on");
    key(&mut window, Key::Enter);
    settle(&mut window);
    let moved = body(&window, 0);
    assert_eq!(moved.view().placement().translation, [0.03, 0.0, 0.0]);
    assert_eq!(window.state().undo_name(), Some("Move cube"));
    assert!((middle(&window, 0) - DVec3::new(0.03, 0.0, 0.0)).length() < 1e-9, "it begins there");
    // About an axis.
    key(&mut window, Key::R);
    key(&mut window, Key::Y);
    type_text(&mut window, "90");
    key(&mut window, Key::Enter);
    settle(&mut window);
    let turn = body(&window, 0).view().placement().rotation.clone();
    assert!((turn.quaternion() * DVec3::X - DVec3::NEG_Z).length() < 1e-9, "{turn:?}");
    // Given up, it is as it was, and no step.
    let steps = window.state().undo_name().map(str::to_owned);
    key(&mut window, Key::S);
    type_text(&mut window, "3");
    key(&mut window, Key::Escape);
    settle(&mut window);
    assert_eq!(window.state().undo_name().map(str::to_owned), steps);
    let particles = window.state().published().status.particles;
    key(&mut window, Key::S);
    type_text(&mut window, "2");
    key(&mut window, Key::Enter);
    settle(&mut window);
    let scaled = body(&window, 0);
    let (OwnedBody::Solid(large), OwnedBody::Solid(small)) = (&scaled, &before) else { panic!("solids") };
    assert_eq!(large.shape.size(), Some([0.08; 3]));
    assert_eq!(large.material.young_modulus, small.material.young_modulus);
    assert_eq!(window.state().published().status.particles, particles, "as many as before");
    for _ in 0..3 {
        undo(&mut window);
    }
    assert_eq!(body(&window, 0), before);
    settle(&mut window);
    // With the pointer, by the square in its middle.
    press_key(&mut window, Modifiers::COMMAND, Key::R);
    until(&mut window, |app| app.published().status.time == 0.0);
    window.run_steps(2);
    let at = window.state().shown_at(middle(&window, 0)).unwrap_or(at);
    super::drag(&mut window, &[at, at + Vec2::new(20.0, 0.0), at + Vec2::new(60.0, -40.0)]);
    settle(&mut window);
    let [x, y, _] = body(&window, 0).view().placement().translation;
    assert!(x > 0.003 && y > 0.003, "right and up as it is seen: {x} {y}");
    let seen = window.state().shown_at(middle(&window, 0)).expect("seen");
    // But for the points within which a press is no drag yet.
    assert!(
        seen.distance(at + Vec2::new(60.0, -40.0)) < 10.0,
        "it is where the pointer left it: {seen:?}, from {at:?}"
    );
}

#[test]
fn a_body_is_copied_renamed_coloured_hidden_and_taken_away() {
    let mut window = open(scene(CUBE));
    hold(&mut window);
    choose_body(&mut window, 0);
    press_key(&mut window, Modifiers::SHIFT, Key::D);
    key(&mut window, Key::X);
    type_text(&mut window, "60");
    key(&mut window, Key::Enter);
    settle(&mut window);
    assert_eq!(names(&window), ["cube", "cube 2"]);
    assert_eq!(body(&window, 1).view().placement().translation, [0.06, 0.0, 0.0]);
    assert_eq!(window.state().selected_body().as_deref(), Some("cube-2"));
    // A copy that was not moved does not lie in what it is a copy of.
    press_key(&mut window, Modifiers::SHIFT, Key::D);
    window.run_steps(2);
    key(&mut window, Key::Enter);
    settle(&mut window);
    let aside = |a: usize, b: usize| (middle(&window, a) - middle(&window, b)).abs().max_element();
    assert!(aside(2, 0) > 0.04 && aside(2, 1) > 0.04, "{} {}", aside(2, 0), aside(2, 1));
    key(&mut window, Key::H);
    assert!(window.state().scene().bodies[2].hidden);
    press_key(&mut window, Modifiers::ALT, Key::H);
    assert!(!window.state().scene().bodies[2].hidden);
    let at = window.get_by_label("cube 3").rect().center();
    click_at(&mut window, at);
    click_at(&mut window, at);
    press_key(&mut window, Modifiers::COMMAND, Key::A);
    type_text(&mut window, "Block");
    key(&mut window, Key::Enter);
    window.step();
    assert_eq!(names(&window), ["cube", "cube 2", "Block"]);
    key(&mut window, Key::X);
    settle(&mut window);
    assert_eq!(names(&window), ["cube", "cube 2"]);
    assert_eq!(window.state().undo_name(), Some("Delete Block"));
    undo(&mut window);
    undo(&mut window);
    assert_eq!(names(&window), ["cube", "cube 2", "cube 3"]);
}

#[test]
fn a_model_joins_the_scene_and_goes_with_it_to_another_window() {
    let mut window = still();
    click(&mut window, "Body");
    click(&mut window, "Add a model…");
    type_path(&mut window, &asset("leaf.glb"));
    let is_said = |said: &str| said.starts_with("Add: leaf, a soft solid of about ") && said.contains(" particles");
    until(&mut window, |app| app.message().is_some_and(is_said));
    until(&mut window, |app| is_settled(app) && app.published().at_rest.bodies.len() == 2);
    window.run_steps(2);
    assert_eq!(window.state().published().status.failure, None, "{:?}", window.state().message());
    let OwnedBody::Solid(leaf) = body(&window, 1) else { panic!("a solid") };
    let Shape::Mesh(shape) = &leaf.shape else { panic!("a mesh") };
    let scale = shape.scale;
    assert_eq!(window.state().selected_body().as_deref(), Some("leaf"));
    key(&mut window, Key::S);
    window.event(Event::PointerMoved(Pos2::new(900.0, 400.0)));
    type_text(&mut window, "0.5");
    key(&mut window, Key::Enter);
    settle(&mut window);
    assert_eq!(window.state().published().status.failure, None, "its solid is there in that size");
    let OwnedBody::Solid(leaf) = body(&window, 1) else { panic!("a solid") };
    assert!(matches!(&leaf.shape, Shape::Mesh(shape) if (shape.scale - 0.5 * scale).abs() < 1e-12));
    window.event(Event::Copy);
    window.step();
    let text = copied(&window).expect("it is on the clipboard");

    let mut other = open(scene(CUBE));
    hold(&mut other);
    other.event(Event::Paste(text.clone()));
    other.run_steps(2);
    until(&mut other, |app| is_settled(app) && app.published().at_rest.bodies.len() == 2);
    assert_eq!(names(&other), ["cube", "leaf"], "{:?}", other.state().message());
    assert_eq!(other.state().published().status.failure, None);
    undo(&mut other);
    assert_eq!(names(&other), ["cube"]);
    let broken = text.replace("leaf.glb", "nowhere.glb");
    other.event(Event::Paste(broken));
    other.run_steps(2);
    assert!(other.state().message().is_some_and(|said| said.contains("nowhere.glb")), "{:?}", other.state().message());
    assert_eq!(names(&other), ["cube"]);
}

#[test]
fn the_support_radius_of_a_model_is_that_of_its_particles_and_fills_it_anew() {
    let mut window = open(Document::load(Some(asset("short_bar.glb"))).expect("the model"));
    hold(&mut window);
    let count = |window: &Window| {
        let OwnedBody::Solid(body) = body(window, 0) else { panic!("a solid") };
        let Shape::Mesh(shape) = body.shape else { panic!("a mesh") };
        shape.particles.expect("a count")
    };
    let before = count(&window);
    let there = window.state().published().status.particles;
    let shown = |window: &Window| -> f64 {
        let value = window.get_by_role_and_label(Role::SpinButton, "Support radius").value().expect("a number");
        value.split_whitespace().next().and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("{value}"))
    };
    let radius = shown(&window);
    let set = |window: &mut Window, label: &str, value: &str| {
        window.get_by_role_and_label(Role::SpinButton, label).scroll_to_me();
        window.run_steps(20);
        set(window, label, value);
    };
    // An eighth of the particles have twice the spacing.
    set(&mut window, "Particles", &(before / 8).to_string());
    until(&mut window, |app| is_settled(app) && app.published().status.particles < there / 4);
    assert!((shown(&window) / radius - 2.0).abs() < 0.02, "{} m, before {radius} m", shown(&window));
    set(&mut window, "Support radius", &radius.to_string());
    until(&mut window, |app| is_settled(app) && app.published().status.particles > there / 2);
    let back = f64::from(count(&window)) / f64::from(before);
    assert!((back - 1.0).abs() < 0.05, "{} particles, before {before}", count(&window));
    set(&mut window, "Young's modulus", "2e5");
    assert_eq!(f64::from(count(&window)) / f64::from(before), back);
}

fn asset(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets").join(name)
}

#[test]
fn numbers_place_a_body_and_give_its_shape() {
    let mut window = open(scene(CUBE));
    hold(&mut window);
    window.get_by_role_and_label(Role::SpinButton, "Turned by").scroll_to_me();
    window.run_steps(20);
    set(&mut window, "Turned by", "90");
    settle(&mut window);
    assert_eq!(body(&window, 0).view().placement().rotation.degrees, 90.0);
    choose(&mut window, "Body", "Add a ball");
    let particles = window.state().published().at_rest.bodies[1].particles.len();
    window.get_by_role_and_label(Role::SpinButton, "Radius").scroll_to_me();
    window.run_steps(20);
    set(&mut window, "Radius", "40 mm");
    settle(&mut window);
    assert_eq!(window.state().scene().bodies[1].shape.size(), Some([0.08; 3]));
    let now = window.state().published().at_rest.bodies[1].particles.len();
    assert!((now as f64 / particles as f64 - 1.0).abs() < 0.1, "{particles} became {now}");
}
