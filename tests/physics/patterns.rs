//! Each pattern does what its line says, in the little scene of its picture.

use crate::common::runner;
use glam::DVec3;
use sinew::edit::fibre_ops::made_to_act;
use sinew::scene::{Fibre, FibreSource, Scene};
use sinew::sim::Runner;
use sinew::sketch::pattern::{PATTERNS, Pattern};
use sinew::solver::MeasureValue;
use sinew::test_support::cli::{Demo, demo};

fn demo_of(id: &str) -> Demo {
    demo(Pattern::by_id(id).expect("a pattern")).expect("a scene").expect("one of its own")
}

fn ran(scene: &Scene, seconds: f64) -> Runner {
    let mut runner = runner(scene);
    for _ in 0..runner.frames_for(seconds) {
        runner.advance_frame();
    }
    assert!(runner.world().divergence().is_none(), "{}: {:?}", scene.name, runner.world().divergence());
    runner
}

/// A measure; a number stands in each component.
fn measured(runner: &Runner, name: &str) -> DVec3 {
    let index = runner.world().probes().iter().position(|probe| probe.name == name).expect("a measure of that name");
    match runner.reported_measures()[index] {
        MeasureValue::Scalar(value) => DVec3::splat(value),
        MeasureValue::Vector(value) => value,
    }
}

/// A measure with the pattern's fibres and without them.
fn beside_plain(id: &str, measure: &str) -> [DVec3; 2] {
    let demo = demo_of(id);
    let both = [&demo.scene, &demo.plain()].map(|scene| measured(&ran(scene, demo.to), measure));
    println!("{id}: {measure} {} with, {} without", both[0], both[1]);
    both
}

#[test]
fn every_pattern_has_its_scene_and_no_fibre_is_trimmed_in_it() {
    for pattern in &PATTERNS {
        let demo = demo_of(pattern.id);
        demo.scene.validate().expect("a sound scene");
        assert!(demo.from < demo.to && !demo.scene.bodies[0].fibres.is_empty());
        let there = runner(&demo.scene).snapshot().bodies[0].fibres.clone();
        assert_eq!(there.len(), demo.scene.bodies[0].fibres.len(), "{}", pattern.id);
    }
}

#[test]
fn upright_fibres_frames_and_short_fibres_keep_the_height_of_a_dropped_bar() {
    for (id, share) in [("vertical", 0.8), ("frame", 0.8), ("short_fibres", 0.93)] {
        let [with, without] = beside_plain(id, "height_loss");
        assert!(without.x > 0.1 && with.x < share * without.x, "{id}: {} and {}", with.x, without.x);
    }
}

#[test]
fn slanted_fibres_shear_along_their_slant() {
    let demo = demo_of("slanted");
    let right = measured(&ran(&demo.scene, demo.to), "shear");
    assert!(right.x > 10.0 && right.z.abs() < 0.02 * right.x, "{right} mm");
    let mut mirrored = demo.scene.clone();
    for fibre in &mut mirrored.bodies[0].fibres {
        let FibreSource::Vertices(vertices) = &mut fibre.source else { panic!("{} has strokes", fibre.id) };
        for vertex in vertices {
            vertex[0] = -vertex[0];
        }
    }
    let left = measured(&ran(&mirrored, demo.to), "shear");
    assert!((right.x + left.x).abs() < 0.02 * right.x, "{right} and {left} mm");
}

#[test]
fn helices_twist_by_their_hand() {
    let [left, right] = ["helix_left", "helix_right"].map(|id| {
        let demo = demo_of(id);
        measured(&ran(&demo.scene, demo.to), "twist").x
    });
    println!("twisted by {left} and {right} degrees");
    assert!(right > 10.0 && (left + right).abs() < 0.02 * right, "{left} and {right} degrees");
}

#[test]
fn a_cross_holds_most_in_its_plane() {
    let [with, without] = beside_plain("cross", "tip");
    assert!(with.x > 1.0 && with.x < 0.85 * without.x, "{with} and {without} mm");
    let demo = demo_of("cross");
    let mut across = demo.scene.clone();
    across.gravity = [0.0, 0.0, across.gravity[0]];
    let across = measured(&ran(&across, demo.to), "tip");
    assert!(across.z > 1.03 * with.x && across.z < 0.85 * without.x, "{across} across, {with} mm in its plane");
}

