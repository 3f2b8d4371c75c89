//! Fibres: what they weigh in, where they sit, how stiff they are.

mod common;
use common::*;
use sinew::scene::{Axis, Distance, MeasureKind, Motion, RestShape, Scene, Side};

/// The press of the short bar at 2 %, with the four fibres of the design's figure.
fn pressed(fraction_of_fibre: f64) -> Scene {
    let mut bar = short_bar(5e7);
    bar.material.damping.air = 8000.0;
    for (k, (x, z)) in [(-0.012, -0.012), (-0.012, 0.012), (0.012, -0.012), (0.012, 0.012)].into_iter().enumerate() {
        let vertices = (0..13).map(|i| [x, 0.003 + 0.0055 * f64::from(i), z]).collect();
        bar.fibres.push(fibre(&format!("f{k}"), vertices, paper(5e5, 2.5e5), fraction_of_fibre, RestShape::Straight));
    }
    bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    bar.pins = vec![
        pin("bottom", &ALL, Motion::Fixed),
        pin("top", &[Axis::Y], ramp([0.0, -1.0, 0.0], Distance::Fraction(0.02), 0.004)),
    ];
    let mut scene = in_space(bar);
    scene.time.frames_per_second = 2000.0;
    scene.measures = vec![measure("press", MeasureKind::ReactionForce(reaction("top", [0.0, 1.0, 0.0])))];
    scene
}

#[test]
fn four_fibres_stiffen_the_press_as_computed() {
    let force = scalar(&settle(&pressed(0.25), 200), 0);
    println!("{force} N");
    assert!((force / 11_828.0 - 1.0).abs() < 0.02, "{force} N, not 11 828 N");
}
