//! What measures read of bodies of which theory says what there is to be read, and the work that pins do.

use crate::common::*;
use sinew::scene::{
    Axis, Distance, IntegratorKind, Keyframe, MeasureKind, Motion, OverEdges, Panel, Region, RestShape, Scene, Side,
    Touching,
};
use sinew::sim::Runner;

const UP: [f64; 3] = [0.0, 1.0, 0.0];

/// A bar of 5 x 12 x 5 particles that is clamped below and pulled by a fiftieth above, free to get thinner, with a
/// fibre.
fn pulled() -> Scene {
    let mut bar = block([5, 12, 5], 1e5);
    bar.material.damping.air = 60.0;
    bar.regions = vec![
        layers("foot", Axis::Y, Side::Min, 1),
        layers("top", Axis::Y, Side::Max, 1),
        Region::in_box("middle", [-1.0, 4.9 * D, -1.0], [1.0, 7.1 * D, 1.0]),
    ];
    bar.pins = vec![
        pin("foot", &[Axis::Y], Motion::Fixed),
        pin("top", &[Axis::Y], ramp(UP, Distance::Metres(0.02 * 11.0 * D), 0.1)),
    ];
    let vertices = (0..9).map(|k| [0.0, D * (1.5 + f64::from(k)), 0.0]).collect();
    bar.fibres = vec![fibre("axis", vertices, rigidity(20.0, 0.0), 0.25, RestShape::AsDrawn)];
    let mut scene = in_space(bar);
    let kinds = [
        ("stress", MeasureKind::stress("middle", Some(UP))),
        ("mises", MeasureKind::stress("middle", None)),
        ("strain", MeasureKind::strain("middle", Some(UP))),
        ("across", MeasureKind::strain("middle", Some([1.0, 0.0, 0.0]))),
        ("volume", MeasureKind::Volume),
        ("tension", MeasureKind::fibre_tension("axis", OverEdges::Greatest)),
        ("mean tension", MeasureKind::fibre_tension("axis", OverEdges::Mean)),
        ("speed", MeasureKind::speed("top")),
        ("pull", MeasureKind::reaction_force("top", [0.0, -1.0, 0.0])),
    ];
    scene.measures = kinds.into_iter().map(|(name, kind)| measure(name, kind)).collect();
    scene
}

fn read(runner: &Runner, name: &str) -> f64 {
    let place = runner.world().probes().iter().position(|probe| probe.name == name).unwrap();
    scalar(runner, place)
}

#[test]
fn a_pulled_bar_is_strained_and_stressed_by_hooke() {
    let scene = pulled();
    let mut moving = runner(&scene);
    (0..3).for_each(|_| moving.advance_frame());
    // Half of a smooth ramp of 0.1 s: one and a half times its mean rate, and a little for what gets thinner.
    let rate = 1.5 * 0.02 * 11.0 * D / 0.1;
    assert!((rate..1.01 * rate).contains(&read(&moving, "speed")), "{} m/s", read(&moving, "speed"));

    let still = settle(&scene, 400);
    let of = |name| read(&still, name);
    let strain = of("strain");
    println!("strain {strain}, across {}, stress {} Pa, mises {} Pa", of("across"), of("stress"), of("mises"));
    // Held layers do not get longer, so that those between do a little more.
    assert!((0.02..0.022).contains(&strain), "{strain}");
    assert!((of("stress") / (1e5 * strain) - 1.0).abs() < 0.02, "{} Pa", of("stress"));
    assert!((of("mises") / of("stress") - 1.0).abs() < 0.02, "{} Pa", of("mises"));
    assert!((of("across") / -strain - 0.33).abs() < 0.01, "{}", of("across"));
    let grown = of("volume") / (300.0 * D.powi(3)) - 1.0;
    assert!((grown / (0.34 * 0.02) - 1.0).abs() < 0.1, "{grown}");
    assert!((of("mean tension") / (5.0 * strain) - 1.0).abs() < 0.05, "{} N", of("mean tension"));
    assert!(of("tension") >= of("mean tension") && of("tension") < 1.1 * of("mean tension"), "{} N", of("tension"));
    assert!(of("speed") < 1e-3 * rate, "{} m/s", of("speed"));

    // All that the pin gave is there, or was taken by the air.
    let (energy, work) = (still.world().energy(), still.world().work());
    let by_hand = 0.5 * of("pull") * 0.02 * 11.0 * D;
    println!("{energy} J of {work} J, {by_hand} J by the last force");
    assert!(energy < work && energy > 0.5 * work, "{energy} J of {work} J");
    assert!((energy / by_hand - 1.0).abs() < 0.03, "{energy} J, not {by_hand} J");
}

#[test]
fn the_work_of_pins_is_all_that_an_undamped_body_has() {
    let mut body = block([3, 5, 3], 1e5);
    body.regions = vec![layers("foot", Axis::Y, Side::Min, 1)];
    let key = |time: f64, x: f64| Keyframe::new(time, [x, 0.0, 0.0]);
    body.pins = vec![pin(
        "foot",
        &ALL,
        Motion::Keyframes(vec![key(0.0, 0.0), key(0.05, 0.004), key(0.1, -0.002), key(0.2, 0.0)]),
    )];
    for (integrator, share) in [(IntegratorKind::LeapFrog, 0.01), (IntegratorKind::Feynman, 0.01)] {
        body.integrator = integrator.into();
        let mut runner = runner(&in_space(body.clone()));
        // What is held has its speed from the start on.
        let (first, mut handled) = (runner.world().energy(), 0.0_f64);
        for _ in 0..15 {
            runner.advance_frame();
            let (energy, work) = (runner.world().energy() - first, runner.world().work());
            handled = handled.max(work);
            assert!((energy - work).abs() < share * handled, "{integrator:?}: {energy} J of {work} J");
        }
        assert!(handled > 1e-4 && runner.world().work_on(0) == runner.world().work());
    }
}

#[test]
fn what_lies_on_a_floor_or_under_a_panel_pushes_with_the_weight() {
    let mut body = block([4, 4, 4], 1e5);
    body.material.damping.air = 20.0;
    body.regions = vec![layers("foot", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    let mut scene = in_space(body).with_floor(0.0);
    scene.gravity = [0.0, -9.81, 0.0];
    let mut panel = Panel::falling("lid", 4.0 * D + 1e-4, [0.1, 0.1]);
    panel.mass = 0.05;
    scene.panels = vec![panel];
    let on = |region: &str| {
        let MeasureKind::ContactForce(of) = MeasureKind::contact_force([0.0, -1.0, 0.0]) else { unreachable!() };
        MeasureKind::ContactForce(Touching { region: Some(region.to_owned()), ..of })
    };
    scene.measures = vec![
        measure("all", MeasureKind::contact_force([0.0, -1.0, 0.0])),
        measure("foot", on("foot")),
        measure("top", on("top")),
        measure("lid", MeasureKind::panel_force("lid")),
    ];
    let still = settle(&scene, 600);
    let (own, of_panel) = (64.0 * 4e-4 * 9.81, 0.05 * 9.81);
    for (name, expected) in [("all", own), ("foot", own + of_panel), ("top", -of_panel), ("lid", of_panel)] {
        let found = read(&still, name);
        println!("{name}: {found} N, expected {expected} N");
        assert!((found - expected).abs() < 2e-3 * (own + of_panel), "{name}: {found} N, not {expected} N");
    }
    assert!((still.world().panel_force(0) - of_panel).abs() < 2e-3 * of_panel);
}
