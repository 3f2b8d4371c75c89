//! Implicit steps: what they solve, how they follow leap-frog, and what becomes of those that cannot be solved.

use crate::common::*;
use glam::DVec3;
use sinew::io::load_scene;
use sinew::scene::{
    Assets, Axis, Body, BreakPast, Distance, Extra, Impulse, IntegratorChoice, IntegratorKind, RestShape, Scene, Side,
};
use sinew::sim::{Runner, Study};
use sinew::solver::Fallbacks;
use std::path::{Path, PathBuf};

const IMPLICIT: [IntegratorKind; 6] = [
    IntegratorKind::BackwardEuler,
    IntegratorKind::TrBdf2,
    IntegratorKind::Sdirk2,
    IntegratorKind::ImplicitMidpoint,
    IntegratorKind::Bdf2,
    IntegratorKind::Newmark,
];

/// A scene of one body under an integrator, with so many frames a second, each a step.
fn stepped(mut scene: Scene, integrator: IntegratorKind, frames_per_second: f64) -> Scene {
    scene.bodies[0].integrator = IntegratorChoice::Given(integrator);
    scene.time.frames_per_second = frames_per_second;
    scene
}

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")
}

fn shipped(name: &str, integrator: IntegratorKind) -> Runner {
    let folder = scenes();
    let scene = stepped(load_scene(&folder.join(name)).unwrap(), integrator, 60.0);
    let assets = sinew::io::load_assets(&scene, &folder, &mut |_| {}).unwrap();
    Runner::new(sinew::bake::bake(&scene, &assets).unwrap())
}

fn energy(runner: &Runner) -> f64 {
    let world = runner.world();
    world.bodies().iter().map(|body| body.energies(world.time()).total()).sum()
}

fn fallbacks(runner: &Runner) -> Fallbacks {
    runner.world().bodies()[0].fallbacks()
}

/// A bar of few particles with a stiff fibre, held at its lower end.
fn held_bar() -> Body {
    let mut bar = block([3, 7, 3], 1e5);
    bar.regions = vec![layers("foot", Axis::Y, Side::Min, 1)];
    bar.pins = vec![pin("foot", &ALL, sinew::scene::Motion::Fixed)];
    let line = (0..7).map(|k| [0.001, 0.003 + 0.006 * f64::from(k), 0.002]).collect();
    bar.fibres = vec![fibre("stiff", line, rigidity(2e3, 2e-3), 0.5, RestShape::Straight)];
    bar
}

