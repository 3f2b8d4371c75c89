//! The parameter that sets the stable step, against measuring the step anew with every parameter halved.

use crate::common::{baked, block, fibre, in_space, paper};
use crate::two_layer::{ball, ring, segment, two_layer, with};
use serde_json::{Value, json};
use sinew::io::apply_sets;
use sinew::scene::{IntegratorKind, RestShape, Scene};
use sinew::sim::{Report, Runner};

fn limit(scene: &Scene) -> (f64, Option<String>) {
    let baked = baked(scene);
    let parts = baked.world.bodies()[0].parts();
    (parts.stable_dt, parts.limited_by.clone())
}

/// By how much halving each parameter raises the stable step of the scene's first body.
fn raised(scene: &Scene, parameters: &[&str]) -> Vec<(String, f64)> {
    let value = serde_json::to_value(scene).unwrap();
    let (present, _) = limit(scene);
    parameters
        .iter()
        .map(|&pointer| {
            let half = (0.5 * value.pointer(pointer).unwrap().as_f64().unwrap()).to_string();
            let mut sets = vec![(pointer, half.as_str())];
            // Contact brakes by the greater of both.
            if pointer.ends_with("contact/cc") {
                sets.push(("/two_layer/0/contact/ct", half.as_str()));
            }
            (pointer.to_owned(), limit(&apply_sets(scene, sets).unwrap()).0 / present)
        })
        .collect()
}

const TWO_LAYER: [&str; 8] = [
    "/two_layer/0/ks",
    "/two_layer/0/kd",
    "/two_layer/0/rks",
    "/two_layer/0/rkd",
    "/two_layer/0/pressure",
    "/two_layer/0/air_drag",
    "/two_layer/0/contact/kc",
    "/two_layer/0/contact/cc",
];

#[test]
fn the_named_parameter_is_the_one_whose_halving_raises_the_step_most() {
    let calm = json!({"kd": 0.5, "rkd": 0.5});
    let floor = json!({"room": {"floor": -3}});
    let cases: Vec<(Value, Value, &str, &str)> = vec![
        // The defaults: one spring that swings, and layers whose radial springs brake too hard.
        (segment(), json!({}), "rk4", "ks"),
        (ring(), json!({}), "rk4", "rkd"),
        (ball(1), json!({}), "rk4", "rkd"),
        (ball(3), json!({}), "rk4", "rkd"),
        (ball(1), json!({}), "symplectic_euler", "rkd"),
        // Hardly damped: a stiffness.
        (with(ring(), calm.clone()), json!({}), "rk4", "ks"),
        (with(ring(), calm.clone()), json!({}), "explicit_euler", "ks"),
        (with(ball(1), with(calm.clone(), json!({"ks": 5000}))), json!({}), "rk4", "ks"),
        (with(ball(1), with(calm, json!({"rks": 3000}))), json!({}), "leap_frog", "rks"),
        (with(ring(), json!({"kd": 2, "rkd": 2, "rks": 3000})), json!({}), "explicit_euler", "rks"),
        // Others in turn.
        (with(segment(), json!({"kd": 200})), json!({}), "rk4", "kd"),
        (with(segment(), json!({"kd": 1, "air_drag": 300})), json!({}), "rk4", "air_drag"),
        (segment(), floor.clone(), "rk4", "contact/kc"),
        (with(segment(), json!({"contact": {"kc": 500, "cc": 200, "ct": 200}})), floor, "rk4", "contact/cc"),
        (
            with(ring(), json!({"ks": 10, "rks": 1, "kd": 0.1, "rkd": 0.1, "pressure": 5000})),
            json!({}),
            "rk4",
            "pressure",
        ),
    ];
    for (body, rest, integrator, expected) in cases {
        let scene = two_layer(&[with(body.clone(), json!({"integrator": integrator}))], rest);
        let (step, limited_by) = limit(&scene);
        let raised = raised(&scene, &TWO_LAYER);
        let (most, by) = raised.iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        println!("{body} {integrator}: {step:.5} s by {limited_by:?}; half of {most} gives {by:.3} times as much");
        assert_eq!(limited_by.as_deref(), Some(most.as_str()), "{body} {integrator}: {raised:?}");
        assert_eq!(most.strip_prefix("/two_layer/0/"), Some(expected), "{body} {integrator}: {raised:?}");
    }
}

#[test]
fn drags_set_the_step_too_and_an_unbounded_step_is_set_by_nothing() {
    let dragged = with(segment(), json!({"mks": 50_000, "drags": [{"target": [0, 3, 0]}]}));
    assert_eq!(limit(&two_layer(&[dragged], json!({}))).1.as_deref(), Some("/two_layer/0/mks"));
    let scene = two_layer(&[with(ball(1), json!({"integrator": "backward_euler"}))], json!({}));
    assert_eq!(limit(&scene), (f64::INFINITY, None));
}

#[test]
fn a_segment_that_creeps_has_the_limit_of_its_real_root() {
    // x'' = -2 (KS x + KD x') / m: the fast root lies on the real axis, on either side of it by round-off.
    for kd in (40..=400).step_by(12) {
        let body = with(segment(), json!({"kd": kd, "integrator": "explicit_euler"}));
        let (step, _) = limit(&two_layer(&[body], json!({})));
        let (half, square) = (f64::from(kd), 1600.0);
        let root = half + (half * half - square).max(0.0).sqrt();
        // Swinging just below the critical damping, where the roots meet.
        let expected = 2.0 / root;
        assert!((step / expected - 1.0).abs() < 0.02, "KD = {kd}: {step}, not {expected}");
    }
}

