//! Each edit of a fibre does what it says, to strokes and to vertices.

use crate::shapes::*;
use glam::DVec3;
use proptest::prelude::*;
use sinew::edit::fibre_ops::*;
use sinew::scene::{Assets, Fibre, FibreSource, RestShape};
use sinew::sketch::{SketchError, View};
use sinew::test_support::geometry::SurfaceIndex;
use sinew::test_support::geometry::arc_length;
use std::f64::consts::{FRAC_PI_2, PI};

/// Rounding of sums of lengths of a tenth of a metre.
const EXACT: f64 = 1e-12;
/// What a lift of equal strokes elsewhere differs by.
const LIFTED: f64 = 1e-9;

/// Everything but the course.
fn same_but_for_course(a: &Fibre, b: &Fibre) -> bool {
    Fibre { source: b.source.clone(), ..a.clone() } == *b
}

fn transforms_of_axes() -> Vec<Transform> {
    let mut all = vec![Transform::translation(DVec3::new(0.013, -0.02, 0.007))];
    let pivot = DVec3::new(0.01, 0.03, -0.02);
    for axis in DVec3::AXES {
        all.push(Transform::reflection(pivot, -2.0 * axis).expect("a normal"));
        for quarters in [-1.0, 1.0, 2.0, 3.0] {
            all.push(Transform::rotation(pivot, 3.0 * axis, quarters * FRAC_PI_2).expect("an axis"));
        }
    }
    // A third of a turn about the diagonal takes every axis to the next.
    all.push(Transform::rotation(pivot, DVec3::ONE, 2.0 * PI / 3.0).expect("an axis"));
    all
}

#[test]
fn strokes_stay_strokes_where_axes_go_to_axes() {
    let mut views = Vec::new();
    for first in transforms_of_axes() {
        let fibre = transform(&drawn(View::Front, View::Side), &first, SAMPLING).expect("a transform").fibre;
        for by in transforms_of_axes() {
            let moved = transform(&fibre, &by, SAMPLING).expect("a transform");
            assert!(is_drawn(&moved.fibre) && moved.note.is_none(), "{by:?}: {:?}", moved.note);
            assert!(same_but_for_course(&fibre, &moved.fibre));
            let expected: Vec<DVec3> = at(&fibre).into_iter().map(|x| by.apply(x)).collect();
            assert!(apart(&at(&moved.fibre), &expected) < LIFTED, "{by:?}");
            views.push([strokes(&moved.fibre).first.view, strokes(&moved.fibre).second.view]);
        }
    }
    for first in View::ALL {
        for second in View::ALL {
            assert_eq!(views.contains(&[first, second]), first != second, "{first} {second}");
        }
    }
}

#[test]
fn transforms_do_what_they_are_named_for() {
    let pivot = DVec3::new(1.0, 2.0, 3.0);
    let quarter = Transform::rotation(pivot, DVec3::Y, FRAC_PI_2).expect("an axis");
    // Right-handed about Y: Z goes to X.
    assert_eq!(quarter.apply(pivot + DVec3::Z), pivot + DVec3::X);
    assert_eq!(quarter.apply(pivot), pivot);
    let mirror = Transform::reflection(pivot, DVec3::new(5.0, 0.0, 0.0)).expect("a normal");
    assert_eq!(mirror.apply(DVec3::new(4.0, 7.0, 8.0)), DVec3::new(-2.0, 7.0, 8.0));
    for nowhere in [DVec3::ZERO, DVec3::new(f64::NAN, 0.0, 0.0)] {
        assert!(matches!(Transform::rotation(pivot, nowhere, 1.0), Err(FibreEditError::NoDirection(_))));
        assert!(matches!(Transform::reflection(pivot, nowhere), Err(FibreEditError::NoDirection(_))));
    }
}

#[test]
fn other_turns_make_vertices_of_strokes_and_say_so() {
    let fibre = drawn(View::Front, View::Side);
    for by in [
        Transform::rotation(DVec3::ZERO, DVec3::Y, 0.3).expect("an axis"),
        Transform::reflection(DVec3::ZERO, DVec3::ONE).expect("a normal"),
    ] {
        let turned = transform(&fibre, &by, SAMPLING).expect("a turn");
        assert!(!is_drawn(&turned.fibre) && same_but_for_course(&fibre, &turned.fibre));
        let said = turned.note.expect("a note");
        let count = at(&fibre).len();
        assert_eq!(said, format!("Fibre 1 is no longer drawn by its two strokes: it has {count} vertices now"));
        let expected: Vec<DVec3> = at(&fibre).into_iter().map(|x| by.apply(x)).collect();
        assert!(apart(&at(&turned.fibre), &expected) < EXACT);
        // Vertices have nothing to lose.
        assert_eq!(transform(&turned.fibre, &by, SAMPLING).expect("a turn").note, None);
    }
}

