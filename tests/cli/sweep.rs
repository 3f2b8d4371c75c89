//! The product of several values.

use super::{Desk, pressed, two_blocks};
use serde_json::{Value, json};

const FRACTION: &str = "/bodies/0/pins/1/motion/ramp/distance/fraction";
const MODULUS: &str = "/bodies/0/material/young_modulus";

#[test]
fn every_combination_is_a_row_and_equals_the_run_of_its_own() {
    let desk = Desk::new(&pressed());
    let out = desk.done(&format!(
        "sweep scene.json --vary {MODULUS}=1e4,2e4 --vary {FRACTION}=0.01,0.05,0.1 --threads 2 --report sweep.json"
    ));
    let report = desk.json("sweep.json");
    assert_eq!(report["scene"], "Pressed block");
    assert_eq!(report["vary"][1], json!({"pointer": FRACTION, "values": [0.01, 0.05, 0.1]}));
    let rows = report["rows"].as_array().unwrap();
    let values: Vec<(f64, f64)> = rows
        .iter()
        .map(|row| (row["values"][MODULUS].as_f64().unwrap(), row["values"][FRACTION].as_f64().unwrap()))
        .collect();
    assert_eq!(values, [(1e4, 0.01), (1e4, 0.05), (1e4, 0.1), (2e4, 0.01), (2e4, 0.05), (2e4, 0.1)]);
    for (row, (modulus, fraction)) in rows.iter().zip(values) {
        desk.done(&format!(
            "simulate scene.json --threads 1 --set {MODULUS}={modulus} --set {FRACTION}={fraction} --report one.json"
        ));
        let one = desk.json("one.json");
        assert_eq!(row["measures"]["press"], one["measures"][0]["value"]);
        assert_eq!(row["measures"]["drift"], one["measures"][1]["value"]);
        assert_eq!(row["bodies"], one["bodies"]);
        assert_eq!((&row["seconds"], &row["at_rest"]), (&one["seconds"], &one["at_rest"]));
        assert_eq!(row["diverged"], Value::Null);
        assert!(row["wall_seconds"].as_f64() > Some(0.0));
    }
    // The head, six rows, and where the report went.
    let lines: Vec<&str> = out.lines().collect();
    assert_eq!(lines.len(), 9, "{out}");
    assert!(lines[0].contains(FRACTION) && lines[0].contains("press [N]") && lines[0].contains("drift [mm]"), "{out}");
    assert_eq!(lines[8], "report written to sweep.json");
}

#[test]
fn parallel_rows_are_the_serial_ones() {
    let desk = Desk::new(&pressed());
    let rows = |threads: u32| {
        desk.done(&format!(
            "sweep scene.json --vary {FRACTION}=0.01,0.02,0.03,0.04,0.05 --fps 100 --threads {threads} --report r.json"
        ));
        let mut report = desk.json("r.json");
        for row in report["rows"].as_array_mut().unwrap() {
            row.as_object_mut().unwrap().remove("wall_seconds");
        }
        report
    };
    assert_eq!(rows(1), rows(4));
}

#[test]
fn arrays_and_text_can_be_varied() {
    let desk = Desk::new(&pressed());
    let out = desk.done("sweep scene.json --vary /gravity=[0,-9.81,0],[0,0,0] --vary /bodies/0/integrator=\"rk4\",\"midpoint\" --seconds 0.02");
    assert_eq!(out.lines().count(), 5, "{out}");
    assert!(out.contains("[0,-9.81,0]") && out.contains("\"midpoint\""), "{out}");
}

#[test]
fn a_bad_value_is_found_before_anything_runs() {
    let desk = Desk::new(&pressed());
    let error = desk.refused(&format!("sweep scene.json --vary {MODULUS}=1e4,-1 --report r.json"));
    assert!(error.contains(&format!("{MODULUS}=-1")) && error.contains("-1"), "{error}");
    // Found only when the scene is put together: one layer of particles.
    let error = desk.refused("sweep scene.json --vary /bodies/0/shape/box/size/0=0.024,0.006 --report r.json");
    assert!(error.contains("/bodies/0/shape/box/size/0=0.006: scene.json: "), "{error}");
    let error = desk.refused(&format!("sweep scene.json --vary {MODULUS}=1 --vary {MODULUS}=2 --report r.json"));
    assert!(error.contains("varied twice"), "{error}");
    let error = desk.refused("sweep scene.json --vary /bodies/0/weight=1 --report r.json");
    assert!(error.contains("is no member of /bodies/0"), "{error}");
    for bad in ["/gravity", "/gravity=", "/gravity=1,"] {
        let said = desk.run(&format!("sweep scene.json --vary {bad} --report r.json"));
        assert_eq!((said.code, desk.files()), (Some(2), vec!["scene.json".to_owned()]), "{said:?}");
    }
}

#[test]
fn rows_that_diverge_are_reported_with_the_others() {
    let desk = Desk::new(&two_blocks());
    let said = desk.run(
        "sweep scene.json --set /time/step={\"manual\":{\"dt\":5e-4,\"substeps_per_frame\":20}} \
         --vary /bodies/1/material/young_modulus=1e4,1e8 --report r.json",
    );
    assert_eq!(said.code, Some(3), "{said:?}");
    let rows = &desk.json("r.json")["rows"];
    assert_eq!(rows[0]["diverged"], Value::Null);
    assert!(rows[1]["diverged"].as_str().unwrap().contains("Stiff block"));
    assert!(said.err.contains("\nerror: /bodies/1/material/young_modulus=100000000.0: body "), "{}", said.err);
    assert!(
        said.err.starts_with("warning: /time/step/manual/dt") && said.err.contains("(in 1 of 2 rows)"),
        "{}",
        said.err
    );
}

#[test]
fn rows_that_do_not_come_to_rest_are_counted() {
    let desk = Desk::new(&pressed());
    let said = desk.run(&format!("sweep scene.json --vary {FRACTION}=0.01,0.02 --until-rest --seconds 0.02"));
    assert_eq!(said.code, Some(0));
    assert!(said.err.starts_with("warning: 2 of 2 rows have not come to rest"), "{}", said.err);
}
