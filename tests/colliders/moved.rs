//! Colliders that move: what they give is what the bodies gain.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{Collider, DriveKeys, DrivenMotion, DrivenTurn, Motion, Ramp, Rotation, Scene, Turn};
use sinew::sim::Runner;

fn quickly(body: sinew::scene::Body, collider: Collider) -> Scene {
    let mut scene = in_space(body).with_collider(collider);
    // Every frame is one step, so that sums over frames are sums over steps.
    scene.time.frames_per_second = 20_000.0;
    scene.time.duration = 0.05;
    scene
}

fn energy(runner: &Runner) -> f64 {
    runner.world().bodies()[0].energies(runner.world().time()).total()
}

#[test]
fn momentum_and_energy_come_from_the_collider_that_gives_them() {
    let motions: [Motion; 3] = [
        Ramp::new([0.0, 1.0, 0.0], sinew::scene::Distance::Metres(0.02), 0.04).into(),
        Turn::new([0.0, 0.0, 1.0], 40.0, 0.04).with_origin([-0.06, -0.01, 0.0]).into(),
        DrivenMotion::new(DriveKeys::new([(0.0, 0.0), (0.03, 1.0), (0.045, 0.4)]), [0.0, 0.015, 0.004])
            .with_turn(DrivenTurn::new([1.0, 0.0, 1.0], 25.0))
            .into(),
    ];
    for (friction, motion) in [0.0, 0.0, 0.0, 0.5].into_iter().zip(motions.iter().cycle()) {
        let body = block([4, 3, 4], 2e5);
        let collider = Collider::cuboid("pusher", [0.1, 0.01, 0.1]).with_translation([0.0, -0.006, 0.0]);
        let scene = quickly(body, collider.with_friction(friction).with_motion(motion.clone()));
        let mut runner = runner(&scene);
        assert_eq!(runner.world().bodies()[0].parts().dt, 1.0 / 20_000.0);
        let start = energy(&runner);
        let (mut impulse, mut last, mut off, mut most) = (DVec3::ZERO, DVec3::ZERO, 0.0_f64, 0.0_f64);
        while runner.world().time() < 0.05 {
            runner.advance_frame();
            let force = -runner.world().force_on_collider(0);
            impulse += 0.5 * (last + force) / 20_000.0;
            last = force;
            let gained = energy(&runner) - start - runner.world().work_of_collider(0);
            off = off.max(gained);
            most = most.max(runner.world().work_of_collider(0));
        }
        let momentum = runner.world().bodies()[0].state().linear_momentum();
        let (work, gained) = (runner.world().work_of_collider(0), energy(&runner) - start);
        println!(
            "friction {friction}: {impulse} N s, {momentum} kg m/s; {work} J done, {gained} J gained, {off} J over"
        );
        assert!(momentum.length() > 1e-3, "it was pushed");
        // Forces of friction hang on the speed: those at both ends of a step are not quite those that it was made of.
        let slack = if friction > 0.0 { 1e-3 } else { 1e-9 };
        assert!(impulse.distance(momentum) < slack * momentum.length());
        assert!(off < 2e-3 * most, "gained {off} J more than the {most} J that were done");
        // Without friction and damping nothing is lost.
        assert!(friction > 0.0 || (work - gained).abs() < 2e-3 * most, "{work} J done, {gained} J gained");
    }
}

#[test]
fn two_jaws_lift_a_block_by_friction() {
    let mut body = block([5, 5, 5], 1e5);
    body.material.damping.pair = 100.0;
    let jaw = |id: &str, side: f64| {
        let keys = [
            (0.0, [0.0; 3]),
            (0.2, [-side * 0.002, 0.0, 0.0]),
            (0.6, [-side * 0.002, 0.04, 0.0]),
            (1.0, [-side * 0.002, 0.04, 0.0]),
        ];
        let keys = keys.map(|(time, offset)| sinew::scene::Keyframe::new(time, offset)).to_vec();
        Collider::cuboid(id, [0.01, 0.04, 0.04])
            .with_translation([side * 0.0205, 0.015, 0.0])
            .with_motion(Motion::Keyframes(keys))
            .with_friction(0.8)
    };
    let mut scene = in_space(body).with_collider(jaw("left", -1.0)).with_collider(jaw("right", 1.0));
    scene.gravity = [0.0, -9.81, 0.0];
    scene.room.floor = Some(0.0);
    let mut runner = runner(&scene);
    crate::resting::run(&mut runner, 0.8);
    let height = runner.world().bodies()[0].state().center().y;
    crate::resting::run(&mut runner, 0.2);
    let later = runner.world().bodies()[0].state().center().y;
    println!("lifted to {height} m, then {later} m");
    assert!(height > 0.053 && (later - height).abs() < 1e-5);
}

#[test]
fn what_lies_on_a_turning_table_is_carried_round() {
    let mut body = block([4, 2, 4], 1e5).with_translation([0.03, 0.0, 0.0]);
    body.material.damping.pair = 100.0;
    let table = Collider::cuboid("table", [0.2, 0.02, 0.2])
        .with_translation([0.0, -0.01, 0.0])
        .with_rotation(Rotation::about([0.0, 1.0, 0.0], 10.0))
        .with_motion(Turn::new([0.0, 1.0, 0.0], 90.0, 1.0));
    let mut scene = in_space(body).with_collider(table.with_friction(0.6)).with_gravity([0.0, -9.81, 0.0]);
    scene.room.contact_damping = 0.3;
    let mut runner = runner(&scene);
    crate::resting::run(&mut runner, 1.2);
    let center = runner.world().bodies()[0].state().center();
    println!("carried to {center}");
    // A quarter turn about Y takes X to -Z.
    assert!(center.distance(DVec3::new(0.0, center.y, -0.03)) < 2e-4, "{center}");
}
