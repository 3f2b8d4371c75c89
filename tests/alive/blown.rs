//! What wind gives to what it blows at.

use crate::common::*;
use glam::DVec3;
use sinew::bake::bake;
use sinew::io::{load_assets, load_scene};
use sinew::scene::{Axis, IntegratorChoice, IntegratorKind, Motion, Scene, Side, TimeStep, Wave, Wind};
use sinew::sim::Runner;
use sinew::solver::MeasureValue;
use std::path::Path;

/// A flap held at its foot, aslant to gusts that come all at once and die down, and that keeps all that it is given.
fn flap(integrator: IntegratorKind) -> Scene {
    let mut body = block([6, 9, 2], 2e4);
    body.regions = vec![layers("foot", Axis::Y, Side::Min, 1)];
    body.pins = vec![pin("foot", &ALL, Motion::Fixed)];
    (body.material.damping.pair, body.material.damping.air) = (0.0, 0.0);
    body.integrator = IntegratorChoice::Given(integrator);
    in_space(body).with_wind(Wind::new([9.0, 2.0, 6.0]).with_drive(Wave::new(0.06)))
}

/// What energy has come from nothing after a while, and the work of the wind [J].
fn unbooked(scene: &Scene, step: f64, halvings: i32) -> [f64; 2] {
    let mut scene = scene.clone();
    scene.time.step = TimeStep::manual(step * 0.5_f64.powi(halvings), 20 << halvings);
    let mut runner = runner(&scene);
    let start = runner.world().energy();
    (0..12).for_each(|_| runner.advance_frame());
    assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    [runner.world().energy() - start - runner.world().work(), runner.world().work()]
}

#[test]
fn the_work_of_wind_is_the_energy_gained_to_second_order_in_the_step() {
    use IntegratorKind::{LeapFrog, Midpoint, Newmark, Rk4, Verlet};
    let stable = baked(&flap(LeapFrog)).world.bodies()[0].parts().stable_dt;
    for kind in [LeapFrog, Verlet, Midpoint, Rk4, Newmark] {
        let found = [0, 1, 2].map(|halvings| unbooked(&flap(kind), 0.4 * stable, halvings));
        println!("{kind:?}: {found:?}");
        let [[off, work], [half, _], [quarter, _]] = found;
        assert!(work > 0.0 && off.abs() < 2e-3 * work, "{kind:?}: {found:?}");
        assert!((quarter / half).abs() < 0.35 && (half / off).abs() < 0.4, "{kind:?}: {found:?}");
    }
}

/// How far the tip of the leaf that ships comes about [mm] within spans of a second each that begin at these times [s],
/// under its wind times a share: the diagonal of the box around its way.
fn ways(share: f64, begin: [f64; 2]) -> [f64; 2] {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let mut scene = load_scene(&folder.join("alive_leaf.json")).expect("a scene that loads");
    scene.wind = scene.wind.map(|wind| wind.with_drive(share));
    let assets = load_assets(&scene, &folder, &mut |_| {}).expect("a model that ships");
    let mut runner = Runner::new(bake(&scene, &assets).expect("a scene that bakes"));
    let mut found = begin.map(|_| [DVec3::INFINITY, DVec3::NEG_INFINITY]);
    while runner.world().time() < begin[1] + 1.0 {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
        let time = runner.world().time();
        let MeasureValue::Vector(tip) = runner.world().measures()[0] else { panic!("the way of the tip") };
        for ([low, high], _) in found.iter_mut().zip(begin).filter(|(_, from)| (*from..*from + 1.0).contains(&time)) {
            (*low, *high) = (low.min(tip), high.max(tip));
        }
    }
    runner.look();
    assert!(runner.world().unbalanced().is_empty(), "{:?}", runner.world().unbalanced());
    let found = found.map(|[low, high]| low.distance(high));
    println!("{share} of the wind: {found:.1?} mm within a second from {begin:?} s on");
    found
}

#[test]
fn a_leaf_flutters_in_a_steady_wind() {
    let blown = ways(1.0, [1.0, 3.0]);
    assert!(blown[0] > 60.0 && blown[1] > 1.3 * blown[0], "{blown:?} mm");
}

#[test]
fn the_swings_of_a_leaf_die_down_without_wind() {
    let calm = ways(0.0, [1.0, 3.0]);
    assert!(calm[1] < 0.8 * calm[0], "{calm:?} mm");
}
