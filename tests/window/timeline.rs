//! The timeline is dragged, stepped and gone on from by pointer and keys.

use super::{Window, advance, button, click, drag, press_key, still, until, view};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect};
use egui_kittest::kittest::{NodeT, Queryable};
use sinew::sim::RecordingStatus;
use sinew::solver::Snapshot;
use sinew::test_support::ui::App;

fn time(app: &App) -> f64 {
    app.published().status.time
}

fn timeline(app: &App) -> &RecordingStatus {
    &app.published().status.recording
}

/// The built-in scene with some frames, each computed and shown once.
fn recorded(frames: usize) -> (Window, Vec<Snapshot>) {
    let mut window = still();
    click(&mut window, "Reset");
    until(&mut window, |app| time(app) == 0.0 && timeline(app).frames == 1);
    let mut shown = vec![window.state().published().snapshot.clone()];
    for _ in 0..frames {
        advance(&mut window);
        shown.push(window.state().published().snapshot.clone());
    }
    window.step();
    (window, shown)
}

/// The bar of the timeline.
fn track(window: &Window) -> Rect {
    window.get_by_label_contains("Timeline from").rect()
}

/// Where the timeline shows a time of the first five seconds.
fn place(window: &Window, time: f64) -> Pos2 {
    let bar = track(window);
    Pos2::new(bar.left() + 8.0 + (time / 5.0) as f32 * (bar.width() - 16.0), bar.top() + 10.0)
}

fn is_frame(window: &Window, shown: &[Snapshot], index: usize) {
    let snapshot = &window.state().published().snapshot;
    let bits = |snapshot: &Snapshot| -> Vec<u64> {
        let points = snapshot.bodies.iter().flat_map(|body| &body.particles);
        points.flat_map(glam::DVec3::to_array).map(f64::to_bits).collect()
    };
    assert_eq!(bits(snapshot), bits(&shown[index]), "frame {index}");
    assert_eq!(*snapshot, shown[index], "frame {index}");
}

#[test]
fn a_drag_in_the_timeline_shows_exactly_what_was_there() {
    let (mut window, shown) = recorded(40);
    let last = shown[40].time;
    let path: Vec<Pos2> = (0..=30).map(|k| place(&window, last - 0.5 * last * f64::from(k) / 30.0)).collect();
    drag(&mut window, &path);
    until(&mut window, |app| timeline(app).in_replay && (time(app) - 0.5 * last).abs() < 0.01);
    let index = shown.iter().position(|frame| frame.time == time(window.state())).expect("a frame that was shown");
    is_frame(&window, &shown, index);
    assert!(!window.state().published().status.playing);
    // While the pointer is down, what is shown follows it; beyond the ends the first and the last frame are shown.
    let from = place(&window, 0.1);
    window.event(Event::PointerMoved(from));
    window.step();
    button(&window, from, PointerButton::Primary, true);
    window.step();
    until(&mut window, |app| (time(app) - 0.1).abs() < 1e-9);
    is_frame(&window, &shown, 6);
    window.event(Event::PointerMoved(Pos2::new(0.0, from.y)));
    window.step();
    until(&mut window, |app| time(app) == 0.0);
    is_frame(&window, &shown, 0);
    let beyond = Pos2::new(track(&window).right() + 50.0, from.y);
    window.event(Event::PointerMoved(beyond));
    window.step();
    until(&mut window, |app| time(app) == last);
    is_frame(&window, &shown, 40);
    button(&window, beyond, PointerButton::Primary, false);
    window.step();
    click(&mut window, "Live");
    until(&mut window, |app| !timeline(app).in_replay);
    is_frame(&window, &shown, 40);
}

#[test]
fn keys_and_buttons_step_through_the_motion() {
    let (mut window, shown) = recorded(8);
    for index in [7, 6, 5] {
        press_key(&mut window, Modifiers::NONE, Key::ArrowLeft);
        until(&mut window, |app| time(app) == shown[index].time);
        is_frame(&window, &shown, index);
    }
    press_key(&mut window, Modifiers::NONE, Key::ArrowRight);
    until(&mut window, |app| time(app) == shown[6].time);
    press_key(&mut window, Modifiers::SHIFT, Key::ArrowLeft);
    until(&mut window, |app| time(app) == 0.0 && timeline(app).in_replay);
    is_frame(&window, &shown, 0);
    click(&mut window, "Advance one frame");
    until(&mut window, |app| time(app) == shown[1].time);
    press_key(&mut window, Modifiers::SHIFT, Key::ArrowRight);
    until(&mut window, |app| !timeline(app).in_replay);
    assert_eq!(time(window.state()), shown[8].time);
    click(&mut window, "Step back");
    until(&mut window, |app| time(app) == shown[7].time);
    click(&mut window, "First kept frame");
    until(&mut window, |app| time(app) == 0.0 && timeline(app).in_replay);
    assert_eq!(timeline(window.state()).frames, 9, "nothing was computed");
}

/// Types the speed of the simulation.
fn slow_down(window: &mut Window, speed: &str) {
    let is_speed = |text: String| text.ends_with(" ×");
    let field = window.get_all_by_role(Role::SpinButton).find(|node| node.value().is_some_and(is_speed));
    field.expect("the speed").click();
    window.step();
    window.step();
    press_key(window, Modifiers::COMMAND, Key::A);
    window.event(Event::Text(speed.to_owned()));
    window.step();
    press_key(window, Modifiers::NONE, Key::Enter);
}

