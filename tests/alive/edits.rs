//! What edits of a moving world do to drives, and what edits of fibres do to how they act.

use crate::common::*;
use crate::fibres::{F, rod, upright};
use glam::DVec3;
use sinew::edit::fibre_ops::{Sampling, Transform, reverse, split, transform};
use sinew::scene::{
    Activation, Body, Drive, DriveKeys, Fibre, FibreSource, Interpolation, Measure, MeasureKind, Panel, PanelDrive,
    PanelMotion, RestShape, Rigidity, Scene, TwoLayer, Wave,
};
use sinew::sim::Runner;

const SAMPLING: Sampling = Sampling { model_diagonal: 0.1, spacing: D };

/// From 0 to 1 at once, long before the edits.
fn early() -> Drive {
    DriveKeys { between: Interpolation::Stepped, ..DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]) }.into()
}

/// A scene after it ran for 0.1 s as another.
fn edited(from: &Scene, to: &Scene) -> Runner {
    let mut before = runner(from);
    while before.world().time() < 0.099 {
        before.advance_frame();
    }
    let mut after = runner(to);
    after.adopt(&before);
    after
}

/// The work that drives did in a frame after an edit [J], where none of them changes any more.
fn work_after(from: &Scene, to: &Scene) -> f64 {
    let mut runner = edited(from, to);
    runner.advance_frame();
    runner.world().bodies()[0].energies(runner.world().time()).activation
}

fn with_fibre(mut body: Body) -> Body {
    body.fibres.push(upright(5, 0.5 * D, 20.0 * F, Activation::contracting(0.3, early())));
    body
}

#[test]
fn a_body_that_starts_anew_starts_under_the_drives_of_now() {
    let before = in_space(rod([3, 4, 3]));
    let mut falling = in_space(with_fibre(rod([3, 5, 3]))).with_gravity([0.0, -9.81, 0.0]);
    falling.gravity_drive = Some(early());
    let runner = edited(&before, &falling);
    let body = &runner.world().bodies()[0];
    let pull: DVec3 = (0..body.state().len()).map(|i| body.net_force(i)).sum();
    assert!((pull.y / (-9.81 * body.state().mass()) - 1.0).abs() < 1e-9, "{pull} N");
    assert_eq!(work_after(&before, &falling), 0.0);
}

#[test]
fn drives_that_an_edit_adds_have_done_nothing_yet() {
    let plain = in_space(rod([3, 5, 3]));
    assert_eq!(work_after(&plain, &in_space(with_fibre(rod([3, 5, 3])))), 0.0);
    let falling = Scene { gravity_drive: Some(early()), ..plain.clone().with_gravity([0.0, -9.81, 0.0]) };
    assert_eq!(work_after(&plain, &falling), 0.0);
    let ball = |pressure: f64| {
        let ball = TwoLayer { pressure, pressure_drive: Some(early()), ..TwoLayer::ball("ball") };
        Scene::new("ball").with_gravity([0.0; 3]).with_two_layer(ball)
    };
    let gas = TwoLayer::ball("ball").pressure;
    assert_eq!(work_after(&ball(0.0), &ball(gas)), 0.0);
    // What was done goes on to count.
    assert!(work_after(&ball(gas), &ball(gas)).abs() > 0.0);
}

#[test]
fn the_work_of_drives_can_be_measured() {
    let mut scene = in_space(with_fibre(rod([3, 5, 3])));
    scene.measures.push(Measure::new("work", "block", MeasureKind::ActivationWork));
    let mut runner = runner(&scene);
    (0..3).for_each(|_| runner.advance_frame());
    let energies = runner.world().bodies()[0].energies(runner.world().time());
    assert!(scalar(&runner, 0) > 0.0);
    assert_eq!(scalar(&runner, 0), -energies.activation);
}

#[test]
fn a_panel_stands_where_its_drive_has_it_from_the_start_and_after_an_edit() {
    let scene = |travel: f64| {
        let panel = Panel::falling("press", 8.0 * D, [0.1, 0.1]);
        let panel = Panel { motion: PanelMotion::Follows(PanelDrive::new(1.0, travel)), ..panel };
        in_space(block([3, 5, 3], 1e5)).with_floor(0.0).with_panel(panel)
    };
    assert_eq!(runner(&scene(-D)).world().panels()[0].height, 7.0 * D);
    assert_eq!(runner(&scene(-9.0 * D)).world().panels()[0].height, 0.0);
    // Into a body that sleeps, which it wakes and from which it is eased.
    let mut pressed = edited(&scene(0.0), &scene(-3.3 * D));
    assert_eq!(pressed.world().panels()[0].height, 8.0 * D - 3.3 * D);
    assert_eq!(pressed.world().overlaps().len(), 1);
    let steps = pressed.world().bodies()[0].steps();
    (0..6).for_each(|_| pressed.advance_frame());
    let body = &pressed.world().bodies()[0];
    assert!(pressed.world().divergence().is_none() && body.steps() > steps);
    let top = body.state().positions.iter().map(|x| x.y).fold(0.0, f64::max);
    assert!(top < 4.4 * D, "{top} m");
}

