//! The window through pointer and key events, without a screen: events in, scene and messages out.
#![cfg(feature = "gui")]

mod at_hand;
mod autosave;
mod bodies;
mod commands;
mod comparing;
mod computing;
mod conductor;
mod drive_courses;
mod drive_fields;
mod drive_waves;
mod drives;
mod editing;
mod effect;
mod elements;
mod exporting;
mod fibres;
mod first_scene;
mod follows;
mod gallery;
mod hashes;
mod hurried;
mod in_sight;
mod journal;
mod loading;
mod monkey;
mod outside;
mod patterns;
mod picture;
mod plots;
mod preferences;
mod pulling;
mod refusals;
mod reporting;
mod running;
mod seeing;
mod sheets;
mod sketching;
mod starts;
mod timeline;

use egui::accesskit::Role;
use egui::{Event, Modifiers, PointerButton, Pos2, Rect, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use sinew::io::scene_from_json;
use sinew::test_support::ui::App;
use sinew::ui::Document;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

type Window = Harness<'static, App>;

/// Longer than anything here takes on a busy machine.
const PATIENCE: Duration = Duration::from_mins(2);

fn open(document: Document) -> Window {
    open_with(document, |app| app)
}

/// The window on a document, with what `build` adds.
fn open_with(document: Document, build: impl FnOnce(App) -> App + 'static) -> Window {
    let mut window = Harness::builder()
        .with_size(Vec2::new(1280.0, 800.0))
        .with_step_dt(1.0 / 60.0)
        .build_eframe(move |creation| build(App::new(&creation.egui_ctx, None, document)));
    until(&mut window, |app| !app.published().at_rest.bodies.is_empty());
    // One more frame for the views to be fitted to what has come.
    window.step();
    window
}

/// The window on the built-in scene, held still a little after its start: in the same frame however busy the machine
/// is.
fn still() -> Window {
    let mut window = open(Document::load(None).expect("the built-in scene"));
    hold(&mut window);
    press_key(&mut window, Modifiers::COMMAND, egui::Key::R);
    until(&mut window, is_at_start);
    for _ in 0..2 {
        press_key(&mut window, Modifiers::NONE, egui::Key::Period);
    }
    until(&mut window, |app| app.published().status.recording.frames == 3);
    window
}

/// Holds the simulation, wherever it has come to.
fn hold(window: &mut Window) {
    press_key(window, Modifiers::NONE, egui::Key::Space);
    until(window, |app| !app.published().status.playing);
}

/// Back to the start of the scene as it is now, with every edit, and held there.
fn reset(window: &mut Window) {
    advance(window);
    press_key(window, Modifiers::COMMAND, egui::Key::R);
    until(window, is_at_start);
}

fn is_at_start(app: &App) -> bool {
    let status = &app.published().status;
    status.time == 0.0 && status.recording.frames == 1 && status.baking.is_none()
}

/// One frame of a simulation that is held; with it, whatever was asked for before has been done.
fn advance(window: &mut Window) {
    let before = window.state().published().status.time;
    press_key(window, Modifiers::NONE, egui::Key::Period);
    until(window, |app| app.published().status.time > before && app.published().status.baking.is_none());
}

/// Whether the simulation has taken up every edit and put the scene together.
fn is_settled(app: &App) -> bool {
    app.is_up_to_date() && app.published().status.baking.is_none()
}

fn scene(text: &str) -> Document {
    let scene = scene_from_json(text).expect("a scene");
    Document { scene, assets: Arc::default(), path: None, folder: PathBuf::new(), note: None, asks: None }
}

/// Shows frames until something has come about.
fn until(window: &mut Window, mut wanted: impl FnMut(&App) -> bool) {
    until_seen(window, |window| wanted(window.state()));
}

/// Shows frames until the window as it is seen is as wanted.
#[allow(clippy::disallowed_methods, reason = "here what is waited for is looked at again and again")]
fn until_seen(window: &mut Window, mut wanted: impl FnMut(&Window) -> bool) {
    let start = Instant::now();
    while !wanted(window) {
        assert!(start.elapsed() < PATIENCE, "it never came about; the last message: {:?}", window.state().message());
        // As much time for what is waited for as for drawing.
        let drawing = Instant::now();
        window.step();
        std::thread::sleep(drawing.elapsed().max(Duration::from_millis(2)));
    }
}

fn press_key(window: &mut Window, modifiers: Modifiers, key: egui::Key) {
    window.key_press_modifiers(modifiers, key);
    window.step();
}

/// Where a view lies.
fn view(window: &Window, name: &str) -> Rect {
    window.get_by_label(&format!("{name} view")).rect()
}

fn button(window: &Window, at: Pos2, button: PointerButton, pressed: bool) {
    window.event(Event::PointerMoved(at));
    window.event(Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
}

/// Drags through points of the window [points], several samples to a frame.
fn drag(window: &mut Window, path: &[Pos2]) {
    window.event(Event::PointerMoved(path[0]));
    window.step();
    button(window, path[0], PointerButton::Primary, true);
    window.step();
    for samples in path[1..].chunks(4) {
        // Straight into one frame's input: what is queued goes one event to a frame.
        window.input_mut().events.extend(samples.iter().map(|&at| Event::PointerMoved(at)));
        window.step();
    }
    button(window, path[path.len() - 1], PointerButton::Primary, false);
    window.step();
    window.step();
}

/// Points along a curve given over [0, 1], in shares of a rectangle about its middle; up is positive.
fn stroke(rect: Rect, curve: impl Fn(f32) -> [f32; 2]) -> Vec<Pos2> {
    let at = |k: usize| {
        let [x, y] = curve(k as f32 / 60.0);
        rect.center() + Vec2::new(x, -y) * rect.height()
    };
    (0..=60).map(at).collect()
}

/// Draws a stroke in a view, in shares of its height about its middle.
fn draw(window: &mut Window, name: &str, curve: impl Fn(f32) -> [f32; 2]) {
    let path = stroke(view(window, name), curve);
    drag(window, &path);
}

fn click(window: &mut Window, label: &str) {
    until_still(window, |window| window.query_by_label(label).map(|node| node.rect()));
    window.get_by_label(label).click();
    window.step();
    window.step();
}

/// Clicks what has a role and a label.
fn click_on(window: &mut Window, role: Role, label: &str) {
    until_still(window, |window| window.query_by_role_and_label(role, label).map(|node| node.rect()));
    window.get_by_role_and_label(role, label).click();
    window.run_steps(3);
}

/// Shows frames until what is looked for is there and lies where it lay a frame before: what is said in a dialog moves
/// the buttons below.
fn until_still(window: &mut Window, place: impl Fn(&Window) -> Option<Rect>) {
    let mut before = None;
    until_seen(window, |window| {
        let now = place(window);
        let still = now.is_some() && now == before;
        before = now;
        still
    });
}