#[test]
fn a_replay_ends_where_the_recording_does() {
    let (mut window, shown) = recorded(20);
    // Slowly, so that a busy machine sees something of it.
    slow_down(&mut window, "0.2");
    click(&mut window, "Replay");
    until(&mut window, |app| timeline(app).in_replay && app.published().status.playing);
    until(&mut window, |app| !timeline(app).in_replay && !app.published().status.playing);
    is_frame(&window, &shown, 20);
    assert_eq!(timeline(window.state()).frames, 21);
    // Held on the way, and gone on with.
    press_key(&mut window, Modifiers::SHIFT, Key::Space);
    until(&mut window, |app| timeline(app).in_replay && app.published().status.playing);
    press_key(&mut window, Modifiers::NONE, Key::Space);
    until(&mut window, |app| !app.published().status.playing);
    // Played on, it reaches the end and computes what comes then.
    press_key(&mut window, Modifiers::NONE, Key::Space);
    until(&mut window, |app| !timeline(app).in_replay && time(app) > shown[20].time);
}

#[test]
fn going_on_from_a_frame_is_said() {
    let (mut window, shown) = recorded(8);
    assert!(window.query_all_by_label("Go on from here").all(|button| button.accesskit_node().is_disabled()));
    press_key(&mut window, Modifiers::NONE, Key::ArrowLeft);
    press_key(&mut window, Modifiers::NONE, Key::ArrowLeft);
    until(&mut window, |app| time(app) == shown[6].time);
    window.step();
    click(&mut window, "Go on from here");
    until(&mut window, |app| !timeline(app).in_replay && time(app) > shown[8].time);
    let said = window.state().message().unwrap_or_default().to_owned();
    assert!(said.contains("0.10 s") && said.contains("2 later frames were dropped"), "{said}");
    press_key(&mut window, Modifiers::NONE, Key::Space);
    until(&mut window, |app| !app.published().status.playing);
    // The same frames as the first time.
    let bar = place(&window, shown[8].time);
    drag(&mut window, &[bar, bar]);
    until(&mut window, |app| timeline(app).in_replay && time(app) == shown[8].time);
    is_frame(&window, &shown, 8);
}

#[test]
fn an_edit_and_a_pull_go_on_from_the_frame_that_is_shown() {
    let (mut window, shown) = recorded(10);
    press_key(&mut window, Modifiers::SHIFT, Key::ArrowLeft);
    until(&mut window, |app| timeline(app).in_replay && time(app) == 0.0);
    for frame in &shown[1..=5] {
        press_key(&mut window, Modifiers::NONE, Key::ArrowRight);
        until(&mut window, |app| time(app) == frame.time);
    }
    // An edit.
    press_key(&mut window, Modifiers::NONE, Key::A);
    press_key(&mut window, Modifiers::NONE, Key::Delete);
    until(&mut window, |app| app.published().status.edits == 1 && !timeline(app).in_replay);
    window.step();
    assert_eq!(time(window.state()), shown[5].time);
    assert_eq!(timeline(window.state()).span.map(|span| span[1]), Some(shown[5].time));
    let said = window.state().message().unwrap_or_default().to_owned();
    assert!(said.contains("5 later frames were dropped"), "{said}");
    // A frame of before the edit, with its fibres, and a pull on it.
    press_key(&mut window, Modifiers::NONE, Key::Period);
    until(&mut window, |app| time(app) > shown[5].time);
    press_key(&mut window, Modifiers::SHIFT, Key::ArrowLeft);
    until(&mut window, |app| timeline(app).in_replay && time(app) == 0.0);
    is_frame(&window, &shown, 0);
    let at = view(&window, "Result").center();
    window.event(Event::PointerMoved(at));
    window.step();
    button(&window, at, PointerButton::Primary, true);
    window.step();
    window.event(Event::PointerMoved(at + egui::Vec2::new(40.0, 0.0)));
    window.step();
    assert!(window.state().grabbed().is_some(), "it is held");
    until(&mut window, |app| !timeline(app).in_replay && timeline(app).frames == 1);
    window.step();
    let said = window.state().message().unwrap_or_default().to_owned();
    assert!(said.contains("with the present scene: 6 later frames were dropped"), "{said}");
    button(&window, at, PointerButton::Primary, false);
    window.step();
}

#[test]
fn memory_is_shown_and_chosen() {
    let (mut window, _) = recorded(12);
    let read_out = |window: &Window, text: &str| window.query_all_by_label_contains(text).next().is_some();
    assert!(read_out(&window, "0.2 s kept, ") && read_out(&window, " of 512 MiB"));
    window.get_by_label_contains("kept, ").click();
    window.step();
    window.step();
    click(&mut window, "2 GiB");
    until(&mut window, |app| timeline(app).limit == 2 << 30);
    window.step();
    assert!(read_out(&window, " of 2 GiB"));
}

#[test]
fn the_timeline_folds_away_and_says_when_there_is_nothing() {
    let mut window = still();
    let shown = |window: &Window| window.query_all_by_label_contains("Timeline from").next().is_some();
    assert!(shown(&window));
    press_key(&mut window, Modifiers::ALT, Key::L);
    window.step();
    assert!(!shown(&window));
    click(&mut window, "View");
    window.get_by_label_contains("Show timeline").click();
    window.step();
    window.step();
    assert!(shown(&window));
    let mut window =
        super::open(super::scene(r#"{"version": 1, "two_layer": [{"id": "ring", "shape": {"ring": {}}}]}"#));
    click(&mut window, "Compare");
    click(&mut window, "Explicit Euler");
    click(&mut window, "Runge-Kutta 4");
    click(&mut window, "Start comparison");
    until(&mut window, |app| app.published().compared.len() == 2);
    window.step();
    assert!(!shown(&window));
    assert!(window.query_all_by_label_contains("Nothing is recorded while").next().is_some());
}
