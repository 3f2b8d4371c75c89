//! What is shown while the strokes are being drawn.

use crate::drawing::{BOX_DIAGONAL, Curve, curve, draw};
use sinew::sketch::{Stroke, View};
use sinew::test_support::sketch::{guides, partial_lift};

#[test]
fn guides_mark_band_ends_and_turns() {
    let first = draw(curve("leaning S"), View::Front, 0.005, 5);
    let guides = guides(&first, View::Side, BOX_DIAGONAL).expect("guides");
    assert_eq!(guides.axis, 1);
    assert_eq!([guides.start, guides.end], [first.points[0].y, first.points[first.points.len() - 1].y]);
    assert_eq!(guides.turns.len(), 3, "{:?}", guides.turns);
    for (found, known) in guides.turns.iter().zip([0.9, 0.1, 0.9]) {
        assert!((found - known).abs() < 0.03, "{found} for {known}");
    }
    assert!((guides.band[0] - 0.1).abs() < 0.03 && (guides.band[1] - 0.9).abs() < 0.03);
}

#[test]
fn guides_follow_the_axis_that_the_views_share() {
    let first = draw(curve("diagonal"), View::Top, 0.0, 5);
    let with_front = guides(&first, View::Front, BOX_DIAGONAL).expect("share X");
    assert_eq!(with_front.axis, 0);
    assert!((with_front.start - 0.1).abs() < 1e-12 && (with_front.end - 0.9).abs() < 1e-12);
    let with_side = guides(&first, View::Side, BOX_DIAGONAL).expect("share Z");
    assert_eq!((with_side.axis, with_side.turns.len()), (2, 0));
    assert!((with_side.start - 0.2).abs() < 1e-12 && (with_side.end - 0.8).abs() < 1e-12);
    assert!(guides(&first, View::Top, BOX_DIAGONAL).is_err());
}

/// A drawing in the side view, up to a share of its points.
fn begun(curve: Curve, share: f64) -> Stroke {
    let mut stroke = draw(curve, View::Side, 0.0, 12);
    stroke.points.truncate((stroke.points.len() as f64 * share) as usize);
    stroke
}

#[test]
fn the_tick_runs_along_the_first_stroke_with_the_pen() {
    for name in ["helix", "arch", "two humps", "fast then slow"] {
        let curve = curve(name);
        let first = draw(curve, View::Front, 0.0, 11);
        for share in [0.15, 0.4, 0.65, 0.9] {
            let second = begun(curve, share);
            let pen = second.points[second.points.len() - 1];
            let found = partial_lift(&first, &second, BOX_DIAGONAL).expect("a preview");
            // The point of the known curve under the pen tells where the tick belongs.
            let under_pen = |t: &f64| View::Side.project(curve(*t)).distance(pen);
            let parameters = (0..=2000).map(|i| f64::from(i) / 2000.0);
            let there = parameters.min_by(|a, b| under_pen(a).total_cmp(&under_pen(b))).expect("a nearest point");
            let off = found.tick.distance(View::Front.project(curve(there)));
            assert!(off < 0.04, "{name} at {share}: {off}");
            assert!(found.curve[191].distance(curve(there)) < 0.04, "{name} at {share}");
        }
    }
}

#[test]
fn the_tick_runs_from_the_end_for_a_stroke_drawn_backwards() {
    let curve = curve("S-curve");
    let first = draw(curve, View::Front, 0.0, 11);
    let mut second = draw(curve, View::Side, 0.0, 12);
    second.points.reverse();
    second.points.truncate(40);
    let found = partial_lift(&first, &second, BOX_DIAGONAL).expect("a preview");
    assert!((found.tick.y - second.points[39].y).abs() < 0.02);
    assert!(found.curve[0].distance(curve(1.0)) < 0.02);
}
