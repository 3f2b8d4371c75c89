//! Regions with a matrix of their own.

use crate::common::*;
use sinew::scene::{Axis, Distance, Motion, RegionMaterial, Side};
use sinew::scene::{Body, MeasureKind, Scene};

const E: f64 = 1e6;

fn own(region: &str, change: impl FnOnce(&mut RegionMaterial)) -> RegionMaterial {
    let mut own = RegionMaterial::of(region);
    change(&mut own);
    own
}

/// A rod whose upper half is another material, pulled by a thousandth.
fn halves(upper: RegionMaterial) -> Scene {
    let mut rod = block([4, 12, 4], E).with_region_material(upper);
    let length = 11.0 * D;
    let omega = std::f64::consts::PI * (E / 1852.0).sqrt() / length;
    rod.material.damping.air = 1.2 * omega;
    rod.regions = vec![
        layers("bottom", Axis::Y, Side::Min, 1),
        layers("top", Axis::Y, Side::Max, 1),
        layers("upper", Axis::Y, Side::Max, 6),
    ];
    let pull = ramp([0.0, 1.0, 0.0], Distance::Metres(1e-3 * length), 3.0 / omega);
    rod.pins = vec![pin("bottom", &[Axis::Y], Motion::Fixed), pin("top", &[Axis::Y], pull)];
    let mut scene = in_space(rod);
    scene.time.frames_per_second = omega;
    scene.measures = vec![measure("pull", MeasureKind::reaction_force("bottom", [0.0, 1.0, 0.0]))];
    scene
}

#[test]
fn two_halves_pull_as_springs_in_a_row() {
    let alone = scalar(&settle(&halves(RegionMaterial::of("upper")), 400), 0);
    let over_alone = |transition: f64| {
        let scene = halves(own("upper", |own| (own.young_modulus, own.transition) = (Some(4.0 * E), transition)));
        scalar(&settle(&scene, 600), 0) / alone
    };
    let (sharp, smooth) = (over_alone(0.0), over_alone(3.0 * D));
    println!("{sharp}, with a transition {smooth}");
    // 2 / (1 + 1/4); the jump is spread over a support radius, which is 5 % of it here. A transition takes some of the
    // soft half.
    assert!((sharp / 1.6 - 1.0).abs() < 0.06 && smooth > 1.05 * sharp, "{sharp}, {smooth}");
}

#[test]
fn density_and_damping_are_the_regions_own() {
    let body = |of: RegionMaterial| -> Body {
        let mut rod = block([4, 12, 4], E).with_region_material(of);
        rod.regions = vec![layers("upper", Axis::Y, Side::Max, 6)];
        rod.initial.deformation = [[1.0, 0.0, 0.0], [0.05, 1.05, 0.0], [0.0, 0.0, 1.0]];
        rod
    };
    let heavy = baked(&in_space(body(own("upper", |own| own.density = Some(5000.0)))));
    let mass = heavy.world.bodies()[0].state().mass();
    let expected = 96.0 * 4e-4 + 96.0 * 5000.0 * D * D * D;
    assert!((mass / expected - 1.0).abs() < 1e-12, "{mass}, not {expected}");
    let energy = |of: RegionMaterial| {
        let mut scene = in_space(body(of));
        scene.time.frames_per_second = 1000.0;
        let mut runner = runner(&scene);
        (0..20).for_each(|_| runner.advance_frame());
        let body = &runner.world().bodies()[0];
        assert!(body.state().linear_momentum().length() < 1e-12, "momentum stays");
        body.energies(0.02).total()
    };
    let [free, damped] = [RegionMaterial::of("upper"), own("upper", |own| own.damping = Some(200.0))].map(energy);
    assert!(damped < 0.9 * free && damped > 0.0, "{damped} J of {free} J");
}
