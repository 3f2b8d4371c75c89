//! What the window shows is what a headless run of the same document computes, bit for bit: scenes are opened, edited
//! by pointer and keys, saved, and run frame by frame in both.
//!
//! Each test prints `state_hash NAME 0123456789abcdef` of the frames that were shown, for
//! `tests/tools/state_hashes.sh`.

use super::editing::{set, type_path};
use super::{Window, advance, click, draw, hold, is_settled, open, press_key, reset, until, view};
use egui::{Event, Key, Modifiers};
use glam::DVec3;
use sinew::bake::bake;
use sinew::io::{load_assets, load_scene};
use sinew::sim::Runner;
use sinew::solver::Snapshot;
use sinew::test_support::ui::App;
use sinew::ui::Document;
use std::collections::hash_map::DefaultHasher;
use std::hash::Hasher;
use std::path::Path;

/// Frames that are shown and compared after an edit.
const FRAMES: usize = 12;

/// The window on a shipped scene, held at its start.
fn held(name: &str) -> Window {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name);
    let mut window = open(Document::load(Some(path)).expect("a shipped scene"));
    hold(&mut window);
    reset(&mut window);
    window
}

/// Waits until the simulation has taken up every edit.
fn settle(window: &mut Window) {
    window.step();
    until(window, is_settled);
    let status = &window.state().published().status;
    assert!(status.failure.is_none() && !status.playing, "{:?}", status.failure);
}

fn type_text(window: &mut Window, text: &str) {
    window.event(Event::Text(text.to_owned()));
    window.step();
}

/// Saves the document through the window, and puts what was written together without one.
fn saved(window: &mut Window) -> Runner {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("edited.json");
    press_key(window, Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    type_path(window, &path);
    headless(&path)
}

/// A run of a scene's file, at its start.
fn headless(path: &Path) -> Runner {
    let scene = load_scene(path).expect("a scene");
    let assets = load_assets(&scene, path.parent().expect("a folder"), &mut |_| {}).expect("its models");
    Runner::new(bake(&scene, &assets).expect("a scene that bakes"))
}

/// Every number of a picture.
fn bits(snapshot: &Snapshot) -> Vec<u64> {
    let points = snapshot.bodies.iter().flat_map(|body| {
        let fibres = body.fibres.iter().flat_map(|fibre| &fibre.vertices);
        body.particles.iter().chain(fibres).copied().chain(body.surface().into_owned()).collect::<Vec<_>>()
    });
    let numbers = points.flat_map(|point: DVec3| point.to_array());
    [snapshot.time].into_iter().chain(snapshot.panels.iter().copied()).chain(numbers).map(f64::to_bits).collect()
}

fn hash_on(hasher: &mut DefaultHasher, app: &App, runner: &Runner, frame: usize) {
    let shown = &app.published().snapshot;
    let computed = runner.particles();
    assert_eq!(bits(shown), bits(&computed), "frame {frame}");
    assert_eq!(*shown, computed, "frame {frame}");
    for number in bits(shown) {
        hasher.write_u64(number);
    }
}

/// Advances both frame by frame; gives the hash of all that was shown.
fn same_frames(window: &mut Window, runner: &mut Runner) -> String {
    let mut hasher = DefaultHasher::new();
    hash_on(&mut hasher, window.state(), runner, 0);
    for frame in 1..=FRAMES {
        advance(window);
        runner.advance_frame();
        hash_on(&mut hasher, window.state(), runner, frame);
    }
    format!("{:016x}", hasher.finish())
}

/// Whether the document of the window differs from the shipped scene.
fn is_edited(window: &Window, name: &str) -> bool {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name);
    **window.state().scene() != load_scene(&path).expect("a shipped scene")
}

#[test]
fn a_fibre_that_was_drawn_moves_as_in_a_headless_run() {
    let mut window = held("short_bar_soft.json");
    let fibres = window.state().scene().bodies[0].fibres.len();
    draw(&mut window, "Front", |s| [0.08 * (3.0 * s).sin() - 0.04, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.1 * s - 0.05, 0.5 * s - 0.25]);
    settle(&mut window);
    assert_eq!(window.state().scene().bodies[0].fibres.len(), fibres + 1, "{:?}", window.state().message());
    let mut runner = saved(&mut window);
    reset(&mut window);
    println!("state_hash window/fibre-drawn {}", same_frames(&mut window, &mut runner));
}

#[test]
fn a_number_that_was_typed_counts_as_in_a_headless_run_from_the_start_and_in_the_midst() {
    let name = "two_layer_ball_on_bar.json";
    let mut window = held(name);
    // In the midst of the motion, by one edit: what moves goes on with the new number.
    let mut before = headless(&Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name));
    println!("state_hash window/as-shipped {}", same_frames(&mut window, &mut before));
    set(&mut window, "Young's modulus", "2e5");
    settle(&mut window);
    assert!(is_edited(&window, name) && window.state().published().status.edits == 1);
    let start = saved(&mut window);
    let mut adopted = start.clone();
    adopted.adopt(&before);
    println!("state_hash window/number-typed-midway {}", same_frames(&mut window, &mut adopted));
    // From the start of the edited scene.
    reset(&mut window);
    let mut runner = start;
    println!("state_hash window/number-typed {}", same_frames(&mut window, &mut runner));
}

#[test]
fn fibres_that_were_moved_and_deleted_leave_the_motion_of_a_headless_run() {
    let name = "figure_09c_soft.json";
    let mut window = held(name);
    let fibres = window.state().scene().bodies[0].fibres.clone();
    click(&mut window, "Midrib");
    settle(&mut window);
    let at = view(&window, "Front").center();
    window.event(Event::PointerMoved(at));
    window.step();
    press_key(&mut window, Modifiers::NONE, Key::G);
    press_key(&mut window, Modifiers::NONE, Key::Y);
    type_text(&mut window, "3");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    settle(&mut window);
    click(&mut window, "Vein 4");
    settle(&mut window);
    window.event(Event::PointerMoved(at));
    window.step();
    press_key(&mut window, Modifiers::NONE, Key::Delete);
    settle(&mut window);
    let left = window.state().scene().bodies[0].fibres.clone();
    assert_eq!(left.len(), fibres.len() - 1, "{:?}", window.state().message());
    assert!(left.iter().any(|fibre| fibre.name == "Midrib" && !fibres.contains(fibre)), "it was moved");
    let mut runner = saved(&mut window);
    reset(&mut window);
    println!("state_hash window/fibres-moved-and-deleted {}", same_frames(&mut window, &mut runner));
}
