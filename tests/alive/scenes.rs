//! The scenes of fibres that act show what they say.

use sinew::bake::bake;
use sinew::io::{apply_sets, load_scene};
use sinew::scene::{Assets, Drive, Scene};
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
    let there = values(&scene("worm"), "crawl", &[5.0])[0];
    assert!(there > length, "{there} mm");
    let early = values(&scene("worm"), "crawl", &[2.0])[0];
    let back = values(&scene("worm_back"), "crawl", &[2.0])[0];
    assert!(early > 50.0 && (back / early + 1.0).abs() < 0.05, "{early} mm, back {back} mm");
    let smooth = apply_sets(&scene("worm"), [("/room/friction", "0")]).expect("a place that is there");
    let slipped = values(&smooth, "crawl", &[2.0])[0];
    assert!(slipped.abs() < 0.02 * early, "{slipped} mm on ice");
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
    assert!(found[0] > 40.0 && (found[1] / found[0] + 1.0).abs() < 0.02, "{found:?}");
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
