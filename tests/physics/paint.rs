//! Painted volume fraction: it takes the matrix away where it is painted, and nothing else.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{Axis, Body, Dab, MeasureKind, Motion, RestShape, Scene, Side, painted};
use sinew::solver::MeasureValue;

fn dab(center: [f64; 3], radius: f64, value: f64, strength: f64) -> Dab {
    Dab { strength, ..Dab::new(center, radius, value) }
}

/// The short bar on a clamped foot under three times its weight, at rest: where the mean of its top layer went [mm].
fn standing(paint: Vec<Dab>) -> DVec3 {
    let mut bar = short_bar(2e5);
    bar.material.damping.air = 150.0;
    bar.paint = paint;
    bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    bar.pins = vec![pin("bottom", &ALL, Motion::Fixed)];
    let mut scene = in_space(bar);
    scene.gravity = [0.0, -30.0, 0.0];
    scene.measures = vec![measure("top", MeasureKind::mean_displacement("top"))];
    match settle(&scene, 300).world().measures()[0] {
        MeasureValue::Vector(moved) => moved,
        MeasureValue::Scalar(other) => panic!("{other}"),
    }
}

#[test]
fn a_side_painted_to_one_gives_way_and_the_bar_leans_to_it() {
    let at = |x: f64| vec![dab([x, 0.024, 0.0], 0.02, 1.0, 1.0)];
    let [plain, right, left] = [Vec::new(), at(0.018), at(-0.018)].map(standing);
    println!("plain {plain}, painted on the right {right}, on the left {left} mm");
    assert!(plain.x.abs() < 1e-6 && plain.y < 0.0, "{plain}");
    assert!(right.y < 1.05 * plain.y, "the top sinks deeper: {right} {plain}");
    assert!(right.x > 0.05 && right.z.abs() < 1e-6, "{right}");
    assert!((right.x + left.x).abs() < 1e-3 * right.x && (right.y - left.y).abs() < 1e-3, "{right} {left}");
}

/// A bar with a fibre, stretched evenly.
fn stretched(paint: Vec<Dab>) -> Scene {
    let mut bar: Body = short_bar(2e5);
    let vertices: Vec<[f64; 3]> = (0..13).map(|k| [0.0, 0.003 + 0.0055 * f64::from(k), 0.0]).collect();
    bar.fibres = vec![fibre("f", vertices, rigidity(3000.0, 0.01), 0.8, RestShape::Straight)];
    bar.initial.deformation[1][1] = 1.01;
    bar.paint = paint;
    in_space(bar)
}

#[test]
fn matrix_is_left_by_the_painted_share_and_the_fibre_keeps_its_own() {
    let paint = vec![
        dab([0.0, 0.04, 0.0], 0.03, 0.5, 1.0),
        dab([0.01, 0.03, 0.01], 0.02, 1.0, 0.7),
        dab([-0.01, 0.06, 0.0], 0.025, 0.0, 1.0),
    ];
    let [plain, brushed] = [Vec::new(), paint.clone()].map(|paint| baked(&stretched(paint)));
    let [without, with] = [&plain, &brushed].map(|baked| baked.world.bodies()[0].energies(0.0));
    // In even strain the energy of a particle is its share of matrix.
    let bare: f64 = plain.fractions[0].iter().map(|fraction| 1.0 - fraction).sum();
    let model = &brushed.world.bodies()[0].parts().model;
    let expected = plain.fractions[0].iter().zip(model.iter()).map(|(&fraction, &x)| painted(fraction, x, &paint));
    let share: f64 = expected.clone().map(|fraction| 1.0 - fraction).sum();
    assert!((share / bare - 1.0).abs() > 0.05, "paint that shows: {share} {bare}");
    assert!((with.matrix / without.matrix / (share / bare) - 1.0).abs() < 1e-12);
    assert!(brushed.fractions[0].iter().copied().eq(expected));
    assert!(with.stretching > 0.0);
    assert_eq!(with.stretching.to_bits(), without.stretching.to_bits());
}

#[test]
fn paint_of_zero_over_everything_brings_the_matrix_back() {
    let erased = baked(&stretched(vec![dab([0.0, 0.036, 0.0], 0.2, 0.0, 1.0)]));
    assert!(erased.fractions[0].iter().all(|fraction| *fraction == 0.0));
    let mut none = stretched(Vec::new());
    none.bodies[0].fibres.clear();
    let matrix = |scene: &Scene| baked(scene).world.bodies()[0].energies(0.0).matrix.to_bits();
    assert_eq!(erased.world.bodies()[0].energies(0.0).matrix.to_bits(), matrix(&none));
}

#[test]
fn paint_that_reaches_nothing_changes_no_bit() {
    let run = |paint: Vec<Dab>| {
        let mut runner = runner(&stretched(paint));
        (0..3).for_each(|_| runner.advance_frame());
        runner.world().bodies()[0].state().positions.iter().map(|x| x.to_array().map(f64::to_bits)).collect::<Vec<_>>()
    };
    let plain = run(Vec::new());
    assert_eq!(run(vec![dab([0.2, 0.0, 0.0], 0.1, 1.0, 1.0), dab([0.0, 0.03, 0.0], 0.1, 1.0, 0.0)]), plain);
    assert_ne!(run(vec![dab([0.0, 0.03, 0.0], 0.01, 1.0, 0.5)]), plain);
}
