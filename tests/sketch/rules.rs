//! Direction, mismatch, degenerate pairs: each rule with the message that people read.

use crate::drawing::{PLAIN, curve, draw, lifted};
use glam::DVec2;
use sinew::sketch::{LiftOptions, SketchError, SketchNote, Stroke, View, lift, structure_particles};
use sinew::test_support::geometry::arc_length;

/// A straight stroke of 50 points.
fn line(view: View, from: [f64; 2], to: [f64; 2]) -> Stroke {
    let (from, to) = (DVec2::from(from), DVec2::from(to));
    Stroke { view, points: (0..50).map(|i| from.lerp(to, f64::from(i) / 49.0)).collect() }
}

fn backwards(stroke: &Stroke) -> Stroke {
    Stroke { view: stroke.view, points: stroke.points.iter().rev().copied().collect() }
}

const STRETCH: LiftOptions = LiftOptions { stretch: true, ..PLAIN };
const FLIP: LiftOptions = LiftOptions { flip_second: true, ..PLAIN };

fn refusal(first: &Stroke, second: &Stroke) -> String {
    lift(first, second, &PLAIN).expect_err("refused").to_string()
}

#[test]
fn a_second_stroke_drawn_backwards_is_reversed_and_others_are_not() {
    for name in ["diagonal", "helix", "S-curve", "cone spiral", "fast then slow", "hook"] {
        let curve = curve(name);
        let (first, second) = (draw(curve, View::Front, 0.01, 7), draw(curve, View::Side, 0.01, 8));
        let ordinary = lifted(&first, &second);
        let reversed = lifted(&first, &backwards(&second));
        assert!(!ordinary.reversed && reversed.reversed, "{name}");
        assert!(reversed.notes.contains(&SketchNote::Reversed) && !ordinary.notes.contains(&SketchNote::Reversed));
        let apart = ordinary.curve.iter().zip(&reversed.curve).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        assert!(apart < 1e-9, "{name}: both directions give the same curve, {apart} apart");
    }
}

#[test]
fn flipping_turns_the_second_stroke_from_what_was_found() {
    let (first, second) = (draw(curve("arch"), View::Front, 0.0, 1), draw(curve("arch"), View::Side, 0.0, 2));
    let (kept, flipped) = (lifted(&first, &second), lift(&first, &second, &FLIP).expect("an arch fits either way"));
    assert!(!kept.reversed && flipped.reversed);
    assert!((kept.curve[0].z - 0.2).abs() < 1e-12 && (flipped.curve[0].z - 0.8).abs() < 1e-12);
    assert!(lift(&first, &backwards(&second), &FLIP).is_ok_and(|lifted| (lifted.curve[0].z - 0.2).abs() < 1e-12));

    let (up, down) = (line(View::Front, [0.0, 0.0], [0.5, 1.0]), line(View::Side, [0.5, 1.0], [0.0, 0.0]));
    let undone = lift(&up, &down, &FLIP).expect("a poor fit is still a preview");
    assert!(!undone.reversed && !undone.notes.contains(&SketchNote::Reversed));
    assert!(undone.notes.iter().any(|note| note.to_string().starts_with("Strokes fit poorly: ")));
}

#[test]
fn a_small_mismatch_is_stretched_silently() {
    let lifted = lifted(&line(View::Front, [0.0, 0.0], [0.4, 1.0]), &line(View::Side, [0.0, 0.02], [0.6, 0.99]));
    assert_eq!(lifted.notes, []);
    assert!(lifted.curve[0].y.abs() < 1e-12 && (lifted.curve[191].y - 1.0).abs() < 1e-12);
    assert!(lifted.clipped.iter().all(Vec::is_empty));
}

#[test]
fn a_middling_mismatch_is_clipped_and_can_be_stretched() {
    let first = line(View::Front, [0.0, 0.0], [0.4, 1.0]);
    let second = line(View::Side, [0.0, 0.0], [0.6, 0.85]);
    let clipped = lifted(&first, &second);
    let notes: Vec<String> = clipped.notes.iter().map(ToString::to_string).collect();
    assert_eq!(notes, ["Strokes overlap 85 % in height; the rest was clipped. Stretch instead?"]);
    assert!((clipped.curve[191].y - 0.85).abs() < 1e-9 && (clipped.curve[191].x - 0.34).abs() < 1e-9);
    let [dashed, none] = &clipped.clipped;
    assert!(none.is_empty() && dashed.len() == 1);
    assert!((arc_length(&dashed[0]) - 0.15 * arc_length(&first.points)).abs() < 1e-9);

    let stretched = lift(&first, &second, &STRETCH).expect("stretches");
    assert_eq!(stretched.notes.len(), 1);
    assert_eq!(stretched.notes[0].to_string(), "The second stroke was stretched to 118 % in height to match the first");
    assert!((stretched.curve[191].y - 1.0).abs() < 1e-12 && stretched.clipped.iter().all(Vec::is_empty));
}