#[test]
fn some_vertices_move_and_the_others_stay() {
    let by = Transform::translation(DVec3::new(0.001, 0.002, -0.003));
    for fibre in [given(), drawn(View::Side, View::Front)] {
        let before = at(&fibre);
        let moved = transform_vertices(&fibre, &[2, 5, 2], &by, SAMPLING).expect("a move");
        for (k, (new, old)) in at(&moved.fibre).into_iter().zip(&before).enumerate() {
            assert_eq!(new, if k == 2 || k == 5 { by.apply(*old) } else { *old }, "{k}");
        }
        let missing = transform_vertices(&fibre, &[0, before.len()], &by, SAMPLING).expect_err("no such vertex");
        let count = before.len();
        assert_eq!(missing.to_string(), format!("There is no vertex {}: the fibre has {count}", count + 1));
        assert_eq!(transform_vertices(&fibre, &[], &by, SAMPLING).expect("nothing to do").fibre, fibre);
        let onto = Transform::translation(before[3] - before[2]);
        let error = transform_vertices(&fibre, &[2], &onto, SAMPLING).expect_err("two in one place");
        assert!(error.to_string().starts_with("Vertex 4 would lie on the one before it"), "{error}");
        let nowhere = Transform::translation(DVec3::new(f64::INFINITY, 0.0, 0.0));
        let error = transform_vertices(&fibre, &[1], &nowhere, SAMPLING).expect_err("nowhere");
        assert_eq!(error, FibreEditError::NotFinite { index: 1 });
    }
    let fibre = drawn(View::Front, View::Side);
    let every: Vec<usize> = (0..at(&fibre).len()).collect();
    assert!(is_drawn(&transform_vertices(&fibre, &every, &by, SAMPLING).expect("a move").fibre));
    let one = transform_vertices(&fibre, &every[1..], &by, SAMPLING).expect("a move");
    assert!(!is_drawn(&one.fibre) && one.note.is_some());
}

#[test]
fn a_detached_fibre_stays_to_the_bit() {
    let fibre = drawn(View::Front, View::Side);
    let detached = detach(&fibre, SAMPLING).expect("a fibre");
    assert!(!is_drawn(&detached.fibre) && detached.note.is_some());
    assert_eq!(at(&detached.fibre), at(&fibre));
}

#[test]
fn running_the_other_way_keeps_strokes_and_course() {
    for fibre in [given(), drawn(View::Front, View::Side)] {
        let reversed = reverse(&fibre).expect("a fibre");
        assert_eq!((is_drawn(&reversed.fibre), &reversed.note), (is_drawn(&fibre), &None));
        let expected: Vec<DVec3> = at(&fibre).into_iter().rev().collect();
        // Where two matches of the strokes cost the same, the first is taken: the way back may take the other.
        assert!(apart(&at(&reversed.fibre), &expected) < 1e-3 * SAMPLING.model_diagonal);
        assert_eq!(reverse(&reversed.fibre).expect("a fibre").fibre, fibre);
    }
}

#[test]
fn inserted_vertices_leave_the_course_and_deleted_ones_are_gone() {
    let fibre = given();
    let before = at(&fibre);
    let inserted = insert_vertex(&fibre, 3, 0.25, SAMPLING).expect("an edge").fibre;
    let after = at(&inserted);
    assert_eq!(after.len(), 10);
    assert!(after[4].distance(before[3].lerp(before[4], 0.25)) < EXACT);
    assert!((arc_length(&after) - arc_length(&before)).abs() < EXACT);
    assert_eq!(at(&delete_vertices(&inserted, &[4], SAMPLING).expect("a vertex").fibre), before);
    let error = insert_vertex(&fibre, 8, 0.5, SAMPLING).expect_err("no such edge");
    assert_eq!(error.to_string(), "There is no edge 9: the fibre has 8");
    for share in [0.0, 1.0, -0.5, f64::NAN] {
        assert!(matches!(insert_vertex(&fibre, 0, share, SAMPLING), Err(FibreEditError::Share(_))));
    }
    let three = delete_vertices(&fibre, &[0, 2, 3, 5, 6, 7], SAMPLING).expect("three are left").fibre;
    assert_eq!(at(&three), [before[1], before[4], before[8]]);
    let error = delete_vertices(&three, &[1], SAMPLING).expect_err("too few");
    assert_eq!(error, FibreEditError::TooFew(2));
    assert!(error.to_string().contains("needs 3 to bend"), "{error}");
    assert!(delete_vertices(&fibre, &[9], SAMPLING).is_err());
    assert_eq!(delete_vertices(&fibre, &[], SAMPLING).expect("nothing to do").fibre, fibre);
}

