//! The scenes of fibres that act show what they say.

use crate::greeting::Greeting;
use sinew::bake::bake;
use sinew::io::{apply_sets, load_assets, load_scene};
use sinew::scene::{Assets, Drive, FollowSelect, Scene};
use sinew::sim::Runner;
use sinew::solver::MeasureValue;
use std::path::Path;

fn scene(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(format!("alive_{name}.json"));
    load_scene(&path).expect("a scene that loads")
}

/// The values [mm, degrees, m] of a measure at some times [s].
fn values(scene: &Scene, measure: &str, times: &[f64]) -> Vec<f64> {
    let mut runner = Runner::new(bake(scene, &Assets::default()).expect("a scene that bakes"));
    let index = runner.world().probes().iter().position(|probe| probe.name == measure).expect("a measure of that name");
    let mut found = Vec::new();
    for &time in times {
        while runner.world().frame() < runner.frames_for(time) {
            runner.advance_frame();
        }
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
        let MeasureValue::Scalar(value) = runner.world().measures()[index] else { panic!("{measure} is a vector") };
        found.push(value);
    }
    println!("{} {measure}: {found:?}", scene.name);
    found
}

#[test]
fn the_worm_crawls_over_its_length_by_friction_alone_and_back_by_the_wave_reversed() {
    let length = 180.0;
    // Half of the ten seconds are enough.
    let [there, back] = ["worm", "worm_back"].map(|name| values(&scene(name), "crawl", &[5.0])[0]);
    assert!(there > length && (back / there + 1.0).abs() < 0.05, "{there} mm, back {back} mm");
    let smooth = apply_sets(&scene("worm"), [("/room/friction", "0")]).expect("a place that is there");
    let slipped = values(&smooth, "crawl", &[1.0])[0];
    assert!(slipped.abs() < 0.01 * there, "{slipped} mm on ice");
}

#[test]
fn the_heart_beats_alike_every_time() {
    let found = values(&scene("heart"), "width", &[0.02, 0.2, 0.78, 1.0, 1.58, 1.8]);
    let [_, first, open, second, opened, third] = found[..] else { panic!("six values") };
    assert!(first < 0.87 * open && second < 0.87 * opened, "{found:?}");
    assert!((second / first - 1.0).abs() < 0.02 && (third / second - 1.0).abs() < 0.01, "{found:?}");
}

#[test]
fn the_gripper_lifts_a_ball_and_holds_it_by_friction_alone() {
    let held = values(&scene("gripper"), "lift", &[3.0, 5.5, 8.0]);
    assert!(held[0] > 60.0 && held.iter().all(|lift| (lift - held[0]).abs() < 0.05), "{held:?}");
    let smooth = apply_sets(&scene("gripper"), [("/room/friction", "0")]).expect("a place that is there");
    let slipped = values(&smooth, "lift", &[2.0])[0];
    assert!(slipped < 10.0, "{slipped} mm without friction");
}

#[test]
fn the_arm_twists_both_ways_alike_and_curls() {
    let found = values(&scene("octopus"), "twist", &[1.2, 3.2, 5.2]);
    assert!((found[0] - 85.0).abs() < 2.0 && (found[1] / found[0] + 1.0).abs() < 0.02, "{found:?}");
    assert!(found[2].abs() < 0.05 * found[0], "{found:?}");
    let reach = values(&scene("octopus"), "reach", &[4.0, 5.2]);
    assert!(reach[1] > 40.0 && reach[0].abs() < 5.0, "{reach:?}");
}

#[test]
fn the_fish_swims_ahead_in_water_and_nowhere_without() {
    let swum = values(&scene("fish"), "swim", &[2.0])[0];
    assert!(swum > 60.0, "{swum} mm");
    let dry = apply_sets(&scene("fish"), [("/wind/density", "0")]).expect("a place that is there");
    let stayed = values(&dry, "swim", &[1.0])[0];
    assert!(stayed.abs() < 1e-6, "{stayed} mm");
}

#[test]
fn the_ball_rolls_by_its_springs_and_back_where_they_go_round_the_other_way() {
    let rolled = values(&scene("ball"), "way", &[3.0])[0];
    assert!(rolled > 300.0, "{rolled} mm");
    let mut other = scene("ball");
    for springs in &mut other.two_layer[0].active_springs {
        let Drive::Wave(wave) = &mut springs.drive else { panic!("a wave") };
        wave.phase_degrees = 180.0 - wave.phase_degrees;
    }
    let back = values(&other, "way", &[3.0])[0];
    assert!(back < -100.0, "{back} mm");
    let smooth = apply_sets(&scene("ball"), [("/room/friction", "0")]).expect("a place that is there");
    let slipped = values(&smooth, "way", &[3.0])[0];
    assert!(slipped.abs() < 1e-6, "{slipped} mm on ice");
}

/// The times [s] and values of the greatest of a series within a span of time.
fn peak(series: &[(f64, f64)], span: std::ops::Range<f64>) -> (f64, f64) {
    let within = series.iter().filter(|(time, _)| span.contains(time));
    *within.max_by(|a, b| a.1.total_cmp(&b.1)).expect("a value in that time")
}

