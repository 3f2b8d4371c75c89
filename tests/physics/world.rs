//! Room, panels, pins, starts, and what happens when a body cannot be computed.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{
    Axis, Distance, Impulse, IntegratorKind, Keyframe, MeasureKind, Motion, Rotation, Scene, Side, TimeStep,
};

fn state_of(runner: &sinew::sim::Runner) -> &sinew::solver::ParticleState {
    runner.world().bodies()[0].state()
}

#[test]
fn a_free_fall_follows_the_parabola_until_the_floor() {
    let mut bar = short_bar(2e5);
    bar.placement.translation = [0.0, 0.5, 0.0];
    bar.initial.velocity = [0.3, 0.0, 0.0];
    let mut scene = in_space(bar);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.room.floor = Some(0.0);
    let mut runner = runner(&scene);
    for _ in 0..12 {
        runner.advance_frame();
    }
    let t = runner.world().time();
    assert!((t - 0.2).abs() < 1e-12);
    let expected = DVec3::new(0.3 * t, 0.536 - 0.5 * 9.81 * t * t, 0.0);
    assert!(state_of(&runner).center().distance(expected) < 1e-9);
}

#[test]
fn a_bounce_without_friction_keeps_its_energy_and_never_sinks_in() {
    let mut bar = short_bar(2e5);
    bar.placement.translation = [0.0, 0.1, 0.0];
    let mut scene = in_space(bar);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.room.floor = Some(0.0);
    scene.room.friction = 0.0;
    let mut runner = runner(&scene);
    let start = runner.world().bodies()[0].energies(0.0).total();
    let mut lowest = f64::INFINITY;
    for _ in 0..40 {
        runner.advance_frame();
        let total = runner.world().bodies()[0].energies(runner.world().time()).total();
        assert!((total / start - 1.0).abs() < 0.01, "{total} J of {start} J");
        lowest = state_of(&runner).positions.iter().map(|x| x.y).fold(lowest, f64::min);
    }
    // Particles are balls of half a spacing: their centres stay above the floor.
    assert!(lowest > 0.0, "{lowest}");
}

#[test]
fn pins_lock_only_their_axes_and_follow_their_motion() {
    let mut bar = short_bar(2e5);
    bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    let key = |time: f64, x: f64| Keyframe::new(time, [x, 0.0, 0.0]);
    bar.pins = vec![
        pin("bottom", &[Axis::X, Axis::Y], Motion::Keyframes(vec![key(0.0, 0.0), key(0.1, 0.01), key(0.2, 0.01)])),
        pin("top", &[Axis::Y], ramp([0.0, 1.0, 0.0], Distance::Metres(0.002), 0.1)),
    ];
    let mut scene = in_space(bar);
    scene.bodies[0].initial.velocity = [0.0, 0.0, 0.05];
    let mut runner = runner(&scene);
    for _ in 0..9 {
        runner.advance_frame();
    }
    let rest = &runner.world().bodies()[0].parts().rest;
    for i in 0..588 {
        let moved = state_of(&runner).positions[i] - rest[i];
        if rest[i].y < D {
            assert!((moved.x - 0.01).abs() < 1e-12 && moved.y.abs() < 1e-12, "{moved}");
        }
        if rest[i].y > 0.072 - D {
            assert!((moved.y - 0.002).abs() < 1e-12, "{moved}");
        }
    }
    // Nothing holds z: the whole bar drifts on.
    let z = state_of(&runner).center().z;
    assert!((z - 0.05 * runner.world().time()).abs() < 1e-12, "{z}");
}

#[test]
fn an_impulse_adds_its_momentum() {
    let mut bar = short_bar(2e5);
    bar.regions = vec![layers("top", Axis::Y, Side::Max, 2)];
    bar.impulses = vec![Impulse::new("top", [0.01, 0.02, -0.03])];
    let mut runner = runner(&in_space(bar));
    runner.advance_frame();
    let p = state_of(&runner).linear_momentum();
    assert!(p.distance(DVec3::new(0.01, 0.02, -0.03)) < 1e-15, "{p}");
}

#[test]
fn a_turned_body_moves_as_the_unturned_one_turned() {
    let at = |turned: bool| {
        let mut bar = short_bar(2e5);
        bar.fibres = vec![fibre(
            "f",
            (0..12)
                .map(|k| {
                    [
                        0.01 * (0.5 * f64::from(k)).cos(),
                        0.004 + 0.0058 * f64::from(k),
                        0.01 * (0.5 * f64::from(k)).sin(),
                    ]
                })
                .collect(),
            rigidity(2000.0, 0.02),
            0.5,
            sinew::scene::RestShape::AsDrawn,
        )];
        bar.initial.deformation = [[0.95, 0.1, 0.0], [0.0, 1.05, 0.0], [0.0, 0.05, 1.0]];
        if turned {
            bar.placement.rotation = Rotation::about([0.0, 0.0, 1.0], 90.0);
            bar.placement.translation = [5.0, 3.0, -2.0];
        }
        let mut scene = in_space(bar);
        scene.time.step = TimeStep::manual(1e-4, 200);
        let mut runner = runner(&scene);
        runner.advance_frame();
        state_of(&runner).positions.clone()
    };
    let (plain, turned) = (at(false), at(true));
    for (a, b) in plain.iter().zip(&turned) {
        let expected = DVec3::new(-a.y, a.x, a.z) + DVec3::new(5.0, 3.0, -2.0);
        assert!(expected.distance(*b) < 1e-10, "{expected} {b}");
    }
}

