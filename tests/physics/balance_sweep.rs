//! Runs of every kind of body under any integrator, material, damping and step, drawn by a seed: each keeps its balance
//! of energy and work, as it is seen frame by frame, or says that it does not.

use crate::balance::{KINDS, of_kind, runner, scene};
use crate::common::wobble;
use serde_json::{Value, json};
use sinew::bake::bake;
use sinew::scene::{Assets, IntegratorKind};

/// A run of the sweep.
struct Case {
    scene: Value,
    seconds: f64,
    what: String,
    /// Whether touch may take by damping what a body by itself gains, so that it cannot be seen from outside.
    may_hide: bool,
}

fn case(number: usize) -> Case {
    let random = |salt: u64| 0.5 + 0.5 * wobble(number, salt).x;
    let pick = |salt: u64, n: usize| (random(salt) * n as f64) as usize % n;
    let kind = number % KINDS;
    let integrator = IntegratorKind::ALL[pick(2, IntegratorKind::ALL.len())];
    let young_modulus = 1e4 * 10_f64.powf(2.0 * random(3));
    let pair = [0.0, 0.0, 3.0, 100.0, 1000.0][pick(4, 5)];
    let air = [0.0, 0.0, 5.0][pick(5, 3)];
    let mut value = of_kind(kind, 3 + pick(6, 3) as u32, young_modulus, [pair, air], 0.2 + 2.0 * random(7));
    for bodies in ["bodies", "two_layer"] {
        for body in value.get_mut(bodies).and_then(Value::as_array_mut).into_iter().flatten() {
            body["integrator"] = json!(integrator.word());
        }
    }
    let stable = bake(&scene(&value), &Assets::default()).map(|baked| baked.stable_step(integrator));
    let stable = stable.unwrap_or(1e-4);
    let share = [0.3, 0.6, 1.0, 1.5, 3.0][pick(8, 5)];
    // One that is stable at any step is tried at those of others and at far longer ones.
    let dt = if stable.is_finite() { share * stable } else { [2e-4, 1e-3, 4e-3, 1.0 / 60.0][pick(9, 4)] }.min(0.02);
    let steps = ((0.1 / dt) as u32).clamp(30, 300);
    let substeps = (steps / 30).max(1);
    value["time"] = json!({"duration": 10, "step": {"manual": {"dt": dt, "substeps_per_frame": substeps}}});
    let what = format!(
        "{number}: kind {kind}, {}, E {young_modulus:.0}, pair {pair}, air {air}, dt {dt:.2e} ({share} of {stable:.2e})",
        integrator.word()
    );
    Case { scene: value, seconds: f64::from(steps) * dt, what, may_hide: (5..=7).contains(&kind) && share >= 1.0 }
}

#[derive(Debug, Default)]
struct Tally {
    kept: usize,
    said: usize,
    wrong: Vec<String>,
}

/// Runs cases and holds that every one keeps its balance, seen frame by frame, or says that it does not.
fn kept_or_said(numbers: impl Iterator<Item = usize>) -> Tally {
    let mut tally = Tally::default();
    for number in numbers {
        let Case { scene: value, seconds, what, may_hide } = case(number);
        let scene = scene(&value);
        let mut runner = runner(&scene);
        let (mut lowest, mut risen) = (f64::INFINITY, 0.0_f64);
        for _ in 0..runner.frames_for(seconds) {
            let world = runner.world();
            let balance = world.energy() - world.work();
            lowest = lowest.min(balance);
            risen = risen.max(balance - lowest);
            runner.advance_frame();
            if runner.world().divergence().is_some() {
                break;
            }
        }
        runner.look();
        let world = runner.world();
        let accuracy = world.accuracy().or_else(|| world.accuracy_of(0));
        let share = accuracy.map_or(f64::INFINITY, |of| risen / of.handled);
        let said = world.divergence().map(ToString::to_string).or(world.unbalanced().first().map(ToString::to_string));
        let word = said.clone().unwrap_or_default();
        println!("{what}: risen by {:.2} %: {word}", 100.0 * share);
        match said {
            None if share < 0.06 => tally.kept += 1,
            Some(_) if share > 0.015 || may_hide => tally.said += 1,
            _ => tally.wrong.push(format!("{what}: risen by {share}: {word}")),
        }
    }
    println!("{} kept, {} said, {} wrong", tally.kept, tally.said, tally.wrong.len());
    tally
}

#[test]
fn every_run_keeps_its_balance_or_says_so() {
    let tally = kept_or_said(0..20);
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
    assert!(tally.kept > 8 && tally.said > 3, "{tally:?}");
}

#[test]
#[ignore = "a long sweep: cargo test --release --test physics -- --ignored two_thousand"]
fn two_thousand_runs_keep_their_balance_or_say_so() {
    let tally = kept_or_said(0..2000);
    assert!(tally.wrong.is_empty(), "{} wrong: {:#?}", tally.wrong.len(), tally.wrong);
}
