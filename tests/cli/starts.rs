//! What is doubtful about a start is said: once, with its figure and what to do, by `check`, by a run and in its
//! report.

use super::Desk;
use serde_json::{Value, json};

fn block(id: &str, y: f64) -> Value {
    json!({"id": id, "shape": {"box": {"center": [0, 0, 0], "size": [0.06, 0.06, 0.06]}},
        "placement": {"translation": [0, y, 0]},
        "material": {"young_modulus": 2e5, "poisson_ratio": 0.33, "mass": {"density": 1000}, "support_radius": 0.025},
        "regions": [{"id": "bottom", "select": {"layers": {"axis": "y", "side": "min", "count": 1}}},
            {"id": "top", "select": {"layers": {"axis": "y", "side": "max", "count": 1}}}]})
}

fn ball(id: &str, y: f64) -> Value {
    json!({"id": id, "shape": {"ball": {"subdivisions": 1}}, "placement": {"translation": [0, y, 0]},
        "integrator": "rk4"})
}

fn scene(bodies: &[Value], two_layer: &[Value], room: &Value) -> Value {
    json!({"version": 1, "gravity": [0, -9.81, 0], "time": {"frames_per_second": 60, "duration": 0.02},
        "bodies": bodies, "two_layer": two_layer, "room": room})
}

fn floor() -> Value {
    json!({"floor": 0})
}

fn pinned(y: f64, pins: Value, room: &Value) -> Value {
    let mut body = block("b", y);
    body["pins"] = pins;
    scene(&[body], &[], room)
}

/// The one warning, which the run and its report repeat.
fn warning(scene: &Value) -> String {
    let desk = Desk::new(scene);
    let checked = desk.run("check scene.json");
    assert_eq!(checked.code, Some(0), "{checked:?}");
    let warnings: Vec<&str> = checked.err.lines().filter(|line| line.starts_with("warning: ")).collect();
    let [warning] = warnings[..] else { panic!("one warning: {checked:?}") };
    let ran = desk.run("simulate scene.json --seconds 0.01 --report out.json");
    assert!(ran.err.contains(warning), "{ran:?}");
    let report: Value =
        serde_json::from_str(&std::fs::read_to_string(desk.path("out.json")).expect("a report")).expect("JSON");
    let notes: Vec<&str> = report["notes"].as_array().expect("notes").iter().filter_map(Value::as_str).collect();
    assert!(notes.contains(&warning), "{notes:?}");
    warning.to_owned()
}

fn said(scene: &Value, parts: &[&str]) {
    let warning = warning(scene);
    for part in parts {
        assert!(warning.contains(part), "{part}: {warning}");
    }
}

#[test]
fn bodies_that_overlap_are_said() {
    let half =
        ["/bodies/1/placement/translation", "\"c\"", "inside the body \"b\"", "0.04", "eased apart", "move it by"];
    said(&scene(&[block("b", 0.05), block("c", 0.07)], &[], &floor()), &half);
    said(&scene(&[block("b", 0.05), block("c", 0.05)], &[], &floor()), &["wholly inside the body \"b\"", "0.06"]);
    let deep = ["/two_layer/1/placement", "inside the body \"t\"", "eased apart", "m/s"];
    said(&scene(&[], &[ball("t", 3.0), ball("u", 4.0)], &floor()), &deep);
    said(&scene(&[], &[ball("t", 3.0), ball("u", 3.0)], &floor()), &deep);
}

#[test]
fn bodies_in_the_floor_a_wall_or_a_panel_are_said() {
    said(
        &scene(&[block("b", 0.0)], &[], &floor()),
        &["108 of its 216", "inside the floor", "0.03", "[0, 0.03", "eased out"],
    );
    said(&scene(&[block("b", -1.0)], &[], &floor()), &["wholly inside the floor", "1.03", "eased out"]);
    said(&scene(&[], &[ball("t", -3.0)], &floor()), &["wholly inside the floor", "5.0", "eased out"]);
    said(&scene(&[], &[ball("t", 0.0)], &floor()), &["inside the floor", "2.0", "eased out"]);
    said(&scene(&[block("b", 1.0)], &[], &json!({"x_max": 0.01})), &["inside the wall x_max", "[-0.02", "eased out"]);
    let mut lid = scene(&[block("b", 1.0)], &[], &floor());
    lid["panels"] =
        json!([{"id": "lid", "height": 1.0, "size": [1, 1], "motion": {"driven": [{"time": 0, "height": 1.0}]}}]);
    said(&lid, &["inside the panel \"lid\"", "0.03", "eased out below it"]);
}

