//! Fields at the particles against what is known of them.

use super::common::{in_space, runner, short_bar};
use glam::{DMat3, DQuat, DVec3};
use sinew::scene::Scene;
use sinew::solver::field::FieldKind;
use sinew::solver::snapshot::FieldSnapshot;

const YOUNG: f64 = 1e5;
const POISSON: f64 = 0.33;

fn deformed(deformation: DMat3) -> Scene {
    let mut body = short_bar(YOUNG);
    let rows = deformation.transpose();
    body.initial.deformation = [rows.x_axis.to_array(), rows.y_axis.to_array(), rows.z_axis.to_array()];
    in_space(body)
}

fn field(scene: &Scene, kind: FieldKind) -> Vec<f64> {
    runner(scene).world().bodies()[0].field(kind)
}

#[test]
fn a_uniform_stretch_has_one_strain_and_one_stress_everywhere_however_it_is_turned() {
    // Drawn out by e along an axis and by q across: the deviator's length says sqrt(2/3) (e - q) sqrt(2/3).
    let (e, q) = (0.08, -0.02);
    let stretch = DMat3::from_diagonal(DVec3::new(1.0 + e, 1.0 + q, 1.0 + q));
    let turn = DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -1.0).normalize(), 0.9));
    let strain = 2.0 / 3.0 * (e - q);
    let mu = YOUNG / (2.0 * (1.0 + POISSON));
    for deformation in [stretch, turn * stretch] {
        let scene = deformed(deformation);
        for value in field(&scene, FieldKind::Strain) {
            assert!((value - strain).abs() < 1e-12, "{value} {strain}");
        }
        // The difference of the principal stresses.
        for value in field(&scene, FieldKind::Stress) {
            assert!((value - 2.0 * mu * (e - q)).abs() < 1e-6, "{value}");
        }
    }
}

#[test]
fn a_rigid_motion_strains_nothing() {
    let scene = deformed(DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(0.3, -1.0, 0.5).normalize(), 2.0)));
    assert!(field(&scene, FieldKind::Strain).iter().all(|value| *value < 1e-12));
    assert!(field(&scene, FieldKind::Stress).iter().all(|value| *value < 1e-6));
}

#[test]
fn a_falling_body_is_as_fast_as_it_should_be() {
    let mut scene = in_space(short_bar(YOUNG));
    scene.gravity = [0.0, -9.81, 0.0];
    scene.room.floor = None;
    let mut runner = runner(&scene);
    for _ in 0..12 {
        runner.advance_frame();
    }
    let speed = 9.81 * runner.world().time();
    let fallen = FieldSnapshot::of(runner.world(), FieldKind::Speed);
    assert!(fallen.bodies[0].iter().all(|value| (value / speed - 1.0).abs() < 1e-9));
    assert!((fallen.range[1] / speed - 1.0).abs() < 1e-9 && fallen.range[0] == 0.0);
}

#[test]
fn the_volume_fraction_is_that_of_the_bake() {
    let text = std::fs::read_to_string("scenes/short_bar_soft.json").unwrap();
    let scene = sinew::io::scene_from_json(&text).unwrap();
    let baked = super::common::baked(&scene);
    let read = baked.world.bodies()[0].field(FieldKind::VolumeFraction);
    assert_eq!(read.len(), baked.fractions[0].len());
    assert!(read.iter().zip(&baked.fractions[0]).all(|(a, b)| (a - b).abs() < 1e-15));
    assert!(read.iter().any(|value| *value > 0.1));
}
