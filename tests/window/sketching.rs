//! Two strokes make a fibre.

use super::{click, drag, draw, open, press_key, still, stroke, until, view};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use glam::{DVec2, DVec3};
use sinew::scene::{Fibre, FibreSource, StrokePair};
use sinew::sketch::{LiftOptions, Stroke, View, lift};
use sinew::test_support::ui::App;
use sinew::ui::Document;

fn fibres(app: &App) -> &[Fibre] {
    &app.scene().bodies[0].fibres
}

fn strokes(fibre: &Fibre) -> &StrokePair {
    match &fibre.source {
        FibreSource::Strokes(pair) => pair,
        FibreSource::Vertices(_) => panic!("{} was not drawn", fibre.id),
    }
}

/// Draws a bow in the front view and a slant in the side view, both as high.
fn draw_a_fibre(window: &mut super::Window) {
    draw(window, "Front", |s| [0.08 * (3.0 * s).sin() - 0.04, 0.5 * s - 0.25]);
    draw(window, "Side", |s| [0.1 * s - 0.05, 0.5 * s - 0.25]);
}

#[test]
fn a_stroke_in_each_view_makes_a_fibre_that_reprojects_onto_both() {
    let mut window = still();
    let before = fibres(window.state()).len();
    draw_a_fibre(&mut window);
    let app = window.state();
    assert_eq!(fibres(app).len(), before + 1, "{:?}", app.message());
    let fibre = fibres(app)[before].clone();
    let pair = strokes(&fibre).clone();
    assert_eq!((pair.first.view, pair.second.view), (View::Front, View::Side));

    // The strokes were drawn half as high as the views are, and both views show to one scale.
    let height = |points: &[[f64; 2]]| points[points.len() - 1][1] - points[0][1];
    assert!((height(&pair.first.points) / height(&pair.second.points) - 1.0).abs() < 1e-3);

    // The solid takes it up, and it lies where both views have it.
    until(&mut window, |app| app.published().at_rest.bodies[0].fibres.len() == before + 1);
    let body = &window.state().published().at_rest.bodies[0];
    let shown = body.fibres.iter().find(|shown| shown.id == fibre.id).expect("it is embedded");
    let low = body.skin.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let diagonal = (body.skin.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max) - low).length();
    let taken = |points: &[[f64; 2]], view| Stroke { view, points: points.iter().map(|&p| DVec2::from(p)).collect() };
    let options = LiftOptions { flip_second: false, stretch: false, model_diagonal: diagonal };
    let lifted = lift(&taken(&pair.first.points, View::Front), &taken(&pair.second.points, View::Side), &options)
        .expect("they are lifted again");
    for vertex in &shown.vertices {
        for (view, stroke) in [View::Front, View::Side].into_iter().zip(&lifted.strokes) {
            let seen = view.project(*vertex);
            let off = stroke.iter().map(|point| point.distance(seen)).fold(f64::INFINITY, f64::min);
            assert!(off < 0.01 * diagonal, "{off} of {diagonal} in {view:?}");
        }
    }
}

#[test]
fn every_pointer_sample_is_used() {
    let mut window = still();
    let rect = view(&window, "Front");
    let path = stroke(rect, |s| [0.1 * (12.0 * s).sin(), 0.5 * s - 0.25]);
    drag(&mut window, &path);
    draw(&mut window, "Side", |s| [0.1 * s - 0.05, 0.5 * s - 0.25]);
    let fibre = fibres(window.state()).last().expect("a fibre").clone();
    // Four samples came to each frame, all of them more than two points apart.
    assert_eq!(strokes(&fibre).first.points.len(), path.len());
}

#[test]
fn the_simulation_goes_on_while_a_fibre_is_drawn() {
    let mut window = open(Document::load(None).expect("the built-in scene"));
    let time = |app: &App| app.published().status.time;
    let start = time(window.state());
    draw_a_fibre(&mut window);
    let count = fibres(window.state()).len();
    until(&mut window, |app| app.published().at_rest.bodies[0].fibres.len() == count);
    let drawn = time(window.state());
    assert!(drawn >= start && window.state().published().status.playing);
    until(&mut window, |app| time(app) > drawn + 0.02);
}

#[test]
fn undo_takes_the_fibre_back_and_redo_brings_it_again() {
    let mut window = still();
    let before = fibres(window.state()).to_vec();
    draw_a_fibre(&mut window);
    let after = fibres(window.state()).to_vec();
    assert_eq!(after.len(), before.len() + 1);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(fibres(window.state()), before);
    press_key(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(fibres(window.state()), after);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    press_key(&mut window, Modifiers::COMMAND, Key::Y);
    assert_eq!(fibres(window.state()), after);
}

#[test]
fn the_second_stroke_can_be_flipped() {
    let mut window = still();
    draw_a_fibre(&mut window);
    let flipped = |app: &App| strokes(fibres(app).last().expect("a fibre")).flip_second;
    assert!(!flipped(window.state()));
    click(&mut window, "Flip second stroke");
    assert!(flipped(window.state()));
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(!flipped(window.state()));
}

#[test]
fn a_fibre_is_previewed_and_escape_takes_strokes_back() {
    let mut window = still();
    let before = fibres(window.state()).len();
    draw(&mut window, "Front", |s| [0.0, 0.5 * s - 0.25]);
    assert!(window.state().message().is_some_and(|text| text.contains("other view")));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    // The stroke is gone: one in the side view is a first one again.
    draw(&mut window, "Side", |s| [0.0, 0.5 * s - 0.25]);
    assert_eq!(fibres(window.state()).len(), before);
    draw(&mut window, "Front", |s| [0.05 * s, 0.5 * s - 0.25]);
    assert_eq!(fibres(window.state()).len(), before + 1);
    assert_eq!(strokes(fibres(window.state()).last().expect("a fibre")).first.view, View::Side);
}

#[test]
fn any_two_views_can_be_drawn_in() {
    let mut window = still();
    let rect = view(&window, "Side");
    click(&mut window, "Side");
    window.step();
    window.step();
    click(&mut window, "Top");
    assert!(window.query_by_label("Side view").is_none());
    assert!(rect.intersects(view(&window, "Top")));
    // They share X: both strokes run from left to right.
    let before = fibres(window.state()).len();
    draw(&mut window, "Front", |s| [0.16 * s - 0.08, 0.2 * s - 0.1]);
    draw(&mut window, "Top", |s| [0.16 * s - 0.08, 0.1 * s - 0.05]);
    assert_eq!(fibres(window.state()).len(), before + 1, "{:?}", window.state().message());
    // The top view's vertical runs down with Z: up on the screen is towards smaller Z.
    let pair = strokes(fibres(window.state()).last().expect("a fibre")).clone();
    assert_eq!((pair.first.view, pair.second.view), (View::Front, View::Top));
    let points = &pair.second.points;
    assert!(points[points.len() - 1][1] < points[0][1]);
    // What the other view shows already, they exchange.
    click(&mut window, "Front");
    window.step();
    window.step();
    click(&mut window, "Side");
    assert!(window.query_by_label("Front view").is_none() && window.query_by_label("Side view").is_some());
}
