//! Runs of all kinds are made again from their reports, to the same bits.

use super::{Desk, pressed, two_blocks};
use serde_json::{Value, json};
use std::fmt::Write;
use std::fs;

/// A bar that acts, with wind and a panel: what changes in time has to begin where it began.
fn driven() -> Value {
    let mut scene = pressed();
    scene["gravity"] = json!([0, -9.81, 0]);
    scene["room"] = json!({"floor": 0});
    scene["wind"] = json!({"velocity": [0.5, 0, 0], "drive": {"wave": {"period": 0.05}}});
    scene["panels"] = json!([{"id": "lid", "height": 0.04, "size": [0.1, 0.1], "mass": 0.02, "motion": "falls"}]);
    scene["bodies"][0]["pins"] = json!([]);
    scene["bodies"][0]["fibres"][0]["activation"] = json!({"drive": {"wave": {"period": 0.04}}, "contract": 0.1});
    scene["measures"] = json!([{"name": "lid", "body": "block", "kind": {"panel_force": {"panel": "lid"}}}]);
    scene
}

fn two_layer() -> Value {
    json!({"version": 1, "name": "Ring", "room": {"floor": -3}, "time": {"duration": 0.1},
        "two_layer": [{"id": "ring", "shape": {"ring": {}}, "initial": {"angular_velocity": [0, 0, 90]}}]})
}

#[test]
fn twenty_reports_are_repeated_to_the_same_bits() {
    let mut made = 0;
    for (scene, integrators) in [
        (pressed(), ["leap_frog", "feynman", "tr_bdf2", "rk4", "fibres_implicit"]),
        (two_blocks(), ["automatic", "verlet", "symplectic_euler", "bdf2", "midpoint"]),
        (driven(), ["automatic", "leap_frog", "feynman", "newmark", "implicit_midpoint"]),
        (two_layer(), ["automatic", "sdirk2", "rk4", "explicit_euler", "backward_euler"]),
    ] {
        let desk = Desk::new(&scene);
        let list = if scene["two_layer"].is_array() { "two_layer" } else { "bodies" };
        for (k, integrator) in integrators.into_iter().enumerate() {
            let (fps, threads) = ([60, 100, 125, 75, 90][k], 1 + k % 3);
            desk.ran(&format!(
                "simulate scene.json --seconds 0.03 --fps {fps} --threads {threads} --set /{list}/0/integrator=\"{integrator}\" \
                 --set /gravity/0=0.{k}1 --report r.json"
            ));
            let report = desk.json("r.json");
            assert!(report["run"]["word_bits"].is_u64() && report["run"]["scene_hash"].is_string());
            assert!(report["bodies"][0]["integrator"].is_string() && report["bodies"][0]["dt"].is_f64());
            let said = desk.run(&format!("simulate --from r.json --threads {} --report again.json", 3 - k % 3));
            assert_eq!(said.code, Some(0), "{integrator}: {said:?}");
            assert!(said.err.contains("the same bits as in r.json"), "{integrator}: {said:?}");
            assert_eq!(desk.json("again.json")["measures"], report["measures"], "{integrator}");
            made += 1;
        }
    }
    assert_eq!(made, 20);
}

#[test]
fn a_model_that_is_not_what_it_was_is_told_of() {
    let cube = |top: f64| {
        let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(|side| side as f64 * 0.03);
        let mut text = String::new();
        for k in 0..8 {
            let [x, y, z] = corner(k);
            writeln!(text, "v {x} {} {z}", if y > 0.0 { top } else { y }).expect("text");
        }
        for face in ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"] {
            writeln!(text, "f {face}").expect("text");
        }
        text
    };
    let mut scene = pressed();
    scene["bodies"][0]["shape"] = json!({"mesh": {"path": "cube.obj"}});
    for list in ["fibres", "pins", "regions"] {
        scene["bodies"][0][list] = json!([]);
    }
    scene["measures"] = json!([]);
    scene["bodies"][0]["initial"] = json!({"angular_velocity": [0, 90, 0]});
    let desk = Desk::new(&scene);
    fs::write(desk.path("cube.obj"), cube(0.03)).expect("written");
    desk.ran("simulate scene.json --seconds 0.02 --report r.json");
    let hash = desk.json("r.json")["run"]["scene_hash"].clone();
    let again = desk.run("simulate --from r.json --report s.json");
    assert!(again.code == Some(0) && !again.err.contains("is not what it was"), "{again:?}");
    assert_eq!(desk.json("s.json")["run"]["scene_hash"], hash);
    // Nothing of it moves otherwise: it is told by the file.
    fs::write(desk.path("cube.obj"), format!("# as before\n{}", cube(0.03))).expect("written");
    let again = desk.run("simulate --from r.json");
    assert!(again.code == Some(0) && again.err.contains("or a model of it is not what it was"), "{again:?}");
    assert!(again.err.contains("the same bits as in r.json"), "{again:?}");
    fs::write(desk.path("cube.obj"), cube(0.036)).expect("written");
    let again = desk.run("simulate --from r.json");
    assert_eq!(again.code, Some(1), "{again:?}");
    assert!(again.err.contains("or a model of it is not what it was"), "{again:?}");
}
