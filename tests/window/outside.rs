//! Scenes that name models outside of their folder: asked about once, and nothing is lost either way.

use super::editing::drop_file;
use super::{Window, click, is_settled, open, press_key, still, until, until_seen};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use sinew::ui::Document;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

/// A cube of 3 cm as a file has it.
fn cube() -> String {
    let mut text = String::new();
    for k in 0..8 {
        let [x, y, z] = [k & 1, k >> 1 & 1, k >> 2].map(|side| f64::from(side) * 0.03);
        writeln!(text, "v {x} {y} {z}").expect("text");
    }
    ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"]
        .iter()
        .fold(text, |text, face| text + "f " + face + "\n")
}

/// A scene whose model lies at `path` from it.
fn scene_of(path: &str) -> String {
    format!(
        r#"{{"version": 1, "name": "Cube", "bodies": [{{"id": "cube", "shape": {{"mesh": {{"path": "{path}"}}}},
            "material": {{"young_modulus": 1e5, "mass": {{"density": 1000}}, "support_radius": 0.015}}}}]}}"#
    )
}

/// A folder with a scene whose model lies beside the scene's folder.
fn folder() -> (TempDir, PathBuf) {
    let root = tempfile::tempdir().expect("a folder");
    for folder in ["scenes", "models", "assets"] {
        fs::create_dir(root.path().join(folder)).expect("made");
    }
    for model in ["models/cube.obj", "assets/cube.obj"] {
        fs::write(root.path().join(model), cube()).expect("written");
    }
    let scene = root.path().join("scenes/scene.json");
    fs::write(&scene, scene_of("../models/cube.obj")).expect("written");
    (root, scene)
}

const QUESTION: &str = "Let scene.json read files outside of its folder?";

fn asks(window: &Window) -> bool {
    window.query_by_label(QUESTION).is_some()
}

fn name(window: &Window) -> &str {
    &window.state().scene().name
}

#[test]
fn it_is_asked_about_once_and_opened() {
    let (_root, scene) = folder();
    let mut window = still();
    drop_file(&mut window, scene.clone());
    until_seen(&mut window, asks);
    assert!(window.query_all_by_label_contains("cube.obj").next().is_some(), "which file it is about");
    // Nothing is open yet.
    assert_ne!(name(&window), "Cube");
    click(&mut window, "Allow");
    until(&mut window, |app| app.scene().name == "Cube" && is_settled(app));
    assert!(!asks(&window));
    // It is not asked again, when it is reloaded and when it is opened again.
    click(&mut window, "File");
    click(&mut window, "Reload");
    until(&mut window, |app| app.message().is_some_and(|said| said.starts_with("Opened")) && is_settled(app));
    press_key(&mut window, Modifiers::COMMAND, Key::N);
    until(&mut window, |app| app.scene().name != "Cube");
    drop_file(&mut window, scene);
    until(&mut window, |app| app.scene().name == "Cube");
    assert!(!asks(&window));
}

#[test]
fn what_is_not_let_leaves_what_is_open() {
    let (root, scene) = folder();
    let mut window = still();
    let before = window.state().scene().clone();
    for answer in ["Don't open", "Escape"] {
        drop_file(&mut window, scene.clone());
        until_seen(&mut window, asks);
        if answer == "Escape" {
            press_key(&mut window, Modifiers::NONE, Key::Escape);
        } else {
            click(&mut window, answer);
        }
        until_seen(&mut window, |window| !asks(window));
        assert_eq!(*window.state().scene(), before);
    }
    // Whether there is such a file is not told before that.
    fs::write(&scene, scene_of("../models/nowhere.obj")).expect("written");
    drop_file(&mut window, scene.clone());
    until_seen(&mut window, asks);
    click(&mut window, "Don't open");
    // What lies in the scene's folder, and in `assets` beside it, is its own.
    fs::write(&scene, scene_of("../assets/cube.obj")).expect("written");
    fs::write(root.path().join("scenes/cube.obj"), cube()).expect("written");
    let beside = root.path().join("scenes/beside.json");
    fs::write(&beside, scene_of("cube.obj").replace("Cube", "Beside")).expect("written");
    drop_file(&mut window, scene);
    until(&mut window, |app| app.scene().name == "Cube");
    drop_file(&mut window, beside);
    until(&mut window, |app| app.scene().name == "Beside");
    assert!(!asks(&window));
}

#[test]
fn the_window_that_is_started_with_it_asks_first() {
    let (_root, scene) = folder();
    let mut window = open_empty(Document::load_or_ask(Some(scene)).expect("a document"));
    until_seen(&mut window, asks);
    assert!(window.state().scene().bodies.is_empty());
    click(&mut window, "Allow");
    until(&mut window, |app| app.scene().name == "Cube" && is_settled(app));
}

/// The window on a document without a body.
fn open_empty(document: Document) -> Window {
    use egui_kittest::Harness;
    Harness::builder()
        .with_size(egui::Vec2::new(1280.0, 800.0))
        .build_eframe(move |creation| sinew::test_support::ui::App::new(&creation.egui_ctx, None, document))
}

#[test]
fn a_scene_that_was_saved_here_is_reloaded_without_a_question() {
    let (root, _) = folder();
    let mut window = open(Document::load(Some(root.path().join("models/cube.obj"))).expect("a model"));
    press_key(&mut window, Modifiers::COMMAND, Key::S);
    super::editing::type_path(&mut window, &root.path().join("scenes/own.json"));
    until(&mut window, |app| app.message().is_some_and(|said| said.starts_with("Saved")));
    let written = fs::read_to_string(root.path().join("scenes/own.json")).expect("there");
    assert!(written.contains("../models/cube.obj"), "{written}");
    click(&mut window, "File");
    click(&mut window, "Reload");
    until(&mut window, |app| app.message().is_some_and(|said| said.starts_with("Opened")));
    assert!(!window.query_all_by_label_contains("outside of its folder").any(|_| true));
}