#[test]
fn a_c_bends_once_and_an_s_twice() {
    // How far the lower and the upper part stand aside of the line from the foot to the tip.
    let aside = |id: &str| {
        let demo = demo_of(id);
        let runner = ran(&demo.scene, demo.to);
        let [tip, lower, upper] = ["tip", "lower", "upper"].map(|name| measured(&runner, name).x);
        [lower - tip * 21.0 / 90.0, upper - tip * 69.0 / 90.0]
    };
    let ([c_low, c_high], [s_low, s_high]) = (aside("c_shape"), aside("s_shape"));
    println!("aside by {c_low}, {c_high} mm and {s_low}, {s_high} mm");
    assert!(c_low < -0.5 && c_high < -0.5, "{c_low} and {c_high} mm");
    assert!(s_low > 0.5 && s_high < -0.5, "{s_low} and {s_high} mm");
}

#[test]
fn rays_and_veins_carry_what_hangs() {
    for (id, measure, share) in [("radial", "rim", 0.6), ("vein", "tip", 0.6)] {
        let [with, without] = beside_plain(id, measure);
        assert!(without.y < -2.0 && with.y < 0.0 && with.y > share * without.y, "{id}: {with} and {without} mm");
    }
}

#[test]
fn a_spiral_turns_the_middle_of_a_plate_that_is_stretched() {
    let [with, without] = beside_plain("spiral", "turn");
    assert!(with.x < -5.0 && without.x.abs() < 0.1, "{} and {} degrees", with.x, without.x);
}

/// A measure at some times, of a scene that runs once.
fn at_times(scene: &Scene, name: &str, times: &[f64]) -> Vec<DVec3> {
    let mut runner = runner(scene);
    let mut found = Vec::new();
    for &time in times {
        while runner.world().frame() < runner.frames_for(time) {
            runner.advance_frame();
        }
        assert!(runner.world().divergence().is_none(), "{}: {:?}", scene.name, runner.world().divergence());
        found.push(measured(&runner, name));
    }
    println!("{} {name}: {found:?}", scene.name);
    found
}

/// The same scene with another value of a parameter, by the identifiers of both.
fn with(id: &str, values: &[(&str, f64)]) -> Scene {
    let pattern = Pattern::by_id(id).expect("a pattern");
    let mut all = pattern.defaults();
    for (name, value) in values {
        let index = pattern.parameters.iter().position(|parameter| parameter.id == *name);
        all[index.expect("a parameter of that name")] = *value;
    }
    let mut scene = demo_of(id).scene;
    let fibres = &mut scene.bodies[0].fibres;
    let acts = pattern.acts(&all, fibres.len());
    let line = |fibre: &Fibre| match &fibre.source {
        FibreSource::Vertices(vertices) => vertices.iter().map(|at| DVec3::from_array(*at)).collect(),
        FibreSource::Strokes(_) => panic!("{} has strokes", fibre.id),
    };
    let lines: Vec<Vec<DVec3>> = fibres.iter().map(line).collect();
    let drives = made_to_act(fibres, (&lines, &acts), id, &[]);
    scene.bodies[0].drives = drives;
    scene
}

#[test]
fn a_worm_crawls_by_its_wave_and_a_fish_swims() {
    let crawl = |waves: f64| at_times(&with("worm", &[("waves", waves)]), "crawl", &[1.6])[0].x;
    let (crawled, back) = (crawl(1.0), crawl(-1.0));
    assert!(crawled > 20.0 && (back / crawled + 1.0).abs() < 0.05, "{crawled} and {back} mm");
    let lively = [("contract", 0.6), ("period", 0.5)];
    let swim = |waves: f64| at_times(&with("tail", &[lively[0], lively[1], ("waves", waves)]), "swim", &[1.5])[0].x;
    let (swum, back) = (swim(1.0), swim(-1.0));
    assert!(swum > 10.0 && (back / swum + 1.0).abs() < 0.05, "{swum} and {back} mm");
}

