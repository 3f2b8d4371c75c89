//! What wind gives to what it blows at.

use crate::common::*;
use sinew::scene::{Axis, IntegratorChoice, IntegratorKind, Motion, Scene, Side, TimeStep, Wave, Wind};

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