#[test]
fn pins_that_cannot_be_meant_are_said() {
    let ramp = |distance: f64, duration: f64, direction: [f64; 3]| {
        let distance = json!({"metres": distance});
        json!({"ramp": {"direction": direction, "distance": distance, "duration": duration}})
    };
    let aside = ramp(0.01, 0.1, [1.0, 0.0, 0.0]);
    let both = json!([{"id": "p", "region": "bottom"}, {"id": "q", "region": "bottom", "motion": aside}]);
    let conflict = ["/bodies/0/pins/1", "\"p\" and \"q\" share 36 particles", "0.01", "along x", "one pin"];
    said(&pinned(0.1, both, &json!({})), &conflict);
    let two = |motion: Value| json!([{"id": "p", "region": "bottom"}, {"id": "q", "region": "top", "motion": motion}]);
    let torn = ["/bodies/0/pins/1", "faster than a push travels", "more time"];
    said(&pinned(0.1, two(ramp(0.05, 1e-9, [1.0, 0.0, 0.0])), &json!({})), &torn);
    let keys = json!({"keyframes": [{"time": 0, "offset": [0, 0, 0]}, {"time": 1e-6, "offset": [100, 0, 0]}]});
    said(&pinned(0.1, two(keys), &json!({})), &torn);
    let away = json!({"keyframes": [{"time": 0, "offset": [0.5, 0, 0]}, {"time": 1, "offset": [0.5, 0, 0]}]});
    said(&pinned(0.1, two(away), &json!({})), &torn);
    let down = json!([{"id": "p", "region": "top", "motion": ramp(0.2, 0.2, [0.0, -1.0, 0.0])}]);
    said(&pinned(0.03, down, &floor()), &["/bodies/0/pins/0", "0.145", "beyond the floor", "end the move"]);
}

#[test]
fn what_can_be_meant_is_not_said() {
    let quiet = |scene: &Value| assert_eq!(Desk::new(scene).run("check scene.json").err, "", "{scene}");
    quiet(&scene(&[block("b", 0.03), block("c", 0.09)], &[ball("t", 3.0)], &floor()));
    let held = json!([{"id": "p", "region": "bottom"}, {"id": "q", "region": "bottom", "axes": ["y"]},
        {"id": "r", "region": "top", "motion": {"ramp":
            {"direction": [0, -1, 0], "distance": {"fraction": 0.2}, "duration": 0.3}}}]);
    quiet(&pinned(0.03, held, &floor()));
    // A root that is held in the floor is not pushed out of it.
    quiet(&pinned(0.025, json!([{"id": "p", "region": "bottom"}]), &floor()));
}

#[test]
fn a_fibre_that_folds_back_is_said() {
    let folded = |vertices: Value| {
        let mut body = block("b", 0.1);
        body["shape"]["box"]["size"] = json!([0.06, 0.12, 0.06]);
        body["fibres"] = json!([{"id": "f", "source": {"vertices": vertices},
            "stiffness": {"rigidity": {"ea": 1000, "ei": 1}}, "volume_fraction": 0.3, "rest_shape": "as_drawn"}]);
        scene(&[body], &[], &floor())
    };
    let sharp = folded(json!([[0, -0.05, 0], [0, 0.05, 0], [0, -0.05, 0]]));
    said(&sharp, &["/bodies/0/fibres/0", "180 degrees", "[0, 0.05", "two fibres"]);
    let square = folded(json!([[0, -0.05, 0], [0, 0.02, 0], [0.02, 0.02, 0]]));
    assert_eq!(Desk::new(&square).run("check scene.json").err, "");
}

#[test]
fn a_poisson_ratio_below_zero_is_refused_with_its_range() {
    let mut body = block("b", 0.1);
    body["material"]["poisson_ratio"] = json!(-0.2);
    let error = Desk::new(&scene(&[body], &[], &floor())).refused("check scene.json");
    assert!(error.contains("/bodies/0/material/poisson_ratio: -0.2 is out of range; give a number from 0"), "{error}");
}
