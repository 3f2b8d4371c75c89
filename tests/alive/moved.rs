//! Pins, panels, gravity, gas and wind that follow drives.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{
    ActiveSprings, AfterLast, Axis, Ball, Distance, Drive, DriveKeys, DrivenMotion, DrivenTurn, Easing, HeightKey,
    Interpolation, Keyframe, Motion, Panel, PanelDrive, PanelMotion, Ramp, Region, Scene, Selector, SharedDrive, Side,
    SpringChoice, TimeStep, Turn, TwoLayer, Wave, Wind,
};
use sinew::sim::Runner;

/// From 0 to 1 in 0.2 s and back, over and over.
fn to_and_fro() -> Drive {
    let keys = DriveKeys::new([(0.0, 0.0), (0.2, 1.0)]);
    DriveKeys { between: Interpolation::Linear, after: AfterLast::Mirror, ..keys }.into()
}

fn advanced(scene: &Scene, seconds: f64) -> Runner {
    let mut runner = runner(scene);
    for _ in 0..runner.frames_for(seconds) {
        runner.advance_frame();
    }
    assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    runner
}

#[test]
fn a_pin_moves_and_turns_as_its_drive_has_it() {
    let mut body = block([3, 5, 3], 1e5).with_drive(SharedDrive::new("nod", to_and_fro()));
    body.regions = vec![Region::new("all", Selector::Everything)];
    let motion = DrivenMotion::new(Drive::Shared("nod".to_owned()), [0.0, 0.01, 0.0])
        .with_turn(DrivenTurn::new([0.0, 1.0, 0.0], 90.0));
    body.pins = vec![pin("all", &ALL, motion.into())];
    let mut scene = in_space(body);
    scene.time.frames_per_second = 100.0;
    for (seconds, value, rate) in [(0.1, 0.5, 5.0), (0.25, 0.75, -5.0), (0.5, 0.5, 5.0)] {
        let runner = advanced(&scene, seconds);
        let body = &runner.world().bodies()[0];
        let turn = glam::DQuat::from_rotation_y(value * std::f64::consts::FRAC_PI_2);
        let middle = body.parts().rest.iter().sum::<DVec3>() / body.state().len() as f64;
        for (i, rest) in body.parts().rest.iter().enumerate() {
            let arm = turn * (*rest - middle);
            let expected = middle + arm + value * DVec3::new(0.0, 0.01, 0.0);
            assert!(body.state().positions[i].distance(expected) < 1e-12, "{seconds} s");
            let spin = rate * std::f64::consts::FRAC_PI_2 * DVec3::Y.cross(arm) + rate * DVec3::new(0.0, 0.01, 0.0);
            assert!(body.state().velocities[i].distance(spin) < 1e-9, "{seconds} s");
        }
        assert!(!runner.at_rest());
    }
}

#[test]
fn a_panel_follows_its_drive() {
    let panel = Panel::falling("pump", 0.2, [0.1, 0.1]);
    let panel = Panel { motion: PanelMotion::Follows(PanelDrive::new(to_and_fro(), -0.05)), ..panel };
    let mut scene = in_space(block([3, 5, 3], 1e5)).with_panel(panel);
    scene.time.frames_per_second = 100.0;
    for (seconds, height) in [(0.1, 0.175), (0.3, 0.175), (0.4, 0.2)] {
        let runner = advanced(&scene, seconds);
        assert!((runner.world().panels()[0].height - height).abs() < 1e-12, "{seconds} s");
    }
}

