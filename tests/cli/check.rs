//! Looking a scene over.

use super::{Desk, pressed, two_blocks};
use serde_json::json;

#[test]
fn what_is_there_is_listed() {
    let desk = Desk::new(&pressed());
    let out = desk.done("check scene.json");
    assert!(
        out.starts_with("Pressed block: 0.1000 s in frames of 0.01667 s; bodies: 1, panels: 0, measures: 2\n"),
        "{out}"
    );
    let row = |start: &str| {
        let line = out.lines().find(|line| line.starts_with(start)).unwrap_or_else(|| panic!("{start}: {out}"));
        line.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    let block = row("Block  fibre_solid");
    assert_eq!((block[2].as_str(), block[4].as_str(), block[5].as_str()), ("96", "1", "5"));
    assert!(out.contains("0.01800 x 0.03000 x 0.01800") && block.last().unwrap() == "0.03840", "{out}");
    assert_eq!(row("top"), ["top", "Block", "16"]);
    assert_eq!(row("press"), ["press", "Block", "reaction_force", "N"]);
    assert_eq!(desk.files(), ["scene.json"]);
}

#[test]
fn sets_are_heeded_and_oddities_said() {
    let desk = Desk::new(&two_blocks());
    let said = desk.run("check scene.json --set /time/step={\"manual\":{\"dt\":1e-3,\"substeps_per_frame\":7}}");
    assert_eq!(said.code, Some(0));
    assert!(said.err.lines().all(|line| line.starts_with("warning: /time/step/manual/dt: ")), "{}", said.err);
    let stiff = said.out.lines().filter(|line| line.starts_with("Stiff block")).nth(1).unwrap();
    assert!(stiff.split_whitespace().any(|word| word == "7"), "{stiff}");

    let mut scene = pressed();
    for k in 0..15 {
        scene[format!("odd_{k:02}")] = json!(k);
    }
    let said = Desk::new(&scene).run("check scene.json");
    assert_eq!(said.err.lines().count(), 11, "{}", said.err);
    assert!(said.err.contains("warning: /odd_09: ") && said.err.contains("5 more unknown fields"), "{}", said.err);
}

#[test]
fn what_cannot_be_put_together_is_refused() {
    let mut scene = pressed();
    scene["bodies"][0]["regions"][0]["select"] = json!({"box": {"min": [1, 1, 1], "max": [2, 2, 2]}});
    let error = Desk::new(&scene).refused("check scene.json");
    assert!(error.starts_with("error: scene.json: /bodies/0/regions/0/select: "), "{error}");
}

#[test]
fn what_sets_the_time_step_is_said_by_check_summary_and_report() {
    let scene = json!({"version": 1, "gravity": [0, 0, 0], "time": {"duration": 0.1},
        "two_layer": [{"id": "ring", "shape": {"ring": {}}, "integrator": "rk4"},
            {"id": "free", "shape": {"segment": {}}, "placement": {"translation": [9, 0, 0]}, "integrator": "backward_euler"}]});
    let desk = Desk::new(&scene);
    for command in ["check scene.json", "simulate scene.json --report out.json"] {
        let out = desk.done(command);
        let limited = |start: &str| {
            let head = out.lines().find(|line| line.contains("limited by")).unwrap_or_else(|| panic!("{out}"));
            let below = out.lines().skip_while(|line| *line != head).find(|line| line.starts_with(start));
            let column = head.find("limited by").unwrap();
            below.and_then(|line| line.get(column..)?.split_whitespace().next()).unwrap_or_default().to_owned()
        };
        assert_eq!((limited("ring").as_str(), limited("free").as_str()), ("/two_layer/0/rkd", "-"), "{out}");
    }
    let report = desk.json("out.json");
    assert_eq!(report["bodies"][0]["limited_by"], "/two_layer/0/rkd");
    assert_eq!(report["bodies"][1]["limited_by"], json!(null));
}
