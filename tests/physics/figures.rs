//! The fibre paper's figures, each by the scene that shows it.

use crate::ship::{mirrored, number, ran, scene, vector};
use sinew::io::apply_sets;
use sinew::scene::Scene;
use sinew::solver::BreakPlace;

/// Time at which a dropped soft bar has been squeezed and sheared or twisted, and has not yet toppled [s].
const LANDED: f64 = 0.12;

#[test]
fn figure_6a_upright_fibres_keep_the_height() {
    let with = number(&ran(&scene("figure_06a_soft.json"), LANDED), "height_loss");
    let without = ran(&scene("figure_06_without_soft.json"), LANDED);
    let (loss, shear, twist) =
        (number(&without, "height_loss"), vector(&without, "shear").length(), number(&without, "twist").abs());
    println!("height lost with fibres {with:.3}, without {loss:.3}");
    assert!(loss > 0.15 && with < 0.5 * loss, "{with} with, {loss} without");
    assert!(shear < 0.01 && twist < 0.01, "the plain bar shears by {shear} mm and twists by {twist} degrees");
}

#[test]
fn figure_6b_the_top_goes_with_the_slant() {
    let leaning = scene("figure_06b_soft.json");
    let right = vector(&ran(&leaning, LANDED), "shear");
    let left = vector(&ran(&mirrored(leaning), LANDED), "shear");
    println!("sheared by {right} and {left} mm");
    assert!(right.x > 8.0 && right.z.abs() < 0.02 * right.x, "{right} mm");
    assert!((right.x + left.x).abs() < 0.01 * right.x, "{right} and {left} mm");
}

#[test]
fn figure_6c_the_twist_flips_with_the_handedness() {
    let helices = scene("figure_06c_soft.json");
    let right = number(&ran(&helices, LANDED), "twist");
    let left = number(&ran(&mirrored(helices), LANDED), "twist");
    println!("twisted by {right} and {left} degrees");
    assert!(right > 15.0, "{right} degrees");
    assert!((right + left).abs() < 0.02 * right, "{right} and {left} degrees");
}

#[test]
fn figure_7_each_shape_bends_its_own_way_and_its_mirror_image_the_other() {
    let pressed = |scene: &Scene| {
        let runner = ran(scene, 0.5);
        (vector(&runner, "tip"), vector(&runner, "middle"))
    };
    let (plain, _) = pressed(&scene("figure_07_without_soft.json"));
    assert!(plain.x.abs() < 0.01 && plain.y < -3.0, "{plain} mm");
    // The sign of the tip's way, and bounds of the share of it that the middle goes.
    let cases = [("a", -1.0, 0.0..0.36), ("b", 1.0, 0.0..1.0), ("c", 1.0, 0.0..1.0), ("d", -1.0, 0.39..1.0)];
    for (shape, way, share) in cases {
        let drawn = scene(&format!("figure_07{shape}_soft.json"));
        let (tip, middle) = pressed(&drawn);
        let (mirror, _) = pressed(&mirrored(drawn));
        println!("{shape}: tip {tip}, middle {middle}, mirrored {mirror} mm");
        assert!(way * tip.x > 8.0 && tip.z.abs() < 0.02 * tip.x.abs(), "{shape}: {tip} mm");
        assert!(share.contains(&(middle.x / tip.x)), "{shape}: {middle} and {tip} mm");
        assert!((tip.x + mirror.x).abs() < 0.01 * tip.x.abs(), "{shape}: {tip} and {mirror} mm");
    }
}

