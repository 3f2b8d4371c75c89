//! What is refused is said with its figure, and nothing is lost.

use super::{Window, click, drag, draw, press_key, still, until, view};
use egui::{Event, Key, Modifiers, MouseWheelUnit};
use egui_kittest::kittest::Queryable;

fn fibres(window: &Window) -> usize {
    window.state().scene().bodies[0].fibres.len()
}

fn said(window: &Window) -> String {
    window.state().message().unwrap_or_default().to_owned()
}

#[test]
fn a_slip_is_no_stroke() {
    let mut window = still();
    let rect = view(&window, "Front");
    drag(&mut window, &[rect.center(), rect.center() + egui::vec2(4.0, 4.0), rect.center() + egui::vec2(6.0, 7.0)]);
    assert!(said(&window).contains("pixels long; draw at least 12"), "{}", said(&window));
}

#[test]
fn strokes_that_hardly_overlap_are_refused_with_the_share_and_can_be_stretched() {
    let mut window = still();
    let before = fibres(&window);
    draw(&mut window, "Front", |s| [0.05 * s, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.05 * s, 0.2 * s - 0.25]);
    assert_eq!(fibres(&window), before);
    let text = said(&window);
    assert!(
        ["39", "40", "41"].iter().any(|share| text.contains(&format!("overlap only {share} % in height"))),
        "{text}"
    );
    click(&mut window, "Stretch instead");
    assert_eq!(fibres(&window), before + 1, "{}", said(&window));
}

#[test]
fn what_was_said_goes_when_it_is_no_longer_true_and_one_thing_is_offered_once() {
    let mut window = still();
    // A fibre whose strokes could be stretched is the last that was drawn.
    draw(&mut window, "Front", |s| [0.05 * s, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.05 * s, 0.43 * s - 0.25]);
    // What is said of it as it is put together comes before what follows.
    until(&mut window, super::is_settled);
    window.step();
    draw(&mut window, "Front", |s| [0.05 * s, 0.5 * s - 0.25]);
    assert!(said(&window).contains("other view"), "{}", said(&window));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    window.step();
    assert_eq!(said(&window), "", "there is no stroke any more");
    draw(&mut window, "Front", |s| [0.05 * s, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.05 * s, 0.2 * s - 0.25]);
    assert!(said(&window).contains("overlap only"));
    assert_eq!(window.query_all_by_label("Stretch instead").count(), 1);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    window.step();
    assert_eq!(said(&window), "");
    // Nothing is selected: it is said until something is.
    let mut window = still();
    press_key(&mut window, Modifiers::NONE, Key::G);
    assert!(said(&window).contains("Select a fibre, a sheet or a body first"), "{}", said(&window));
    click(&mut window, "Helix 1");
    assert_eq!(said(&window), "");
}

#[test]
fn a_stroke_that_is_drawn_again_at_another_height_can_be_stretched() {
    let mut window = still();
    draw(&mut window, "Front", |s| [0.05 * s, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.05 * s, 0.5 * s - 0.25]);
    let before = window.state().scene().clone();
    press_key(&mut window, Modifiers::NONE, Key::D);
    draw(&mut window, "Side", |s| [-0.05 * s, 0.2 * s - 0.25]);
    assert!(said(&window).contains("overlap only"), "{}", said(&window));
    assert_eq!(*window.state().scene(), before);
    click(&mut window, "Stretch instead");
    assert_ne!(*window.state().scene(), before, "{}", said(&window));
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(*window.state().scene(), before, "it was one step");
}

#[test]
fn a_clipped_pair_says_so_and_offers_to_stretch() {
    let mut window = still();
    let before = fibres(&window);
    draw(&mut window, "Front", |s| [0.05 * s, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.05 * s, 0.43 * s - 0.25]);
    assert_eq!(fibres(&window), before + 1, "{}", said(&window));
    assert!(said(&window).contains('%'), "{}", said(&window));
    click(&mut window, "Stretch instead");
    assert!(window.query_by_label("Clip instead").is_some());
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(window.query_by_label("Clip instead").is_none());
}

#[test]
fn strokes_that_run_flat_cannot_give_depth() {
    let mut window = still();
    let before = fibres(&window);
    draw(&mut window, "Front", |s| [0.4 * s - 0.2, 0.01 * s]);
    draw(&mut window, "Side", |s| [0.4 * s - 0.2, 0.01 * s]);
    assert_eq!(fibres(&window), before);
    assert!(said(&window).contains("cannot give depth") && said(&window).contains("top view"), "{}", said(&window));
    // The first stroke is still there.
    draw(&mut window, "Front", |s| [0.05 * s, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.05 * s, 0.5 * s - 0.25]);
    assert_eq!(fibres(&window), before + 1);
}

#[test]
fn a_fibre_outside_the_solid_is_discarded_with_its_distance() {
    let mut window = still();
    draw(&mut window, "Front", |s| [0.39, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.39, 0.5 * s - 0.25]);
    until(&mut window, |app| app.message().is_some_and(|text| text.contains("nearest material")));
    assert!(said(&window).contains(" h away"), "{}", said(&window));
    window.step();
    assert_eq!(window.query_all_by_label("outside").count(), 1, "the list marks it");
}

#[test]
fn ends_that_stick_out_are_trimmed_with_their_count() {
    let mut window = still();
    // From further away there is room to draw beyond the solid.
    let at = view(&window, "Front").center();
    window.event(Event::PointerMoved(at));
    window.event(Event::MouseWheel {
        unit: MouseWheelUnit::Line,
        delta: egui::vec2(0.0, -12.0),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Unknown,
        modifiers: Modifiers::NONE,
    });
    window.run_steps(30);
    draw(&mut window, "Front", |s| [0.02 * s, 0.8 * s - 0.4]);
    draw(&mut window, "Side", |s| [0.02 * s, 0.8 * s - 0.4]);
    until(&mut window, |app| app.message().is_some_and(|text| text.contains("points outside the solid were trimmed")));
}
