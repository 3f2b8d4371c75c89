//! What is doubtful about a start is said in the window, too, as it is on the command line.

use super::{is_settled, open, scene, until};
use serde_json::{Value, json};

fn block(id: &str, y: f64) -> Value {
    json!({"id": id, "name": format!("Block {id}"), "shape": {"box": {"size": [0.06, 0.06, 0.06]}},
        "placement": {"translation": [0, y, 0]},
        "material": {"young_modulus": 2e5, "mass": {"density": 1000}, "support_radius": 0.05},
        "regions": [{"id": "bottom", "select": {"layers": {"axis": "y", "side": "min", "count": 1}}},
            {"id": "top", "select": {"layers": {"axis": "y", "side": "max", "count": 1}}}]})
}

fn with(what: &str, value: Value) -> Value {
    let mut body = block("b", 0.1);
    body[what] = value;
    body
}

/// What the window says of a scene as it is opened.
fn said(bodies: &[Value], two_layer: &[Value]) -> String {
    let text = json!({"version": 1, "room": {"floor": 0}, "bodies": bodies, "two_layer": two_layer}).to_string();
    let mut window = open(scene(&text));
    until(&mut window, is_settled);
    window.step();
    window.state().message().unwrap_or_default().to_owned()
}

#[test]
fn a_doubtful_start_is_said_with_its_figure_and_what_to_do() {
    let ball = json!({"id": "t", "name": "Ball", "shape": {"ball": {"subdivisions": 1}}});
    let slide = json!({"ramp": {"direction": [1, 0, 0], "distance": {"metres": 0.01}, "duration": 0.1}});
    let jump = json!({"keyframes": [{"time": 0, "offset": [0, 0, 0]}, {"time": 1e-6, "offset": [100, 0, 0]}]});
    let conflict = json!([{"id": "p", "region": "bottom"}, {"id": "q", "region": "bottom", "motion": slide}]);
    let torn = json!([{"id": "p", "region": "bottom"}, {"id": "q", "region": "top", "motion": jump}]);
    let folded = json!([{"id": "f", "source": {"vertices": [[0, -0.02, 0], [0, 0.02, 0], [0, -0.02, 0]]},
        "stiffness": {"rigidity": {"ea": 1000, "ei": 1}}, "volume_fraction": 0.3, "rest_shape": "as_drawn"}]);
    for (bodies, two_layer, words) in [
        (vec![block("b", 0.05), block("c", 0.07)], vec![], ["inside the body", "eased apart", "move it by"]),
        (vec![block("b", 0.0)], vec![], ["inside the floor", "0.03", "eased out"]),
        (vec![], vec![ball], ["inside the floor", "eased out", "move it by"]),
        (vec![with("pins", conflict)], vec![], ["share", "along x", "one pin"]),
        (vec![with("pins", torn)], vec![], ["faster than a push travels", "more time", "pin"]),
        (vec![with("fibres", folded)], vec![], ["180 degrees", "0.02", "two fibres"]),
    ] {
        let said = said(&bodies, &two_layer);
        assert!(words.iter().all(|word| said.contains(word)), "{words:?}: {said}");
    }
    // What can be meant is not.
    let said = said(&[block("b", 0.1)], &[]);
    assert!(!said.contains("inside") && !said.contains("eased"), "{said}");
}