#[test]
fn smoothing_keeps_the_ends_and_takes_kinks_out() {
    let mut zigzag = at(&given());
    for (k, vertex) in zigzag.iter_mut().enumerate() {
        vertex.x += if k % 2 == 0 { 0.002 } else { -0.002 };
    }
    let fibre = fibre(FibreSource::Vertices(zigzag.iter().map(DVec3::to_array).collect()));
    let kinks = |points: &[DVec3]| {
        points.windows(3).map(|p| (p[0] - 2.0 * p[1] + p[2]).length()).fold(0.0, |sum: f64, kink| sum + kink)
    };
    let smoothed = at(&smooth(&fibre, 3, SAMPLING).expect("a fibre").fibre);
    assert_eq!((smoothed[0], smoothed[8]), (zigzag[0], zigzag[8]));
    assert!(kinks(&smoothed) < 0.3 * kinks(&zigzag), "{} {}", kinks(&smoothed), kinks(&zigzag));
    assert_eq!(smooth(&fibre, 0, SAMPLING).expect("a fibre").fibre, fibre);
}

#[test]
fn resampling_spaces_vertices_evenly() {
    for (fibre, within) in [(given(), 0.002), (drawn(View::Front, View::Side), 1e-4)] {
        let before = at(&fibre);
        for count in [3, 7, 40] {
            let points = at(&resample(&fibre, ResampleTo::Count(count), SAMPLING).expect("a fibre").fibre);
            assert_eq!(points.len(), count);
            assert!(apart(&[points[0], points[count - 1]], &[before[0], before[before.len() - 1]]) < EXACT);
        }
        let points = at(&resample(&fibre, ResampleTo::Spacing(0.004), SAMPLING).expect("a fibre").fibre);
        let edges: Vec<f64> = points.windows(2).map(|edge| edge[0].distance(edge[1])).collect();
        assert!(edges.iter().all(|edge| (edge - 0.004).abs() < within), "{edges:?}");
        assert_eq!(at(&resample(&fibre, ResampleTo::Spacing(9.0), SAMPLING).expect("a fibre").fibre).len(), 3);
        for (to, error) in [
            (ResampleTo::Count(2), FibreEditError::Count(2)),
            (ResampleTo::Spacing(0.0), FibreEditError::Spacing(0.0)),
            (ResampleTo::Count(5000), FibreEditError::TooMany { wanted: 5000.0, limit: MOST_VERTICES }),
        ] {
            assert_eq!(resample(&fibre, to, SAMPLING).expect_err("refused"), error);
        }
        assert!(matches!(
            resample(&fibre, ResampleTo::Spacing(1e-300), SAMPLING),
            Err(FibreEditError::TooMany { wanted, .. }) if wanted > 1e290
        ));
    }
}

#[test]
fn snapped_vertices_lie_at_the_offset_under_the_surface() {
    let scene = crate::scene();
    let bar = surface(&scene.bodies[0], &Assets::default()).expect("a box");
    let fibre = given();
    for offset in [-0.003, 0.0, 0.002] {
        let snapped = at(&snap(&fibre, None, &bar, offset, SAMPLING).expect("a surface").fibre);
        for (vertex, before) in snapped.iter().zip(at(&fibre)) {
            let nearest = bar.nearest(*vertex).expect("a surface");
            assert!((vertex.distance(nearest.point) - f64::abs(offset)).abs() < EXACT, "{vertex}");
            let out = (*vertex - nearest.point).dot(nearest.normal);
            assert!(out * offset >= 0.0, "{out} {offset}");
            let foot = bar.nearest(before).expect("a surface").point;
            assert!(vertex.distance(foot) < f64::abs(offset) + EXACT, "the nearest place, not another one");
        }
    }
    let some = at(&snap(&fibre, Some(&[4]), &bar, 0.0, SAMPLING).expect("a surface").fibre);
    assert!(some.iter().zip(at(&fibre)).enumerate().all(|(k, (new, old))| (*new == old) == (k != 4)));
    let empty = SurfaceIndex::new(Vec::new(), Vec::new());
    assert_eq!(snap(&fibre, None, &empty, 0.0, SAMPLING), Err(FibreEditError::NoSurface));
    assert!(snap(&fibre, Some(&[9]), &bar, 0.0, SAMPLING).is_err());
}

