//! The bodies stay in the picture, or the picture says where they are.

use super::{Window, button, click, is_settled, press_key, still, until, view};
use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Rect, Vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use sinew::test_support::ui::App;
use sinew::ui::Document;
use std::path::Path;

const ARROW: &str = "The bodies are out of sight: show them";

fn middle(app: &App) -> DVec3 {
    let particles = &app.published().snapshot.bodies[0].particles;
    particles.iter().sum::<DVec3>() / particles.len() as f64
}

/// What the result view shows of the particles.
fn seen(window: &Window) -> Rect {
    let app = window.state();
    let particles = app.published().snapshot.bodies.iter().flat_map(|body| body.particles.iter());
    Rect::from_points(&particles.filter_map(|&at| app.shown_at(at)).collect::<Vec<_>>())
}

fn fills(window: &Window) -> bool {
    let (room, seen) = (view(window, "Result"), seen(window));
    room.contains_rect(seen) && seen.size().max_elem() > 0.2 * room.size().min_elem()
}

#[test]
fn a_scene_of_another_size_is_fitted_when_it_is_opened() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/two_layer_figure_14.json");
    let mut window = super::open(Document::load(Some(path)).expect("it ships"));
    super::hold(&mut window);
    press_key(&mut window, Modifiers::COMMAND, Key::N);
    window.run_steps(3);
    until(&mut window, |app| app.scene().bodies.len() == 1 && is_settled(app));
    window.run_steps(40);
    assert!(fills(&window), "{:?} in {:?}", seen(&window), view(&window, "Result"));
}

/// Moves what is seen far to the left of the result view.
fn look_away(window: &mut Window) {
    let room = view(window, "Result");
    for _ in 0..3 {
        let (from, to) = (room.right_center() - Vec2::new(8.0, 0.0), room.left_center() + Vec2::new(8.0, 0.0));
        window.event(Event::ModifiersChanged(Modifiers::SHIFT));
        button(window, from, PointerButton::Middle, true);
        window.event(Event::PointerMoved(from.lerp(to, 0.5)));
        button(window, to, PointerButton::Middle, false);
        window.event(Event::ModifiersChanged(Modifiers::NONE));
        window.run_steps(3);
    }
}

#[test]
fn an_arrow_points_at_bodies_that_are_out_of_sight_and_brings_them_back() {
    let mut window = still();
    assert!(window.query_by_label(ARROW).is_none());
    look_away(&mut window);
    let arrow = window.get_by_label(ARROW).rect();
    assert!(arrow.center().x < view(&window, "Result").center().x, "they are to the left");
    click(&mut window, ARROW);
    window.run_steps(40);
    assert!(window.query_by_label(ARROW).is_none() && fills(&window));
}

#[test]
fn the_view_follows_a_body_that_falls_when_it_is_asked_to() {
    let mut window = still();
    let moved = |window: &mut Window| {
        let before = window.state().shown_at(middle(window.state())).expect("it is seen");
        for _ in 0..6 {
            super::advance(window);
        }
        window.step();
        before.distance(window.state().shown_at(middle(window.state())).expect("it is seen"))
    };
    let free = moved(&mut window);
    press_key(&mut window, Modifiers::ALT, Key::B);
    window.step();
    let followed = moved(&mut window);
    assert!(free > 5.0 && followed < 0.5, "{free} and {followed} points");
    // By hand it is still moved where one likes.
    window.event(Event::PointerMoved(view(&window, "Result").center()));
    let delta = egui::vec2(0.0, 6.0);
    let (phase, source) = (egui::TouchPhase::Move, egui::MouseWheelSource::Unknown);
    window.event(Event::MouseWheel { unit: MouseWheelUnit::Line, delta, phase, source, modifiers: Modifiers::NONE });
    let before = seen(&window).size();
    window.run_steps(30);
    assert!(seen(&window).size().x > 1.2 * before.x);
}
