//! The press of the short bar: bottom layer clamped, top layer's height prescribed, forces at rest.

use crate::common::*;
use sinew::scene::{Axis, Distance, MeasureKind, Motion, Scene, Side};

fn pressed(fraction: f64) -> Scene {
    let mut bar = short_bar(5e7);
    bar.material.damping.air = 8000.0;
    bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    bar.pins = vec![
        pin("bottom", &ALL, Motion::Fixed),
        pin("top", &[Axis::Y], ramp([0.0, -1.0, 0.0], Distance::Fraction(fraction), 0.004)),
    ];
    let mut scene = in_space(bar);
    scene.time.frames_per_second = 2000.0;
    scene.measures = vec![measure("press", MeasureKind::reaction_force("top", [0.0, 1.0, 0.0]))];
    scene
}

#[test]
fn force_on_the_top_without_fibres() {
    for (fraction, expected) in [(0.02, 1950.0), (0.05, 4872.0), (0.10, 9735.0)] {
        let runner = settle(&pressed(fraction), 100);
        let force = scalar(&runner, 0);
        println!("{fraction}: {force} N in {} steps", runner.world().bodies()[0].steps());
        assert!((force / expected - 1.0).abs() < 0.01, "{fraction}: {force} N, not {expected} N");
    }
}