#[test]
fn figure_8_the_soft_plant_stands_with_fibres_and_falls_without() {
    let shown = |name: &str| {
        let runner = ran(&scene(name), 1.0);
        (number(&runner, "height_loss"), vector(&runner, "middle").length())
    };
    let [(without, _), (stiff, _), (with, middle), (foot, middle_with_foot)] =
        ["a", "b", "c", "d"].map(|part| shown(&format!("figure_08{part}_soft.json")));
    println!("height lost: {without:.3} without, {stiff:.3} stiff, {with:.3} with, {foot:.3} with more at the foot");
    println!("middle swings by {middle:.1} mm, {middle_with_foot:.1} mm with more at the foot");
    assert!(without > 0.7, "{without}");
    assert!(stiff.abs() < 0.1 && with.abs() < 0.15 && foot.abs() < 0.15, "{stiff}, {with}, {foot}");
    assert!(middle_with_foot > 1.0 && middle > 1.5 * middle_with_foot, "{middle} and {middle_with_foot} mm");
    // A stem that buckles does so slowly at first.
    let later = number(&ran(&scene("figure_08c_soft.json"), 4.0), "height_loss");
    assert!(later.abs() < 0.15, "it falls after all: {later}");
}

#[test]
fn figure_9_the_vein_cuts_the_sag_at_least_fivefold() {
    // Slowed by the air, so that both have come near their rest.
    let sag = |name: &str| {
        let slowed = apply_sets(&scene(name), [("/bodies/0/material/damping/air", "12")]).unwrap();
        -vector(&ran(&slowed, 0.8), "sag").y
    };
    let [soft, stiff, veined] = ["a", "b", "c"].map(|part| sag(&format!("figure_09{part}_soft.json")));
    println!("sag {soft:.1} mm without, {stiff:.1} mm stiff, {veined:.1} mm with");
    assert!(soft > 300.0 && veined > 1.0 && soft > 5.0 * veined, "{soft} and {veined} mm");
    assert!(stiff > 1.0 && soft > 5.0 * stiff, "{soft} and {stiff} mm");
}

#[test]
fn figure_9_between_its_veins_the_leaf_stays_soft() {
    // Pulled at the edge of the blade, the veined leaf gives way there as the stiff one does not.
    let edge = |name: &str| {
        let pushed = apply_sets(
            &scene(name),
            [
                ("/gravity", "[0, 0, 0]"),
                ("/bodies/0/regions/2/select", r#"{"box": {"min": [0.3, -1, 0.085], "max": [0.45, 1, 1]}}"#),
                ("/bodies/0/impulses", r#"[{"region": "tip", "impulse": [0, -0.15, 0]}]"#),
                ("/measures/0/over_time", "\"peak\""),
            ],
        );
        -vector(&ran(&pushed.unwrap(), 0.2), "sag").y
    };
    let (stiff, veined) = (edge("figure_09b_soft.json"), edge("figure_09c_soft.json"));
    println!("edge bent by {stiff:.1} mm in the stiff leaf, {veined:.1} mm in the veined one");
    assert!(stiff > 0.0 && veined > 3.0 * stiff, "{stiff} and {veined} mm");
}

#[test]
fn figure_10_the_stalk_snaps_and_the_leaf_hangs_from_it() {
    let snapping = scene("figure_10_soft.json");
    let on_threads = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| ran(&snapping, 0.3))
    };
    let (broken, other) = (on_threads(1), on_threads(3));
    let whole = ran(&scene("figure_10_without_soft.json"), 0.3);
    let (sag, without) = (-vector(&broken, "sag").y, -vector(&whole, "sag").y);
    println!("sag {sag:.1} mm, {without:.1} mm where nothing breaks");
    assert!(sag > 200.0 && without.abs() < 0.3 * sag, "{sag} and {without} mm");
    assert_eq!(whole.snapshot().bodies[0].breaks, []);
    let breaks = broken.snapshot().bodies[0].breaks.clone();
    // The first one is a turn too far, in the stalk, before the blade begins.
    assert!(matches!(breaks[0].place, BreakPlace::Vertex(vertex) if vertex < 5), "{breaks:?}");
    assert!(!breaks.is_empty() && breaks[0].time > 0.0 && breaks[0].time < 0.3, "{breaks:?}");
    assert_eq!(other.snapshot().bodies[0].breaks, breaks, "on other threads");
    // A report tells how many there were and when it began.
    let report = sinew::sim::Report::new(&snapping, &broken, 1.0, Vec::new());
    assert_eq!((report.bodies[0].breaks, report.bodies[0].first_break), (breaks.len(), Some(breaks[0].time)));
}
