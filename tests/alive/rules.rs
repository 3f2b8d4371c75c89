//! What is refused of drives, and where.

use crate::common::*;
use crate::fibres::{rod, upright};
use serde_json::{Value, json};
use sinew::io::scene_from_json;
use sinew::scene::{
    Activation, Assets, Drive, DriveKeys, IntegratorKind, Interpolation, Motion, Region, Rigidity, Scene, Selector,
    SharedDrive, TwoLayer, Wave, Wind,
};

/// A scene of a body with two shared drives and fibres that follow them.
fn alive() -> Value {
    let mut body = rod([3, 7, 3])
        .with_drive(SharedDrive::new("left", Wave::new(0.8).with_wavelength(0.05)))
        .with_drive(SharedDrive::new("right", Wave::new(0.8).with_phase(180.0)));
    body.fibres.push(upright(7, 0.5 * D, 40.0, Activation::contracting(0.3, Drive::Shared("left".to_owned()))));
    body.regions = vec![Region::new("all", Selector::Everything)];
    body.pins = vec![pin("all", &ALL, Motion::Fixed)];
    serde_json::to_value(Scene { gravity_drive: Some(1.0.into()), ..in_space(body) }).expect("a scene as JSON")
}

#[test]
fn what_makes_no_sense_is_refused_where_it_stands() {
    assert!(scene_from_json(&alive().to_string()).is_ok());
    let drive = "/bodies/0/drives/0/drive";
    let activation = "/bodies/0/fibres/0/activation";
    let keys = |after: &str, times: [f64; 2]| json!({"keyframes": {"after": after, "keys": [{"time": times[0], "value": 0}, {"time": times[1], "value": 1}]}});
    let at = |pointer: &str, rest: &str| format!("{pointer}{rest}");
    for (pointer, value, place, words) in [
        (at(drive, "/wave/period"), json!(0), at(drive, "/wave/period"), "above 0 s"),
        (at(drive, "/wave/wavelength"), json!(0), at(drive, "/wave/wavelength"), "runs the other way"),
        (at(drive, "/wave/amplitude"), json!(1e16), at(drive, "/wave/amplitude"), "1e16"),
        (drive.to_owned(), keys("hold", [0.5, 0.5]), at(drive, "/keyframes/keys/1/time"), "order of time"),
        (drive.to_owned(), json!({"shared": "right"}), drive.to_owned(), "only names another drive"),
        (
            drive.to_owned(),
            json!({"keyframes": {"after": "mirror", "keys": [{"time": 0, "value": 0.5}]}}),
            at(drive, "/keyframes/after"),
            "two keys",
        ),
        (
            drive.to_owned(),
            json!({"keyframes": {"keys": [{"time": 0, "value": 0}], "otherwise": {"drive": {"shared": "right"}}}}),
            at(drive, "/keyframes/otherwise/drive"),
            "only names another drive",
        ),
        (
            drive.to_owned(),
            json!({"keyframes": {"keys": [{"time": 0, "value": 0}], "otherwise": {"drive": {"wave": {"period": 0}}}}}),
            at(drive, "/keyframes/otherwise/drive/wave/period"),
            "above 0 s",
        ),
        (
            drive.to_owned(),
            json!({"keyframes": {"keys": [{"time": 0, "value": 0}, {"time": 1, "value": 1}], "after": "repeat",
                "otherwise": {"drive": {"constant": 0}, "back_in": 0.1}}}),
            at(drive, "/keyframes/after"),
            "comes again, and goes back",
        ),
        ("/bodies/0/drives/1/id".to_owned(), json!("left"), "/bodies/0/drives/1/id".to_owned(), "taken"),
        (at(activation, "/drive/shared"), json!("middle"), at(activation, "/drive/shared"), "\"left\", \"right\""),
        (at(activation, "/contract"), json!(0.9), at(activation, "/contract"), "0.9"),
        (at(activation, "/contract"), json!(-0.6), at(activation, "/contract"), "-0.5 to 0.8"),
        (at(activation, "/drive"), json!({"constant": 3}), at(activation, "/contract"), "where its drive is 3"),
        (
            activation.to_owned(),
            json!({"drive": {"shared": "right"}, "twist": {"degrees_per_metre": 10}}),
            at(activation, "/twist"),
            "`gj`",
        ),
        (
            activation.to_owned(),
            json!({"drive": {"constant": 2}, "muscle": {"force": 1}}),
            at(activation, "/drive"),
            "from 0 to 1",
        ),
        (
            activation.to_owned(),
            json!({"drive": {"constant": 0.5}, "volume_fraction": 1.2}),
            at(activation, "/volume_fraction"),
            "1.2",
        ),
        (
            activation.to_owned(),
            json!({"drive": {"constant": 1.5}, "volume_fraction": 0.9}),
            at(activation, "/volume_fraction"),
            "takes a fibre of 0.25 from 1.225",
        ),
        (
            "/bodies/0/pins".to_owned(),
            json!([{"id": "p", "region": "all", "motion": {"driven": {"drive": {"shared": "left"}}}}]),
            "/bodies/0/pins/0/motion/driven/drive".to_owned(),
            "runs along fibres",
        ),
        ("/gravity_drive".to_owned(), json!({"shared": "left"}), "/gravity_drive".to_owned(), "no part of a body"),
        ("/bodies/0/integrator".to_owned(), json!("fibres_implicit"), "/bodies/0/integrator".to_owned(), "leap_frog"),
    ] {
        let mut scene = alive();
        *scene.pointer_mut(&pointer).expect("a place that is there") = value;
        let error = scene_from_json(&scene.to_string()).expect_err(&pointer).to_string();
        assert!(error.starts_with(&format!("{place}: ")) && error.contains(words), "{pointer}: {error}");
    }
}

