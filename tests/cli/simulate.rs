//! One run: summary, report, series, frames.

use super::{Desk, names, pressed, program, said, two_blocks};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::process::Stdio;

fn members(value: &Value) -> BTreeSet<&str> {
    value.as_object().expect("an object").keys().map(String::as_str).collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn the_summary_names_what_ran_and_what_was_measured() {
    let out = Desk::new(&pressed()).done("simulate scene.json");
    for part in
        ["Pressed block: 0.1000 s in 6 frames", "real time", "Block", "96", "press", "drift", "N\n", "mm\n", "matrix"]
    {
        assert!(out.contains(part), "{part}: {out}");
    }
    assert!(!out.contains("written"), "{out}");
}

#[test]
fn the_built_in_scene_runs_from_any_folder() {
    let desk = Desk::new(&pressed());
    let said = desk.run("simulate --seconds 0.05 --report report.json");
    assert_eq!(said.code, Some(0), "{said:?}");
    let report = desk.json("report.json");
    assert_eq!(report["bodies"][0]["particles"], 588);
    assert_eq!(report["frames"], 3);
}

#[test]
fn a_time_within_a_frame_is_said_to_be_run_to_the_end_of_it() {
    let desk = Desk::new(&pressed());
    let within = desk.run("simulate scene.json --seconds 0.01");
    assert!(
        within.err.contains("note: 0.01000 s lies within a frame, which is run to its end at 0.01667 s"),
        "{within:?}"
    );
    let whole = desk.run("simulate scene.json --seconds 0.05");
    assert!(!whole.err.contains("lies within"), "{whole:?}");
}

#[test]
fn a_report_has_every_field() {
    let desk = Desk::new(&pressed());
    let out = desk.done("simulate scene.json --report report.json");
    assert!(out.ends_with("report written to report.json\n"), "{out}");
    let report = desk.json("report.json");
    for field in ["scene", "seconds", "wall_seconds", "real_time_factor", "bodies", "measures"] {
        assert!(members(&report).contains(field), "{field}");
    }
    let body = &report["bodies"][0];
    let fields = [
        "name",
        "kind",
        "particles",
        "mean_neighbours",
        "fibres",
        "structure_particles",
        "integrator",
        "integrator_reason",
        "dt",
        "stable_dt",
        "limited_by",
        "halved_steps",
        "handed_over_steps",
        "steps",
        "diverged",
        "energy",
        "linear_momentum",
        "angular_momentum",
        "state_hash",
    ];
    assert!(members(body).is_superset(&BTreeSet::from(fields)), "{body}");
    let energies = [
        "kinetic",
        "matrix",
        "zero_energy",
        "stretching",
        "bending",
        "springs",
        "pressure",
        "contact",
        "gravity",
        "grab",
        "twisting",
        "activation",
        "membrane",
        "hinges",
        "elements",
    ];
    assert_eq!(members(&body["energy"]), BTreeSet::from(energies));
    assert_eq!((&report["scene"], &body["kind"]), (&json!("Pressed block"), &json!("fibre_solid")));
    assert_eq!((&body["particles"], &body["fibres"], &body["structure_particles"]), (&json!(96), &json!(1), &json!(5)));
    assert_eq!(body["diverged"], Value::Null);
    assert!((number(&report["seconds"]) - 0.1).abs() < 1e-12);
    let steps = number(&report["seconds"]) / number(&body["dt"]);
    assert!((number(&body["steps"]) - steps).abs() < 1e-6, "{body}");
    let factor = number(&report["seconds"]) / number(&report["wall_seconds"]);
    assert!((number(&report["real_time_factor"]) / factor - 1.0).abs() < 1e-9);

    let press = &report["measures"][0];
    assert_eq!(members(press), BTreeSet::from(["name", "kind", "value", "unit"]));
    assert_eq!(
        (&press["name"], &press["kind"], &press["unit"]),
        (&json!("press"), &json!("reaction_force"), &json!("N"))
    );
    assert!(number(&press["value"]) > 0.0);
    let drift = &report["measures"][1];
    assert_eq!(drift["unit"], "mm");
    // 5 % of the 30 mm between the first and the last layer.
    assert!((number(&drift["value"][1]) + 1.5).abs() < 1e-9, "{drift}");
}

#[test]
fn a_series_has_a_row_a_frame_and_the_last_is_the_report() {
    let desk = Desk::new(&pressed());
    desk.done("simulate scene.json --series series.csv --report report.json --fps 100");
    let report = desk.json("report.json");
    let mut reader = csv::Reader::from_path(desk.path("series.csv")).unwrap();
    let head: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let rows: Vec<Vec<f64>> = reader.deserialize().map(|row| row.unwrap()).collect();
    assert_eq!(rows.len(), 11);
    let column = |name: &str| head.iter().position(|other| other == name).unwrap_or_else(|| panic!("{name}: {head:?}"));
    for (frame, row) in rows.iter().enumerate() {
        assert!((row[column("time [s]")] - 0.01 * frame as f64).abs() < 1e-12);
    }
    let last = rows.last().unwrap();
    assert_eq!(last[column("press [N]")], number(&report["measures"][0]["value"]));
    assert_eq!(last[column("drift y [mm]")], number(&report["measures"][1]["value"][1]));
    for (name, energy) in report["bodies"][0]["energy"].as_object().unwrap() {
        assert_eq!(last[column(&format!("block: {name} [J]"))], number(energy));
    }
    assert_eq!(last[column("block: linear_momentum y [kg m/s]")], number(&report["bodies"][0]["linear_momentum"][1]));
    assert_eq!(
        last[column("block: angular_momentum z [kg m²/s]")],
        number(&report["bodies"][0]["angular_momentum"][2])
    );
    // Time, energies, momenta, measures; totals, the body's sums and centre; two pins and a fibre.
    assert_eq!(head.len(), 1 + 15 + 6 + 1 + 3 + 2 + 5 + 2 * 3 + 3);
    // What was pressed is what is stored and lost, and it is the press that does it.
    let (energy, work) = (last[column("total_energy [J]")], last[column("total_work [J]")]);
    assert!(work > 0.0 && (0.5 * work..=work).contains(&energy), "{energy} J of {work} J");
    assert_eq!((energy, work), (last[column("block: energy [J]")], last[column("block: work [J]")]));
    assert_eq!(last[column("block: pin_force push y [N]")], last[column("press [N]")]);
    let [greatest, mean] = ["greatest", "mean"].map(|which| last[column(&format!("block: {which}_tension axis [N]"))]);
    assert!(mean < greatest && greatest < 0.0, "a fibre that is pressed: {mean} and {greatest} N");
    assert_eq!(last[column("block: breaks axis [1]")], 0.0);
    assert!((last[column("block: center y [m]")] - 0.018).abs() < 2e-3);
}

#[test]
fn columns_of_a_body_are_named_alike_whatever_stands_beside_it() {
    let heads = |scene: &Value| {
        let desk = Desk::new(scene);
        desk.done("simulate scene.json --seconds 0 --series series.csv");
        let text = desk.text("series.csv");
        let head: BTreeSet<String> = text.lines().next().unwrap().split(',').map(str::to_owned).collect();
        head
    };
    let mut scene = two_blocks();
    scene["measures"] = json!([]);
    let two = heads(&scene);
    scene["bodies"].as_array_mut().unwrap().pop();
    let one = heads(&scene);
    assert!(one.contains("block: kinetic [J]") && one.is_subset(&two), "{one:?}");
    assert!(two.difference(&one).all(|name| name.starts_with("stiff: ")), "{two:?}");
}

#[test]
fn frames_are_obj_files_that_hold_together() {
    let desk = Desk::new(&pressed());
    desk.done("simulate scene.json --out deep/frames");
    let files = names(&desk.path("deep/frames"));
    let expected: Vec<String> = (0..7).map(|k| format!("frame_{k:06}.obj")).collect();
    assert_eq!(files, expected);
    for file in &files {
        let text = desk.text(&format!("deep/frames/{file}"));
        let (mut vertices, mut objects, mut faces, mut lines) = (0, Vec::new(), 0, Vec::new());
        for line in text.lines() {
            let (kind, rest) = line.split_once(' ').unwrap();
            let indices = || rest.split(' ').map(|word| word.parse::<usize>().unwrap()).collect::<Vec<_>>();
            match kind {
                "v" => {
                    let point: Vec<f64> = rest.split(' ').map(|word| word.parse().unwrap()).collect();
                    assert!(point.len() == 3 && point.iter().all(|x| x.is_finite()));
                    vertices += 1;
                }
                "f" => {
                    assert!(indices().len() == 3 && indices().iter().all(|k| (1..=vertices).contains(k)));
                    faces += 1;
                }
                "l" => lines.push(indices()),
                "o" => objects.push(rest),
                other => assert_eq!(other, "#"),
            }
        }
        // 4 x 6 x 4 cells: 2 (24 + 24 + 16) squares of two triangles; 130 corners; then the fibre's five vertices.
        assert_eq!((objects, faces), (vec!["Block", "Block.axis"], 256));
        assert_eq!((vertices, lines), (135, vec![vec![131, 132, 133, 134, 135]]));
    }
    assert_ne!(desk.text("deep/frames/frame_000000.obj"), desk.text("deep/frames/frame_000003.obj"));

    let shorter = desk.run("simulate scene.json --seconds 0.05 --out deep/frames");
    assert_eq!(shorter.code, Some(0));
    assert!(shorter.err.starts_with("warning: deep/frames: 3 more frames"), "{}", shorter.err);
}

#[test]
fn values_can_be_set() {
    let desk = Desk::new(&pressed());
    let press = |set: &str| {
        desk.done(&format!("simulate scene.json {set} --report report.json"));
        number(&desk.json("report.json")["measures"][0]["value"])
    };
    let stiffer = press("--set /bodies/0/material/young_modulus=2e4 --set /bodies/0/fibres=[]");
    let plain = press("--set /bodies/0/fibres=[]");
    assert!(stiffer > 1.5 * plain && plain > 0.0, "{stiffer} {plain}");
    desk.done("simulate scene.json --set /time/step={\"manual\":{\"dt\":1e-4,\"substeps_per_frame\":10}} --report report.json");
    assert_eq!(desk.json("report.json")["frames"], 100);
}

#[test]
fn until_rest_stops_early_or_says_that_it_did_not() {
    let desk = Desk::new(&pressed());
    let out = desk.done("simulate scene.json --until-rest --seconds 60 --report report.json");
    let report = desk.json("report.json");
    assert_eq!(report["at_rest"], true);
    assert!(number(&report["seconds"]) < 30.0, "{report}");
    assert!(out.contains(", at rest\n"), "{out}");

    let said = desk.run("simulate scene.json --until-rest --set /time/duration=0.002 --report report.json");
    let report = desk.json("report.json");
    assert_eq!((said.code, &report["at_rest"]), (Some(0), &json!(false)));
    // Ten times the duration of the scene, in whole frames.
    assert_eq!(report["frames"], 2);
    assert!(said.err.contains("warning: not everything has come to rest after 0.02"), "{}", said.err);
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let mut scene = pressed();
    // 14 x 14 x 12 particles: enough for the loops to be divided.
    scene["bodies"][0]["shape"]["box"]["size"] = json!([0.084, 0.084, 0.072]);
    let desk = Desk::new(&scene);
    let hash = |threads: u32| {
        desk.done(&format!("simulate scene.json --seconds 0.05 --threads {threads} --report report.json"));
        let body = &desk.json("report.json")["bodies"][0];
        assert!(body["particles"].as_u64() > Some(2000));
        body["state_hash"].as_str().unwrap().to_owned()
    };
    let one = hash(1);
    assert_eq!(one, hash(2));
    assert_eq!(one, hash(3));
}

#[test]
fn one_body_diverges_and_the_other_goes_on() {
    let desk = Desk::new(&two_blocks());
    let step = "/time/step={\"manual\":{\"dt\":5e-4,\"substeps_per_frame\":20}}";
    let said = desk.run(&format!("simulate scene.json --set {step} --report r.json --series s.csv --out frames"));
    assert_eq!(said.code, Some(3), "{said:?}");
    let (warning, error) = said.err.trim_end().split_once('\n').unwrap();
    assert!(
        warning.starts_with("warning: /time/step/manual/dt: ") && warning.contains("beyond the stable"),
        "{warning}"
    );
    assert!(error.starts_with("error: body \"Stiff block\" diverged at 0.0"), "{error}");
    assert!(error.contains("lower /time/step/manual/dt") && error.lines().count() == 1, "{error}");
    let report = desk.json("r.json");
    assert_eq!(report["bodies"][0]["diverged"], Value::Null);
    assert!(report["bodies"][1]["diverged"].as_str().unwrap().contains("Stiff block"));
    assert_eq!(report["frames"], 10);
    // The soft block has fallen freely for the whole time: v = g t, less the air's drag.
    assert!(number(&report["bodies"][0]["linear_momentum"][1]) < -1e-3);
    assert_eq!(desk.text("s.csv").lines().count(), 12);
    assert_eq!(names(&desk.path("frames")).len(), 11);
    let finite = |name: &str| !desk.text(name).contains("NaN") && !desk.text(name).contains("inf");
    assert!(finite("s.csv") && finite("frames/frame_000010.obj"));
    assert!(said.out.contains("diverged"), "{}", said.out);
}

#[test]
fn a_run_ends_when_nothing_is_left_to_run() {
    let desk = Desk::new(&pressed());
    let step = "/time/step={\"manual\":{\"dt\":0.05,\"substeps_per_frame\":2}}";
    let said = desk.run(&format!("simulate scene.json --set {step} --seconds 1000 --report r.json"));
    assert_eq!(said.code, Some(3), "{said:?}");
    assert!(number(&desk.json("r.json")["frames"]) < 10.0);
    assert_eq!(desk.json("r.json")["at_rest"], false);
    assert!(!said.out.contains("real time"), "{}", said.out);
}

#[test]
fn notes_of_the_scene_are_said_and_reported() {
    let mut scene = pressed();
    scene["bodies"][0]["colour"] = json!("red");
    scene["bodies"][0]["fibres"][0]["stiffness"]["rigidity"]["ea"] = json!(0.01);
    let desk = Desk::new(&scene);
    let said = desk.run("simulate scene.json --seconds 0 --report r.json");
    assert_eq!(said.code, Some(0));
    let lines: Vec<&str> = said.err.lines().collect();
    assert_eq!(lines.len(), 2, "{lines:?}");
    assert!(lines[0].starts_with("warning: /bodies/0/colour: ") && lines[0].contains("kept but not used"), "{lines:?}");
    assert!(lines[1].starts_with("warning: /bodies/0/fibres/0/stiffness: "), "{lines:?}");
    assert_eq!(desk.json("r.json")["notes"], json!(lines));
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let desk = Desk::new(&pressed());
    for arguments in [&["schema"] as &[&str], &["simulate", "scene.json", "--seconds", "0"]] {
        let mut child = program()
            .args(arguments)
            .current_dir(desk.folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // Gone before the program has anything to say.
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    }
}

#[test]
fn an_empty_scene_runs() {
    let desk = Desk::new(&json!({"version": 1}));
    let out = desk.done("simulate scene.json --series s.csv --out frames --report r.json");
    assert!(out.starts_with("scene.json: 1.000 s in 60 frames"), "{out}");
    assert_eq!(said(program().arg("check").arg(desk.path("scene.json"))).code, Some(0));
}

#[test]
fn breaks_are_listed_with_their_place_and_time() {
    let mut scene = pressed();
    scene["bodies"][0]["fibres"][0]["break_past"] = serde_json::json!({"tension": 1e-6});
    scene["bodies"][0]["pins"][1]["motion"]["ramp"]["direction"] = serde_json::json!([0, 1, 0]);
    let desk = Desk::new(&scene);
    let out = desk.done("simulate scene.json --report report.json");
    let broken: Vec<&str> = out.lines().filter(|line| line.contains("axis")).collect();
    let report = desk.json("report.json");
    let body = &report["bodies"][0];
    assert_eq!(body["breaks"], broken.len(), "{out}");
    assert!(!broken.is_empty() && broken.iter().all(|line| line.contains("between vertices")), "{out}");
    assert!(body["first_break"].as_f64().unwrap() > 0.0);
}

#[test]
fn the_run_of_a_report_is_made_again_to_the_same_bits() {
    let desk = Desk::new(&pressed());
    desk.done(
        "simulate scene.json --seconds 0.05 --fps 100 --threads 1 --set /bodies/0/material/young_modulus=2e4 --report r.json",
    );
    let run = &desk.json("r.json")["run"];
    assert_eq!(run["scene_file"], "scene.json");
    assert_eq!(run["sets"], json!(["/bodies/0/material/young_modulus=2e4"]));
    assert_eq!((&run["threads"], &run["fps"]), (&json!(1), &json!(100.0)));
    assert_eq!(run["version"], env!("CARGO_PKG_VERSION"));
    let said = desk.run("simulate --from r.json --threads 2 --report again.json");
    assert_eq!((said.code, said.err.trim_end()), (Some(0), "repeated: 1 body, the same bits as in r.json"));
    assert_eq!(desk.json("again.json")["bodies"], desk.json("r.json")["bodies"]);
    // Another scene under the same name is noticed, and so is what it comes to.
    let mut other = pressed();
    other["gravity"] = json!([0, -1, 0]);
    std::fs::write(desk.path("scene.json"), other.to_string()).unwrap();
    let said = desk.run("simulate --from r.json");
    assert_eq!(said.code, Some(1), "{said:?}");
    assert!(
        said.err.contains("not what it was") && said.err.contains("body block came to another state"),
        "{}",
        said.err
    );
    let said = desk.refused("simulate --from scene.json");
    assert!(said.contains("scene.json") && said.contains("simulate --report FILE"), "{said}");
    let said = desk.run("simulate --from r.json --seconds 1");
    assert_eq!(said.code, Some(2), "{said:?}");
}
