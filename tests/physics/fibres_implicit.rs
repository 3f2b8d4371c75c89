//! Stiff fibres in a soft matrix: taken implicitly they let the body step as the matrix alone would, and move it as
//! small explicit steps do.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{Assets, Axis, IntegratorKind, RestShape, Scene, Side};
use sinew::sim::{Runner, Study};

/// A soft block held at its foot with two strands so stiff that they set the step, one of them bent as drawn.
fn strands(rest_shape: RestShape) -> Scene {
    let mut bar = block([5, 12, 5], 1e4);
    let strand = |id: &str, x: f64, bow: f64| {
        let at = |k: i32| {
            let y = 0.004 + 0.0055 * f64::from(k);
            [x + bow * (std::f64::consts::PI * f64::from(k) / 11.0).sin(), y, 0.001]
        };
        fibre(id, (0..12).map(at).collect(), rigidity(2000.0, 2e-3), 0.5, rest_shape)
    };
    bar.fibres = vec![strand("left", -0.006, 0.0), strand("right", 0.005, 0.004)];
    bar.regions = vec![layers("foot", Axis::Y, Side::Min, 1), layers("head", Axis::Y, Side::Max, 1)];
    let mut scene = in_space(bar);
    scene.gravity = [3.0, -9.81, 1.0];
    scene
}

fn held(mut scene: Scene) -> Scene {
    scene.bodies[0].pins = vec![pin("foot", &ALL, sinew::scene::Motion::Fixed)];
    scene
}

fn stepped_by(mut scene: Scene, kind: IntegratorKind) -> Runner {
    scene.bodies[0].integrator = kind.into();
    runner(&scene)
}

fn positions(runner: &Runner) -> &[DVec3] {
    &runner.world().bodies()[0].state().positions
}