fn exploding(integrator: IntegratorKind) -> Scene {
    let mut bar = short_bar(5e7);
    bar.integrator = integrator.into();
    bar.initial.deformation[1][1] = 1.05;
    let mut scene = in_space(bar);
    scene.time.step = TimeStep::manual(6e-5, 100);
    scene
}

#[test]
fn a_step_beyond_the_stable_one_is_warned_of_and_stops_the_body_in_a_good_state() {
    let scene = exploding(IntegratorKind::LeapFrog);
    let notes = baked(&scene).notes;
    assert!(notes.iter().any(|note| note.warning && note.path == "/time/step/manual/dt"), "{notes:?}");
    let mut runner = runner(&scene);
    for _ in 0..20 {
        runner.advance_frame();
    }
    let divergence = runner.world().divergence().expect("a divergence").to_string();
    assert!(divergence.contains("\"Block\"") && divergence.contains("/time/step/manual/dt"), "{divergence}");
    assert!(runner.all_stopped());
    let state = state_of(&runner);
    assert!(state.positions.iter().chain(&state.velocities).all(|v| v.is_finite()));
    let extent = state.positions.iter().map(|x| x.length()).fold(0.0, f64::max);
    assert!(extent < 0.2, "{extent}");
}

#[test]
fn other_bodies_go_on_when_one_diverges() {
    let mut scene = exploding(IntegratorKind::LeapFrog);
    let mut second = short_bar(2e5);
    second.id = "second".into();
    second.name = "Second".into();
    second.initial.velocity = [1.0, 0.0, 0.0];
    second.placement.translation = [1.0, 0.0, 0.0];
    scene.bodies.push(second);
    let mut runner = runner(&scene);
    for _ in 0..20 {
        runner.advance_frame();
    }
    let bodies = runner.world().bodies();
    assert!(bodies[0].divergence().is_some() && bodies[1].divergence().is_none());
    assert!((bodies[1].state().center().x - 1.0 - runner.world().time()).abs() < 1e-9);
}

#[test]
fn thin_shapes_are_refused_with_the_radius_that_helps() {
    let mut sheet = block([10, 1, 10], 2e5);
    sheet.id = "sheet".into();
    let error =
        sinew::bake::bake(&in_space(sheet), &sinew::scene::Assets::default()).err().expect("an error").to_string();
    assert!(error.contains("/bodies/0/material/support_radius") && error.contains("1.25 times"), "{error}");
}

#[test]
fn peaks_do_not_depend_on_the_frame_rate() {
    let peak = |frames_per_second: f64| {
        let mut bar = short_bar(2e5);
        bar.initial.velocity = [0.0, -1.0, 0.0];
        bar.placement.translation = [0.0, 0.001, 0.0];
        bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
        let mut scene = in_space(bar);
        scene.room.floor = Some(0.0);
        scene.time.frames_per_second = frames_per_second;
        scene.measures = vec![measure("loss", MeasureKind::height_loss("top", "bottom", Axis::Y)).at_peak()];
        let mut runner = runner(&scene);
        for _ in 0..runner.frames_for(0.1) {
            runner.advance_frame();
        }
        runner.reported_measures()[0].magnitude()
    };
    let (coarse, fine) = (peak(20.0), peak(1000.0));
    assert!(fine > 0.03 && (coarse / fine - 1.0).abs() < 1e-2, "{coarse} {fine}");
}

#[test]
fn every_integrator_holds_at_its_automatic_step() {
    for integrator in
        [IntegratorKind::LeapFrog, IntegratorKind::ExplicitEuler, IntegratorKind::Midpoint, IntegratorKind::Rk4]
    {
        let mut bar = block([4, 5, 4], 2e5);
        bar.integrator = integrator.into();
        bar.initial.velocity = [0.0, -1.0, 0.0];
        bar.placement.translation = [0.0, 0.001, 0.0];
        bar.material.damping.pair = 20.0;
        let mut scene = in_space(bar);
        scene.gravity = [0.0, -9.81, 0.0];
        scene.room.floor = Some(0.0);
        scene.room.contact_damping = 0.2;
        let mut runner = runner(&scene);
        for _ in 0..15 {
            runner.advance_frame();
        }
        assert!(runner.world().divergence().is_none(), "{integrator:?}: {:?}", runner.world().divergence());
    }
}

#[test]
fn what_cannot_be_waited_for_or_measured_is_refused_by_name() {
    let refused = |scene: &Scene| {
        let outcome = sinew::bake::bake(scene, &sinew::scene::Assets::default());
        outcome.err().expect("an error").to_string()
    };
    let mut slow = in_space(short_bar(5e7));
    slow.time.frames_per_second = 1e-3;
    assert!(refused(&slow).contains("/time/frames_per_second"), "{}", refused(&slow));
    let mut flat = in_space(short_bar(5e7));
    flat.bodies[0].regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    flat.measures = vec![measure("loss", MeasureKind::height_loss("top", "bottom", Axis::X))];
    assert!(refused(&flat).contains("no height"), "{}", refused(&flat));
}

#[test]
fn a_body_inside_the_floor_is_warned_of() {
    let mut bar = short_bar(2e5);
    bar.placement.translation = [0.0, -0.02, 0.0];
    let mut scene = in_space(bar);
    scene.room.floor = Some(0.0);
    let notes = baked(&scene).notes;
    assert!(notes.iter().any(|note| note.warning && note.text.contains("inside the floor")), "{notes:?}");
}
