//! Bodies that follow the joints of a skeleton or the points of a cache.

use crate::common::*;
use crate::rig::{ANGLE, ELBOW, Rig, SECONDS, write_cache};
use glam::{DQuat, DVec3};
use sinew::bake::bake;
use sinew::edit::body_ops::scaled;
use sinew::io::load_assets;
use sinew::scene::{
    AfterLast, Body, CacheLeader, ClosedMesh, Dab, Follow, FollowSelect, FollowSprings, Material, Rotation, Scene,
    SkeletonLeader, TimeStep, TwoLayer,
};
use sinew::sim::Runner;

/// Turn about z of the upper joint [rad] at a time since the motion's start, and its rate.
fn turn(time: f64) -> (f64, f64) {
    if (0.0..SECONDS).contains(&time) { (ANGLE * time / SECONDS, ANGLE / SECONDS) } else { (ANGLE, 0.0) }
}

/// Where what hangs on the upper joint is led at an angle [rad] with a rate [1/s].
fn led(at: DVec3, (angle, rate): (f64, f64)) -> [DVec3; 2] {
    let arm = DQuat::from_rotation_z(angle) * (at - ELBOW);
    [ELBOW + arm, rate * DVec3::Z.cross(arm)]
}

pub fn skeleton() -> SkeletonLeader {
    SkeletonLeader::new("rig.gltf")
}

/// The column of the rig filled with particles that follow so, weightless.
pub fn solid(follow: Follow) -> Body {
    let material = Material::new(2e4, 0.33, 1000.0).with_support_radius(0.025);
    Body::from_mesh("column", "rig.gltf").with_material(material).with_follow(follow)
}

pub fn scene(body: Body) -> Scene {
    in_space(body).with_frame_rate(100.0)
}

pub fn started(scene: &Scene, rig: &Rig) -> Runner {
    scene.validate().expect("a valid scene");
    let assets = load_assets(scene, rig.path(), &mut |_| {}).expect("files that are there");
    let baked = bake(scene, &assets).expect("a scene that bakes");
    Runner::new(baked)
}

pub fn run_to(runner: &mut Runner, seconds: f64) {
    while runner.world().frame() < runner.frames_for(seconds) {
        runner.advance_frame();
    }
    assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
}

/// Checks every particle that one joint alone holds against the joints' own motion: places to 1e-7 m, which is what
/// single precision leaves of the file, and velocities.
fn check(runner: &Runner, angle: (f64, f64), place: impl Fn(DVec3) -> DVec3) {
    let body = &runner.world().bodies()[0];
    let (mut below, mut above) = (0, 0);
    for (i, &at) in body.parts().model.iter().enumerate() {
        let [x, v] = match at.y {
            y if y < 0.0499 => [at, DVec3::ZERO],
            y if y > 0.0701 => led(at, angle),
            _ => continue,
        };
        if at.y < 0.05 {
            below += 1;
        } else {
            above += 1;
        }
        let (found, speed) = (body.state().positions[i], body.state().velocities[i]);
        assert!(found.distance(place(x)) < 1e-7, "{at}: {found}, not {}", place(x));
        assert!(speed.distance(place(v) - place(DVec3::ZERO)) < 2e-6, "{at}: {speed}, not {v} turned");
    }
    assert!(below > 20 && above > 20, "{below} below, {above} above");
}

#[test]
fn held_particles_go_with_their_joints() {
    let rig = Rig::column();
    let mut body = solid(Follow { start: 0.1, ..Follow::new("bones", skeleton()) });
    let rotation = Rotation::about(DVec3::new(0.6, 0.0, 0.8), 30.0);
    body.placement.rotation = rotation.clone();
    body.placement.translation = [0.3, 0.2, -0.1];
    let place = |x: DVec3| rotation.quaternion() * x + DVec3::new(0.3, 0.2, -0.1);
    let mut runner = started(&scene(body), &rig);
    for time in [0.05, 0.15, 0.3, 0.47, 0.6] {
        run_to(&mut runner, time);
        check(&runner, if time < 0.1 { (0.0, 0.0) } else { turn(time - 0.1) }, place);
    }
    assert!(runner.world().unbalanced().is_empty());
}

#[test]
fn a_two_layer_body_follows_too() {
    let rig = Rig::column();
    let mut body = TwoLayer::from_mesh("column", ClosedMesh::new("rig.gltf"));
    body.pressure = 0.0;
    let body = body.with_follow(Follow::new("bones", skeleton()));
    let scene = Scene::new("test").with_gravity([0.0; 3]).with_two_layer(body).with_frame_rate(100.0);
    let mut runner = started(&scene, &rig);
    for time in [0.1, 0.33, 0.5] {
        run_to(&mut runner, time);
        check(&runner, turn(time), |x| x);
    }
}

