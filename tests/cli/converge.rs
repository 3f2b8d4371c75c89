//! `sinew converge`: a body of fixed size, filled more finely.

use super::{Desk, pressed};
use serde_json::json;

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
