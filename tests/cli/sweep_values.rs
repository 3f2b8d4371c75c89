//! What a sweep varies and how, the files it leaves, and how it goes on after it was cut off.

use super::{Desk, pressed};
use serde_json::{Value, json};

const FRACTION: &str = "/bodies/0/pins/1/motion/ramp/distance/fraction";
const AIR: &str = "/bodies/0/material/damping/air";

/// The rows of a report without the time they took.
fn rows(desk: &Desk, name: &str) -> Vec<Value> {
    let mut rows = desk.json(name)["rows"].as_array().expect("rows").clone();
    for row in &mut rows {
        row.as_object_mut().expect("a row").remove("wall_seconds");
    }
    rows
}

#[test]
fn tied_values_change_together_and_ranges_are_lists() {
    let desk = Desk::new(&pressed());
    desk.done("sweep scene.json --vary /gravity/0,/gravity/2=1..3/3 --fps 50 --seconds 0.02 --report r.json");
    let report = desk.json("r.json");
    assert_eq!(report["vary"][0], json!({"pointer": "/gravity/0", "tied": ["/gravity/2"], "values": [1, 2, 3]}));
    for (row, gravity) in rows(&desk, "r.json").iter().zip([1, 2, 3]) {
        desk.done(&format!(
            "simulate scene.json --fps 50 --seconds 0.02 --set /gravity/0={gravity} --set /gravity/2={gravity} --report one.json"
        ));
        assert_eq!(row["bodies"], desk.json("one.json")["bodies"]);
    }
}

#[test]
fn drives_are_set_and_varied() {
    let mut scene = pressed();
    (scene["gravity"], scene["gravity_drive"]) = (json!([0, -9.81, 0]), json!({"wave": {"period": 0.04}}));
    let desk = Desk::new(&scene);
    let period = "/gravity_drive/wave/period";
    desk.done(&format!("sweep scene.json --vary {period}=0.02,0.03 --fps 50 --seconds 0.02 --report r.json"));
    let rows = rows(&desk, "r.json");
    for (row, value) in rows.iter().zip(["0.02", "0.03"]) {
        desk.done(&format!("simulate scene.json --fps 50 --seconds 0.02 --set {period}={value} --report one.json"));
        assert_eq!(row["bodies"], desk.json("one.json")["bodies"], "{value}");
    }
    assert_ne!(rows[0]["bodies"], rows[1]["bodies"]);
}

#[test]
fn random_values_are_drawn_from_a_seed() {
    let desk = Desk::new(&pressed());
    let drawn = |seed: u32| {
        desk.done(&format!(
            "sweep scene.json --vary {AIR}=10..1000/random/log --samples 4 --seed {seed} --seconds 0.01 --report r.json"
        ));
        let rows = rows(&desk, "r.json");
        let value = |row: &Value| row["values"][AIR].as_f64().expect("a number");
        rows.iter().map(value).collect::<Vec<f64>>()
    };
    let first = drawn(1);
    assert!(first.len() == 4 && first.iter().all(|value| (10.0..=1000.0).contains(value)), "{first:?}");
    assert_eq!(first, drawn(1));
    assert_ne!(first, drawn(2));
    let said = desk.refused(&format!("sweep scene.json --vary {AIR}=10..1000/random"));
    assert!(said.contains("--samples N"), "{said}");
    let said = desk.refused(&format!("sweep scene.json --vary {AIR}=10,20 --samples 3"));
    assert!(said.contains("0.1..0.9/random"), "{said}");
}

#[test]
fn rows_are_written_as_csv_series_and_a_plot() {
    let desk = Desk::new(&pressed());
    let sweep = format!("sweep scene.json --vary {FRACTION}=0.01,0.02 --vary {AIR}=100,200 --seconds 0.05");
    desk.done(&format!("{sweep} --report r.json --csv r.csv --series series --plot p.svg --plot-y press"));
    let csv = desk.text("r.csv");
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], format!("{FRACTION},{AIR},press [N],drift [mm],time [s],at rest,diverged"));
    assert_eq!(lines.len(), 5);
    let rows = rows(&desk, "r.json");
    let press: f64 = lines[3].split(',').nth(2).expect("a cell").parse().expect("a number");
    assert_eq!(Some(press), rows[2]["measures"]["press"].as_f64());
    assert_eq!(super::names(&desk.path("series")).len(), 4);
    let alone = format!("simulate scene.json --seconds 0.05 --set {FRACTION}=0.02 --set {AIR}=100 --series one.csv");
    desk.done(&alone);
    assert_eq!(desk.text("series/row_00002.csv"), desk.text("one.csv"));
    let plot = desk.text("p.svg");
    assert_eq!((plot.matches("<polyline").count(), plot.contains("press [N]")), (2, true), "{plot}");
    assert!(plot.contains("air 100") && plot.contains(FRACTION), "{plot}");
    let said = desk.refused(&format!("{sweep} --plot q.svg --plot-y weight"));
    assert!(said.contains("--plot-y weight") && said.contains("press, drift"), "{said}");
}

