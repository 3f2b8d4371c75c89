//! Bodies that are eased into a motion, or led by springs, all over alike or here more than there.

use crate::follows::{run_to, scene, skeleton, solid, started};
use crate::rig::{ANGLE, ELBOW, Rig, SECONDS, write_cache};
use glam::{DQuat, DVec3};
use sinew::bake::bake;
use sinew::io::load_assets;
use sinew::scene::{AfterLast, CacheLeader, ClosedMesh, Dab, Follow, FollowSprings, Scene, TwoLayer};

#[test]
fn a_two_layer_body_follows_a_cache_held_and_by_springs() {
    let rig = Rig::column();
    let times: Vec<f64> = (0..=24).map(|k| f64::from(k) / 60.0).collect();
    let moved = |at: DVec3, time: f64| DQuat::from_rotation_z(3.0 * time * time) * at + DVec3::X * (0.2 * time * time);
    write_cache(rig.path(), "moved.pc2", &times, moved);
    write_cache(rig.path(), "moved.mdd", &times, moved);
    let springs = FollowSprings { damping: 1.0, ..FollowSprings::new(1e6) };
    let in_frames = CacheLeader { frames_per_second: Some(60.0), ..CacheLeader::new("moved.pc2") };
    for (follow, within) in [
        (Follow::new("held", in_frames), 1e-5),
        (Follow::new("led", CacheLeader::new("moved.mdd").with_rest("rig.gltf")).with_springs(springs), 1e-4),
    ] {
        let mut body = TwoLayer::from_mesh("column", ClosedMesh::new("rig.gltf"));
        body.pressure = 0.0;
        let scene = Scene::new("test").with_gravity([0.0; 3]).with_frame_rate(100.0);
        let mut runner = started(&scene.with_two_layer(body.with_follow(follow)), &rig);
        for time in [0.1, 0.2, 0.33] {
            run_to(&mut runner, time);
            let body = &runner.world().bodies()[0];
            let far = body.parts().rest.iter().zip(&body.state().positions).map(|(at, x)| x.distance(moved(*at, time)));
            let far = far.fold(0.0, f64::max);
            assert!(far < within, "{far} m at {time} s");
        }
    }
}

#[test]
fn a_body_is_eased_into_a_first_frame_that_is_not_its_rest() {
    let rig = Rig::column();
    let away = DVec3::new(0.05, 0.02, 0.0);
    write_cache(rig.path(), "away.mdd", &[0.0, 1.0], |at, time| at + away + DVec3::Z * (0.03 * time));
    let follow = Follow { start: 0.05, pre_roll: 0.2, ..Follow::new("bones", CacheLeader::new("away.mdd")) };
    let mut runner = started(&scene(solid(follow)), &rig);
    let mut way = |time: f64| {
        run_to(&mut runner, time);
        let body = &runner.world().bodies()[0];
        let ways = body.parts().rest.iter().zip(&body.state().positions).map(|(at, x)| *x - *at);
        let ways: Vec<DVec3> = ways.collect();
        // All go the same way.
        assert!(ways.iter().all(|way| way.distance(ways[0]) < 1e-6), "{time} s");
        ways[0]
    };
    let expected = [
        (0.05, DVec3::ZERO),
        (0.15, 0.5 * away),
        // The motion begins where the body has come to.
        (0.25, away),
        (0.35, away + DVec3::Z * 0.003),
    ];
    for (time, expected) in expected {
        let found = way(time);
        assert!(found.distance(expected) < 1e-6, "{found}, not {expected} at {time} s");
    }
}

