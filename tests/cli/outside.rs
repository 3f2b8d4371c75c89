//! Commands read models outside of a scene's folder only where they are told to.

use super::Desk;
use serde_json::{Value, json};
use std::fs;

fn scene(path: &str) -> Value {
    json!({"version": 1, "bodies": [{"id": "cube", "shape": {"mesh": {"path": path}},
        "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.015}}]})
}

#[test]
fn models_that_lie_elsewhere_are_read_where_that_is_said() {
    let desk = Desk::new(&scene("../models/cube.obj"));
    for folder in ["scenes", "models", "assets"] {
        fs::create_dir(desk.path(folder)).expect("made");
    }
    let corner =
        |k| format!("v {} {} {}\n", 0.03 * f64::from(k & 1), 0.03 * f64::from(k >> 1 & 1), 0.03 * f64::from(k >> 2));
    let corners: Vec<String> = (0..8).map(corner).collect();
    let cube = corners.concat() + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    for model in ["models/cube.obj", "assets/cube.obj"] {
        fs::write(desk.path(model), &cube).expect("written");
    }
    let put = |path: &str| fs::write(desk.path("scenes/scene.json"), scene(path).to_string()).expect("written");
    put("../models/cube.obj");
    for command in [
        "check scenes/scene.json",
        "simulate scenes/scene.json --seconds 0 --report report.json",
        "collect scenes/scene.json --out there",
        "fibres scenes/scene.json --to lines.csv",
    ] {
        let line = desk.refused(command);
        assert!(line.contains("cube.obj") && line.contains("--outside"), "{command}: {line}");
    }
    assert!(!desk.path("report.json").exists() && !desk.path("there").exists(), "nothing is written");
    desk.ran("check scenes/scene.json --outside");
    // Collected, it is its own.
    desk.ran("collect scenes/scene.json --outside --out there");
    desk.ran("check there/scene.json");
    for path in ["../assets/cube.obj", "../scenes/../assets/cube.obj"] {
        put(path);
        desk.ran("check scenes/scene.json");
    }
    // Whether there is such a file is not told.
    put("../../nowhere.obj");
    let line = desk.refused("check scenes/scene.json");
    assert!(line.contains("outside of its folder"), "{line}");
    // A value that is set counts as one of the file.
    put("../assets/cube.obj");
    desk.refused("check scenes/scene.json --set /bodies/0/shape/mesh/path=\"../models/cube.obj\"");
    // So does one that a sweep tries, before any is run.
    let vary = "--vary /bodies/0/shape/mesh/path=\"../assets/cube.obj\",\"../models/cube.obj\"";
    let sweep = format!("sweep scenes/scene.json --seconds 0 --report rows.json {vary}");
    let line = desk.refused(&sweep);
    assert!(line.contains("models/cube.obj") && line.contains("--outside"), "{line}");
    assert!(!desk.path("rows.json").exists(), "nothing is run");
    desk.ran(&format!("{sweep} --outside"));
}

#[test]
fn a_recording_reads_its_own_models_only() {
    let desk = Desk::new(&scene("cube.obj"));
    fs::create_dir(desk.path("there")).expect("made");
    let journal = json!({"program": "1", "scene": scene("../cube.obj"), "asked": [], "hashes": ["0"]});
    fs::write(desk.path("there/journal.json"), journal.to_string()).expect("written");
    let line = desk.refused("replay there/journal.json");
    assert!(line.contains("outside of its folder") && line.contains("cube.obj"), "{line}");
    let line = desk.refused("replay there/journal.json --outside");
    assert!(!line.contains("outside of its folder"), "it is looked for now: {line}");
}