#[test]
fn rows_that_would_take_too_much_memory_side_by_side_run_one_after_the_other() {
    let desk = Desk::new(&pressed());
    let sweep = format!("sweep scene.json --vary {AIR}=100..900/4 --seconds 0.02 --threads 4");
    desk.done(&format!("{sweep} --memory 1000000 --report many.json"));
    let said = desk.run(&format!("{sweep} --memory 1 --report one.json"));
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(said.err.starts_with("note: one row at a time runs, since each takes up to "), "{}", said.err);
    assert!(said.err.ends_with(" MiB and 1.000 MiB may be taken\n") && said.err.lines().count() == 1, "{}", said.err);
    assert_eq!(rows(&desk, "one.json"), rows(&desk, "many.json"));
}

#[test]
fn a_report_is_gone_on_from_where_it_stops() {
    let desk = Desk::new(&pressed());
    let sweep = format!("sweep scene.json --vary {AIR}=100..900/5 --seconds 0.03");
    desk.done(&format!("{sweep} --report whole.json"));
    let mut part = desk.json("whole.json");
    let rows_of = part["rows"].as_array_mut().expect("rows");
    rows_of.remove(3);
    rows_of.remove(1);
    // What is kept is kept as it is.
    rows_of[0]["wall_seconds"] = json!(1234.5);
    part["complete"] = json!(false);
    std::fs::write(desk.path("part.json"), part.to_string()).expect("written");
    let said = desk.run(&format!("{sweep} --report part.json --resume"));
    assert_eq!(
        (said.code, said.err.trim_end()),
        (Some(0), "resumed: 3 of 5 rows are in the report already and are kept")
    );
    assert_eq!(desk.json("part.json")["rows"][0]["wall_seconds"], json!(1234.5));
    assert_eq!(rows(&desk, "part.json"), rows(&desk, "whole.json"));
    assert_eq!(desk.json("part.json")["complete"], true);
    // A report of anything else is left alone.
    for other in [sweep.replace("/5", "/4"), sweep.replace("0.03", "0.04"), format!("{sweep} --set /gravity/1=-1")] {
        let said = desk.refused(&format!("{other} --report part.json --resume"));
        assert!(said.contains("part.json") && said.contains("another sweep"), "{said}");
    }
}

#[test]
fn a_report_that_is_gone_on_from_gives_the_table_that_it_would_have_given() {
    let desk = Desk::new(&pressed());
    let sweep = format!("sweep scene.json --vary {AIR}=100..900/5 --seconds 0.03");
    let whole = desk.done(&format!("{sweep} --report whole.json --csv whole.csv"));
    let mut part = desk.json("whole.json");
    part["rows"].as_array_mut().expect("rows").truncate(2);
    std::fs::write(desk.path("part.json"), part.to_string()).expect("written");
    let resumed = desk.ran(&format!("{sweep} --report part.json --csv part.csv --resume"));
    assert_eq!(desk.text("part.csv"), desk.text("whole.csv"), "columns in the order of the scene's measures, too");
    assert_eq!(resumed.replace("part.", "whole."), whole);
}

#[cfg(unix)]
#[test]
fn a_sweep_that_is_killed_leaves_its_rows_and_ends_as_if_it_had_not_been() {
    let desk = Desk::new(&pressed());
    // Longer runs where a machine is too fast to be killed in between.
    let cut_off = [0.1, 1.0, 10.0].into_iter().find_map(|seconds| {
        let sweep = format!("sweep scene.json --vary {AIR}=100..900/100 --seconds {seconds}");
        std::fs::remove_file(desk.path("r.json")).ok();
        let child = super::interrupting::started(&desk, &format!("{sweep} --threads 1 --report r.json --csv r.csv"));
        super::interrupting::wait_until(|| desk.path("r.json").exists() && rows(&desk, "r.json").len() >= 40);
        super::interrupting::send("KILL", &child);
        drop(child.wait_with_output());
        (rows(&desk, "r.json").len() < 100).then_some(sweep)
    });
    let sweep = cut_off.expect("a sweep that takes a while");
    let (before, part) = (rows(&desk, "r.json"), desk.json("r.json"));
    assert!((40..100).contains(&before.len()) && part["complete"] == false, "{} rows", before.len());
    assert_eq!(desk.files(), ["r.json", "scene.json"], "nothing but whole files");
    let said = desk.run(&format!("{sweep} --threads 1 --report r.json --csv r.csv --resume"));
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(said.err.contains(&format!("{} of 100 rows", before.len())), "{said:?}");
    desk.done(&format!("{sweep} --threads 2 --report whole.json --csv whole.csv"));
    assert_eq!(rows(&desk, "whole.json").len(), 100);
    assert_eq!(rows(&desk, "r.json"), rows(&desk, "whole.json"));
    // The same bytes: wall times stand in the report alone.
    assert_eq!(desk.text("r.csv"), desk.text("whole.csv"));
    assert_eq!(desk.text("r.csv").lines().count(), 101);
    // But for them, the reports are the same, too.
    let without_times = |name: &str| {
        let mut report = desk.json(name);
        report["rows"] = rows(&desk, name).into();
        report
    };
    assert_eq!(without_times("r.json"), without_times("whole.json"));
}
