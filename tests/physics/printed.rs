//! The fibre paper's figures with Table 1's own values: what the soft companions show at a glance is there too, smaller
//! and within milliseconds.

use crate::figures::{mirrored, number, ran, scene, vector};

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
    let tip = |name: &str| vector(&ran(&scene(name), 0.008), "tip").x;
    let plain = tip("figure_07_without.json");
    assert!(plain.abs() < 0.01, "{plain} mm");
    for (shape, way) in [("a", -1.0), ("b", 1.0), ("c", 1.0), ("d", -1.0)] {
        let name = format!("figure_07{shape}.json");
        let (drawn, mirror) = (tip(&name), vector(&ran(&mirrored(scene(&name)), 0.008), "tip").x);
        println!("{shape}: tip {drawn:.3} mm, mirrored {mirror:.3} mm");
        assert!(way * drawn > 0.3 && (drawn + mirror).abs() < 0.01 * drawn.abs(), "{shape}: {drawn} and {mirror} mm");
    }
}

#[test]
fn figure_8_with_table_1s_values() {
    // The beginning of the first swing: the whole of it takes minutes.
    let shown = |name: &str| {
        let runner = ran(&scene(name), 0.05);
        (number(&runner, "height_loss"), vector(&runner, "middle").length())
    };
    let [(without, falling), (stiff, _), (with, middle), (foot, middle_with_foot)] =
        ["a", "b", "c", "d"].map(|part| shown(&format!("figure_08{part}.json")));
    println!("height lost: {without:.3} without, {stiff:.3} stiff, {with:.3} with, {foot:.3} with more at the foot");
    println!(
        "middle moved by {falling:.1} mm without, {middle:.1} mm with, {middle_with_foot:.1} mm with more at the foot"
    );
    assert!(without > 0.03 && without > 3.0 * with && without > 3.0 * foot, "{without}, {with}, {foot}");
    assert!(stiff.abs() < 0.01, "{stiff}");
    assert!(falling > 2.0 * middle && middle > 2.0 * middle_with_foot, "{falling}, {middle}, {middle_with_foot} mm");
}

#[test]
fn figure_9_with_table_1s_values() {
    // Half a swing, whatever its period.
    let sag = |name: &str| -vector(&ran(&scene(name), 0.1), "sag").y;
    let (soft, stiff, veined) = (sag("figure_09a.json"), sag("figure_09b.json"), sag("figure_09c.json"));
    println!("sag {soft:.1} mm without, {stiff:.1} mm stiff, {veined:.1} mm with");
    assert!(soft > 20.0 && veined > 1.0 && soft > 5.0 * veined, "{soft} and {veined} mm");
    assert!(stiff > 1.0 && soft > 5.0 * stiff, "{soft} and {stiff} mm");
}

#[test]
fn figure_10_with_table_1s_values() {
    let struck = |name: &str| {
        let runner = ran(&scene(name), 0.05);
        (-vector(&runner, "sag").y, runner.snapshot().bodies[0].breaks.clone())
    };
    let (torn, breaks) = struck("figure_10.json");
    let (whole, none) = struck("figure_10_without.json");
    println!("sag {torn:.1} mm, {whole:.1} mm where nothing tears");
    assert!(torn > 60.0 && whole < 0.0, "{torn} and {whole} mm");
    assert!(!breaks.is_empty() && breaks.iter().all(|one| one.fibre == 0), "only the upper strand tears: {breaks:?}");
    assert_eq!(none, []);
}
