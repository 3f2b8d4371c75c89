//! The program as a person or a script meets it: arguments in; words, files and an exit code out.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod balance;
mod check;
mod compare;
mod converge;
mod errors;
mod export;
mod export_clip;
mod export_kept;
mod export_over;
mod interrupting;
mod lines;
mod models;
mod opened_models;
mod outside;
mod pictures;
mod regime;
mod repeated;
mod replay;
mod simulate;
mod starts;
mod sweep;
mod sweep_values;
mod table1;
mod trace;
mod unwritten;

use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// A folder with a scene in it.
struct Desk {
    folder: TempDir,
}

/// What a command said, and how it ended.
#[derive(Debug)]
struct Said {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Desk {
    fn new(scene: &Value) -> Self {
        let desk = Self { folder: TempDir::new().expect("a temporary folder") };
        fs::write(desk.path("scene.json"), scene.to_string()).expect("the scene is written");
        desk
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Runs the program in the folder; arguments are split at spaces.
    fn run(&self, arguments: &str) -> Said {
        said(program().args(arguments.split(' ')).current_dir(self.folder.path()))
    }

    /// Runs the program, which must do its work without a warning.
    fn done(&self, arguments: &str) -> String {
        let said = self.run(arguments);
        assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{arguments}: {said:?}");
        said.out
    }

    /// Runs the program, which must do its work, whatever it has to say of the scene.
    fn ran(&self, arguments: &str) -> String {
        let said = self.run(arguments);
        assert_eq!(said.code, Some(0), "{arguments}: {said:?}");
        said.out
    }

    /// Runs the program, which must refuse in one line and write nothing; gives the line.
    fn refused(&self, arguments: &str) -> String {
        let before = self.files();
        let said = self.run(arguments);
        assert_eq!((said.code, said.out.as_str()), (Some(2), ""), "{arguments}: {said:?}");
        assert!(said.err.starts_with("error: ") && said.err.trim_end().lines().count() == 1, "{}", said.err);
        assert_eq!(self.files(), before);
        said.err
    }

    fn json(&self, name: &str) -> Value {
        serde_json::from_str(&self.text(name)).expect("the file is JSON")
    }

    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).expect("the file can be read")
    }

    /// Names of all that lies in the folder.
    fn files(&self) -> Vec<String> {
        names(self.folder.path())
    }
}

fn names(folder: &Path) -> Vec<String> {
    let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
    let mut names: Vec<String> = fs::read_dir(folder).expect("the folder can be read").flatten().map(name).collect();
    names.sort();
    names
}

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_sinew"))
}

fn said(command: &mut Command) -> Said {
    let Output { status, stdout, stderr } = command.output().expect("the program runs");
    let text = |bytes| String::from_utf8(bytes).expect("the program speaks UTF-8");
    Said { code: status.code(), out: text(stdout), err: text(stderr) }
}

/// A soft block of 4 x 6 x 4 particles, clamped below, its top layer pressed down within 0.1 s, with one fibre.
fn pressed() -> Value {
    json!({
        "version": 1,
        "name": "Pressed block",
        "gravity": [0, 0, 0],
        "time": {"duration": 0.1},
        "bodies": [{
            "id": "block",
            "name": "Block",
            "shape": {"box": {"center": [0, 0.018, 0], "size": [0.024, 0.036, 0.024]}},
            "material": {
                "young_modulus": 1e4, "mass": {"per_particle": 4e-4}, "support_radius": 0.015, "damping": {"air": 200}
            },
            "fibres": [{
                "id": "axis",
                "source": {"vertices": [[0, 0.006, 0], [0, 0.012, 0], [0, 0.018, 0], [0, 0.024, 0], [0, 0.03, 0]]},
                "stiffness": {"rigidity": {"ea": 50, "ei": 1e-5}}
            }],
            "regions": [
                {"id": "bottom", "select": {"layers": {"axis": "y", "side": "min", "count": 1}}},
                {"id": "top", "select": {"layers": {"axis": "y", "side": "max", "count": 1}}}
            ],
            "pins": [
                {"id": "hold", "region": "bottom"},
                {"id": "push", "region": "top", "axes": ["y"], "motion": {"ramp": {
                    "direction": [0, -1, 0], "distance": {"fraction": 0.05}, "duration": 0.05}}}
            ]
        }],
        "measures": [
            {"name": "press", "body": "block", "kind": {"reaction_force": {"region": "top", "along": [0, 1, 0]}}},
            {"name": "drift", "body": "block", "kind": {"mean_displacement": {"region": "top"}}}
        ]
    })
}

/// Two blocks beside each other that fall; the second is much stiffer.
fn two_blocks() -> Value {
    let mut scene = pressed();
    scene["bodies"][0]["pins"] = json!([]);
    scene["bodies"][0]["fibres"] = json!([]);
    scene["measures"] = json!([{"name": "fall", "body": "stiff", "kind": {"mean_displacement": {"region": "top"}}}]);
    scene["gravity"] = json!([0, -9.81, 0]);
    let mut stiff = scene["bodies"][0].clone();
    stiff["id"] = json!("stiff");
    stiff["name"] = json!("Stiff block");
    stiff["placement"] = json!({"translation": [0.1, 0, 0]});
    stiff["material"]["young_modulus"] = json!(1e8);
    scene["bodies"].as_array_mut().expect("a list").push(stiff);
    scene
}

#[test]
fn the_schema_is_json_and_describes_scenes() {
    let said = said(program().arg("schema"));
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""));
    let schema: Value = serde_json::from_str(&said.out).unwrap();
    assert!(jsonschema::is_valid(&schema, &pressed()));
    assert!(!jsonschema::is_valid(&schema, &json!({"version": "one"})));
}

#[test]
fn asked_for_nothing_it_opens_its_window_or_says_what_is_missing() {
    let nothing = said(program().env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET"));
    if cfg!(feature = "gui") {
        assert_eq!((nothing.code, nothing.out.as_str()), (Some(4), ""));
        let said = nothing.err.trim_end();
        assert!(said.lines().count() == 1 && said.contains("apt install") && said.contains("sinew simulate"), "{said}");
    } else {
        assert_eq!(nothing.code, Some(0));
        assert!(nothing.out.starts_with("Soft short bar: 2.000 s"), "{}", nothing.out);
    }
    let help = said(program().arg("--help"));
    assert_eq!(help.code, Some(0));
    for command in ["simulate", "render", "sweep", "compare", "check", "schema"] {
        assert!(help.out.contains(command), "{}", help.out);
    }
    assert_eq!(said(program().args(["simulate", "--frames"])).code, Some(2));
}
