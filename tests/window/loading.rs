//! Models that take long: how far reading and filling have come is seen, and both end where they are not wanted.

use super::editing::{drop_file, type_path};
use super::{Window, click, click_on, is_settled, still, until, until_seen};
use egui::accesskit::Role;
use egui::{Event, Shape};
use egui_kittest::kittest::Queryable;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A ball of `rings` rings as a file has it.
fn ball(rings: u32) -> String {
    let sides = 2 * rings;
    let mut text = "v 0 0 0.05\nv 0 0 -0.05\n".to_owned();
    let mut line = |line: std::fmt::Arguments<'_>| text.write_fmt(line).expect("a string takes it");
    for ring in 1..=rings {
        let (sine, cosine) = (std::f64::consts::PI * f64::from(ring) / f64::from(rings + 1)).sin_cos();
        for side in 0..sides {
            let (y, x) = (std::f64::consts::TAU * f64::from(side) / f64::from(sides)).sin_cos();
            line(format_args!("v {} {} {}\n", 0.05 * sine * x, 0.05 * sine * y, 0.05 * cosine));
        }
    }
    let index = |ring: u32, side: u32| 3 + ring * sides + side % sides;
    for side in 0..sides {
        line(format_args!("f 1 {} {}\n", index(0, side), index(0, side + 1)));
        line(format_args!("f 2 {} {}\n", index(rings - 1, side + 1), index(rings - 1, side)));
        for ring in 0..rings - 1 {
            let [a, b] = [index(ring, side), index(ring + 1, side)];
            line(format_args!("f {a} {b} {} {}\n", index(ring + 1, side + 1), index(ring, side + 1)));
        }
    }
    text
}

fn folder(name: &str, text: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    put(folder.path(), name, text);
    folder
}

fn put(folder: &Path, name: &str, text: &str) {
    fs::write(folder.join(name), text).expect("written");
}

#[test]
fn a_model_that_takes_long_to_read_is_told_of_and_cancelled() {
    let folder = folder("large.obj", &ball(200));
    let mut window = still();
    let before = window.state().scene().clone();
    window.input_mut().dropped_files.push(super::editing::dropped(folder.path().join("large.obj")));
    window.step();
    until_seen(&mut window, |window| window.query_by_label_contains("large.obj: ").is_some());
    assert!(window.state().is_loading());
    window.get_by_role_and_label(Role::Button, "Cancel").click();
    window.run_steps(2);
    assert!(!window.state().is_loading());
    // What was read all the same is heard by nobody, and the window takes another.
    drop_file(&mut window, folder.path().join("nowhere.obj"));
    until(&mut window, |app| app.message().is_some_and(|said| said.contains("nowhere.obj")));
    assert_eq!(*window.state().scene(), before);
}

#[test]
fn filling_a_model_tells_how_far_it_is_and_stops() {
    let folder = folder("ball.obj", &ball(12));
    // More particles than are soon found.
    put(
        folder.path(),
        "many.json",
        r#"{"version": 1, "name": "Many", "bodies": [{"id": "ball", "name": "Ball",
            "shape": {"mesh": {"path": "ball.obj", "particles": 1500000}},
            "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.01}}]}"#,
    );
    let mut window = still();
    drop_file(&mut window, folder.path().join("many.json"));
    until_seen(&mut window, |window| {
        let told = "Putting together Ball: filling the shape with particles, ";
        window.query_all_by_label_contains(told).next().is_some()
    });
    click_on(&mut window, Role::Button, "Stop");
    until(&mut window, |app| app.published().status.stopped && app.published().status.baking.is_none());
    window.step();
    assert!(window.query_all_by_label_contains("Stopped before it was put together").next().is_some());
    // With fewer it is put together.
    put(
        folder.path(),
        "few.json",
        &fs::read_to_string(folder.path().join("many.json")).expect("text").replace("1500000", "200"),
    );
    drop_file(&mut window, folder.path().join("few.json"));
    until(&mut window, |app| {
        let bodies = &app.published().at_rest.bodies;
        bodies.len() == 1 && (150..250).contains(&bodies[0].particles.len())
    });
}

/// A block with a fin as thick as this [m], as a file has it.
fn finned(thickness: f64) -> String {
    let mut text = String::new();
    let blocks = [([-0.05; 3], [0.05; 3]), ([0.03, 0.011, -0.04], [0.13, 0.011 + thickness, 0.04])];
    for (min, max) in blocks {
        for k in 0..8 {
            let [x, y, z] = [0, 1, 2].map(|axis| if k >> axis & 1 == 0 { min[axis] } else { max[axis] });
            writeln!(text, "v {x} {y} {z}").expect("a string takes it");
        }
    }
    for first in [0, 8] {
        for [a, b, c, d] in [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]] {
            let face = [a, b, c, d].map(|corner| (corner + first).to_string()).join(" ");
            writeln!(text, "f {face}").expect("a string takes it");
        }
    }
    text
}

