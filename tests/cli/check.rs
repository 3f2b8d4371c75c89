//! Looking a scene over.

use super::{Desk, pressed, two_blocks};
use serde_json::{Value, json};

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

/// What is said of how a body of this shape is filled.
fn said_of(shape: &Value, files: &[(&str, String)]) -> String {
    let mut scene = pressed();
    let body = &mut scene["bodies"][0];
    body["shape"] = shape.clone();
    for list in ["fibres", "pins", "regions"] {
        body[list] = json!([]);
    }
    scene["measures"] = json!([]);
    let desk = Desk::new(&scene);
    for (name, text) in files {
        std::fs::write(desk.path(name), text).expect("written");
    }
    let said = desk.run("check scene.json");
    assert_eq!(said.code, Some(0), "{said:?}");
    said.err
}

/// An L whose arms are 3 x 6 mm thick, as wide again, extruded along x.
fn angle() -> String {
    let corners = [[-18, -18], [18, -18], [18, 0], [0, 0], [0, 18], [-18, 18]];
    let mut lines: Vec<String> = Vec::new();
    for x in [-45, 45] {
        lines.extend(
            corners.map(|[y, z]| format!("v {} {} {}", f64::from(x) / 1e3, f64::from(y) / 1e3, f64::from(z) / 1e3)),
        );
    }
    for k in 0..6 {
        let next = (k + 1) % 6;
        lines.push(format!("f {} {} {} {}", k + 1, next + 1, next + 7, k + 7));
    }
    lines.extend(["f 1 4 3 2", "f 1 6 5 4", "f 7 8 9 10", "f 7 10 11 12"].map(str::to_owned));
    lines.join("\n")
}

#[test]
fn how_far_off_theory_a_section_may_be_is_said_of_every_kind() {
    let boxed = |size: [f64; 3]| json!({"box": {"size": size}});
    let turned = json!({"box": {"size": [0.1, 0.02, 0.02], "lattice_rotation": {"axis": [1, 0, 0], "degrees": 22.5}}});
    let rod = json!({"cylinder": {"radius": 0.012, "height": 0.08}});
    let leaf = boxed([0.12, 0.018, 0.072]);
    let angled = json!({"mesh": {"path": "angle.obj"}});
    for (shape, starts) in [
        (&turned, "particles stand for"),
        (&rod, "particles stand for"),
        (
            &leaf,
            "it is filled by whole layers, 3.0 of them where it is thinnest, it may bend up to 9 % and twist up to 16 %",
        ),
        (
            &angled,
            "it is filled by whole layers, 3.0 of them where it is thinnest, it may bend up to 9 % and twist up to 16 %",
        ),
        (
            &boxed([0.072, 0.012, 0.012]),
            "2.0 of them where it is thinnest, it may bend up to 14 % and twist up to 24 % off",
        ),
    ] {
        let said = said_of(shape, &[("angle.obj", angle())]);
        let line = said.lines().find(|line| line.contains(starts)).unwrap_or_else(|| panic!("{shape}: {said}"));
        assert!(line.starts_with("note: /bodies/0/shape: ") && line.ends_with("% off theory"), "{line}");
    }
    // Within some per cent of theory.
    assert_eq!(said_of(&boxed([0.072, 0.018, 0.018]), &[]), "");
    assert_eq!(said_of(&boxed([0.12, 0.06, 0.12]), &[]), "");
}
