//! Nothing goes through a collider, however fast.

use crate::common::*;
use glam::DVec3;
use serde_json::json;
use sinew::geometry::TriangleMesh;
use sinew::io::scene_from_json;
use sinew::scene::{Assets, Collider, ColliderMesh, DriveKeys, DrivenMotion, Scene};
use sinew::sim::Runner;

/// One triangle across X at its origin.
fn wall() -> Assets {
    let positions = vec![DVec3::new(0.0, -40.0, -30.0), DVec3::new(0.0, -40.0, 30.0), DVec3::new(0.0, 60.0, 0.0)];
    let mut assets = Assets::default();
    assets.insert_obstacle("wall", &TriangleMesh { positions, triangles: vec![[0, 1, 2]] }).expect("a surface");
    assets
}

fn thrown(scene: Scene, frames: u32, seconds: f64) -> (Runner, f64) {
    let mut scene = scene.with_collider(Collider::new("wall", ColliderMesh::new("wall")));
    scene.time.duration = seconds;
    scene.time.frames_per_second = f64::from(frames) / seconds;
    scene.validate().expect("a valid scene");
    let mut runner = Runner::new(sinew::bake::bake(&scene, &wall()).expect("a scene that bakes"));
    let mut furthest = f64::NEG_INFINITY;
    for _ in 0..frames {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
        let positions = &runner.world().bodies()[0].state().positions;
        furthest = positions.iter().map(|x| x.x).fold(furthest, f64::max);
    }
    (runner, furthest)
}

#[test]
fn a_bar_at_a_kilometre_a_second_does_not_pass_one_triangle() {
    for speed in [100.0, 1000.0] {
        for young_modulus in [1e5, 1e7] {
            let bar =
                block([6, 3, 3], young_modulus).with_translation([-0.03, 0.0, 0.0]).with_velocity([speed, 0.1, 0.0]);
            let energy = 0.5 * 54.0 * 4e-4 * speed * speed;
            let (runner, furthest) = thrown(in_space(bar), 20, 0.3 / speed);
            let left = runner.world().bodies()[0].energies(runner.world().time()).total();
            let speed_left = runner.world().bodies()[0].state().linear_momentum().x / (54.0 * 4e-4);
            println!("{young_modulus:e} Pa at {speed} m/s: to {furthest} m, {left} of {energy} J, {speed_left} m/s");
            assert!(furthest < 0.0 && left < energy && speed_left < 0.01 * speed);
        }
    }
}

#[test]
fn a_ball_at_a_hundred_metres_a_second_does_not_pass_one_triangle() {
    for speed in [100.0, 1000.0] {
        let ball = json!({"version": 1, "gravity": [0, 0, 0], "two_layer": [{"id": "ball",
            "shape": {"ball": {"subdivisions": 2}}, "pressure": 0, "placement": {"translation": [-2.5, 0, 0]},
            "initial": {"velocity": [speed, 0, 0]}}]});
        let (_, furthest) = thrown(scene_from_json(&ball.to_string()).expect("a scene"), 20, 6.0 / speed);
        println!("at {speed} m/s: to {furthest} m");
        assert!(furthest < 0.0);
    }
}

#[test]
fn a_collider_that_is_flung_at_a_body_takes_it_along() {
    let body = block([3, 3, 3], 1e5);
    let mut runner = {
        let keys =
            DriveKeys { between: sinew::scene::Interpolation::Linear, ..DriveKeys::new([(0.0, 0.0), (0.002, 1.0)]) };
        let plate = Collider::cuboid("plate", [0.001, 0.1, 0.1])
            .with_translation([-0.02, 0.009, 0.0])
            .with_motion(DrivenMotion::new(keys, [0.2, 0.0, 0.0]));
        let mut scene = in_space(body).with_collider(plate);
        scene.time.frames_per_second = 10_000.0;
        scene.time.duration = 0.002;
        runner(&scene)
    };
    while runner.world().time() < 0.0019 {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
        let plate = runner.world().colliders()[0].pose(runner.world().time()).translation.x;
        let behind =
            runner.world().bodies()[0].state().positions.iter().map(|x| x.x - plate).fold(f64::INFINITY, f64::min);
        assert!(behind > 0.0, "{behind} m behind the plate at {} s", runner.world().time());
    }
    let speed = runner.world().bodies()[0].state().linear_momentum().x / (27.0 * 4e-4);
    println!("taken along at {speed} m/s");
    assert!(speed > 95.0);
}