#[test]
fn a_course_becomes_a_drive_that_moves_the_same() {
    let ways: [Motion; 4] = [
        Ramp { easing: Easing::Linear, ..Ramp::new([0.0, 2.0, 0.0], Distance::Metres(0.004), 0.1) }.into(),
        Turn { start: 0.02, ..Turn::new([0.0, 1.0, 1.0], 40.0, 0.1) }.into(),
        Motion::Keyframes(
            [(0.0, 0.0), (0.05, -0.004), (0.12, 0.002)]
                .map(|(time, way)| Keyframe::new(time, [way, 0.0, 2.0 * way]))
                .to_vec(),
        ),
        Motion::Keyframes([0.0, 0.1].map(|time| Keyframe::new(time, [0.0; 3])).to_vec()),
    ];
    let heights = [(0.02, 0.2), (0.1, 0.17), (0.2, 0.25)].map(|(time, height)| HeightKey::new(time, height));
    let panel = Panel { motion: PanelMotion::Driven(heights.to_vec()), ..Panel::falling("lid", 0.2, [0.1, 0.1]) };
    for motion in ways {
        let mut body = block([3, 5, 3], 1e5);
        body.regions = vec![layers("foot", Axis::Y, Side::Min, 1)];
        body.pins = vec![pin("foot", &ALL, motion)];
        let before = in_space(body).with_panel(panel.clone());
        let mut after = before.clone();
        let courses: Vec<_> = before.drivables().into_iter().filter_map(|of| Some((of.course(&before)?, of))).collect();
        assert_eq!(courses.len(), 2);
        for (drive, of) in courses {
            of.set(&mut after, Some(drive.clone())).expect("it is there");
            assert_eq!((of.drive(&after), of.course(&after)), (Some(&drive), None));
        }
        after.validate().expect("a sound scene");
        let found = [&before, &after].map(|scene| advanced(scene, 0.15));
        let [one, other] = found.each_ref().map(|runner| &runner.world().bodies()[0].state().positions);
        let farthest = one.iter().zip(other).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        assert!(farthest < 1e-10, "{farthest} m apart");
        let [one, other] = found.each_ref().map(|runner| runner.world().panels()[0].height);
        assert!((one - other).abs() < 1e-15 && one != 0.2, "{one} and {other} m");
    }
    // What goes round a corner is no single number, nor is a share of a body's extent.
    let corner = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]].map(|offset| Keyframe::new(0.0, offset));
    assert!(Motion::Keyframes(corner.to_vec()).as_driven().is_none());
    assert!(Motion::from(Ramp::new([1.0, 0.0, 0.0], Distance::Fraction(0.1), 1.0)).as_driven().is_none());
}

/// What is left of a balance that should stay as it was, and the work of its drives [J], with so many steps a frame.
fn balance(scene: &Scene, step: f64, halvings: i32) -> (f64, f64) {
    let mut scene = scene.clone();
    scene.time.step = TimeStep::manual(step * 0.5_f64.powi(halvings), 20 << halvings);
    let mut runner = runner(&scene);
    let energies = |runner: &Runner| runner.world().bodies()[0].energies(runner.world().time());
    let start = energies(&runner).total();
    (0..10).for_each(|_| runner.advance_frame());
    (energies(&runner).total() - start, energies(&runner).activation)
}

#[test]
fn gravity_follows_its_drive_and_its_work_is_booked() {
    let mut scene = Scene { gravity_drive: Some(0.5.into()), ..Scene::new("fall").with_body(block([3, 3, 3], 1e5)) };
    scene.time.frames_per_second = 100.0;
    let fallen = |runner: &Runner| {
        let body = &runner.world().bodies()[0];
        body.parts().rest[0].y - body.state().positions[0].y
    };
    let half = fallen(&advanced(&scene, 0.1));
    assert!((half / (0.25 * 9.81 * 0.01) - 1.0).abs() < 1e-9, "{half} m");
    scene.gravity_drive = Some(Wave::new(0.05).into());
    let stable = baked(&scene).world.bodies()[0].parts().stable_dt;
    let found = [0, 1].map(|halvings| balance(&scene, 0.5 * stable, halvings));
    assert!(found[0].0.abs() < 1e-3 * found[0].1.abs(), "{found:?}");
    assert!((found[1].0 / found[0].0 - 0.25).abs() < 0.05, "{found:?}");
}

