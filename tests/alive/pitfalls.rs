//! What is said of fibres whose activation cannot show, and when those that act break.

use crate::common::*;
use crate::fibres::{E, F, rod, upright};
use sinew::scene::{Activation, BreakPast, DriveKeys, Motion, Region, Selector};
use sinew::solver::{BreakPlace, FibreBreak};
use std::f64::consts::PI;

/// Below a fifth of the material in its reach a fibre is lost in the matrix, contraction and all.
#[test]
fn a_contraction_that_is_lost_in_the_matrix_is_said() {
    let displaced = 0.2 * PI * H * H * E;
    for (share, activation, is_said) in [
        (0.95, Activation::contracting(0.3, 1.0), true),
        (1.05, Activation::contracting(0.3, 1.0), false),
        (0.95, Activation::contracting(0.0, 1.0), false),
        (0.95, Activation::pulling(10.0 * F, 1.0), false),
    ] {
        let mut bar = rod([4, 7, 4]);
        bar.fibres.push(upright(7, 0.0, share * displaced, activation));
        let notes = baked(&in_space(bar)).notes;
        let weak: Vec<_> = notes.iter().filter(|note| note.warning && note.path.ends_with("/stiffness")).collect();
        assert_eq!(weak.len(), usize::from(share < 1.0), "{weak:?}");
        assert_eq!(weak.iter().any(|note| note.text.contains("contraction is lost")), is_said, "{share}: {weak:?}");
    }
}

/// A fibre breaks by what it carries, which is against the length that it wants to have now.
#[test]
fn limits_of_breaking_go_by_the_length_that_a_fibre_wants_to_have_now() {
    let carried = 0.25 * 40.0 * F * 0.3;
    // Held as drawn while it contracts by 0.3 within 20 ms.
    let breaks = |tension: f64| -> Vec<FibreBreak> {
        let mut bar = rod([3, 7, 3]);
        let coming = DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]);
        bar.fibres.push(upright(7, 0.5 * D, 40.0 * F, Activation::contracting(0.3, coming)));
        bar.fibres[0].break_past = Some(BreakPast { tension: Some(tension), ..BreakPast::default() });
        bar.regions = vec![Region::new("all", Selector::Everything)];
        bar.pins = vec![pin("all", &ALL, Motion::Fixed)];
        let mut scene = in_space(bar);
        scene.time.frames_per_second = 100.0;
        let mut runner = runner(&scene);
        (0..3).for_each(|_| runner.advance_frame());
        runner.world().bodies()[0].breaks().copied().collect()
    };
    assert!(breaks(1.01 * carried).is_empty(), "it carries less");
    let found = breaks(0.5 * carried);
    assert!(!found.is_empty());
    // Half of it is there half-way: 3 s² - 2 s³ is a half at 10 ms.
    let first = found[0];
    assert!(matches!(first.place, BreakPlace::Edge(_)) && (first.time - 0.01).abs() < 2e-3, "{first:?}");
}