#[test]
fn the_character_follows_its_bones_and_its_ears_lag_and_settle() {
    let scene = scene("character");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let assets = load_assets(&scene, &folder, &mut |_| {}).expect("a model that ships");
    let greeting = Greeting::read(&folder.join("../assets/character.glb"));
    let baked = bake(&scene, &assets).expect("a scene that bakes");
    let mut runner = Runner::new(baked);
    let index = |name: &str| runner.world().probes().iter().position(|probe| probe.name == name).expect("a measure");
    let (head, ears, belly) = (index("head_sway"), index("ear_sway"), index("belly_sway"));
    let (mut of_head, mut of_ears, mut of_belly, mut furthest) = (Vec::new(), Vec::new(), Vec::new(), 0.0_f64);
    let FollowSelect::Distance(near) = scene.bodies[0].follows[0].select else { panic!("near bones") };
    // All that is held to the bones, with where the file's own skin has it.
    let rest = runner.world().bodies()[0].parts().rest.iter().enumerate();
    let held: Vec<_> =
        rest.filter(|(_, at)| greeting.is_near_a_bone(**at, near)).map(|(i, at)| (i, greeting.hung(*at))).collect();
    while runner.world().frame() < runner.frames_for(4.0) {
        runner.advance_frame();
        let world = runner.world();
        assert!(world.divergence().is_none(), "{:?}", world.divergence());
        let measures = world.measures();
        let value = |index: usize| match measures[index] {
            MeasureValue::Scalar(value) => value,
            MeasureValue::Vector(value) => panic!("a vector: {value}"),
        };
        of_head.push((world.time(), value(head)));
        of_ears.push((world.time(), value(ears)));
        of_belly.push((world.time(), value(belly)));
        if world.frame().is_multiple_of(6) && world.time() >= 0.4 {
            let positions = &world.bodies()[0].state().positions;
            for (i, hung) in &held {
                let expected = greeting.place(hung, world.time() - 0.4);
                furthest = furthest.max(positions[*i].distance(expected));
            }
        }
    }
    println!("{} particles on bones, at most {furthest:.2e} m off", held.len());
    // Two bows to its right (x below zero), one to its left in between.
    let turned = |series: &[(f64, f64)]| series.iter().map(|&(time, x)| (time, -x)).collect::<Vec<_>>();
    let first = [peak(&turned(&of_head), 0.6..1.15), peak(&turned(&of_ears), 0.6..1.15)];
    assert!((first[0].1 - 61.0).abs() < 2.0 && (first[1].1 - 152.0).abs() < 6.0, "{first:?}");
    let bows = [(true, 0.6..1.15), (false, 1.15..1.65), (true, 1.65..2.2)];
    for (is_right, span) in bows {
        let series = |of: &[(f64, f64)]| if is_right { turned(of) } else { of.to_vec() };
        let [bone, flesh] = [peak(&series(&of_head), span.clone()), peak(&series(&of_ears), span)];
        println!("head {:.1} mm at {:.3} s, ears {:.1} mm at {:.3} s", bone.1, bone.0, flesh.1, flesh.0);
        assert!(bone.1 > 40.0 && flesh.1 > 1.5 * bone.1, "{bone:?} {flesh:?}");
        assert!(flesh.0 - bone.0 > 0.04, "the ears lag: {bone:?} {flesh:?}");
    }
    // The motion ends at 2.4 s: the head is back then, the ears swing on, and come to rest.
    let swing = |from: f64, to: f64| {
        let within = || of_ears.iter().filter(|(time, _)| (from..=to).contains(time)).map(|of| of.1);
        within().fold(f64::NEG_INFINITY, f64::max) - within().fold(f64::INFINITY, f64::min)
    };
    println!("ears swing over {:.1} mm, then {:.1} mm", swing(2.4, 3.2), swing(3.6, 4.0));
    assert!(swing(2.4, 3.2) > 20.0 && swing(3.6, 4.0) < 0.4 * swing(2.4, 3.2));
    // The belly hangs on springs so weak that it goes less far than the hips, by 20 mm, and comes to rest as well.
    let [right, left] = [peak(&turned(&of_belly), 0.6..1.15), peak(&of_belly, 1.15..1.65)];
    println!("belly {:.1} mm to its right, {:.1} mm to its left", right.1, left.1);
    assert!((12.0..20.0).contains(&right.1) && (12.0..20.0).contains(&left.1), "{right:?} {left:?}");
    assert!(of_belly.iter().filter(|(time, _)| *time > 3.5).all(|(_, x)| x.abs() < 1.0));
    let back = of_head.iter().filter(|(time, _)| *time > 2.5).map(|of| of.1.abs()).fold(0.0, f64::max);
    assert!(back < 3.0, "{back} mm");
    assert!(held.len() > 50 && furthest < 1e-3, "{} particles, {furthest} m", held.len());
    assert!(runner.world().unbalanced().is_empty(), "{:?}", runner.world().unbalanced());
}

#[test]
fn the_character_moves_alike_on_any_number_of_threads() {
    let mut scene = scene("character");
    // In the midst of the motion, not on the way to where that begins.
    for follow in &mut scene.bodies[0].follows {
        (follow.pre_roll, follow.speed) = (0.02, 10.0);
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let assets = load_assets(&scene, &folder, &mut |_| {}).expect("a model that ships");
    let bits = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let mut runner = Runner::new(bake(&scene, &assets).expect("a scene that bakes"));
            (0..3).for_each(|_| runner.advance_frame());
            let state = runner.world().bodies()[0].state();
            let numbers = state.positions.iter().chain(&state.velocities).flat_map(glam::DVec3::to_array);
            numbers.map(f64::to_bits).collect::<Vec<u64>>()
        })
    };
    let one = bits(1);
    assert!([2, 5].into_iter().all(|threads| bits(threads) == one));
}
