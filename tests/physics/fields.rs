//! Fields at the particles against what is known of them.

use super::common::{D, fibre, in_space, rigidity, runner, short_bar};
use glam::{DMat3, DQuat, DVec3};
use sinew::scene::{BreakPast, RestShape, Scene};
use sinew::solver::FieldKind;
use sinew::solver::{FieldSnapshot, TensionSnapshot};

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
    let turn = DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -1.0).normalize_or_zero(), 0.9));
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
    let scene = deformed(DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(0.3, -1.0, 0.5).normalize_or_zero(), 2.0)));
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

const EA: f64 = 3000.0;
const FRACTION: f64 = 0.5;

/// A bar stretched uniformly along its height, with a straight fibre along it.
fn stretched(by: f64, breaks_past: Option<f64>) -> Scene {
    let mut bar = short_bar(YOUNG);
    let vertices = (0..12).map(|k| [0.0, 0.003 + D * f64::from(k), 0.0]).collect();
    let mut along = fibre("f", vertices, rigidity(EA, 0.01), FRACTION, RestShape::AsDrawn);
    along.break_past = breaks_past.map(|tension| BreakPast { tension: Some(tension), ..BreakPast::default() });
    bar.fibres = vec![along];
    bar.initial.deformation[1][1] = by;
    in_space(bar)
}

#[test]
fn every_edge_of_a_fibre_carries_its_rigidity_times_the_strain_with_its_sign() {
    for strain in [0.04, -0.03, 0.0] {
        let run = runner(&stretched(1.0 + strain, None));
        let tensions = run.world().bodies()[0].tensions();
        let line = &run.world().bodies()[0].parts().fibres[0];
        assert_eq!((tensions.len(), tensions[0].len()), (1, line.vertices.len() - 1));
        let expected = FRACTION * EA * strain;
        for force in &tensions[0] {
            assert!((force - expected).abs() < 1e-6 * EA, "{force} N, not {expected} N");
        }
        let seen = TensionSnapshot::of(run.world());
        assert!((seen.range - expected.abs()).abs() < 1e-6 * EA && seen.range > 0.0, "{}", seen.range);
    }
}

#[test]
fn a_broken_edge_carries_nothing() {
    let mut run = runner(&stretched(1.1, Some(20.0)));
    run.advance_frame();
    let body = &run.world().bodies()[0];
    let tensions = body.tensions();
    assert!(body.breaks().count() > 0);
    for at in body.breaks() {
        let sinew::solver::BreakPlace::Edge(edge) = at.place else { panic!("{at:?}") };
        assert_eq!(tensions[0][edge as usize], 0.0);
    }
}