#[test]
fn the_knife_cuts_in_two_at_a_vertex() {
    let fibre = given();
    let mut other = fibre.clone();
    other.id = "fibre-2".into();
    let among = [fibre.clone(), other];
    let (first, second) = split(&fibre, 3, &among, &[], SAMPLING).expect("an inner vertex");
    let before = at(&fibre);
    assert_eq!((at(&first.fibre), at(&second)), (before[..=3].to_vec(), before[3..].to_vec()));
    assert_eq!((first.fibre.id.as_str(), second.id.as_str()), ("fibre-1", "fibre-3"));
    assert_eq!(second.name, "Fibre 3");
    assert_eq!((second.rest_shape, &second.extra), (RestShape::Straight, &fibre.extra));
    for (vertex, left) in [(0, 1), (1, 2), (7, 2), (8, 1)] {
        let error = split(&fibre, vertex, &among, &[], SAMPLING).expect_err("a stub");
        assert_eq!(error, FibreEditError::Stub { index: vertex, left });
    }
    assert!(matches!(split(&fibre, 9, &among, &[], SAMPLING), Err(FibreEditError::NoVertex { index: 9, count: 9 })));
    let (first, _) = split(&drawn(View::Front, View::Side), 5, &among, &[], SAMPLING).expect("an inner vertex");
    assert!(first.note.expect("a note").contains("no longer drawn by its two strokes"));
}

#[test]
fn copies_have_names_of_their_own() {
    let named = |id: &str, name: &str| Fibre { id: id.into(), name: name.into(), ..given() };
    let among = [named("fibre-1", "Fibre 1"), named("fibre-2", ""), named("rib", "Rib"), named("7", "7")];
    let made = copies(among.iter().chain([&among[0]]), &among);
    let names: Vec<(&str, &str)> = made.iter().map(|fibre| (fibre.id.as_str(), fibre.name.as_str())).collect();
    let expected =
        [("fibre-3", "Fibre 3"), ("fibre-4", ""), ("rib-2", "Rib 2"), ("fibre-5", "5"), ("fibre-6", "Fibre 6")];
    assert_eq!(names, expected);
    assert!(made.iter().all(|copy| at(copy) == at(&given())));
}

#[test]
fn redrawing_one_view_keeps_the_other_stroke() {
    let mut fibre = drawn(View::Front, View::Side);
    if let FibreSource::Strokes(pair) = &mut fibre.source {
        pair.flip_second = true;
    }
    let straight = |x: f64| (0..30).map(|k| [x, 0.01 + 0.07 * f64::from(k) / 29.0]).collect::<Vec<_>>();
    for view in [View::Front, View::Side] {
        let redrawn = redraw(&fibre, view, straight(0.004), SAMPLING).expect("a stroke");
        let (old, new) = (strokes(&fibre), strokes(&redrawn.fibre));
        assert_eq!(new.first == old.first, view == View::Side);
        assert_eq!(new.second == old.second, view == View::Front);
        assert!(!new.flip_second && redrawn.note.expect("a note").contains("no longer flipped"));
        // Straight in this view, as it was in the other: within a hundredth of the model.
        let own = view.axes()[0];
        for (k, vertex) in at(&redrawn.fibre).iter().enumerate() {
            assert!((vertex[own] - 0.004).abs() < 1e-3, "{k}: {vertex}");
        }
    }
    let error = redraw(&fibre, View::Top, straight(0.0), SAMPLING).expect_err("another view");
    assert_eq!(
        error.to_string(),
        "The fibre was drawn in the front and side views, not in the top view. Redraw it in one of the two"
    );
    assert_eq!(redraw(&given(), View::Front, straight(0.0), SAMPLING), Err(FibreEditError::NoStrokes));
    let short = (0..30).map(|k| [0.0, 0.01 + 0.02 * f64::from(k) / 29.0]).collect();
    let error = redraw(&fibre, View::Front, short, SAMPLING).expect_err("too short for the other");
    assert!(matches!(error, FibreEditError::Sketch(SketchError::Overlap { .. })), "{error}");
}

fn vector() -> impl Strategy<Value = DVec3> {
    [-0.1..0.1f64, -0.1..0.1, -0.1..0.1].prop_map(DVec3::from_array)
}

proptest! {
    /// There and back again, and lengths kept.
    #[test]
    fn rigid_moves_keep_lengths_and_are_undone_by_their_inverse(
        pivot in vector(), axis in vector(), angle in -7.0..7.0f64, offset in vector()
    ) {
        prop_assume!(axis.length() > 1e-6);
        let turn = |angle| Transform::rotation(pivot, axis, angle).expect("an axis");
        let fibre = given();
        let mirror = Transform::reflection(pivot, axis).expect("a normal");
        for [there, back] in [
            [turn(angle), turn(-angle)],
            [mirror, mirror],
            [Transform::translation(offset), Transform::translation(-offset)],
        ] {
            let moved = transform(&fibre, &there, SAMPLING).expect("a move").fibre;
            prop_assert!((arc_length(&at(&moved)) - arc_length(&at(&fibre))).abs() < EXACT);
            let again = transform(&moved, &back, SAMPLING).expect("a move").fibre;
            prop_assert!(apart(&at(&again), &at(&fibre)) < EXACT);
        }
    }
}