#[test]
fn a_two_layer_body_is_led_by_springs_to_where_its_joints_have_it() {
    let rig = Rig::column();
    let far = |stiffness: f64| {
        let springs = FollowSprings { damping: 1.0, ..FollowSprings::new(stiffness) };
        let mut body = TwoLayer::from_mesh("column", ClosedMesh::new("rig.gltf"));
        body.pressure = 0.0;
        let body = body.with_follow(Follow::new("flesh", skeleton()).with_springs(springs));
        let scene = Scene::new("test").with_gravity([0.0; 3]).with_two_layer(body).with_frame_rate(100.0);
        let mut runner = started(&scene, &rig);
        run_to(&mut runner, 0.8);
        let body = &runner.world().bodies()[0];
        let above = body.parts().model.iter().zip(&body.state().positions).filter(|(at, _)| at.y > 0.0701);
        let off: Vec<f64> = above.map(|(at, x)| x.distance(led(*at, turn(0.8))[0])).collect();
        assert!(off.len() > 10);
        off.into_iter().fold(0.0, f64::max)
    };
    // The motion has ended: what is left is what the springs of the body bend the stiffer ones by.
    let [soft, stiff] = [2e4, 2e6].map(far);
    println!("{:.2} mm and {:.3} mm off", 1e3 * soft, 1e3 * stiff);
    assert!(stiff < 1e-4 && soft > 3.0 * stiff, "{soft} and {stiff} m");
}

#[test]
fn a_motion_is_eased_into_and_held_repeated_mirrored_or_hurried() {
    let rig = Rig::column();
    let follow = Follow { start: 0.05, pre_roll: 0.1, ..Follow::new("bones", skeleton()) };
    // While it is eased into the first frame, which is the rest pose here, nothing moves.
    for (after, speed, time, expected) in [
        (AfterLast::Hold, 1.0, 0.1, (0.0, 0.0)),
        (AfterLast::Hold, 1.0, 0.35, turn(0.2)),
        (AfterLast::Hold, 2.0, 0.25, (turn(0.2).0, 2.0 * turn(0.2).1)),
        (AfterLast::Repeat, 1.0, 0.65, turn(0.1)),
        (AfterLast::Mirror, 1.0, 0.65, (turn(0.3).0, -turn(0.3).1)),
    ] {
        let mut runner = started(&scene(solid(Follow { after, speed, ..follow.clone() })), &rig);
        run_to(&mut runner, time);
        check(&runner, expected, |x| x);
        assert!(!runner.at_rest(), "{after:?} {time} s");
    }
}

#[test]
fn springs_give_way_by_weight_over_stiffness() {
    let rig = Rig::column();
    let stiffness = 4000.0;
    let springs = FollowSprings { damping: 1.0, ..FollowSprings::new(stiffness) };
    let still = Follow { start: 100.0, ..Follow::new("flesh", skeleton()).with_springs(springs) };
    let sag = |follow: &Follow| {
        let mut scene = scene(solid(follow.clone()));
        scene.gravity = [0.0, -9.81, 0.0];
        let mut runner = started(&scene, &rig);
        run_to(&mut runner, 0.4);
        let body = &runner.world().bodies()[0];
        let fallen = body.parts().rest.iter().zip(&body.state().positions).map(|(a, b)| a.y - b.y);
        fallen.collect::<Vec<f64>>()
    };
    // Springs are as strong as their particles are heavy: all sink alike, and nothing is strained.
    let whole = sag(&still);
    assert!(whole.iter().all(|sag| (sag * stiffness / 9.81 - 1.0).abs() < 1e-3), "{whole:?}");
    // One dab over everything halves them.
    let dab = Dab::new([0.0, 0.06, 0.0], 1.0, 0.5);
    let half = sag(&Follow { paint: vec![dab], ..still });
    assert!(half.iter().all(|sag| (sag * stiffness / 9.81 - 2.0).abs() < 4e-3), "{half:?}");
}

/// What is left of a balance that should stay as it was [J], the work done, and the energy handled.
fn balance(scene: &Scene, rig: &Rig, steps: u32) -> (f64, f64) {
    let mut scene = scene.clone();
    let dt = 0.01 / f64::from(steps);
    scene.time.step = TimeStep::manual(dt, steps);
    let mut runner = started(&scene, rig);
    let start = runner.world().energy();
    run_to(&mut runner, 0.2);
    let work = runner.world().work();
    assert!(runner.world().unbalanced().is_empty(), "{:?}", runner.world().unbalanced());
    (runner.world().energy() - start - work, work)
}