#[test]
fn gas_follows_its_drive_and_its_work_is_booked() {
    let breath = SharedDrive::new("breath", DriveKeys::new([(0.0, 1.0), (0.5, 60.0)]));
    let mut ball = TwoLayer { drives: vec![breath], ..TwoLayer::ball("ball") };
    ball.pressure_drive = Some(Drive::Shared("breath".to_owned()));
    (ball.kd, ball.rkd) = (0.0, 0.0);
    let scene = Scene::new("breath").with_gravity([0.0; 3]).with_two_layer(ball.clone());
    let world = baked(&scene).world;
    let stable = world.bodies()[0].parts().stable_dt;
    let found = [0, 1].map(|halvings| balance(&scene, 0.3 * stable, halvings));
    println!("{found:?}");
    assert!(found[0].0.abs() < 1e-5 * found[0].1.abs(), "{found:?}");
    assert!((found[1].0 / found[0].0).abs() < 0.35, "{found:?}");
    (ball.kd, ball.rkd) = (15.0, 50.0);
    let scene = Scene::new("breath").with_gravity([0.0; 3]).with_two_layer(ball.clone());
    let extent = |runner: &Runner| {
        let positions = &runner.world().bodies()[0].state().positions;
        positions.iter().map(|x| x.length()).fold(0.0, f64::max)
    };
    let (before, after) = (extent(&advanced(&scene, 0.0)), extent(&advanced(&scene, 1.5)));
    let full = TwoLayer { pressure: 60.0 * ball.pressure, pressure_drive: None, ..ball };
    let full = extent(&advanced(&Scene::new("full").with_gravity([0.0; 3]).with_two_layer(full), 1.5));
    assert!(after > 1.005 * before && (after / full - 1.0).abs() < 1e-3, "{before}, then {after}, not {full} m");
}

#[test]
fn wind_pushes_a_box_as_a_plate_of_its_face_and_slides_along_the_others() {
    let push = |wind: Wind, velocity: [f64; 3]| {
        let body = block([5, 7, 5], 1e5).with_velocity(velocity);
        let runner = runner(&in_space(body).with_wind(wind));
        let body = &runner.world().bodies()[0];
        (0..body.state().len()).map(|i| body.net_force(i)).sum::<DVec3>()
    };
    let plate = 0.5 * 1.2 * 1.1 * (5.0 * D) * (7.0 * D) * 9.0;
    let found = push(Wind::new([3.0, 0.0, 0.0]), [0.0; 3]);
    assert!(found.distance(DVec3::X * plate) < 0.02 * plate, "{found} N, not {plate} N");
    // It is the velocity against the air that counts, and a drive may turn the wind round.
    assert!(push(Wind::new([3.0, 0.0, 0.0]), [3.0, 0.0, 0.0]).length() < 1e-9 * plate);
    let back = push(Wind::new([3.0, 0.0, 0.0]).with_drive(-1.0), [0.0; 3]);
    assert!((back + found).length() < 1e-9 * plate, "{back} N");
    assert!(push(Wind::default(), [-3.0, 0.0, 0.0]).distance(found) < 1e-9 * plate);
}

#[test]
fn wind_pushes_a_ball_half_as_hard_as_a_plate_of_its_shadow() {
    let push = |wind: [f64; 3]| {
        let ball = TwoLayer::new("ball", Ball { subdivisions: 4, ..Ball::default() });
        let scene = Scene::new("ball").with_gravity([0.0; 3]).with_two_layer(ball);
        let runner = runner(&scene.with_wind(Wind::new(wind)));
        let body = &runner.world().bodies()[0];
        (0..body.state().len()).map(|i| body.net_force(i)).sum::<DVec3>()
    };
    // A quarter of its whole surface is its shadow, of which the cubes of cosines leave a half.
    let half = 0.5 * 0.5 * 1.2 * 1.1 * std::f64::consts::PI * 4.0 * 9.0;
    for wind in [DVec3::X, DVec3::NEG_X, DVec3::new(0.0, 0.6, -0.8)] {
        let found = push((3.0 * wind).to_array());
        println!("{wind}: {:.4}", found.dot(wind) / half);
        assert!(found.distance(half * wind) < 0.01 * half, "{found} N, not {half} N along {wind}");
    }
}

