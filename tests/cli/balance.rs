//! A run that gains energy says so, and ends as one that diverged once nothing is left of its motion.

use super::{Desk, pressed};
use serde_json::{Value, json};

/// A strained block that nothing damps or holds, under explicit Euler.
pub(super) fn gaining() -> Value {
    let mut scene = pressed();
    let block = &mut scene["bodies"][0];
    block["pins"] = json!([]);
    block["fibres"] = json!([]);
    block["material"]["damping"] = json!({"pair": 0, "air": 0});
    block["initial"] = json!({"deformation": [[1.1, 0.05, 0], [0, 0.95, 0], [0, 0, 1]]});
    block["integrator"] = json!("explicit_euler");
    scene["measures"] = json!([]);
    scene["time"] = json!({"duration": 0.2, "step": {"manual": {"dt": 1e-4, "substeps_per_frame": 20}}});
    scene
}

#[test]
fn a_gain_is_warned_of_and_stands_in_the_report() {
    let desk = Desk::new(&gaining());
    let said = desk.run("simulate scene.json --seconds 0.006 --report report.json");
    assert_eq!(said.code, Some(0), "{said:?}");
    let warning = said.err.lines().find(|line| line.contains("that nothing gave")).expect("a warning");
    for part in ["warning: body \"Block\" gained", "explicit_euler", "/time/step/manual/dt", "/bodies/0/integrator"] {
        assert!(warning.contains(part), "{part}: {warning}");
    }
    let report = desk.json("report.json");
    assert_eq!(report["unbalanced"].as_array().map(Vec::len), Some(1), "{}", report["unbalanced"]);
    assert!(warning.ends_with(report["unbalanced"][0].as_str().expect("words")), "{warning}");
    let accuracy = &report["bodies"][0]["accuracy"];
    let [gained, handled] = ["energy_gained", "energy_handled"].map(|name| accuracy[name].as_f64().expect("a number"));
    assert!(gained > 0.02 * handled && gained < handled, "{accuracy}");
    // Nothing but its own forces acts on it.
    let drift = accuracy["linear_momentum_drift"].as_f64().expect("a number");
    assert!(drift < 1e-9, "{accuracy}");
}

#[test]
fn what_has_gained_all_that_it_had_ends_with_3() {
    let desk = Desk::new(&gaining());
    let said = desk.run("simulate scene.json --report report.json");
    assert_eq!(said.code, Some(3), "{said:?}");
    let lines: Vec<&str> = said.err.lines().filter(|line| line.contains("that nothing gave")).collect();
    assert!(lines.len() == 2 && lines[0].starts_with("warning: "), "{lines:?}");
    assert!(lines[1].starts_with("error: body \"Block\" diverged at ") && lines[1].contains("100 %"), "{lines:?}");
    assert!(desk.json("report.json")["bodies"][0]["diverged"].is_string());
    assert_eq!(desk.run("simulate scene.json --set /bodies/0/integrator=\"leap_frog\"").code, Some(0));
}

#[test]
fn a_sweep_says_which_of_its_rows_gained() {
    let desk = Desk::new(&gaining());
    let said = desk.run(
        "sweep scene.json --seconds 0.006 --vary /bodies/0/integrator=\"explicit_euler\",\"leap_frog\" --report r.json",
    );
    let lines: Vec<&str> = said.err.lines().filter(|line| line.contains("that nothing gave")).collect();
    assert!(lines.len() == 1 && lines[0].contains("explicit_euler"), "{said:?}");
    let rows = &desk.json("r.json")["rows"];
    assert_eq!(rows[1]["unbalanced"], json!([]), "{rows}");
}