#[test]
fn the_work_of_what_leads_is_booked_and_closes_the_balance() {
    let rig = Rig::column();
    let springs = FollowSprings { damping: 0.0, ..FollowSprings::new(2000.0) };
    let soft = Follow::new("flesh", skeleton()).with_springs(springs);
    let hard = Follow::new("bones", skeleton()).with_select(FollowSelect::Distance(0.012));
    // The joint sets out at once, which a step sees in its middle or not at all: it is played gently from a rest
    // instead.
    let mut rig_at_rest = rig;
    let tangents = [0.0; 4];
    let turn = DQuat::from_rotation_z(ANGLE).to_array();
    let rows = [tangents, [0.0, 0.0, 0.0, 1.0], tangents, tangents, turn, tangents].concat();
    rig_at_rest.json["animations"][0]["samplers"][0]["output"] = rig_at_rest.numbers("VEC4", 6, rows).into();
    rig_at_rest.json["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE".into();
    rig_at_rest.write();
    for (name, follows) in [("soft", vec![soft.clone()]), ("hard", vec![hard.clone()]), ("both", vec![hard, soft])] {
        let mut body = solid(follows[0].clone());
        body.follows = follows;
        let found = [16, 32].map(|steps| balance(&scene(body.clone()), &rig_at_rest, steps));
        println!("{name}: {found:?}");
        assert!(found[0].1 > 1e-4 && found[0].0.abs() < 5e-3 * found[0].1, "{name}: {found:?}");
        assert!((found[1].0 / found[0].0).abs() < 0.35, "{name}: {found:?}");
    }
}

#[test]
fn the_stable_step_includes_the_springs() {
    let rig = Rig::column();
    let stiff = Follow::new("flesh", skeleton()).with_springs(FollowSprings::new(1e7));
    for damping in [0.0, 0.3] {
        let mut body = solid(stiff.clone());
        let springs = FollowSprings { damping, ..FollowSprings::new(1e7) };
        body.follows[0] = stiff.clone().with_springs(springs.clone());
        let mut scene = scene(body);
        let parts = started(&scene, &rig);
        let parts = parts.world().bodies()[0].parts();
        assert_eq!(parts.limited_by.as_deref(), Some("/bodies/0/follows"));
        let stable = parts.stable_dt;
        let grows = |scene: &mut Scene, share: f64| {
            let steps = 200;
            scene.time.frames_per_second = 1.0 / (f64::from(steps) * share * stable);
            scene.time.step = TimeStep::manual(share * stable, steps);
            scene.bodies[0].initial.velocity = [1e-3, 0.0, 0.0];
            let mut runner = started(scene, &rig);
            (0..5).for_each(|_| runner.advance_frame());
            let state = runner.world().bodies()[0].state();
            runner.world().divergence().is_some() || state.velocities.iter().any(|v| v.length() > 10.0)
        };
        assert!(!grows(&mut scene, 0.97), "it does not hold at the stable step");
        if damping == 0.0 {
            assert!(grows(&mut scene, 1.06), "the stable step is far too short");
        }
        let two_layer = TwoLayer::from_mesh("column", ClosedMesh::new("rig.gltf"));
        let two_layer = two_layer.with_follow(stiff.clone().with_springs(springs));
        let scene = Scene::new("test").with_two_layer(two_layer);
        let runner = started(&scene, &rig);
        assert_eq!(runner.world().bodies()[0].parts().limited_by.as_deref(), Some("/two_layer/0/follows"));
    }
}

#[test]
fn caches_lead_particles_of_the_mesh_that_they_were_made_of() {
    let rig = Rig::column();
    let times: Vec<f64> = (0..=24).map(|k| f64::from(k) / 60.0).collect();
    // A turn whose angle grows with the square of the time about a slanting axis, through a point that moves.
    let moved = |at: DVec3, time: f64| {
        let axis = DVec3::new(0.6, 0.0, 0.8);
        DQuat::from_axis_angle(axis, 3.0 * time * time) * at + DVec3::new(0.1 * time, 0.0, 0.2 * time * time)
    };
    write_cache(rig.path(), "moved.pc2", &times, moved);
    write_cache(rig.path(), "moved.mdd", &times, moved);
    let in_frames = CacheLeader { frames_per_second: Some(60.0), ..CacheLeader::new("moved.pc2") };
    for leader in [in_frames, CacheLeader::new("moved.mdd").with_rest("rig.gltf")] {
        let mut runner = started(&scene(solid(Follow::new("cached", leader))), &rig);
        for time in [0.0, 0.11, 0.2, 0.33] {
            run_to(&mut runner, time);
            let body = &runner.world().bodies()[0];
            for (i, &at) in body.parts().rest.iter().enumerate() {
                // Between samples the cubic pieces cut a corner of some micrometres.
                let found = body.state().positions[i];
                assert!(found.distance(moved(at, time)) < 1e-5, "{at}: {found}, not {} at {time} s", moved(at, time));
                let rate = (moved(at, time + 1e-6) - moved(at, time - 1e-6)) / 2e-6;
                let slack = if time == 0.0 { 0.02 } else { 2e-3 };
                assert!(body.state().velocities[i].distance(rate) < slack, "{rate} at {time} s");
            }
        }
    }
    // Springs follow as well, and what is easy to follow is followed closely.
    let springs = FollowSprings { damping: 1.0, ..FollowSprings::new(1e6) };
    let leader = CacheLeader::new("moved.mdd");
    let mut runner = started(&scene(solid(Follow::new("cached", leader).with_springs(springs))), &rig);
    run_to(&mut runner, 0.2);
    let body = &runner.world().bodies()[0];
    let off = body.parts().rest.iter().zip(&body.state().positions).map(|(at, x)| x.distance(moved(*at, 0.2)));
    assert!(off.fold(0.0, f64::max) < 1e-4);
}

#[test]
fn threads_and_checkpoints_change_no_bit() {
    let rig = Rig::column();
    let hard = Follow { pre_roll: 0.02, ..Follow::new("bones", skeleton().with_joints(["tip"])) };
    let hard = hard.with_select(FollowSelect::SkinWeight(0.9));
    let soft = Follow { pre_roll: 0.02, ..Follow::new("flesh", skeleton()).with_springs(FollowSprings::new(500.0)) };
    let mut body = solid(hard.clone());
    body.follows = vec![hard.clone(), soft.clone()];
    let mut two_layer = TwoLayer::from_mesh("bag", ClosedMesh::new("rig.gltf"));
    (two_layer.pressure, two_layer.follows) = (0.0, vec![hard, soft]);
    let two_layer = two_layer.with_translation([0.3, 0.0, 0.0]);
    let scene = scene(body).with_two_layer(two_layer);
    let bits = |runner: &Runner| {
        let world = runner.world();
        let states = world.bodies().iter().flat_map(|body| [&body.state().positions, &body.state().velocities]);
        let mut bits: Vec<u64> = states.flatten().flat_map(DVec3::to_array).map(f64::to_bits).collect();
        bits.extend([world.energy().to_bits(), world.work().to_bits()]);
        bits
    };
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let mut runner = started(&scene, &rig);
            run_to(&mut runner, 0.06);
            bits(&runner)
        })
    };
    let one = run(1);
    assert!([2, 5].into_iter().all(|threads| run(threads) == one));
    let mut world = bake(&scene, &load_assets(&scene, rig.path(), &mut |_| {}).expect("files")).expect("a scene").world;
    (0..3).for_each(|_| world.advance_frame());
    let kept = world.checkpoint();
    (0..3).for_each(|_| world.advance_frame());
    let work = world.work();
    world.go_back(&kept);
    (0..3).for_each(|_| world.advance_frame());
    assert_eq!(world.work().to_bits(), work.to_bits());
    assert_eq!(one[one.len() - 1], work.to_bits());
}