#[test]
fn a_turn_above_the_common_range_is_flattened_not_cut_in_two() {
    let arch = |view, height: f64| {
        let points = (0..=100).map(|i| f64::from(i) / 100.0).map(|t| DVec2::new(t, height * 4.0 * t * (1.0 - t)));
        Stroke { view, points: points.collect() }
    };
    let lifted = lifted(&arch(View::Front, 1.0), &arch(View::Side, 0.85));
    assert_eq!(lifted.clipped[0].len(), 1, "the top of the first arch");
    assert!(lifted.clipped[1].is_empty());
    assert!((lifted.curve[0].x - 0.0).abs() < 1e-9 && (lifted.curve[191].x - 1.0).abs() < 1e-9);
    assert!(lifted.curve.iter().all(|point| point.y < 0.8501));
    assert!(lifted.deviation < 0.01, "{}", lifted.deviation);
}

#[test]
fn a_large_mismatch_is_refused_with_its_figure() {
    let up_to = |height| line(View::Side, [0.0, 0.0], [0.6, height]);
    let first = line(View::Front, [0.0, 0.0], [0.4, 1.0]);
    assert_eq!(refusal(&first, &up_to(0.6)), "Strokes overlap only 60 % in height. Stretch or redraw?");
    assert_eq!(refusal(&first, &up_to(0.4)), "Strokes overlap only 40 % in height. Stretch or redraw?");
    let apart = line(View::Side, [0.0, 2.0], [0.6, 3.0]);
    assert_eq!(refusal(&first, &apart), "Strokes overlap only 0 % in height. Stretch or redraw?");
    let stretched = lift(&first, &up_to(0.4), &STRETCH).expect("stretches as the message offers");
    assert!((stretched.curve[191].y - 1.0).abs() < 1e-12 && stretched.cost < 1e-9);

    let (front, top) = (line(View::Front, [0.0, 0.0], [1.0, 0.4]), line(View::Top, [0.0, 0.0], [0.5, 0.7]));
    assert_eq!(refusal(&front, &top), "Strokes overlap only 50 % in width (X). Stretch or redraw?");
    let (side, top) = (line(View::Side, [0.0, 0.0], [1.0, 0.4]), line(View::Top, [0.0, 0.0], [0.5, 0.7]));
    assert_eq!(refusal(&side, &top), "Strokes overlap only 70 % in depth (Z). Stretch or redraw?");
}

#[test]
fn flat_strokes_name_the_view_that_would_help() {
    assert_eq!(
        refusal(&line(View::Front, [0.0, 0.5], [1.0, 0.56]), &line(View::Side, [0.0, 0.5], [0.5, 0.55])),
        "Both strokes run flat: height covers only 6 % of the longer one, which cannot give depth. \
         Keep the front stroke and draw the other one in the top view instead"
    );
    // In front and top views, strokes along Y and Z give no depth: X is what they share.
    assert_eq!(
        refusal(&line(View::Front, [0.5, 0.0], [0.5, 0.4]), &line(View::Top, [0.5, 0.0], [0.5, 0.8])),
        "Both strokes run flat: width (X) covers only 0 % of the longer one, which cannot give depth. \
         Keep the top stroke and draw the other one in the side view instead"
    );
    assert_eq!(
        refusal(&line(View::Front, [0.0, 0.0], [0.5, 1.0]), &line(View::Side, [0.0, 0.5], [0.8, 0.5])),
        "The second stroke is flat in height and the other one is not. Redraw the second stroke"
    );
}

#[test]
fn one_turn_higher_in_one_view_is_said() {
    let humps = |view, second_hump: f64| {
        let height = |t: f64| if t < 0.5 { 1.0 } else { second_hump } * (std::f64::consts::TAU * t).sin().abs();
        let points = (0..=200).map(|i| f64::from(i) / 200.0).map(|t| DVec2::new(t, height(t)));
        Stroke { view, points: points.collect() }
    };
    let lifted = lifted(&humps(View::Front, 0.9), &humps(View::Side, 0.8));
    assert!(lifted.cost < 0.03 && lifted.deviation > 0.01);
    let notes: Vec<String> = lifted.notes.iter().map(ToString::to_string).collect();
    assert_eq!(notes, ["The fibre strays 2.7 % of the model from a stroke: their turns or ends differ in height"]);
}

#[test]
fn corners_of_a_stroke_of_three_points_survive() {
    let corner = Stroke { view: View::Front, points: vec![DVec2::ZERO, DVec2::new(0.0, 0.5), DVec2::new(0.5, 1.0)] };
    let lifted = lifted(&corner, &line(View::Side, [0.0, 0.0], [0.2, 1.0]));
    let nearest = lifted.curve.iter().map(|point| point.truncate().distance(corner.points[1]));
    assert!(nearest.fold(f64::INFINITY, f64::min) < 0.02);
}

#[test]
fn particles_are_as_many_as_the_length_asks_for() {
    let lifted = lifted(&line(View::Front, [0.0, 0.0], [0.0, 1.0]), &line(View::Side, [0.0, 0.0], [0.0, 1.0]));
    let count = |spacing| structure_particles(&lifted.curve, spacing).map(|particles| particles.len());
    assert_eq!(count(0.1), Ok(11));
    assert_eq!(count(0.096), Ok(11), "rounds 10.4 down");
    assert_eq!(count(0.094), Ok(12), "rounds 10.6 up");
    assert_eq!(count(10.0), Ok(4));
    assert_eq!(count(1e-300), Ok(64));
    assert_eq!(count(0.0), Err(SketchError::Spacing(0.0)));
    let particles = structure_particles(&lifted.curve, 0.1).expect("a curve of length 1");
    assert!(particles.iter().enumerate().all(|(i, point)| (point.y - 0.1 * i as f64).abs() < 1e-9));
}
