//! Runs under any integrator and step are judged by the energy that they were given.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{Assets, Axis, Distance, Drive, IntegratorKind, Keyframe, Motion, Panel, Scene, Side, Wave, Wind};
use sinew::sim::{Study, Trial};

/// A scene, an integrator and a share of its stable step.
struct Case {
    scene: Scene,
    integrator: IntegratorKind,
    share: f64,
}

/// The case of a number: free bodies that fall, spin or swing, and bodies that are driven from rest by pins, wind or a
/// panel, under any integrator.
fn case(number: usize) -> Case {
    let random = |salt: u64| 0.5 + 0.5 * wobble(number, salt).x;
    let pick = |salt: u64, n: usize| (random(salt) * n as f64) as usize % n;
    let layers_up = 3 + pick(1, 4) as u32;
    let mut body = block([3, layers_up, 3], 1e4 * 10_f64.powf(2.0 * random(2)));
    body.material.damping.pair = if pick(3, 2) == 0 { 0.0 } else { 30.0 };
    let kind = number % 6;
    if kind > 1 {
        body.regions = vec![layers("foot", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
        body.pins = vec![pin("foot", &ALL, Motion::Fixed)];
    }
    match kind {
        0 => body.initial.velocity = (0.5 * wobble(number, 5)).to_array(),
        1 => body.initial.deformation = [[1.1, 0.05, 0.0], [0.0, 0.95, 0.0], [0.0, 0.0, 1.0]],
        2 => body.pins.push(pin("top", &ALL, ramp([1.0, 0.5, 0.0], Distance::Metres(0.003), 0.05))),
        3 => {
            let key = |time: f64, x: f64| Keyframe::new(time, [x, 0.0, 0.0]);
            let motion = Motion::Keyframes(vec![key(0.0, 0.0), key(0.02, 0.002), key(0.04, -0.002), key(0.06, 0.0)]);
            body.pins.push(pin("top", &ALL, motion));
        }
        _ => {}
    }
    let mut scene = in_space(body);
    if kind == 0 {
        scene.gravity = [0.0, -9.81, 0.0];
        scene.room.floor = Some(-0.001);
    } else if kind == 4 {
        let gusts = Drive::Wave(Wave::new(0.02));
        scene.wind = Some(Wind { drive: Some(gusts), ..Wind::new([8.0, 0.0, 3.0]) });
    } else if kind == 5 {
        let height = f64::from(layers_up) * D;
        scene.panels = vec![Panel::driven("lid", [0.1, 0.1], [(0.0, height + 2e-4), (0.05, 0.93 * height)])];
    }
    let integrator = IntegratorKind::ALL[pick(6, IntegratorKind::ALL.len())];
    let shares = [1.0 / 30.0, 0.2, 0.7, 1.5, 3.0];
    Case { scene, integrator, share: shares[pick(7, shares.len())] }
}

/// The greatest energy of motion and strain in a run of so many steps, or until it blows up [J], infinite if that is no
/// number; and the steps.
fn peak(trial: &mut Trial, steps: u64) -> (f64, u64) {
    let mut peak = 0.0_f64;
    for step in 1..=steps {
        trial.step();
        let world = trial.world();
        let energies = world.bodies().iter().map(|body| body.energies(world.time()));
        let now: f64 = energies.map(|energies| energies.total() - energies.gravity).sum();
        peak = if now.is_finite() { peak.max(now) } else { f64::INFINITY };
        if trial.blew_up_at().is_some() {
            return (peak, step);
        }
    }
    (peak, steps)
}

/// What cases were found to be.
#[derive(Debug, Default)]
struct Judged {
    stable: usize,
    unstable: usize,
    /// Those between the two, where it is a matter of taste; they are not judged.
    grey: usize,
    wrong: Vec<String>,
}

/// Holds what is said of a case against the same run in steps of a tenth: one whose energy grows less than half beyond
/// that run's is stable, one that grows to four times as much is not.
fn judge(number: usize, judged: &mut Judged) {
    let Case { scene, integrator, share } = case(number);
    let study = Study::new(&scene, &Assets::default()).unwrap();
    // One that is stable at any step is tried at shares of a hundredth of a second.
    let dt = share * study.stable_step(integrator).min(0.01);
    let steps = ((0.05 / dt) as u64).clamp(40, 1500);
    let (mut trial, mut finer) = (study.trial(integrator, dt), study.trial(integrator, 0.1 * dt));
    let (greatest, made) = peak(&mut trial, steps);
    let grown = greatest / peak(&mut finer, 10 * made).0;
    let what = format!(
        "{number}: kind {}, {integrator:?} at {share:.2}, grown {grown:.3}, gained {:.3}",
        number % 6,
        trial.gained()
    );
    let is_stable = if grown < 1.5 {
        judged.stable += 1;
        true
    } else if grown.is_nan() || grown > 4.0 {
        judged.unstable += 1;
        false
    } else {
        println!("grey {what}");
        judged.grey += 1;
        return;
    };
    println!("{} {what}", if is_stable { "stable" } else { "not" });
    if trial.is_stable() != is_stable {
        judged.wrong.push(what);
    }
}

/// Draws cases until so many are judged.
fn judged(wanted: usize) -> Judged {
    let mut judged = Judged::default();
    for number in 0.. {
        if judged.stable + judged.unstable == wanted {
            break;
        }
        judge(number, &mut judged);
        assert!(judged.grey <= wanted, "{judged:?}");
    }
    let Judged { stable, unstable, grey, wrong } = &judged;
    println!("{wanted} judged: {stable} stable, {unstable} not, {} wrongly; {grey} between, skipped", wrong.len());
    judged
}

/// All of so many are judged rightly, and there are enough of either.
fn judged_rightly(wanted: usize) {
    let judged = judged(wanted);
    assert!(judged.wrong.is_empty(), "{:#?}", judged.wrong);
    assert_eq!(judged.stable + judged.unstable, wanted);
    assert!(judged.stable > wanted / 3 && judged.unstable > wanted / 10, "{judged:?}");
}

#[test]
fn driven_and_free_runs_are_judged_by_the_energy_they_were_given() {
    judged_rightly(24);
}

#[test]
fn work_of_pins_that_come_and_go_within_a_step_is_no_gain() {
    // Pins that are back after each step of TR-BDF2 and SDIRK2; gusts that begin at nothing; and what does blow up.
    let mut judged = Judged::default();
    for number in [28, 33, 130, 135, 147, 134] {
        judge(number, &mut judged);
    }
    assert!(judged.wrong.is_empty(), "{:#?}", judged.wrong);
    assert!(judged.stable >= 4 && judged.unstable >= 1, "{judged:?}");
}

#[test]
#[ignore = "a long sweep: cargo test --release --test physics -- --ignored two_hundred"]
fn two_hundred_driven_and_free_runs_are_judged_rightly() {
    judged_rightly(200);
}

#[test]
fn a_body_of_which_nothing_is_asked_is_stable_up_to_its_step() {
    // Turned, so that its places are rounded, and kept awake by a pin that goes nowhere.
    let mut body = block([3, 4, 3], 1e5);
    (body.placement.rotation.axis, body.placement.rotation.degrees) = ([1.0, 2.0, 3.0], 37.0);
    body.regions = vec![layers("foot", Axis::Y, Side::Min, 1)];
    body.pins = vec![pin("foot", &ALL, ramp([1.0, 0.0, 0.0], Distance::Metres(0.0), 10.0))];
    let study = Study::new(&in_space(body), &Assets::default()).unwrap();
    for (integrator, share, stable) in [
        (IntegratorKind::LeapFrog, 0.5, true),
        (IntegratorKind::Rk4, 0.9, true),
        (IntegratorKind::TrBdf2, 10.0, true),
        (IntegratorKind::LeapFrog, 1.5, false),
    ] {
        let mut trial = study.trial(integrator, share * study.stable_step(integrator).min(1e-3));
        (0..400).for_each(|_| trial.step());
        println!("{integrator:?} at {share}: {} J, gained {}", trial.energy(), trial.gained());
        assert_eq!(trial.is_stable(), stable, "{integrator:?} at {share}: gained {}", trial.gained());
    }
}

#[test]
fn a_slow_drive_from_rest_is_no_blow_up_and_its_work_is_what_is_stored() {
    let mut body = block([3, 6, 3], 1e5);
    body.regions = vec![layers("foot", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    body.pins =
        vec![pin("foot", &ALL, Motion::Fixed), pin("top", &ALL, ramp([1.0, 0.0, 0.0], Distance::Metres(0.004), 0.2))];
    let scene = in_space(body);
    let study = Study::new(&scene, &Assets::default()).unwrap();
    for integrator in [IntegratorKind::LeapFrog, IntegratorKind::Rk4, IntegratorKind::TrBdf2] {
        let dt = if integrator == IntegratorKind::TrBdf2 { 0.002 } else { study.stable_step(integrator) / 3.0 };
        let mut trial = study.trial(integrator, dt);
        (0..(0.2 / dt) as u64).for_each(|_| trial.step());
        let stored = trial.energy();
        println!("{integrator:?}: {stored} J stored, gained {}", trial.gained());
        assert_eq!(trial.blew_up_at(), None, "{integrator:?}");
        assert!(stored > 1e-5 && trial.gained() < 0.05, "{integrator:?}: {stored} J, gained {}", trial.gained());
    }
    // Lost to nothing: displacement of the top is what was asked for.
    let mut trial = study.trial(IntegratorKind::LeapFrog, 1e-4);
    (0..2100).for_each(|_| trial.step());
    let body = &trial.world().bodies()[0];
    let top = body.parts().rest.iter().zip(&body.state().positions).filter(|(rest, _)| rest.y > 5.0 * D);
    assert!(top.clone().all(|(rest, x)| x.distance(*rest + DVec3::X * 0.004) < 1e-12));
}
