//! Anything may come in: an error or a finite curve comes out.

use crate::drawing::{CURVES, PLAIN, draw};
use glam::{DVec2, DVec3};
use proptest::collection::vec;
use proptest::prelude::*;
use sinew::sketch::{LiftOptions, Placed, Stroke, View, lift, structure_particles, trim};
use sinew::test_support::sketch::{guides, partial_lift};

fn view() -> impl Strategy<Value = View> {
    prop_oneof![Just(View::Front), Just(View::Side), Just(View::Top)]
}

/// Any number at all, or one that a hand might draw, or one of the usual suspects.
fn number() -> impl Strategy<Value = f64> {
    let suspects = [0.0, -0.0, 1.0, f64::NAN, f64::INFINITY, f64::MIN_POSITIVE, 5e-324, 1e9, 1e-9, 1e308];
    prop_oneof![3 => -1.0..1.0, 1 => any::<f64>(), 1 => proptest::sample::select(suspects.to_vec())]
}

fn wild_stroke() -> impl Strategy<Value = Stroke> {
    (view(), vec((number(), number()), 0..12))
        .prop_map(|(view, points)| Stroke { view, points: points.into_iter().map(DVec2::from).collect() })
}

/// Points on a grid of 2^-16, so that moving them by whole numbers loses no digit.
fn tame_stroke(view: View) -> impl Strategy<Value = Stroke> {
    let coordinate = || (0..65536_i32).prop_map(|i| f64::from(i) / 65536.0);
    vec((coordinate(), coordinate()), 2..40)
        .prop_map(move |points| Stroke { view, points: points.into_iter().map(DVec2::from).collect() })
}

fn two_views() -> impl Strategy<Value = [View; 2]> {
    (view(), view()).prop_filter("two different views", |(a, b)| a != b).prop_map(|(a, b)| [a, b])
}

fn tame_pair() -> impl Strategy<Value = (Stroke, Stroke)> {
    two_views().prop_flat_map(|[a, b]| (tame_stroke(a), tame_stroke(b)))
}

fn options(model_diagonal: impl Strategy<Value = f64>) -> impl Strategy<Value = LiftOptions> {
    (any::<bool>(), any::<bool>(), model_diagonal).prop_map(|(flip_second, stretch, model_diagonal)| LiftOptions {
        flip_second,
        stretch,
        model_diagonal,
    })
}