#[test]
fn parts_too_thin_for_any_particle_are_said_and_marked() {
    let scene = r#"{"version": 1, "gravity": [0, 0, 0], "room": {"floor": null}, "bodies": [{"id": "body",
        "shape": {"mesh": {"path": "body.obj", "particles": 500}},
        "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.01}}]}"#;
    for (thickness, is_thin) in [(0.001, true), (0.04, false)] {
        let folder = folder("body.obj", &finned(thickness));
        put(folder.path(), "scene.json", scene);
        let mut window = still();
        drop_file(&mut window, folder.path().join("scene.json"));
        until(&mut window, |app| app.scene().bodies[0].id == "body" && is_settled(app));
        window.run_steps(3);
        let status = &window.state().published().status;
        let said = status.notes.iter().any(|note| note.contains("(the first at ["));
        assert_eq!([said, status.warns], [is_thin; 2], "{thickness} m: {:?}", status.notes);
        let is_mark = |shape: &Shape| matches!(shape, Shape::Circle(of) if (of.radius, of.stroke.width) == (3.0, 1.0));
        let marks = window.output().shapes.iter().filter(|shape| is_mark(&shape.shape)).count();
        assert_eq!(marks > 20, is_thin, "{thickness} m: {marks} marks");
    }
}

/// Asks for a model that bodies touch.
fn add_collider(window: &mut Window, path: &Path) {
    click(window, "World");
    window.run_steps(5);
    window.get_by_label("Add a collider").scroll_to_me();
    window.run_steps(20);
    click(window, "Add a collider");
    click(window, "Mesh file…");
    type_path(window, path);
}

#[test]
fn a_collider_that_takes_long_to_read_is_told_of_and_cancelled() {
    let folder = folder("large.obj", &ball(200));
    put(folder.path(), "small.obj", &ball(4));
    let mut window = still();
    add_collider(&mut window, &folder.path().join("large.obj"));
    until_seen(&mut window, |window| window.query_by_label_contains("large.obj: ").is_some());
    assert!(window.state().is_loading());
    window.get_by_role_and_label(Role::Button, "Cancel").click();
    window.run_steps(2);
    assert!(!window.state().is_loading() && window.state().scene().colliders.is_empty());
    add_collider(&mut window, &folder.path().join("small.obj"));
    until(&mut window, |app| !app.is_loading() && app.scene().colliders.len() == 1);
    assert_eq!(window.state().scene().colliders[0].name, "small");
    until(&mut window, |app| app.is_up_to_date() && app.published().status.baking.is_none());
    assert_eq!(window.state().published().status.failure, None);
    // What cannot be read is said, and nothing comes of it.
    add_collider(&mut window, &folder.path().join("nowhere.obj"));
    until(&mut window, |app| app.message().is_some_and(|said| said.contains("nowhere.obj")));
    assert_eq!(window.state().scene().colliders.len(), 1);
}

/// A ball of a model's file, as it is copied.
pub(super) fn copied_ball(path: &Path) -> String {
    serde_json::json!({"sinew": "body", "half_size": [0.05, 0.05, 0.05], "center": [0, 0, 0], "body": {"solid": {
        "id": "ball", "shape": {"mesh": {"path": path, "particles": 200}},
        "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.01}}}})
    .to_string()
}

#[test]
fn a_body_that_is_pasted_is_read_beside_the_window_and_cancelled() {
    let folder = folder("large.obj", &ball(200));
    put(folder.path(), "small.obj", &ball(4));
    let mut window = still();
    let before = window.state().scene().clone();
    window.event(Event::Paste(copied_ball(&folder.path().join("large.obj"))));
    window.step();
    until_seen(&mut window, |window| window.query_by_label_contains("large.obj: ").is_some());
    assert!(window.state().is_loading());
    window.get_by_role_and_label(Role::Button, "Cancel").click();
    window.run_steps(2);
    assert!(!window.state().is_loading() && *window.state().scene() == before);
    window.event(Event::Paste(copied_ball(&folder.path().join("small.obj"))));
    until(&mut window, |app| app.scene().bodies.len() == before.bodies.len() + 1);
    until(&mut window, |app| app.is_up_to_date() && app.published().status.baking.is_none());
    assert_eq!(window.state().published().status.failure, None);
    // What is named as if it came with the program, and does not, is not looked for anywhere.
    window.event(Event::Paste(copied_ball(Path::new("small.obj"))));
    until(&mut window, |app| app.message().is_some_and(|said| said.contains("small.obj: ")));
    assert_eq!(window.state().scene().bodies.len(), before.bodies.len() + 1);
}
