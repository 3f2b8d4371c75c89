//! The fibre paper's figures with Table 1's own values: what the soft companions show is there too, smaller or sooner
//! over.

use crate::ship::{mirrored, number, ran, scene, vector};
use sinew::scene::Scene;
use sinew::solver::BreakPlace;

#[test]
fn figure_6_with_table_1s_values() {
    let landed = |name: &str| ran(&scene(name), 0.0025);
    let without = landed("figure_06_without.json");
    let (loss, kept) = (number(&without, "height_loss"), number(&landed("figure_06a.json"), "height_loss"));
    println!("height lost {loss:.4} without, {kept:.4} with upright fibres");
    assert!(loss > 0.05 && kept < 0.5 * loss, "{kept} with, {loss} without");
    let sheared = vector(&landed("figure_06b.json"), "shear");
    let other = vector(&ran(&mirrored(scene("figure_06b.json")), 0.0025), "shear");
    println!("sheared by {sheared} and {other} mm");
    assert!(sheared.x > 5.0 && (sheared.x + other.x).abs() < 0.01 * sheared.x, "{sheared} and {other} mm");
    let twisted = number(&landed("figure_06c.json"), "twist");
    let other = number(&ran(&mirrored(scene("figure_06c.json")), 0.0025), "twist");
    println!("twisted by {twisted} and {other} degrees");
    assert!(twisted > 8.0 && (twisted + other).abs() < 0.02 * twisted, "{twisted} and {other} degrees");
    let (shear, twist) = (vector(&without, "shear").length(), number(&without, "twist").abs());
    assert!(shear < 0.01 && twist < 0.01, "the plain bar shears by {shear} mm and twists by {twist} degrees");
}

#[test]
fn figure_7_with_table_1s_values() {
    let pressed = |scene: &Scene| {
        let runner = ran(scene, 0.008);
        [vector(&runner, "tip").x, vector(&runner, "middle").x]
    };
    let [plain, _] = pressed(&scene("figure_07_without.json"));
    assert!(plain.abs() < 0.01, "{plain} mm");
    // The sign of the tip's way, and bounds of the share of it that the middle goes.
    let cases = [("a", -1.0, 0.0..0.3), ("b", 1.0, 0.3..0.7), ("c", 1.0, -2.0..0.0), ("d", -1.0, 0.35..0.7)];
    for (shape, way, share) in cases {
        let drawn = scene(&format!("figure_07{shape}.json"));
        let [tip, middle] = pressed(&drawn);
        let [mirror, _] = pressed(&mirrored(drawn));
        println!("{shape}: tip {tip:.3} mm, middle {middle:.3} mm, mirrored {mirror:.3} mm");
        assert!(way * tip > 0.3 && (tip + mirror).abs() < 0.01 * tip.abs(), "{shape}: {tip} and {mirror} mm");
        assert!(share.contains(&(middle / tip)), "{shape}: {middle} and {tip} mm");
    }
}

#[test]
fn figure_8_with_table_1s_values() {
    // The beginning of the first swing: the whole of it takes minutes. All else of the page: the test below.
    let shown = |name: &str, seconds: f64| {
        let runner = ran(&scene(name), seconds);
        (number(&runner, "height_loss"), vector(&runner, "middle").length())
    };
    let [(without, falling), (stiff, shaking), (with, middle), (foot, middle_with_foot)] =
        ["a", "b", "c", "d"].map(|part| shown(&format!("figure_08{part}.json"), 0.05));
    println!("height lost: {without:.3} without, {stiff:.3} stiff, {with:.3} with, {foot:.3} with more at the foot");
    println!("middle moved by {falling:.1}, {shaking:.1}, {middle:.1}, {middle_with_foot:.1} mm");
    assert!(without > 0.03 && without > 3.0 * with && without > 3.0 * foot, "{without}, {with}, {foot}");
    assert!(stiff.abs() < 0.01 && shaking < middle, "{stiff}, {shaking} mm");
    assert!(falling > 2.0 * middle && middle > 2.0 * middle_with_foot, "{falling}, {middle}, {middle_with_foot} mm");
    let (down, _) = shown("figure_08a.json", 0.5);
    assert!(down > 0.9, "it is down: {down}");
}

#[test]
#[ignore = "takes minutes; `cargo test --test physics figure_8 -- --ignored` runs it"]
fn figure_8_with_table_1s_values_to_its_end() {
    let lost = |part: &str| {
        let runner = ran(&scene(&format!("figure_08{part}.json")), 0.5);
        let lost = number(&runner, "height_loss");
        println!("{part}: height lost {lost:.3}, middle {:.1} mm", vector(&runner, "middle").length());
        lost
    };
    let (without, stiff, with, foot) = (lost("a"), lost("b"), lost("c"), lost("d"));
    assert!(without > 0.9 && stiff < 0.03 && with < 0.35 && foot < 0.35, "{without}, {stiff}, {with}, {foot}");
}

#[test]
fn figure_9_with_table_1s_values() {
    // Long enough for each to have been at its lowest.
    let sag = |name: &str| -vector(&ran(&scene(name), 0.12), "sag").y;
    let (soft, stiff, veined) = (sag("figure_09a.json"), sag("figure_09b.json"), sag("figure_09c.json"));
    println!("sag {soft:.2} mm without, {stiff:.2} mm stiff, {veined:.2} mm with");
    assert!(soft > 20.0 && veined > 1.0 && soft > 5.0 * veined, "{soft} and {veined} mm");
    assert!(stiff > 1.0 && soft > 5.0 * stiff, "{soft} and {stiff} mm");
}

#[test]
fn figure_10_with_table_1s_values() {
    let struck = |name: &str| {
        let runner = ran(&scene(name), 0.05);
        let places: Vec<BreakPlace> = runner.snapshot().bodies[0].breaks.iter().map(|one| one.place).collect();
        (-vector(&runner, "sag").y, places, runner)
    };
    let (torn, places, runner) = struck("figure_10.json");
    let (whole, none, _) = struck("figure_10_without.json");
    println!("sag {torn:.1} mm, {whole:.1} mm where nothing tears; {places:?}");
    assert!(whole > 20.0 && torn > 1.7 * whole, "{torn} and {whole} mm");
    // The upper strand alone tears, from where it is held on.
    let mut order: Vec<u32> = Vec::new();
    for place in &places {
        let BreakPlace::Edge(edge) = *place else { panic!("{places:?}") };
        order.push(edge);
    }
    assert!(order.len() > 5 && order.is_sorted() && order[0] == 0, "{order:?}");
    assert!(runner.snapshot().bodies[0].breaks.iter().all(|one| one.fibre == 0));
    assert_eq!(none, []);
}
