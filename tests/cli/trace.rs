//! `--trace`: how long what took, in the form that Perfetto and chrome://tracing open.

use super::{Desk, pressed, two_blocks};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;

/// Names of the spans of a trace, each with how often it came. Ends match beginnings, and time runs on in each thread.
fn spans(trace: &Value) -> BTreeMap<String, usize> {
    let mut found = BTreeMap::new();
    let mut threads: BTreeMap<u64, (Vec<f64>, f64)> = BTreeMap::new();
    for event in trace.as_array().expect("a list of events") {
        assert_eq!(event["pid"], 1);
        let tid = event["tid"].as_u64().expect("a thread");
        let (open, last) = threads.entry(tid).or_default();
        let kind = event["ph"].as_str().expect("a kind of event");
        if kind == "M" {
            continue;
        }
        let time = event["ts"].as_f64().expect("a time");
        assert!(time >= *last, "{event} comes after {last} µs");
        *last = time;
        match kind {
            "B" => {
                open.push(time);
                *found.entry(event["name"].as_str().expect("a name").to_owned()).or_default() += 1;
            }
            "E" => assert!(open.pop().is_some(), "{event} ends what never began"),
            other => panic!("{other} is no kind of event that is written"),
        }
    }
    assert!(threads.values().all(|(open, _)| open.is_empty()), "something never ends");
    found
}

#[test]
fn a_trace_has_the_stages_of_baking_the_frames_and_the_files() {
    let desk = Desk::new(&pressed());
    let said = desk.run("simulate scene.json --report report.json --trace t.json");
    assert_eq!((said.code, said.err.as_str()), (Some(0), "note: trace written to t.json\n"));
    let trace = desk.json("t.json");
    let found = spans(&trace);
    for (name, count) in
        [("bake", 1), ("sampling", 1), ("neighbours", 1), ("embedding", 1), ("frame", 6), ("body", 6), ("write", 1)]
    {
        assert_eq!(found.get(name), Some(&count), "{name}: {found:?}");
    }
    let of = |name: &str| trace.as_array().expect("a list").iter().find(|event| event["name"] == name).expect("a span");
    assert_eq!(of("sampling")["args"]["body"], "Block");
    assert_eq!(of("body")["args"]["name"], "Block");
    assert_eq!(of("frame")["args"]["number"], 0);
    assert!(of("write")["args"]["file"].as_str().is_some_and(|file| file.ends_with("report.json")));
    // Frames that are written beside the run, and how long that takes of it.
    desk.run("simulate scene.json --out frames --format pc2 --trace out.json");
    assert_eq!(spans(&desk.json("out.json")).get("export"), Some(&7), "the start and six frames");
    // The same motion as without.
    let hash = |report: Value| report["bodies"][0]["state_hash"].clone();
    let traced = hash(desk.json("report.json"));
    desk.done("simulate scene.json --report report.json");
    assert_eq!(hash(desk.json("report.json")), traced);
}

#[test]
fn every_command_that_runs_a_scene_can_be_traced() {
    let desk = Desk::new(&two_blocks());
    for arguments in [
        "sweep scene.json --seconds 0.02 --vary /bodies/0/material/young_modulus=1e4,2e4 --trace t.json",
        "compare scene.json --seconds 0.02 --integrators leap_frog,rk4 --dt 1e-4 --trace t.json",
        "simulate scene.json --seconds 0.02 --trace=t.json",
    ] {
        let said = desk.run(arguments);
        assert_eq!(said.code, Some(0), "{arguments}: {said:?}");
        assert!(said.err.ends_with("note: trace written to t.json\n"), "{arguments}: {said:?}");
        let found = spans(&desk.json("t.json"));
        assert!(found["bake"] >= 1, "{arguments}: {found:?}");
        fs::remove_file(desk.path("t.json")).expect("removed");
    }
}

#[test]
fn a_trace_replaces_an_earlier_one_and_nothing_else() {
    let desk = Desk::new(&pressed());
    for _ in 0..2 {
        assert_eq!(desk.run("simulate scene.json --seconds 0.02 --trace t.json").code, Some(0));
    }
    let scene = desk.text("scene.json");
    let refused = desk.refused("simulate scene.json --trace scene.json");
    assert!(refused.contains("scene.json") && refused.contains("no trace"), "{refused}");
    assert_eq!(desk.text("scene.json"), scene);
    // A report that the run itself writes there is kept, too.
    let said = desk.run("simulate scene.json --seconds 0.02 --report both.json --trace both.json");
    assert!(said.code == Some(2) && said.err.contains("both.json"), "{said:?}");
    assert_eq!(desk.json("both.json")["bodies"][0]["name"], json!("Block"));
    desk.refused("simulate scene.json --trace missing/t.json");
}

#[test]
fn what_cannot_be_run_leaves_no_trace() {
    let desk = Desk::new(&json!({"version": 1, "bodies": 5}));
    desk.refused("simulate scene.json --trace t.json");
}
