//! `sinew converge`: a body of fixed size, filled more finely.

use super::{Desk, pressed};
use serde_json::{Value, json};

#[test]
fn a_body_is_filled_more_finely_and_stays_as_large_and_heavy() {
    let mut scene = pressed();
    // Clamped and pressed by size, not by layers, and heavy.
    scene["gravity"] = json!([0, -9.81, 0]);
    scene["bodies"][0]["regions"] = json!([
        {"id": "bottom", "select": {"box": {"min": [-1, -1, -1], "max": [1, 0.009, 1]}}},
        {"id": "top", "select": {"box": {"min": [-1, 0.027, -1], "max": [1, 1, 1]}}}
    ]);
    scene["bodies"][0]["fibres"] = json!([]);
    let desk = Desk::new(&scene);
    let out = desk.done("converge scene.json --layers 4,2,6 --fps 50 --seconds 0.06 --report r.json --plot p.svg");
    let report = desk.json("r.json");
    let runs = report["runs"].as_array().unwrap();
    let layers: Vec<u64> = runs.iter().map(|run| run["layers"].as_u64().unwrap()).collect();
    assert_eq!(layers, [2, 4, 6]);
    for (run, spacing) in runs.iter().zip([0.012, 0.006, 0.004]) {
        assert!((run["spacing"].as_f64().unwrap() / spacing - 1.0).abs() < 1e-12, "{run}");
    }
    assert_eq!(runs[1]["particles"], 4 * 6 * 4);
    // At four layers it is the scene as it stands.
    desk.done("simulate scene.json --fps 50 --seconds 0.06 --report one.json");
    let press = desk.json("one.json")["measures"][0]["value"].as_f64().unwrap();
    let found = runs[1]["values"][0].as_f64().unwrap();
    assert!((found / press - 1.0).abs() < 1e-9, "{found} {press}");
    assert_eq!(report["limits"][0]["measure"], "press");
    let lines: Vec<&str> = out.lines().collect();
    assert!(
        lines[0].contains("press [N]") && lines.iter().any(|line| line.trim_start().starts_with("extrapolated")),
        "{out}"
    );
    assert_eq!(desk.text("p.svg").matches("<polyline").count(), 2);
    let said = desk.refused("converge scene.json --body leaf --report s.json");
    assert!(said.contains("--body leaf") && said.contains("known: block"), "{said}");
}

#[test]
fn a_box_that_is_held_by_its_layers_converges_by_an_order_between_one_and_two() {
    let mut scene = pressed();
    let body = &mut scene["bodies"][0];
    // Whole layers at every resolution.
    body["shape"] = json!({"box": {"center": [0, 0.024, 0], "size": [0.024, 0.048, 0.024]}});
    body["material"]["mass"] = json!({"density": 1850});
    body["fibres"] = json!([]);
    body["pins"][1] = json!({"id": "push", "region": "top", "motion": {"ramp": {
        "direction": [0, -1, 0], "distance": {"metres": 0.0004}, "duration": 0.05}}});
    let desk = Desk::new(&scene);
    desk.done("converge scene.json --layers 3,4,5,6 --until-rest --seconds 1 --report r.json");
    let report = desk.json("r.json");
    let of = |run: &Value| (run["spacing"].as_f64().unwrap(), run["values"][0].as_f64().unwrap());
    let runs: Vec<(f64, f64)> = report["runs"].as_array().unwrap().iter().map(of).collect();
    assert!(report["runs"].as_array().unwrap().iter().all(|run| run["at_rest"] == true), "{report}");
    // Particles are held at their centres, half a spacing within the faces: between them it is shorter by a spacing,
    // and stiffer by that, an error of first order, which is half of all.
    let order = report["limits"][0]["order"].as_f64().unwrap();
    assert!((1.2..1.8).contains(&order), "{order}: {runs:?}");
    let left: Vec<(f64, f64)> = runs.iter().map(|&(spacing, press)| (spacing, press * (0.048 - spacing))).collect();
    let [first, .., last] = left[..] else { panic!("four runs") };
    let found = (first.1 / last.1 - 1.0) / (runs[0].1 / runs[3].1 - 1.0);
    assert!((0.3..0.7).contains(&found), "{found} of the difference is left: {left:?}");
    // EA over the height, and more where both ends keep their width.
    let hooke = 1e4 * 0.024 * 0.024 * 0.0004 / 0.048;
    let limit = report["limits"][0]["value"].as_f64().unwrap() / hooke;
    assert!((1.0..1.15).contains(&limit), "{limit}");
}

/// Whatever fills a lattice, one that is round or a mesh too, by its thickness and at the same mass.
#[test]
fn shapes_that_are_no_boxes_are_filled_more_finely_too() {
    let mut scene = pressed();
    // Held altogether, it weighs on what holds it.
    scene["gravity"] = json!([0, -10, 0]);
    let all = json!({"id": "all", "select": {"box": {"min": [-1, -1, -1], "max": [1, 1, 1]}}});
    let weight = json!({"reaction_force": {"region": "all", "along": [0, 1, 0]}});
    scene["measures"] = json!([{"name": "weight", "body": "block", "kind": weight}]);
    let body = &mut scene["bodies"][0];
    body["regions"] = json!([all]);
    body["pins"] = json!([{"id": "hold", "region": "all"}]);
    body["fibres"] = json!([]);
    body["material"]["mass"] = json!({"density": 1000});
    let round = json!({"torus": {"radius": 0.03, "tube_radius": 0.01}});
    let mesh = json!({"mesh": {"path": "prism.obj", "particles": 300}});
    let prism_volume = 0.5 * 0.03 * 0.03 * 0.05;
    for (shape, thickness, volume) in
        [(round, 0.02, 2.0 * std::f64::consts::PI.powi(2) * 0.03 * 1e-4), (mesh, 0.03, prism_volume)]
    {
        scene["bodies"][0]["shape"] = shape.clone();
        let desk = Desk::new(&scene);
        std::fs::write(desk.path("prism.obj"), PRISM).unwrap();
        desk.done("converge scene.json --layers 3,5 --fps 50 --seconds 0.02 --report r.json");
        let runs = desk.json("r.json")["runs"].clone();
        for (run, layers) in runs.as_array().unwrap().iter().zip([3.0, 5.0]) {
            let spacing = run["spacing"].as_f64().unwrap();
            assert!((spacing * layers / thickness - 1.0).abs() < 1e-9, "{shape} {run}");
            let mass = 0.1 * run["values"][0].as_f64().unwrap().abs();
            assert!((mass / (1000.0 * volume) - 1.0).abs() < 0.02, "{shape} {run}: {volume}");
        }
        assert!(runs[1]["particles"].as_u64() > runs[0]["particles"].as_u64(), "{runs}");
    }
}

/// A prism over a right-angled triangle of 30 by 30 mm, 50 mm high.
const PRISM: &str = "\
v 0 0 0
v 0.03 0 0
v 0 0 0.03
v 0 0.05 0
v 0.03 0.05 0
v 0 0.05 0.03
f 1 2 3
f 4 6 5
f 1 4 5 2
f 2 5 6 3
f 3 6 4 1
";