#[test]
fn springs_that_act_have_the_lengths_that_their_drive_says() {
    let drive = DriveKeys::new([(0.0, 0.0), (0.4, 1.0)]);
    let mut segment = TwoLayer::segment("wire");
    (segment.kd, segment.air_drag) = (20.0, 0.0);
    segment.active_springs = vec![ActiveSprings::new("pull", "everything", 0.25, drive)];
    let runner = advanced(&Scene::new("wire").with_gravity([0.0; 3]).with_two_layer(segment), 3.0);
    let positions = &runner.world().bodies()[0].state().positions;
    let length = positions[0].distance(positions[1]);
    assert!((length / (0.75 * 2.0) - 1.0).abs() < 1e-6, "{length} m");
    let momentum: DVec3 = runner.world().bodies()[0].state().velocities.iter().copied().sum();
    assert!(momentum.length() < 1e-12, "{momentum}");
}

#[test]
fn the_work_of_springs_is_booked_and_only_theirs_that_are_chosen_change() {
    let mut ball = TwoLayer { pressure: 0.0, ..TwoLayer::ball("ball") };
    (ball.kd, ball.rkd) = (0.0, 0.0);
    let wave = || Drive::from(Wave::new(0.3));
    ball.active_springs = vec![
        ActiveSprings::new("all", "everything", 0.2, wave()),
        ActiveSprings::new("later", "outer", -0.3, wave()).only(SpringChoice::Structural),
    ];
    let scene = Scene::new("springs").with_gravity([0.0; 3]).with_two_layer(ball);
    let stable = baked(&scene).world.bodies()[0].parts().stable_dt;
    let found = [0, 1].map(|halvings| balance(&scene, 0.3 * stable, halvings));
    println!("{found:?}");
    assert!(found[0].1.abs() > 0.1 && found[0].0.abs() < 1e-3 * found[0].1.abs(), "{found:?}");
    assert!((found[1].0 / found[0].0).abs() < 0.35, "{found:?}");
    // Those of the outer layer are longer, the others shorter.
    let outer = |count: usize| {
        let mut still = scene.clone();
        let ball = &mut still.two_layer[0];
        (ball.kd, ball.rkd) = (30.0, 30.0);
        ball.active_springs.truncate(count);
        ball.active_springs.iter_mut().for_each(|springs| springs.drive = 1.0.into());
        let runner = advanced(&still, 3.0);
        let positions = &runner.world().bodies()[0].state().positions;
        positions[..18].iter().map(|place| place.length()).sum::<f64>() / 18.0
    };
    let found = [0, 1, 2].map(outer);
    println!("radius {found:?} m");
    assert!((found[0] - 2.0).abs() < 1e-9 && (found[1] - 1.6).abs() < 1e-3, "{found:?}");
    assert!(found[2] > found[1] + 0.2, "{found:?}");
}

#[test]
fn springs_across_a_ring_bring_its_layers_together_or_apart() {
    let apart = |kind: SpringChoice, contract: f64| {
        let mut ring = TwoLayer { pressure: 0.0, ..TwoLayer::ring("ring") };
        (ring.kd, ring.rkd) = (30.0, 30.0);
        ring.active_springs = vec![ActiveSprings::new("across", "everything", contract, 1.0).only(kind)];
        let runner = advanced(&Scene::new("ring").with_gravity([0.0; 3]).with_two_layer(ring), 3.0);
        let positions = &runner.world().bodies()[0].state().positions;
        let middle = positions.iter().sum::<DVec3>() / positions.len() as f64;
        let radius = |layer: &[DVec3]| layer.iter().map(|x| x.distance(middle)).sum::<f64>() / layer.len() as f64;
        let (outer, inner) = positions.split_at(positions.len() / 2);
        radius(outer) - radius(inner)
    };
    let rest = apart(SpringChoice::Radius, 0.0);
    assert!((rest - 1.0).abs() < 1e-6, "{rest} m");
    for kind in [SpringChoice::Radius, SpringChoice::Shear] {
        let [shorter, longer] = [0.3, -0.3].map(|contract| apart(kind, contract) / rest);
        println!("{kind:?}: {shorter:.3}, {longer:.3}");
        assert!((0.65..0.95).contains(&shorter) && (1.05..1.35).contains(&longer), "{kind:?}: {shorter}, {longer}");
    }
}

