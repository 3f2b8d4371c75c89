//! `sinew compare`.

use super::Desk;
use serde_json::{Value, json};

fn ring() -> Value {
    json!({
        "version": 1, "name": "Ring", "gravity": [0, 0, 0], "time": {"duration": 0.4},
        "two_layer": [{
            "id": "ring", "shape": {"ring": {}}, "initial": {"deformation": [[1.2, 0, 0], [0, 0.9, 0], [0, 0, 1]]}
        }]
    })
}

#[test]
fn every_pair_runs_with_exactly_its_step() {
    let desk = Desk::new(&ring());
    let out =
        desk.done("compare scene.json --integrators euler,midpoint,rk4 --dt 0.001,0.02 --seconds 1 --report r.json");
    assert!(out.contains("blew up at") && out.contains("report written to r.json"), "{out}");
    let report = desk.json("r.json");
    assert_eq!(report["seconds"], 1.0);
    let runs = report["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 6);
    for (run, (integrator, dt)) in runs
        .iter()
        .zip(["explicit_euler", "midpoint", "rk4"].iter().flat_map(|name| [0.001, 0.02].map(|dt| (*name, dt))))
    {
        assert_eq!((run["integrator"].as_str(), run["dt"].as_f64()), (Some(integrator), Some(dt)), "{run}");
        let stable = dt < 0.01;
        assert_eq!(run["stable"], stable, "{run}");
        assert_eq!(run["blew_up_at"].is_null(), stable, "{run}");
        assert_eq!(run["energy_error"].is_number(), stable, "{run}");
        assert!(run["evaluations"].as_u64().unwrap() > 0 && run["wall_seconds"].as_f64().unwrap() > 0.0, "{run}");
    }
    // One, two and four evaluations a step, and one more of what is reported at the end of each.
    let evaluations = |index: usize| runs[index]["evaluations"].as_u64().unwrap() as f64 / 1000.0;
    assert!((1.0..1.1).contains(&evaluations(0)) && evaluations(2) <= 3.1 && evaluations(4) <= 5.1, "{report}");
}

#[test]
fn orders_are_fitted_and_drawn() {
    let desk = Desk::new(&ring());
    let out = desk
        .done("compare scene.json --integrators midpoint,rk4 --dt 5e-4,1e-3,2e-3 --order --plot o.svg --report r.json");
    assert!(out.contains("plot written to o.svg"), "{out}");
    let orders = &desk.json("r.json")["orders"];
    for (index, (name, expected)) in [("midpoint", 2.0), ("rk4", 4.0)].iter().enumerate() {
        assert_eq!(orders[index]["integrator"], *name);
        assert!((orders[index]["order"].as_f64().unwrap() - expected).abs() < 0.2, "{orders}");
    }
    let svg = desk.text("o.svg");
    assert!(svg.starts_with("<svg") && svg.contains("midpoint: 2.0") && svg.contains("rk4: 4."), "{svg}");
}

#[test]
fn fibre_solids_are_compared_too() {
    let mut scene = super::pressed();
    scene["bodies"][0]["pins"] = json!([]);
    scene["measures"] = json!([]);
    let desk = Desk::new(&scene);
    desk.done("compare scene.json --integrators leap_frog,symplectic_euler --dt 1e-4 --seconds 0.01 --report r.json");
    let runs = &desk.json("r.json")["runs"];
    assert!(runs[0]["stable"] == true && runs[1]["stable"] == true, "{runs}");
}

#[test]
fn bad_options_are_refused_in_words() {
    let desk = Desk::new(&ring());
    for arguments in ["--integrators rk5", "--dt 0", "--dt -1", "--seconds 0", "--dt x"] {
        let said = desk.run(&format!("compare scene.json {arguments}"));
        assert_eq!(said.code, Some(2), "{said:?}");
        assert!(said.err.contains("use one of") || said.err.contains("give a number"), "{}", said.err);
    }
    let error = desk.refused("compare scene.json --report scene.json");
    assert!(error.contains("same file"), "{error}");
}
