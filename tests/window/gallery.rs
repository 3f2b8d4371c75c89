//! The scenes that ship are shown with pictures and open from wherever the program is started.

use super::{Window, button, click, is_settled, press_key, still, until};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use sinew::bake::bake;
use sinew::scene::TwoLayerShape;
use sinew::test_support::ui::{App, EXAMPLES, Example, Group};
use sinew::ui::Document;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The window as it is at the first start.
fn first_start() -> Window {
    let document = Document::load(None).expect("the built-in scene");
    let mut window =
        Harness::builder().with_size(Vec2::new(1280.0, 800.0)).with_step_dt(1.0 / 60.0).build_eframe(move |creation| {
            let mut app = App::new(&creation.egui_ctx, None, document);
            app.welcome();
            app
        });
    until(&mut window, |app| !app.published().at_rest.bodies.is_empty());
    window
}

#[test]
fn every_scene_that_ships_is_an_example_with_its_words() {
    let scenes: BTreeSet<String> = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes"))
        .expect("the scenes")
        .map(|entry| entry.expect("a file").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned())
        .collect();
    let examples: BTreeSet<String> = EXAMPLES.iter().map(|example| example.name.to_owned()).collect();
    assert_eq!(examples, scenes);
    assert_eq!(EXAMPLES.len(), scenes.len(), "each stands once");
    let titles: BTreeSet<&str> = EXAMPLES.iter().map(|example| example.title).collect();
    assert_eq!(titles.len(), EXAMPLES.len());
    for example in EXAMPLES {
        assert!(example.line.ends_with('.') && example.line.len() <= 64, "{}: {}", example.name, example.line);
    }
    for group in Group::ALL {
        assert!(EXAMPLES.iter().any(|example| example.group == group), "{group:?}");
    }
}

#[test]
fn every_example_opens_without_its_files_and_bakes() {
    for example in EXAMPLES {
        let document = Document::of_example(example).unwrap_or_else(|error| panic!("{}: {error}", example.name));
        assert!(document.path.is_none());
        let baked = bake(&document.scene, &document.assets);
        assert!(baked.is_ok(), "{}: {:?}", example.name, baked.err());
    }
}

#[test]
fn the_first_start_plays_the_bar_beside_its_ghost_until_something_is_touched() {
    let touch: [fn(&mut Window); 3] = [
        |window| press_key(window, Modifiers::NONE, Key::Escape),
        |window| press_key(window, Modifiers::NONE, Key::F),
        |window| {
            for pressed in [true, false] {
                button(window, Pos2::new(12.0, 780.0), PointerButton::Primary, pressed);
                window.run_steps(3);
            }
        },
    ];
    for (k, touch) in touch.into_iter().enumerate() {
        let mut window = first_start();
        let scene = window.state().scene().clone();
        assert!(!window.state().shows_examples(), "no dialog stands in the way");
        until(&mut window, |app| app.published().ghost.is_some() && app.published().status.time > 0.05);
        let ghost = window.state().published().ghost.clone().expect("a ghost");
        assert!(ghost.bodies[0].fibres.is_empty());
        if k == 0 {
            // Over and over.
            until(&mut window, |app| app.published().status.time > 0.15);
            until(&mut window, |app| app.published().status.time < 0.06);
        }
        touch(&mut window);
        until(&mut window, |app| app.published().ghost.is_none() && is_settled(app));
        assert_eq!(*window.state().scene(), scene, "the scene is as it was");
        let app = window.state();
        assert!(app.undo_name().is_none());
        // What runs is the document itself from now on, past where it began again before.
        until(&mut window, |app| app.published().status.time > 0.6);
    }
}

#[test]
fn examples_are_found_by_their_words_in_a_window_that_keeps_its_size() {
    let mut window = still();
    press_key(&mut window, Modifiers::COMMAND, Key::E);
    window.run_steps(10);
    let close = window.get_by_label("Close").rect();
    let is_shown = |window: &Window, title: &str| window.query_by_label(title).is_some();
    assert!(is_shown(&window, "A twisting bar") && is_shown(&window, "A snapping stalk"));
    window.event(Event::Text("snapping".to_owned()));
    window.run_steps(3);
    assert!(!is_shown(&window, "A twisting bar") && is_shown(&window, "A snapping stalk"));
    assert_eq!(window.get_by_label("Close").rect(), close, "nothing moves away under the pointer");
    press_key(&mut window, Modifiers::COMMAND, Key::A);
    window.event(Event::Text("no such words".to_owned()));
    window.run_steps(3);
    assert!(!is_shown(&window, "A snapping stalk"));
    assert_eq!(window.get_by_label("Close").rect(), close);
}

#[test]
fn pictures_are_decoded_when_they_are_seen() {
    let mut window = still();
    assert_eq!(window.state().decoded_examples(), 0, "not before the first frame, nor while they are not shown");
    press_key(&mut window, Modifiers::COMMAND, Key::E);
    window.run_steps(30);
    let seen = window.state().decoded_examples();
    assert!(seen > 4 && seen < EXAMPLES.len() / 2, "{seen} of {}", EXAMPLES.len());
}

#[test]
fn an_example_is_a_document_without_a_file_and_can_be_saved_with_its_model() {
    let mut window = still();
    press_key(&mut window, Modifiers::COMMAND, Key::E);
    window.step();
    window.get_by_label("An inner tube").scroll_to_me();
    // Scrolling takes a moment.
    window.run_steps(60);
    click(&mut window, "An inner tube");
    assert!(!window.state().shows_examples());
    let tube = Example::named("two_layer_mesh").expect("it ships");
    let (scene, _) = tube.load().expect("it opens");
    assert_eq!(**window.state().scene(), scene);
    until(&mut window, |app| {
        app.published().at_rest.bodies.iter().any(|body| body.layers.is_some()) && is_settled(app)
    });
    assert!(window.state().published().status.failure.is_none());

    // Saving asks where, and the model goes with the scene.
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("tube.glb"), "taken").expect("written");
    press_key(&mut window, Modifiers::COMMAND, Key::S);
    window.run_steps(2);
    press_key(&mut window, Modifiers::COMMAND, Key::A);
    let path = folder.path().join("mine.json");
    window.event(Event::Text(path.display().to_string()));
    window.step();
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    window.step();
    assert!(path.is_file(), "{:?}", window.state().message());
    let saved = Document::load(Some(path)).expect("it is opened again, model and all");
    let TwoLayerShape::Mesh(shape) = &saved.scene.two_layer[0].shape else { panic!("a mesh") };
    assert_eq!(shape.path, "tube-2.glb");
    assert_eq!(fs::read_to_string(folder.path().join("tube.glb")).expect("there"), "taken");
}