#[test]
fn a_pin_that_holds_one_axis_moves_along_that_alone() {
    let mut body = block([3, 5, 3], 1e5);
    body.regions = vec![Region::new("all", Selector::Everything)];
    let motion = DrivenMotion::new(to_and_fro(), [0.02, 0.01, 0.0]);
    body.pins = vec![pin("all", &[Axis::Y], motion.into())];
    let runner = advanced(&in_space(body), 0.1);
    let body = &runner.world().bodies()[0];
    let ways = body.state().positions.iter().zip(body.parts().rest.iter()).map(|(now, rest)| *now - *rest);
    for way in ways {
        assert!((way - DVec3::Y * 0.005).length() < 1e-12, "{way}");
    }
}

#[test]
fn work_of_springs_stays_where_a_drive_is_taken_away_and_idle_ones_are_told() {
    let mut ball = TwoLayer { pressure: 0.0, ..TwoLayer::ball("ball") };
    let springs = |id: &str, region: &str| ActiveSprings::new(id, region, 0.2, Wave::new(0.3));
    ball.active_springs = vec![springs("outer", "outer"), springs("inner", "inner")];
    let scene = Scene::new("springs").with_gravity([0.0; 3]).with_two_layer(ball.clone());
    let run = advanced(&scene, 0.1);
    let work = |runner: &Runner| runner.world().bodies()[0].energies(runner.world().time()).activation;
    let before = work(&run);
    ball.active_springs.remove(0);
    let mut edited = runner(&Scene::new("springs").with_gravity([0.0; 3]).with_two_layer(ball.clone()));
    edited.adopt(&run);
    assert!(before.abs() > 1e-3 && (work(&edited) - before).abs() < 1e-12 * before.abs(), "{before} J");
    ball.active_springs.push(springs("none", "inner").only(SpringChoice::Radius));
    ball.active_springs.push(springs("all", "everything"));
    let notes = baked(&Scene::new("springs").with_gravity([0.0; 3]).with_two_layer(ball)).notes;
    let idle: Vec<&str> =
        notes.iter().filter(|note| note.text.contains("moves nothing")).map(|note| note.path.as_str()).collect();
    assert_eq!(idle, ["/two_layer/0/active_springs/1", "/two_layer/0/active_springs/0"]);
}

#[test]
fn springs_that_cannot_act_are_refused_where_they_stand() {
    let refused = |springs: ActiveSprings| {
        let ball = TwoLayer { active_springs: vec![springs], ..TwoLayer::ball("ball") };
        Scene::new("ball").with_two_layer(ball).validate().expect_err("it is refused").to_string()
    };
    let springs = |region: &str, contract: f64, drive: Drive| ActiveSprings::new("pull", region, contract, drive);
    for (said, with) in [
        (refused(springs("elsewhere", 0.2, 1.0.into())), "/two_layer/0/active_springs/0/region"),
        (refused(springs("outer", 0.9, 1.0.into())), "/two_layer/0/active_springs/0/contract"),
        (refused(springs("outer", f64::NAN, 1.0.into())), "/two_layer/0/active_springs/0/contract"),
        (refused(springs("outer", 0.2, Wave::new(1.0).with_wavelength(0.1).into())), "runs along fibres"),
        (refused(springs("outer", 0.2, Drive::Shared("none".to_owned()))), "is no drive of this body"),
    ] {
        assert!(said.contains(with), "{said}");
    }
}