#[test]
fn a_body_that_is_scaled_takes_what_it_follows_along() {
    let rig = Rig::column();
    let near = Follow::new("bones", skeleton()).with_select(FollowSelect::Distance(0.012));
    let body = solid(near);
    let larger = scaled(&body.clone().into(), DVec3::ZERO, 2.0).expect("a factor above zero");
    let sinew::scene::OwnedBody::Solid(larger) = larger else { panic!("a fibre solid") };
    let [own, twice] = [body, *larger].map(|body| {
        let runner = started(&scene(body), &rig);
        runner.world().bodies()[0].parts().model.to_vec()
    });
    assert!(own.len() == twice.len() && own.iter().zip(&twice).all(|(a, b)| (2.0 * *a).distance(*b) < 1e-12));
    // Held over all of it, so that both are where their joints are.
    let held = |factor: f64| {
        let body = solid(Follow::new("bones", skeleton()));
        let body = scaled(&body.into(), DVec3::ZERO, factor).expect("a factor above zero");
        let sinew::scene::OwnedBody::Solid(body) = body else { panic!("a fibre solid") };
        let mut runner = started(&scene(*body), &rig);
        run_to(&mut runner, 0.02);
        runner.world().bodies()[0].state().positions.clone()
    };
    let far = held(1.0).iter().zip(held(2.0)).map(|(a, b)| (2.0 * *a).distance(b)).fold(0.0, f64::max);
    assert!(far < 1e-9, "{far} m");
}