#[test]
fn fibre_solids_name_their_material_fibre_or_damping() {
    let bar = in_space(block([5, 8, 5], 1e6));
    let (step, limited_by) = limit(&bar);
    assert_eq!(limited_by.as_deref(), Some("/bodies/0/material/young_modulus"));
    let halved = raised(&bar, &["/bodies/0/material/young_modulus"])[0].1;
    assert!((halved - 2.0_f64.sqrt()).abs() < 1e-3, "{step} {halved}");

    let line = |x: f64| (0..6).map(|k| [x, 0.006 * (f64::from(k) - 2.5), 0.0]).collect();
    let mut fibred = bar.clone();
    fibred.bodies[0].fibres = vec![
        fibre("soft", line(-0.006), paper(1e2, 1e2), 0.5, RestShape::Straight),
        fibre("stiff", line(0.006), paper(1e6, 1e6), 0.5, RestShape::Straight),
    ];
    // Taken implicitly, as a bake would have them, they leave the step to the matrix.
    assert_eq!(limit(&fibred).1.as_deref(), Some("/bodies/0/material/young_modulus"));
    fibred.bodies[0].integrator = IntegratorKind::LeapFrog.into();
    assert_eq!(limit(&fibred).1.as_deref(), Some("/bodies/0/fibres/1/stiffness"));
    let raised_by = raised(&fibred, &["/bodies/0/material/young_modulus", "/bodies/0/fibres/1/stiffness/paper/ks"]);
    assert!(raised_by[1].1 > 1.1 && raised_by[0].1 < 1.05, "{raised_by:?}");

    let mut damped = bar;
    damped.bodies[0].material.damping.pair = 1e5;
    let (_, limited_by) = limit(&damped);
    let raised_by = raised(&damped, &["/bodies/0/material/young_modulus", "/bodies/0/material/damping/pair"]);
    assert!(raised_by[1].1 > raised_by[0].1, "{raised_by:?}");
    assert_eq!(limited_by.as_deref(), Some("/bodies/0/material/damping/pair"));
}

#[test]
fn notes_reports_and_divergences_name_it() {
    let blown = with(
        ring(),
        json!({"integrator": "explicit_euler",
        "initial": {"deformation": [[1.05, 0, 0], [0, 0.95, 0], [0, 0, 1]]}}),
    );
    let step = json!({"time": {"step": {"manual": {"dt": 0.016, "substeps_per_frame": 5}}}});
    let scene = two_layer(&[blown], step);
    let baked = baked(&scene);
    let note = baked.notes.iter().find(|note| note.path == "/time/step/manual/dt").unwrap();
    assert!(note.warning && note.text.contains("set by /two_layer/0/rkd"), "{note}");
    let mut runner = Runner::new(baked);
    for _ in 0..100 {
        runner.advance_frame();
    }
    let message = runner.world().divergence().unwrap().to_string();
    let remedy = "lower /time/step/manual/dt, or /two_layer/0/rkd, which sets it";
    assert!(message.contains(remedy), "{message}");
    let report = Report::new(&scene, &runner, 1.0, Vec::new());
    assert_eq!(report.bodies[0].limited_by.as_deref(), Some("/two_layer/0/rkd"));
    // What is advised helps.
    let eased = apply_sets(&scene, [("/two_layer/0/rkd", "20")]).unwrap();
    let mut runner = Runner::new(crate::common::baked(&eased));
    for _ in 0..100 {
        runner.advance_frame();
    }
    assert!(runner.world().divergence().is_none());
}

#[test]
fn a_bursting_pressure_is_stopped_with_its_name_and_the_others_go_on() {
    let automatic = json!({});
    let manual = json!({"time": {"step": {"manual": {"dt": 1e-3, "substeps_per_frame": 16}}}});
    for (body, pressure) in [(ring(), 1e9), (ball(1), 1e9), (ball(1), 1e14)] {
        for step in [&automatic, &manual] {
            let burst = with(body.clone(), json!({"pressure": pressure}));
            let other = with(segment(), json!({"placement": {"translation": [0, 60, 0]}}));
            let scene = two_layer(&[burst, other], with(json!({"gravity": [0, -9.81, 0]}), step.clone()));
            let mut runner = Runner::new(baked(&scene));
            for _ in 0..60 {
                runner.advance_frame();
            }
            let bodies = runner.world().bodies();
            let Some(message) = bodies[0].divergence().map(ToString::to_string) else {
                // The automatic step may follow it, into the other; a given one cannot.
                assert!(*step == automatic, "it bursts");
                continue;
            };
            assert!(message.contains("or /two_layer/0/pressure, which sets it"), "{message}");
            assert!(bodies[0].state().positions.iter().all(|x| x.is_finite()));
            let fallen = 60.0 - bodies[1].state().center().y;
            let time = runner.world().time();
            assert!(bodies[1].divergence().is_none() && (fallen - 0.5 * 9.81 * time * time).abs() < 1e-3, "{fallen}");
        }
    }
}