/// A rod whose fibre curls and twists.
fn turning() -> Fibre {
    let mut fibre = upright(9, 0.5 * D, 0.0, Activation::curling(1500.0, [0.4, 0.2, 1.0], early()));
    let twist = Activation::twisting(2000.0, 0.0).twist;
    fibre.activation.as_mut().expect("it acts").twist = twist;
    fibre.stiffness = Rigidity::new(0.0, 10.0 * F * D * D).with_twisting(20.0 * F * D * D).into();
    fibre
}

/// Where the particles of a rod with this fibre are after a while [m], and where they were.
fn moved(fibre: Fibre) -> (Vec<DVec3>, Vec<DVec3>) {
    let mut body = rod([4, 9, 4]);
    body.fibres.push(fibre);
    let mut runner = runner(&in_space(body));
    (0..4).for_each(|_| runner.advance_frame());
    let body = &runner.world().bodies()[0];
    (body.state().positions.clone(), body.parts().rest.to_vec())
}

#[test]
fn what_a_fibre_does_is_turned_mirrored_and_kept_with_it() {
    let (before, rest) = moved(turning());
    let middle = 4.5 * D * DVec3::Y;
    let by = [
        Transform::reflection(middle, DVec3::X),
        Transform::reflection(middle, DVec3::Y),
        Transform::rotation(middle, DVec3::Y, std::f64::consts::FRAC_PI_2),
    ];
    for by in by.into_iter().map(|by| by.expect("a direction")) {
        let (after, _) = moved(transform(&turning(), &by, SAMPLING).expect("a move").fibre);
        assert_same(&before, &after, &rest, |x| by.apply(x));
    }
    let (after, _) = moved(reverse(&turning()).expect("the other way").fibre);
    assert_same(&before, &after, &rest, |x| x);
    let shift = before.iter().zip(&rest).map(|(x, rest)| x.distance(*rest)).fold(0.0, f64::max);
    assert!(shift > 0.15 * D, "{shift} m");
}

/// Asserts that particles went where others went, under a map of places.
fn assert_same(before: &[DVec3], after: &[DVec3], rest: &[DVec3], map: impl Fn(DVec3) -> DVec3) {
    for (x, from) in before.iter().zip(rest) {
        let image = map(*from);
        let same = rest.iter().position(|other| other.distance(image) < 1e-3 * D).expect("a particle there");
        assert!(after[same].distance(map(*x)) < 1e-6 * D, "{} m, not {} m", after[same], map(*x));
    }
}

fn waving(vertices: &[[f64; 3]], wave: Wave) -> Fibre {
    let fibre = fibre("wave", vertices.to_vec(), rigidity(20.0 * F, 0.0), 0.25, RestShape::Straight);
    fibre.with_activation(Activation::contracting(0.3, wave))
}

fn vertices(of: &Fibre) -> Vec<[f64; 3]> {
    let FibreSource::Vertices(vertices) = &of.source else { panic!("vertices") };
    vertices.clone()
}

#[test]
fn a_wave_runs_from_the_first_point_of_a_fibre_wherever_it_meets_the_material() {
    let wave = Wave::new(0.04).with_wavelength(0.05);
    let course: Vec<[f64; 3]> = (-5..9).map(|k| [0.5 * D, D * (f64::from(k) + 0.5), 0.0]).collect();
    let mut body = rod([4, 9, 4]);
    body.fibres.push(waving(&course, wave.clone()));
    let kept = baked(&in_space(body)).world.bodies()[0].parts().fibres[0].vertices.len();
    let outside = course.len() - kept;
    assert!(outside > 2);
    let behind = 360.0 * (outside as f64 * D) / 0.05;
    let (whole, rest) = moved(waving(&course, wave.clone()));
    let (part, _) = moved(waving(&course[outside..], wave.with_phase(behind)));
    assert_same(&whole, &part, &rest, |x| x);
}

#[test]
fn a_wave_goes_on_in_the_half_that_a_cut_leaves() {
    let shared = sinew::scene::SharedDrive::new("beat", Wave::new(0.04).with_wavelength(0.05).with_phase(30.0));
    let course: Vec<[f64; 3]> = (0..9).map(|k| [0.5 * D, D * (f64::from(k) + 0.5), 0.0]).collect();
    let mut fibre = waving(&course, Wave::new(0.04));
    fibre.activation.as_mut().expect("it acts").drive = Drive::Shared("beat".to_owned());
    let (first, second) = split(&fibre, 4, &[], std::slice::from_ref(&shared), SAMPLING).expect("two halves");
    assert_eq!(first.fibre.activation, fibre.activation);
    assert_eq!(vertices(&second)[0], course[4]);
    let Some(Drive::Wave(wave)) = second.activation.map(|activation| activation.drive) else { panic!("a wave") };
    assert!((wave.phase_degrees - (30.0 + 360.0 * 4.0 * D / 0.05)).abs() < 1e-9, "{} degrees", wave.phase_degrees);
    // A wave along nothing stays shared.
    let still = sinew::scene::SharedDrive::new("beat", Wave::new(0.04));
    let (_, second) = split(&fibre, 4, &[], &[still], SAMPLING).expect("two halves");
    assert_eq!(second.activation, fibre.activation);
}