#[test]
fn a_finger_curls_to_its_side_and_straightens() {
    let tip = at_times(&demo_of("finger").scene, "tip", &[1.2, 1.6]);
    assert!(tip[0].x > 20.0 && tip[1].x.abs() < 0.25 * tip[0].x && tip[0].z.abs() < 0.05 * tip[0].x, "{tip:?} mm");
}

#[test]
fn a_heart_gets_narrow_and_tall_and_a_breath_small_all_round() {
    let size = |id: &str, axis: &str| {
        let found = at_times(&demo_of(id).scene, axis, &[0.0, 1.2, 1.6]);
        [found[1].x / found[0].x, found[2].x / found[0].x]
    };
    let ([narrow, again], [tall, _]) = (size("rings", "width"), size("rings", "height"));
    assert!(narrow < 0.92 && tall > 1.01 && (again - 1.0).abs() < 0.05, "{narrow}, {again}, {tall}");
    // A ball breathes: it is as high as it is wide, and gets smaller along the axis of its spokes, too.
    let [[wide, again], [high, _], [deep, _]] = ["width", "height", "depth"].map(|axis| size("spokes", axis));
    assert!(wide < 0.95 && (again - 1.0).abs() < 0.05, "{wide}, {again}");
    assert!((wide - high).abs() < 0.01 && deep < 0.97, "{wide}, {high}, {deep}");
}

#[test]
fn arms_of_a_starfish_bend_down_in_turns() {
    let scene = demo_of("starfish").scene;
    let star = &scene.bodies[0];
    assert_eq!((star.fibres.len(), star.drives.len(), star.voids.len()), (5, 5, 5));
    // A swing of every arm, from the second on.
    let (period, mut runner) = (0.8, runner(&scene));
    let mut lowest = [(f64::INFINITY, 0.0); 5];
    let mut highest = [f64::NEG_INFINITY; 5];
    while runner.world().frame() < runner.frames_for(2.0 * period) {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
        let time = runner.world().time();
        for arm in 0..5 {
            let y = measured(&runner, &format!("arm_{}", arm + 1)).y;
            if time > period && y < lowest[arm].0 {
                lowest[arm] = (y, time);
            }
            if time > period {
                highest[arm] = highest[arm].max(y);
            }
        }
    }
    println!("lowest {lowest:.3?}, highest {highest:.1?}");
    // So late in its swing each is down, less the fifth of a swing by which it comes after the one before it.
    let late: Vec<f64> = (0..5).map(|arm| (lowest[arm].1 / period - 0.2 * arm as f64).rem_euclid(1.0)).collect();
    let mean = late.iter().sum::<f64>() / 5.0;
    for arm in 0..5 {
        let low = lowest[arm].0;
        assert!(low < -10.0 && highest[arm] > 0.5 * low, "arm {arm}: {low} to {} mm", highest[arm]);
        // A quarter of the way to the next: they come strictly one after the other, round and round.
        assert!((late[arm] - mean).abs() < 0.05, "arm {arm}: {late:?}");
    }
}

#[test]
fn a_trunk_twists_both_ways_alike_and_a_tentacle_curls_besides() {
    let twist = at_times(&demo_of("trunk").scene, "twist", &[1.2, 1.6]);
    assert!(twist[0].x > 15.0 && (twist[1].x / twist[0].x + 1.0).abs() < 0.1, "{twist:?} degrees");
    // A third and two thirds of a swing after the right-handed ones came the left-handed and the upright ones.
    let tentacle = demo_of("tentacle").scene;
    let twist = at_times(&tentacle, "twist", &[1.2, 1.2 + 0.8 / 3.0]);
    assert!(twist[0].x > 10.0 && twist[1].x < -10.0, "{twist:?} degrees");
    let tip = at_times(&tentacle, "tip", &[1.2, 1.2 + 1.6 / 3.0]);
    assert!(tip[1].x > 10.0 && tip[0].x.abs() < 0.5 * tip[1].x, "{tip:?} mm");
}