#[test]
fn fibres_that_act_are_never_stepped_implicitly() {
    // Where the same fibres, passive, would be.
    let kind = |acts: bool| {
        let mut rod = block([3, 15, 3], 2e3);
        rod.fibres.push(upright(15, 0.5 * D, 2e4, Activation::contracting(0.1, Wave::new(0.1))));
        rod.fibres[0].activation = rod.fibres[0].activation.take().filter(|_| acts);
        baked(&in_space(rod)).world.bodies()[0].parts().integrator_word
    };
    assert_eq!([kind(false), kind(true)], [IntegratorKind::FibresImplicit.word(), IntegratorKind::LeapFrog.word()]);
}

#[test]
fn fibres_that_turn_too_far_from_vertex_to_vertex_are_refused() {
    let curl = |rate: f64| Activation::curling(rate, [0.0, 0.0, 1.0], -2.0);
    let twist = |rate: f64| Activation::twisting(rate, -2.0);
    let bake = |activation: Activation| {
        let mut rod = rod([3, 7, 3]);
        let mut fibre = upright(7, 0.5 * D, 40.0, activation);
        fibre.stiffness = Rigidity::new(1.0, 1e-6).with_twisting(1e-6).into();
        rod.fibres.push(fibre);
        sinew::bake::bake(&in_space(rod), &Assets::default()).map(|_| ()).map_err(|error| error.to_string())
    };
    // Twice the rate over a spacing.
    for (most, part, of) in [(90.0, "curl", curl as fn(f64) -> Activation), (180.0, "twist", twist)] {
        let greatest = most / (2.0 * D);
        assert_eq!(bake(of(0.999 * greatest)), Ok(()));
        for rate in [1.001 * greatest, -1.001 * greatest] {
            let error = bake(of(rate)).expect_err("too far");
            let place = format!("/bodies/0/fibres/0/activation/{part}/degrees_per_metre: ");
            assert!(error.starts_with(&place) && error.contains(&format!("less than {most}")), "{error}");
        }
    }
}

#[test]
fn it_is_said_of_what_no_wind_pushes_on() {
    let notes = |body: TwoLayer| {
        let scene = Scene::new("blown").with_two_layer(body).with_wind(Wind::new([3.0, 0.0, 0.0]));
        baked(&scene).notes.into_iter().filter(|note| note.text.contains("wind")).count()
    };
    assert_eq!([notes(TwoLayer::ring("ring")), notes(TwoLayer::ball("ball"))], [1, 0]);
}

#[test]
fn a_smooth_course_counts_where_its_slopes_lead_it() {
    let keys = |slope: f64, between: Interpolation| {
        let mut keys = DriveKeys { between, ..DriveKeys::new([(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)]) };
        keys.keys[1].slope = slope;
        keys
    };
    assert_eq!(keys(0.0, Interpolation::Smooth).range(), [0.0, 1.0]);
    let [least, greatest] = keys(1.5, Interpolation::Smooth).range();
    assert!(least == 0.0 && greatest > 1.1, "{least} to {greatest}");
    assert_eq!(keys(1.5, Interpolation::Linear).range(), [0.0, 1.0]);
    let scene = |slope: f64| {
        let mut body = rod([3, 7, 3]);
        let drive = keys(slope, Interpolation::Smooth);
        body.fibres.push(upright(7, 0.0, 1.0, Activation::contracting(0.75, drive)));
        in_space(body)
    };
    scene(0.0).validate().expect("a sound scene");
    let refused = scene(1.5).validate().expect_err("shorter than can be").to_string();
    assert!(refused.contains("activation/contract") && refused.contains("makes the fibre shorter"), "{refused}");
    let refused = scene(f64::NAN).validate().expect_err("no number").to_string();
    assert!(refused.contains("keys/1/slope"), "{refused}");
}
