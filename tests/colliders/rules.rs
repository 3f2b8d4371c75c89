//! What a scene says of its colliders is checked, and what cannot be meant is told.

use crate::common::*;
use sinew::scene::{
    Collider, ColliderMesh, Distance, Drive, DrivenMotion, Measure, MeasureKind, Motion, Ramp, Rotation, Scene,
};

fn with(change: impl Fn(&mut Collider)) -> Scene {
    let mut collider = Collider::cuboid("step", [0.1, 0.02, 0.1]);
    change(&mut collider);
    in_space(block([3, 3, 3], 1e5)).with_collider(collider)
}

#[test]
fn every_value_of_a_collider_is_checked() {
    type Case = (&'static str, fn(&mut Collider));
    let cases: [Case; 9] = [
        ("/colliders/0/id", |of| of.id.clear()),
        ("/colliders/0/shape/box/size/1", |of| of.shape = Collider::cuboid("", [1.0, 0.0, 1.0]).shape),
        ("/colliders/0/shape/sphere/radius", |of| of.shape = Collider::sphere("", -1.0).shape),
        ("/colliders/0/shape/capsule/length", |of| of.shape = Collider::capsule("", 1.0, -1.0).shape),
        ("/colliders/0/shape/mesh/path", |of| of.shape = ColliderMesh::new(" ").into()),
        ("/colliders/0/placement/rotation/axis", |of| of.placement.rotation = Rotation::about([0.0; 3], 1.0)),
        ("/colliders/0/motion/ramp/distance", |of| {
            of.motion = Ramp::new([1.0, 0.0, 0.0], Distance::Fraction(0.5), 1.0).into();
        }),
        ("/colliders/0/motion/driven/drive", |of| {
            of.motion = Motion::Driven(DrivenMotion::new(Drive::Shared("beat".to_owned()), [1.0, 0.0, 0.0]));
        }),
        ("/colliders/0/friction", |of| of.friction = f64::NAN),
    ];
    for (pointer, change) in cases {
        let error = with(change).validate().expect_err(pointer);
        assert_eq!(error.path, pointer, "{error}");
    }
    assert!(with(|_| {}).validate().is_ok());
    let twice = with(|_| {}).with_collider(Collider::sphere("step", 1.0));
    assert_eq!(twice.validate().expect_err("the same name twice").path, "/colliders/1/id");
    let measure = |of: &str| with(|_| {}).with_measure(Measure::new("push", "block", MeasureKind::collider_force(of)));
    assert!(measure("step").validate().is_ok());
    let error = measure("stair").validate().expect_err("no such collider");
    assert_eq!(error.path, "/measures/0/kind/collider_force/collider", "{error}");
}

#[test]
fn a_body_that_starts_in_a_collider_is_eased_out_of_it() {
    let mut scene = with(|of| of.placement.translation = [0.0, 0.0, 0.0]);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.bodies[0].material.damping.pair = 50.0;
    let baked = baked(&scene);
    let note = baked.notes.iter().find(|note| note.text.contains("the collider \"step\"")).expect("a note");
    assert!(note.warning && note.path == "/bodies/0/placement/translation", "{note}");
    let mut runner = sinew::sim::Runner::new(baked);
    let mut fastest = 0.0_f64;
    while runner.world().time() < 0.6 {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none());
        fastest = runner.world().bodies()[0].state().velocities.iter().map(|v| v.length()).fold(fastest, f64::max);
    }
    let lowest = runner.world().bodies()[0].state().positions.iter().map(|x| x.y).fold(f64::INFINITY, f64::min);
    println!("at most {fastest} m/s, lowest at {lowest} m");
    assert!(fastest < 0.4 && (lowest - 0.013).abs() < 2e-4);
}