#[test]
fn each_has_its_order_where_matrix_and_fibres_swing() {
    let mut bar = held_bar();
    bar.initial.deformation = [[1.0, 0.02, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let study = Study::new(&in_space(bar), &Assets::default()).unwrap();
    // Shorter than the period of the stiffest motion, which is a third of a millisecond.
    for of in study.convergence(&IMPLICIT, 5e-4, 20, 3) {
        assert_eq!(of.points.len(), 3);
        let expected = if of.integrator == IntegratorKind::BackwardEuler { 1.0 } else { 2.0 };
        let found = of.order.unwrap();
        println!("{:?}: {found:.3}, errors {:?}", of.integrator, of.points);
        assert!((found - expected).abs() < 0.25, "{:?}: {found}", of.integrator);
    }
}

/// The printed leaf, released under its weight: leap-frog's first mode swings at 13.14 Hz and does not fade.
#[test]
fn the_leaf_swings_and_rests_as_under_leap_frog() {
    let tip = |runner: &Runner| {
        let body = &runner.world().bodies()[0];
        let far =
            (0..body.parts().rest.len()).max_by(|&a, &b| body.parts().rest[a].x.total_cmp(&body.parts().rest[b].x));
        body.state().positions[far.unwrap()].y - body.parts().rest[far.unwrap()].y
    };
    let mut settling = shipped("leaf.json", IntegratorKind::BackwardEuler);
    for _ in 0..120 {
        settling.advance_frame();
        if settling.at_rest() {
            break;
        }
    }
    assert!(settling.at_rest());
    let rest = tip(&settling);

    let mut runner = shipped("leaf.json", IntegratorKind::TrBdf2);
    let (mut sags, mut evaluations) = (vec![0.0], Vec::new());
    for _ in 0..30 {
        let before = runner.world().bodies()[0].evaluations();
        runner.advance_frame();
        evaluations.push(runner.world().bodies()[0].evaluations() - before);
        sags.push(tip(&runner));
    }
    evaluations.sort_unstable();
    let median = evaluations[15] as f64 / 2.0;
    let fit = fit_cosine(&sags, 1.0 / 60.0, rest);
    println!("rest {rest:.6} m; {fit:?}; {median} evaluations a stage, {evaluations:?}");
    assert!(median <= 6.0, "{evaluations:?}");
    assert_eq!(fallbacks(&runner), Fallbacks::default());
    assert!((12.0..13.3).contains(&fit.frequency) && fit.decay < 1.0, "{fit:?}");
    assert!((fit.mean / rest - 1.0).abs() < 0.005, "{} and {rest}", fit.mean);
}

/// The first mode of a bar that is clamped at one end is that in which it swings.
#[test]
fn the_first_mode_is_the_slowest_swing() {
    let mut bar = block([3, 12, 4], 1e6);
    bar.regions = vec![layers("foot", Axis::Y, Side::Min, 1)];
    bar.pins = vec![pin("foot", &ALL, sinew::scene::Motion::Fixed)];
    // Leaning along its thinner side.
    bar.initial.deformation = [[1.0, 0.01, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut scene = stepped(in_space(bar), IntegratorKind::LeapFrog, 2000.0);
    let expected = Study::new(&scene, &Assets::default()).unwrap().first_mode().unwrap() / std::f64::consts::TAU;
    scene.gravity = [0.0; 3];
    let mut runner = runner(&scene);
    let lean = |runner: &Runner| runner.world().bodies()[0].state().center().x;
    let mut values = vec![lean(&runner)];
    for _ in 0..1500 {
        runner.advance_frame();
        values.push(lean(&runner));
    }
    // The foot is held where the shear about the middle put it: the body swings about that.
    let rest = values.iter().sum::<f64>() / values.len() as f64;
    let mut crossings = Vec::new();
    for (frame, pair) in values.windows(2).enumerate() {
        let [before, now] = [pair[0] - rest, pair[1] - rest];
        if before > 0.0 && now <= 0.0 {
            crossings.push((frame as f64 + before / (before - now)) / 2000.0);
        }
    }
    assert!(crossings.len() > 8, "{crossings:?} about {rest}");
    let swings = crossings.len() as f64 - 1.0;
    let found = swings / (crossings[crossings.len() - 1] - crossings[0]);
    println!("{expected:.4} Hz expected, {found:.4} Hz in {swings} swings");
    assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
}

#[derive(Debug)]
struct Cosine {
    frequency: f64,
    decay: f64,
    mean: f64,
}

/// `mean + e^(-decay t) (a cos + b sin)(2 pi frequency t)` through values `dt` [s] apart, by least squares: the best of
/// a fine net of frequencies and decays.
fn fit_cosine(values: &[f64], dt: f64, near: f64) -> Cosine {
    let mut best = (f64::INFINITY, Cosine { frequency: 0.0, decay: 0.0, mean: near });
    for frequency in (1000..1500).map(|k| 0.01 * f64::from(k)) {
        for decay in (-4..30).map(|k| 0.1 * f64::from(k)) {
            let basis = |k: usize| {
                let t = dt * k as f64;
                let (sin, cos) = (std::f64::consts::TAU * frequency * t).sin_cos();
                DVec3::new(1.0, (-decay * t).exp() * cos, (-decay * t).exp() * sin)
            };
            let (mut normal, mut right) = (glam::DMat3::ZERO, DVec3::ZERO);
            for (k, &value) in values.iter().enumerate() {
                let b = basis(k);
                normal += glam::DMat3::from_cols(b * b.x, b * b.y, b * b.z);
                right += value * b;
            }
            let shares = normal.inverse() * right;
            let error: f64 = values.iter().enumerate().map(|(k, value)| (value - shares.dot(basis(k))).powi(2)).sum();
            if error < best.0 {
                best = (error, Cosine { frequency, decay, mean: shares.x });
            }
        }
    }
    best.1
}

#[test]
fn tr_bdf2_keeps_momenta_of_what_turns() {
    let mut bar = block([5, 8, 5], 5e7);
    bar.initial.velocity = [1.0, 2.0, -0.5];
    bar.initial.angular_velocity = [300.0, 450.0, -200.0];
    let mut runner = runner(&stepped(in_space(bar), IntegratorKind::TrBdf2, 240.0));
    let about_centre = |runner: &Runner| {
        let state = runner.world().bodies()[0].state();
        state.angular_momentum() - state.center().cross(state.linear_momentum())
    };
    let (p, l) = (runner.world().bodies()[0].state().linear_momentum(), about_centre(&runner));
    for _ in 0..48 {
        runner.advance_frame();
    }
    let after = runner.world().bodies()[0].state().linear_momentum();
    let (linear, angular) = ((after - p).length() / p.length(), (about_centre(&runner) - l).length() / l.length());
    println!("linear {linear:e}, angular {angular:e}, {:?}", fallbacks(&runner));
    assert!(linear < 1e-7 && angular < 1e-3, "linear {linear:e}, angular {angular:e}");
    assert_eq!(fallbacks(&runner), Fallbacks::default());
}

#[test]
fn a_sudden_move_of_a_pin_is_one_step() {
    let mut bar = block([4, 12, 4], 3e8);
    bar.regions = vec![layers("foot", Axis::Y, Side::Min, 1), layers("head", Axis::Y, Side::Max, 1)];
    let first_frame = |distance: f64| {
        let pull = ramp([0.0, 1.0, 0.0], Distance::Metres(distance), 1e-4);
        let pins = vec![pin("foot", &ALL, sinew::scene::Motion::Fixed), pin("head", &ALL, pull)];
        let bar = Body { pins, ..bar.clone() };
        let mut runner = runner(&stepped(in_space(bar), IntegratorKind::BackwardEuler, 60.0));
        runner.advance_frame();
        assert_eq!(fallbacks(&runner), Fallbacks::default());
        runner.world().bodies()[0].evaluations()
    };
    // The matrix is found in the first frame of each.
    let evaluations = first_frame(0.02 * 0.072) - first_frame(0.0);
    println!("{evaluations} evaluations more than at rest");
    assert!(evaluations <= 15, "{evaluations}");
}

/// A pinned axis is held alone: the head follows along x and is free along the others.
#[test]
fn pins_hold_axis_by_axis() {
    let mut bar = held_bar();
    bar.regions.push(layers("head", Axis::Y, Side::Max, 1));
    bar.pins.push(pin("head", &[Axis::X], ramp([1.0, 0.0, 0.0], Distance::Metres(0.004), 0.1)));
    bar.material.damping.air = 30.0;
    let mut scene = stepped(in_space(bar), IntegratorKind::BackwardEuler, 60.0);
    let implicit = settle(&scene, 600);
    scene.bodies[0].integrator = IntegratorChoice::Given(IntegratorKind::LeapFrog);
    let explicit = settle(&scene, 600);
    let apart = implicit.world().bodies()[0].state().positions.iter();
    let apart =
        apart.zip(&explicit.world().bodies()[0].state().positions).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    println!("{apart:e} m apart at rest");
    assert!(apart < 0.005 * 0.004, "{apart:e}");
}

/// Nothing is won by a landing, however long the step, and none of it ends in a divergence.
#[test]
fn a_landing_gains_no_energy_under_any_of_them() {
    for integrator in IMPLICIT {
        let mut bar = block([4, 6, 4], 1e5);
        bar.placement.translation = [0.0, 0.02, 0.0];
        bar.initial.velocity = [0.0, -1.5, 0.0];
        let mut scene = stepped(in_space(bar), integrator, 60.0);
        scene.gravity = [0.0, -9.81, 0.0];
        scene.room.floor = Some(0.0);
        let mut runner = runner(&scene);
        let start = energy(&runner);
        let mut highest: f64 = start;
        for _ in 0..40 {
            runner.advance_frame();
            assert!(runner.world().divergence().is_none(), "{integrator:?}: {:?}", runner.world().divergence());
            highest = highest.max(energy(&runner));
        }
        println!("{integrator:?}: {start:.6} J, at most {highest:.6} J, {:?}", fallbacks(&runner));
        assert!(highest <= 1.01 * start, "{integrator:?}: {highest} J of {start} J");
    }
}

#[test]
fn backward_euler_takes_energy_of_stiff_fibres_too() {
    let mut bar = held_bar();
    bar.initial.deformation = [[1.0, 0.1, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut runner = runner(&stepped(in_space(bar), IntegratorKind::BackwardEuler, 60.0));
    let mut last = energy(&runner);
    for frame in 0..20 {
        runner.advance_frame();
        let now = energy(&runner);
        assert!(now <= last * (1.0 + 1e-6), "{frame}: {last} J, then {now} J, {:?}", fallbacks(&runner));
        last = now;
    }
}

#[test]
fn figure_7_c_goes_on_at_sixty_frames_a_second_under_backward_euler() {
    let mut runner = shipped("figure_07c_soft.json", IntegratorKind::BackwardEuler);
    for _ in 0..15 {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    }
    println!("{:?}", fallbacks(&runner));
}

/// A blow that no long step can follow is left to leap-frog, and that is said.
#[test]
fn what_cannot_be_solved_is_handed_over_and_counted() {
    let mut bar = block([4, 6, 4], 5e7);
    bar.placement.translation = [0.0, 0.05, 0.0];
    bar.initial.velocity = [3.0, -15.0, 0.0];
    let mut scene = stepped(in_space(bar), IntegratorKind::TrBdf2, 60.0);
    scene.room.floor = Some(0.0);
    let mut runner = runner(&scene);
    let start = energy(&runner);
    for _ in 0..6 {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
        assert!(energy(&runner) < 1.02 * start, "{} J of {start} J", energy(&runner));
    }
    println!("{:?}, height {}", fallbacks(&runner), runner.world().bodies()[0].state().center().y);
    assert!(fallbacks(&runner).halved > 0);
    assert!(runner.world().bodies()[0].state().center().y > 0.3, "it has bounced");
}

/// What is held, starts without speed and takes no blow is stepped as a whole where leap-frog would take hundreds of
/// steps; a blow, a fall, a strand that may tear, a panel or another body leaves it to leap-frog.
#[test]
fn a_bake_chooses_the_whole_body_implicit_where_it_is_held_and_stiff() {
    let chosen = |change: &dyn Fn(&mut Scene)| {
        let mut bar = held_bar();
        bar.material.young_modulus = 1e8;
        let mut scene = in_space(bar);
        scene.time.frames_per_second = 60.0;
        change(&mut scene);
        let baked = baked(&scene);
        let parts = baked.world.bodies()[0].parts();
        (parts.integrator_word, parts.integrator_reason.clone(), parts.dt)
    };
    let (word, reason, dt) = chosen(&|_| {});
    assert_eq!((word, dt), ("tr_bdf2", 1.0 / 60.0));
    let reason = reason.unwrap();
    assert!(reason.starts_with("the whole body implicit: step 1.7e-2 instead of "), "{reason}");
    // Longer frames are divided.
    assert_eq!(chosen(&|scene| scene.time.frames_per_second = 24.0).2, 1.0 / 72.0);
    let explicit: [&dyn Fn(&mut Scene); 6] = [
        &|scene| scene.bodies[0].material.young_modulus = 1e4,
        &|scene| scene.bodies[0].pins.clear(),
        &|scene| scene.bodies[0].initial.velocity = [0.0, 0.0, 1.0],
        &|scene| {
            let tension = Some(5.0);
            scene.bodies[0].fibres[0].break_past = Some(BreakPast { angle: None, tension, extra: Extra::new() });
        },
        &|scene| scene.bodies[0].impulses = vec![Impulse::new("foot", [0.1, 0.0, 0.0])],
        &|scene| scene.time.frames_per_second = 5000.0,
    ];
    for (k, change) in explicit.iter().enumerate() {
        assert_ne!(chosen(change).0, "tr_bdf2", "{k}");
    }
}

/// A pull by hand is part of what is solved, and does not end in leap-frog.
#[test]
fn a_pull_moves_a_held_body_to_the_same_rest() {
    let pulled = |integrator| {
        let mut bar = held_bar();
        bar.material.damping.air = 30.0;
        let mut world = baked(&stepped(in_space(bar), integrator, 60.0)).world;
        let body = world.body_mut(0).unwrap();
        let top = body.state().positions.iter().enumerate().max_by(|a, b| a.1.y.total_cmp(&b.1.y)).unwrap().0;
        let point = body.point(top).unwrap();
        let target = body.state().positions[top] + DVec3::new(0.01, 0.0, 0.004);
        body.grab(point, target);
        for _ in 0..120 {
            world.advance_frame();
        }
        let body = &world.bodies()[0];
        (body.state().positions[top], target, body.fallbacks())
    };
    let (implicit, target, fell_back) = pulled(IntegratorKind::TrBdf2);
    let (explicit, _, _) = pulled(IntegratorKind::LeapFrog);
    println!("{} from the target, {:e} apart, {fell_back:?}", implicit.distance(target), implicit.distance(explicit));
    assert_eq!(fell_back, Fallbacks::default());
    assert!(implicit.distance(explicit) < 1e-3 * implicit.distance(target), "{implicit} {explicit}");
}
