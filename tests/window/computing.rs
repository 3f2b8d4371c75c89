//! A slow motion is computed ahead and played at full speed.

use super::editing::set;
use super::{click, open, press_key, still, until};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use sinew::ui::Document;
use std::path::Path;

/// Opens the question by its name in the palette.
fn ask(window: &mut super::Window) {
    press_key(window, Modifiers::COMMAND, Key::P);
    window.event(egui::Event::Text("compute ahead".into()));
    window.run_steps(2);
    press_key(window, Modifiers::NONE, Key::Enter);
    window.run_steps(2);
}

#[test]
fn what_was_asked_for_is_computed_told_and_played() {
    let mut window = still();
    let before = window.state().published().status.time;
    ask(&mut window);
    set(&mut window, "Simulated time", "0.2");
    click(&mut window, "Compute");
    until(&mut window, |app| app.published().status.ahead.is_some() || app.published().status.recording.in_replay);
    until(&mut window, |app| app.published().status.ahead.is_none() && !app.published().status.playing);
    let status = &window.state().published().status;
    assert!((status.time - before - 0.2).abs() < 0.02, "{} s", status.time - before);
    assert!(status.recording.span.is_some_and(|span| span[1] == status.time));
}

#[test]
fn computing_is_told_with_the_time_that_is_left_and_can_be_stopped() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/leaf.json");
    let mut window = open(Document::load(Some(path)).expect("it ships"));
    super::hold(&mut window);
    ask(&mut window);
    click(&mut window, "Compute");
    super::until_seen(&mut window, |window| window.query_by_label_contains("Computing ").is_some());
    click(&mut window, "Stop");
    until(&mut window, |app| app.published().status.ahead.is_none() && !app.published().status.playing);
    assert!(window.query_by_label_contains("Computing ").is_none());
}
