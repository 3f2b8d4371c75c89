//! The matching figures: known curves, drawn unevenly with 1 % noise, against the curve that comes back.

use crate::drawing::{BOX_DIAGONAL, CURVES, apart, curve, draw, exact, lifted};
use glam::DVec3;
use sinew::sketch::{Lifted, SketchNote, View};
use sinew::test_support::geometry::{arc_length, distance_to_polyline};
use sinew::test_support::sketch::{SAMPLES, STRAY_LIMIT};

/// Drawings of each curve.
const DRAWINGS: u64 = 20;
/// Standard deviation of the noise: 1 % of the unit box.
const NOISE: f64 = 0.01;

fn drawings(name: &str, noise: f64) -> impl Iterator<Item = Lifted> {
    let curve = curve(name);
    (0..DRAWINGS).map(move |seed| {
        lifted(&draw(curve, View::Front, noise, 2 * seed), &draw(curve, View::Side, noise, 2 * seed + 1))
    })
}

/// The same two strokes joined by arc length alone.
fn by_arc_length(lifted: &Lifted) -> Vec<DVec3> {
    let [first, second] = &lifted.strokes;
    first.iter().zip(second).map(|(a, b)| DVec3::new(a.x, 0.5 * (a.y + b.y), b.x)).collect()
}

/// The same two strokes joined in the order of their shared coordinate.
fn by_height(lifted: &Lifted) -> Vec<DVec3> {
    let [mut first, mut second] = lifted.strokes.clone();
    first.sort_by(|a, b| a.y.total_cmp(&b.y));
    second.sort_by(|a, b| a.y.total_cmp(&b.y));
    first.iter().zip(&second).map(|(a, b)| DVec3::new(a.x, 0.5 * (a.y + b.y), b.x)).collect()
}

/// Mean over all drawings of the largest distance between curve and truth.
fn mean_error(name: &str, join: impl Fn(&Lifted) -> Vec<DVec3>) -> f64 {
    let truth = exact(curve(name));
    drawings(name, NOISE).map(|lifted| apart(&join(&lifted), &truth)).sum::<f64>() / DRAWINGS as f64
}

#[test]
fn matching_by_the_shared_axis_beats_arc_length() {
    for (name, limit) in [("helix", 0.05), ("two-turn helix", 0.085), ("S-curve", 0.035), ("fast then slow", 0.035)] {
        let matched = mean_error(name, |lifted| lifted.curve.clone());
        let plain = mean_error(name, by_arc_length);
        eprintln!("{name}: {matched:.3} matched, {plain:.3} by arc length");
        assert!(matched < limit, "{name}: {matched}");
        assert!(matched < 0.7 * plain, "{name}: {matched} against {plain}");
    }
}

#[test]
fn every_known_curve_comes_back() {
    for (name, curve) in CURVES {
        let error = mean_error(name, |lifted| lifted.curve.clone());
        eprintln!("{name}: {error:.3}");
        assert!(error < if name.contains('-') || name.contains("spiral") { 0.085 } else { 0.045 }, "{name}: {error}");
        // Without noise only the sampling is left.
        let clean = drawings(name, 0.0).map(|lifted| apart(&lifted.curve, &exact(curve))).fold(0.0, f64::max);
        eprintln!("{name}: {clean:.3} without noise");
        assert!(clean < 0.03, "{name}: {clean}");
    }
}

#[test]
fn sorting_by_height_fails_on_a_stroke_that_turns_back() {
    let sorted = mean_error("leaning S", by_height);
    let matched = mean_error("leaning S", |lifted| lifted.curve.clone());
    eprintln!("leaning S: {sorted:.3} sorted, {matched:.3} matched");
    assert!(sorted > 0.3 && matched < 0.03, "{sorted} against {matched}");
}

#[test]
fn every_pair_of_views_gives_the_same_curve() {
    let pairs = [
        (View::Front, View::Side),
        (View::Side, View::Front),
        (View::Front, View::Top),
        (View::Top, View::Front),
        (View::Side, View::Top),
        (View::Top, View::Side),
    ];
    // It moves along all three axes throughout, at its own pace along each.
    let curve = |t: f64| DVec3::new(0.1 + 0.6 * t + 0.2 * t * t, 0.1 + 0.8 * t.sqrt(), 0.9 - 0.5 * t - 0.3 * t * t * t);
    for (a, b) in pairs {
        let lifted = lifted(&draw(curve, a, 0.0, 3), &draw(curve, b, 0.0, 4));
        let error = apart(&lifted.curve, &exact(curve));
        eprintln!("{a} and {b}: {error:.4}");
        assert!(error < 0.01, "{a} and {b}: {error}");
        assert!((lifted.curve[0] - curve(0.0)).length() < 1e-12 && !lifted.reversed);
    }
}

#[test]
fn the_curve_is_uniform_in_arc_length() {
    for lifted in drawings("hook", NOISE) {
        assert_eq!(lifted.curve.len(), SAMPLES);
        let step = arc_length(&lifted.curve) / (SAMPLES - 1) as f64;
        // Chords cut corners, so they may be a little shorter than the arc between their ends.
        assert!(lifted.curve.windows(2).all(|pair| ((pair[1] - pair[0]).length() - step).abs() < 0.2 * step));
    }
}

#[test]
fn seen_in_its_views_the_curve_lies_on_its_strokes_or_says_otherwise() {
    let mut strayed = 0;
    for (name, _) in CURVES {
        for lifted in drawings(name, NOISE) {
            let far = |point: &DVec3| {
                let [first, second] = &lifted.strokes;
                let front = distance_to_polyline(View::Front.project(*point), first);
                front.max(distance_to_polyline(View::Side.project(*point), second))
            };
            let deviation = lifted.curve.iter().map(far).fold(0.0, f64::max) / BOX_DIAGONAL;
            assert!((deviation - lifted.deviation).abs() < 1e-12);
            let noted = lifted.notes.iter().any(|note| matches!(note, SketchNote::Strays { .. }));
            assert!(lifted.cost > 0.01 || noted == (deviation > STRAY_LIMIT), "{name}: {deviation}");
            strayed += usize::from(noted);
        }
        for lifted in drawings(name, 0.3 * NOISE) {
            assert!(lifted.cost > 0.01 || lifted.deviation < STRAY_LIMIT, "{name}: {}", lifted.deviation);
        }
    }
    eprintln!("{strayed} of 200 curves stray by more than 1 %");
    assert!(strayed <= 4, "{strayed} of 200 curves stray");
}