/// Greatest distance of particles between two runs [m].
fn apart(one: &Runner, other: &Runner) -> f64 {
    positions(one).iter().zip(positions(other)).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

fn advance(runner: &mut Runner, frames: u32) {
    for _ in 0..frames {
        runner.advance_frame();
    }
    assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
}

#[test]
fn they_move_a_body_as_small_explicit_steps_do() {
    for rest_shape in [RestShape::Straight, RestShape::AsDrawn] {
        let scene = held(strands(rest_shape));
        let [mut explicit, mut implicit] =
            [IntegratorKind::LeapFrog, IntegratorKind::FibresImplicit].map(|kind| stepped_by(scene.clone(), kind));
        let start = positions(&explicit).to_vec();
        let (mut furthest, mut moved) = (0.0, 0.0);
        for _ in 0..15 {
            advance(&mut explicit, 1);
            advance(&mut implicit, 1);
            furthest = f64::max(furthest, apart(&explicit, &implicit));
            let way = positions(&explicit).iter().zip(&start).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
            moved = f64::max(moved, way);
        }
        let steps = [&explicit, &implicit].map(|runner| runner.world().bodies()[0].steps());
        println!("{rest_shape:?}: {:.3} mm apart on a way of {:.1} mm, steps {steps:?}", 1e3 * furthest, 1e3 * moved);
        assert!(moved > 0.005 && furthest < 0.02 * moved, "{furthest} m of {moved} m");
        assert!(steps[0] > 4 * steps[1], "{steps:?}");
    }
}

#[test]
fn they_keep_the_momentum_of_a_free_body() {
    let mut scene = strands(RestShape::AsDrawn);
    scene.gravity = [0.0; 3];
    scene.bodies[0].initial.angular_velocity = [0.0, 0.0, 600.0];
    scene.bodies[0].initial.velocity = [1.0, 0.5, 0.0];
    scene.bodies[0].fibres[0].volume_fraction = 0.3;
    let mut runner = stepped_by(scene, IntegratorKind::FibresImplicit);
    let momenta = |runner: &Runner| {
        let state = runner.world().bodies()[0].state();
        (state.linear_momentum(), state.angular_momentum())
    };
    let (linear, angular) = momenta(&runner);
    advance(&mut runner, 12);
    let (linear_after, angular_after) = momenta(&runner);
    let (linear, angular) =
        (linear_after.distance(linear) / linear.length(), angular_after.distance(angular) / angular.length());
    println!("linear {linear:e}, angular {angular:e}");
    assert!(linear < 1e-12 && angular < 1e-3, "{linear} and {angular}");
}

#[test]
fn they_lose_energy_and_never_gain_any() {
    let mut scene = held(strands(RestShape::Straight));
    scene.bodies[0].material.damping.pair = 0.0;
    let mut runner = stepped_by(scene, IntegratorKind::FibresImplicit);
    let energy = |runner: &Runner| runner.world().bodies()[0].energies(runner.world().time()).total();
    let kinetic = |runner: &Runner| runner.world().bodies()[0].state().kinetic_energy();
    let first = energy(&runner);
    let (mut most, mut fastest) = (first, 0.0);
    for _ in 0..120 {
        advance(&mut runner, 1);
        most = f64::max(most, energy(&runner));
        fastest = f64::max(fastest, kinetic(&runner));
    }
    println!("{:e} J at first, at most {:e} J more, {fastest:e} J in motion", first, most - first);
    assert!(fastest > 1e-4 && most - first < 0.01 * fastest, "{first}, {most}, {fastest}");
}

#[test]
fn they_come_to_the_same_rest() {
    let rest = |kind| {
        let mut scene = held(strands(RestShape::AsDrawn));
        scene.bodies[0].material.damping.air = 12.0;
        let mut runner = stepped_by(scene, kind);
        let start = positions(&runner).to_vec();
        advance(&mut runner, 90);
        let moved: DVec3 = positions(&runner).iter().zip(&start).map(|(a, b)| *a - *b).sum();
        moved / start.len() as f64
    };
    let (explicit, implicit) = (rest(IntegratorKind::LeapFrog), rest(IntegratorKind::FibresImplicit));
    println!("moved by {explicit} m and {implicit} m");
    assert!(explicit.length() > 1e-3 && implicit.distance(explicit) < 0.005 * explicit.length());
}

#[test]
fn particles_may_be_held_along_some_axes_and_moved() {
    let moved = |kind, safety| {
        let mut scene = strands(RestShape::Straight);
        scene.bodies[0].pins = vec![
            pin("foot", &[Axis::Y], sinew::scene::Motion::Fixed),
            pin("head", &[Axis::X, Axis::Y], ramp([1.0, 0.2, 0.0], sinew::scene::Distance::Metres(0.01), 0.1)),
        ];
        scene.gravity = [0.0; 3];
        scene.time.step = sinew::scene::TimeStep::automatic(safety);
        let mut runner = stepped_by(scene, kind);
        advance(&mut runner, 9);
        runner
    };
    let explicit = moved(IntegratorKind::LeapFrog, 0.6);
    let [coarse, fine] = [0.6, 0.15].map(|safety| apart(&explicit, &moved(IntegratorKind::FibresImplicit, safety)));
    println!("{:.3} and {:.3} mm apart", 1e3 * coarse, 1e3 * fine);
    assert!(coarse < 5e-4 && fine < 0.35 * coarse, "{coarse} and {fine}");
}

#[test]
fn they_break_first_where_small_steps_break_them() {
    let broken = |kind| {
        let mut scene = held(strands(RestShape::Straight));
        for fibre in &mut scene.bodies[0].fibres {
            fibre.break_past = Some(sinew::scene::BreakPast { angle: Some(1.5), tension: None, ..Default::default() });
        }
        scene.bodies[0].initial.velocity = [0.2, 0.0, 0.0];
        let mut runner = stepped_by(scene, kind);
        advance(&mut runner, 6);
        let body = &runner.world().bodies()[0];
        body.breaks().copied().collect::<Vec<_>>()
    };
    // Which of those that are past their limit together goes next hangs on the step.
    let (explicit, implicit) = (broken(IntegratorKind::LeapFrog), broken(IntegratorKind::FibresImplicit));
    println!("{} and {}, first {:?} and {:?}", explicit.len(), implicit.len(), explicit[0], implicit[0]);
    assert_eq!((explicit[0].fibre, explicit[0].place), (implicit[0].fibre, implicit[0].place));
    assert!((explicit[0].time - implicit[0].time).abs() < 2e-3, "{explicit:?}, not {implicit:?}");
    assert!(implicit.len() > 3 && explicit.len() > 3);
}

#[test]
fn a_bake_chooses_them_where_fibres_alone_set_the_step() {
    let chosen = |ea: f64, ei: f64, kind: Option<IntegratorKind>| {
        let mut scene = held(strands(RestShape::Straight));
        scene.bodies[0].fibres.iter_mut().for_each(|fibre| fibre.stiffness = rigidity(ea, ei));
        if let Some(kind) = kind {
            scene.bodies[0].integrator = kind.into();
        }
        let baked = baked(&scene);
        let parts = baked.world.bodies()[0].parts();
        (
            parts.integrator_word,
            parts.integrator_reason.clone(),
            baked.notes.iter().map(|note| note.path.clone()).collect(),
        )
    };
    let (word, reason, notes): (_, _, Vec<String>) = chosen(2000.0, 2e-3, None);
    assert_eq!(word, "fibres_implicit");
    let reason = reason.expect("a reason");
    assert!(reason.starts_with("fibres implicit: stable step ") && reason.contains(" instead of "), "{reason}");
    assert!(notes.iter().any(|path| path == "/bodies/0/integrator"), "{notes:?}");
    let (word, reason, notes) = chosen(0.5, 1e-6, None);
    assert_eq!((word, reason), ("leap_frog", None));
    assert!(!notes.iter().any(|path| path == "/bodies/0/integrator"), "{notes:?}");
    assert_eq!(chosen(2000.0, 2e-3, Some(IntegratorKind::LeapFrog)).0, "leap_frog");
}

#[test]
fn a_step_too_long_for_them_is_cut() {
    let mut scene = strands(RestShape::AsDrawn);
    // Pressed to a third and a little sheared, the strands buckle at once.
    scene.bodies[0].initial.deformation = [[1.0, 0.1, 0.0], [0.0, 0.35, 0.0], [0.0, 0.1, 1.0]];
    let study = Study::new(&scene, &Assets::default()).expect("a scene that bakes");
    // Nothing stops what moves too fast to be meant.
    let mut trial = study.trial(IntegratorKind::FibresImplicit, 1e-3);
    let steps = 100;
    for _ in 0..steps {
        trial.step();
    }
    println!("{} evaluations in {steps} steps", trial.evaluations());
    assert_eq!(trial.blew_up_at(), None);
    assert!(trial.evaluations() > steps + 10, "some step was cut");
    let fallbacks = trial.world().bodies()[0].fallbacks();
    assert!(fallbacks.halved > 0 && fallbacks.halved < steps, "{fallbacks:?}");
}