/// The frame at `from` is the one that is eased into, and the first of every round.
#[test]
fn a_motion_is_played_from_a_frame_within_it_after_a_pre_roll() {
    let rig = Rig::column();
    let away = |time: f64| DVec3::new(0.05, 0.02, 0.03 * time);
    write_cache(rig.path(), "away.mdd", &[0.0, 0.2, 0.5], |at, time| at + away(time));
    write_cache(rig.path(), "away.pc2", &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], |at, time| at + away(0.1 * time));
    let in_frames = CacheLeader { frames_per_second: Some(10.0), ..CacheLeader::new("away.pc2") };
    for leader in [CacheLeader::new("away.mdd"), in_frames] {
        let follow = Follow { start: 0.05, pre_roll: 0.2, from: 0.4, ..Follow::new("bones", leader) };
        for (after, time, expected) in [
            (AfterLast::Hold, 0.15, 0.5 * away(0.4)),
            (AfterLast::Hold, 0.25, away(0.4)),
            (AfterLast::Hold, 0.3, away(0.45)),
            (AfterLast::Hold, 0.5, away(0.5)),
            (AfterLast::Repeat, 0.38, away(0.43)),
            (AfterLast::Mirror, 0.38, away(0.47)),
        ] {
            let mut runner = started(&scene(solid(Follow { after, ..follow.clone() })), &rig);
            run_to(&mut runner, time);
            let body = &runner.world().bodies()[0];
            for (at, x) in body.parts().rest.iter().zip(&body.state().positions) {
                assert!((*x - *at).distance(expected) < 1e-6, "{after:?} {time} s: {}, not {expected}", *x - *at);
            }
        }
    }
    // Joints: eased by half of the angle that the clip has there, and on from that.
    let follow = Follow { start: 0.05, pre_roll: 0.2, from: 0.1, ..Follow::new("bones", skeleton()) };
    let there = ANGLE * 0.1 / SECONDS;
    for (after, time, angle) in [
        (AfterLast::Hold, 0.15, 0.5 * there),
        (AfterLast::Hold, 0.25, there),
        (AfterLast::Hold, 0.4, ANGLE * 0.25 / SECONDS),
        (AfterLast::Hold, 0.6, ANGLE),
        (AfterLast::Repeat, 0.6, ANGLE * 0.15 / SECONDS),
    ] {
        let mut runner = started(&scene(solid(Follow { after, ..follow.clone() })), &rig);
        run_to(&mut runner, time);
        let body = &runner.world().bodies()[0];
        for (at, x) in body.parts().model.iter().zip(&body.state().positions).filter(|(at, _)| at.y > 0.0701) {
            let expected = ELBOW + DQuat::from_rotation_z(angle) * (*at - ELBOW);
            assert!(x.distance(expected) < 1e-6, "{after:?} {time} s: {x}, not {expected}");
        }
    }
    // Past its end there is only its last frame, and that is said.
    let follow = Follow::new("bones", skeleton()).with_from(2.0 * SECONDS);
    let scene = scene(solid(follow));
    let assets = load_assets(&scene, rig.path(), &mut |_| {}).expect("files that are there");
    let notes = bake(&scene, &assets).expect("a scene that bakes").notes;
    assert!(notes.iter().any(|note| note.warning && note.path == "/bodies/0/follows/0/from"), "{notes:?}");
    let mut runner = started(&scene, &rig);
    run_to(&mut runner, 0.1);
    let body = &runner.world().bodies()[0];
    let turned = |at: &DVec3| ELBOW + DQuat::from_rotation_z(ANGLE) * (*at - ELBOW);
    let ends = body.parts().model.iter().zip(&body.state().positions).filter(|(at, _)| at.y > 0.0701);
    assert!(ends.map(|(at, x)| x.distance(turned(at))).fold(0.0, f64::max) < 1e-6);
}

#[test]
fn springs_that_are_painted_weaker_here_give_way_more_here() {
    let rig = Rig::column();
    let stiffness = 4000.0;
    let springs = FollowSprings { damping: 1.0, ..FollowSprings::new(stiffness) };
    let still = Follow { start: 100.0, ..Follow::new("flesh", skeleton()).with_springs(springs) };
    let dab = Dab::new([0.0, 0.12, 0.0], 0.06, 0.2);
    let mut body = solid(Follow { paint: vec![dab], ..still });
    // So soft that its parts sink almost as they would alone.
    body.material.young_modulus = 500.0;
    let mut scene = scene(body);
    scene.gravity = [0.0, -9.81, 0.0];
    let mut runner = started(&scene, &rig);
    run_to(&mut runner, 0.6);
    let body = &runner.world().bodies()[0];
    let alone = 9.81 / stiffness;
    let mean = |range: std::ops::Range<f64>| {
        let particles = body.parts().model.iter().enumerate().filter(|(_, at)| range.contains(&at.y));
        let sags: Vec<f64> = particles.map(|(i, _)| body.parts().rest[i].y - body.state().positions[i].y).collect();
        sags.iter().sum::<f64>() / sags.len() as f64 / alone
    };
    let [foot, head] = [mean(0.0..0.03), mean(0.09..0.12)];
    println!("sinks {foot:.3} and {head:.3} times as far as without paint");
    assert!((0.99..1.4).contains(&foot) && (1.5..5.01).contains(&head), "{foot} {head}");
}