proptest! {
    #[test]
    fn wild_strokes_never_panic(
        first in wild_stroke(),
        second in wild_stroke(),
        options in options(prop_oneof![number(), Just(1.0)]),
    ) {
        if let Ok(lifted) = lift(&first, &second, &options) {
            prop_assert!(lifted.curve.iter().all(|point| point.is_finite()));
            prop_assert!(lifted.cost.is_finite() && lifted.deviation.is_finite());
        }
        if let Ok(preview) = partial_lift(&first, &second, options.model_diagonal) {
            prop_assert!(preview.curve.iter().all(|point| point.is_finite()) && preview.tick.is_finite());
        }
        if let Ok(guides) = guides(&first, second.view, options.model_diagonal) {
            prop_assert!(guides.band[0] <= guides.start && guides.start <= guides.band[1]);
        }
    }

    #[test]
    fn tame_strokes_give_ordered_matches_and_a_fibre(
        (first, second) in tame_pair(),
        options in options(0.01..100.0),
        spacing in 1e-4..10.0,
    ) {
        match lift(&first, &second, &options) {
            Ok(lifted) => {
                prop_assert!(lifted.curve.iter().all(|point| point.is_finite()));
                prop_assert_eq!((lifted.matches[0], lifted.matches[lifted.matches.len() - 1]), ([0, 0], [191, 191]));
                let steps = lifted.matches.windows(2).map(|w| [w[1][0] - w[0][0], w[1][1] - w[0][1]]);
                prop_assert!(steps.into_iter().all(|step| [[0, 1], [1, 0], [1, 1]].contains(&step)));
                let particles = structure_particles(&lifted.curve, spacing);
                prop_assert!(particles.is_ok_and(|particles| (4..=64).contains(&particles.len())));
            }
            Err(error) => prop_assert!(!error.to_string().contains("NaN")),
        }
    }

    #[test]
    fn a_moved_pair_gives_the_moved_curve((first, second) in tame_pair(), by in [-999..999_i32, -999..999, -999..999]) {
        let by = DVec3::from(by.map(f64::from));
        let moved = |stroke: &Stroke| Stroke {
            view: stroke.view,
            points: stroke.points.iter().map(|&point| point + stroke.view.project(by)).collect(),
        };
        let options = LiftOptions { stretch: true, ..PLAIN };
        if let Ok(still) = lift(&first, &second, &options) {
            let there = lift(&moved(&first), &moved(&second), &options).expect("lifts wherever it stands");
            prop_assert_eq!(&there.matches, &still.matches);
            let apart = still.curve.iter().zip(&there.curve).map(|(a, b)| (*a + by).distance(*b)).fold(0.0, f64::max);
            prop_assert!(apart < 1e-11, "{}", apart);
        }
    }

    #[test]
    fn any_particles_can_be_trimmed(
        particles in vec((any::<[f64; 3]>(), any::<bool>(), any::<f64>()), 0..20),
        h in any::<f64>(),
    ) {
        let place = |(point, embedded, distance)| Placed { point: DVec3::from_array(point), embedded, distance };
        let particles: Vec<Placed> = particles.into_iter().map(place).collect();
        match trim(&particles, h) {
            Ok(trimmed) => prop_assert!(trimmed.runs.iter().all(|run| run.len() >= 3)),
            Err(error) => prop_assert!(error.to_string().starts_with("Fibre discarded: ")),
        }
    }
}

#[test]
fn unusable_strokes_are_refused_in_words() {
    let stroke = |view, points: &[[f64; 2]]| Stroke { view, points: points.iter().copied().map(DVec2::from).collect() };
    let good = stroke(View::Front, &[[0.0, 0.0], [1.0, 1.0]]);
    let second =
        |points: &[[f64; 2]]| lift(&good, &stroke(View::Side, points), &PLAIN).expect_err("refused").to_string();
    assert_eq!(second(&[]), "The second stroke is too short (0 m long). Redraw the second stroke");
    assert_eq!(second(&[[0.5, 0.5]]), "The second stroke is too short (0 m long). Redraw the second stroke");
    assert_eq!(second(&[[0.5, 0.5]; 9]), "The second stroke is too short (0 m long). Redraw the second stroke");
    assert_eq!(
        second(&[[0.5, 0.5], [0.5, f64::NAN]]),
        "Point 2 of the second stroke is not a finite number. Redraw the second stroke"
    );
    assert_eq!(
        second(&[[0.5, 0.5], [0.5, 1e300]]),
        "Point 2 of the second stroke lies more than 1e9 model sizes away. Redraw the second stroke"
    );
    assert_eq!(
        lift(&good, &good, &PLAIN).expect_err("one view twice").to_string(),
        "Both strokes were drawn in the front view. Draw the second one in another view"
    );
    let no_model = LiftOptions { model_diagonal: f64::NAN, ..PLAIN };
    assert!(lift(&good, &stroke(View::Side, &[[0.0, 0.0], [1.0, 1.0]]), &no_model).is_err());
    assert!(structure_particles(&[DVec3::ONE; 5], 0.1).is_err());
    assert!(structure_particles(&[DVec3::ZERO, DVec3::NAN], 0.1).is_err());
}

#[test]
fn thousands_of_points_are_as_good_as_a_hundred() {
    let curve = CURVES[0].1;
    let first = draw(curve, View::Front, 0.0, 1);
    let points = (0..20_000).map(|i| View::Side.project(curve(f64::from(i) / 19_999.0))).collect();
    let lifted = lift(&first, &Stroke { view: View::Side, points }, &PLAIN).expect("lifts");
    assert!(lifted.cost < 0.01);
}
