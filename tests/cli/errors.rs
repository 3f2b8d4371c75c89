//! Input that cannot be used: one line, exit code 2, nothing written.

use super::{Desk, pressed};
use serde_json::json;
use std::fs;

const OUTPUTS: &str = "--report r.json --series s.csv --out frames";

#[test]
fn scenes_that_cannot_be_read() {
    let desk = Desk::new(&pressed());
    let error = desk.refused(&format!("simulate missing.json {OUTPUTS}"));
    assert!(error.contains("missing.json: there is no such file"), "{error}");

    let text = desk.text("scene.json");
    fs::write(desk.path("damaged.json"), &text[..text.len() / 2]).unwrap();
    for command in ["simulate", "check"] {
        let error = desk.refused(&format!("{command} damaged.json"));
        assert!(error.contains("damaged.json: line 1, column "), "{error}");
    }

    let mut scene = pressed();
    scene["bodies"][0]["material"]["poisson_ratio"] = json!(0.7);
    fs::write(desk.path("wrong.json"), scene.to_string()).unwrap();
    let error = desk.refused(&format!("simulate wrong.json {OUTPUTS}"));
    assert!(error.contains("/bodies/0/material/poisson_ratio: 0.7 "), "{error}");
    let error = desk.refused("sweep wrong.json --vary /gravity/1=0,1 --report r.json");
    assert!(error.contains("/bodies/0/material/poisson_ratio: 0.7 "), "{error}");

    scene["bodies"][0]["material"]["poisson_ratio"] = json!(0.3);
    scene["bodies"][0]["shape"]["box"]["size"] = json!([2, 2, 2]);
    fs::write(desk.path("vast.json"), scene.to_string()).unwrap();
    let error = desk.refused(&format!("simulate vast.json {OUTPUTS}"));
    assert!(error.contains("particles"), "{error}");
}

#[test]
fn values_that_cannot_be_set() {
    let desk = Desk::new(&pressed());
    let cases = [
        ("/bodies/0/material/young_modulus=soft", "is not JSON"),
        ("/bodies/0/material/young_modulus=-5", "/bodies/0/material/young_modulus: -5"),
        ("/bodies/7/name=1", "/bodies"),
        ("/bodies/0/material/young=1", "is no member of"),
        ("gravity=[0,0,0]", "is not a pointer"),
    ];
    for (set, part) in cases {
        let error = desk.refused(&format!("simulate scene.json --set {set} {OUTPUTS}"));
        assert!(error.contains(part), "{set}: {error}");
    }
    let said = desk.run(&format!("simulate scene.json --set /gravity {OUTPUTS}"));
    assert_eq!((said.code, desk.files()), (Some(2), vec!["scene.json".to_owned()]), "{said:?}");
}

#[test]
fn options_that_cannot_be_used() {
    let desk = Desk::new(&pressed());
    for bad in ["--seconds -1", "--seconds nan", "--seconds 1e9", "--threads 0", "--threads x", "--fps fast"] {
        let said = desk.run(&format!("simulate scene.json {bad} {OUTPUTS}"));
        assert_eq!((said.code, desk.files()), (Some(2), vec!["scene.json".to_owned()]), "{bad}: {said:?}");
        assert!(said.err.starts_with("error: "), "{}", said.err);
    }
    for bad in ["0", "-60", "nan", "inf", "1e9"] {
        let error = desk.refused(&format!("simulate scene.json --fps={bad} {OUTPUTS}"));
        assert!(error.contains("/time/frames_per_second: "), "{error}");
    }
    let by_hand = "/time/step={\"manual\":{\"dt\":1e-4,\"substeps_per_frame\":10}}";
    let error = desk.refused(&format!("simulate scene.json --set {by_hand} --fps 30 {OUTPUTS}"));
    assert!(error.contains("--fps") && error.contains("0.001 s"), "{error}");
}

#[test]
fn files_that_cannot_be_written_are_found_before_the_run() {
    let desk = Desk::new(&pressed());
    // A run of this length would take hours: the refusal must come first.
    let long = "simulate scene.json --seconds 100000";
    for option in ["--report", "--series"] {
        let error = desk.refused(&format!("{long} {option} no/such/folder/file"));
        assert!(error.contains("no/such/folder/file") && error.contains("check that its folder exists"), "{error}");
        let error = desk.refused(&format!("{long} {option} ."));
        assert!(error.contains("not a regular file"), "{error}");
        let error = desk.refused(&format!("{long} {option} ./scene.json"));
        assert!(error.contains("the scene and ") && error.contains("the same file"), "{error}");
    }
    let error = desk.refused(&format!("{long} --report same --series ./same"));
    assert!(error.contains("--report and --series are the same file"), "{error}");
    let error = desk.refused(&format!("{long} --out scene.json"));
    assert!(error.contains("scene.json: the folder cannot be written to"), "{error}");
    let error = desk.refused("sweep scene.json --vary /time/duration=1e5 --report no/such/r.json");
    assert!(error.contains("no/such/r.json"), "{error}");
}

#[test]
fn words_of_a_scene_cannot_drive_the_terminal() {
    let mut scene = pressed();
    scene["name"] = json!("red \u{1b}[31m\nname");
    scene["bodies"][0]["name"] = json!("b\u{7}\r");
    scene["measures"][0]["name"] = json!("m\u{1b}]0;t\u{7}");
    let desk = Desk::new(&scene);
    for command in ["simulate scene.json", "check scene.json", "sweep scene.json --vary /time/duration=0,0.01"] {
        let out = desk.done(command);
        assert!(!out.chars().any(|c| c.is_control() && c != '\n'), "{command}: {out:?}");
    }
}
