//! Runs that are interrupted: what was computed until then is there, and is told to be a part.
#![cfg(unix)]

use super::{Desk, names, pressed, program};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Longer than anything here takes on any machine.
const LIMIT: Duration = Duration::from_mins(5);

pub(super) fn started(desk: &Desk, arguments: &str) -> Child {
    let mut command = program();
    command.args(arguments.split(' ')).current_dir(desk.folder.path());
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

pub(super) fn send(signal: &str, child: &Child) {
    // A shell has `kill` built in, wherever there is one.
    let text = format!("kill -{signal} {}", child.id());
    Command::new("sh").args(["-c", &text]).stderr(Stdio::null()).status().expect("a shell");
}

#[allow(clippy::disallowed_methods, reason = "between two looks at the condition")]
pub(super) fn wait_until(mut condition: impl FnMut() -> bool) {
    let begun = Instant::now();
    while !condition() {
        assert!(begun.elapsed() < LIMIT, "the condition never came");
        std::thread::sleep(Duration::from_millis(5));
    }
}

fn ended(child: Child) -> (Option<i32>, String, String) {
    let Output { status, stdout, stderr } = child.wait_with_output().expect("the program ends");
    let text = |bytes| String::from_utf8(bytes).expect("the program speaks UTF-8");
    (status.code(), text(stdout), text(stderr))
}

#[test]
fn a_run_that_is_interrupted_gives_what_it_has_and_says_that_it_is_a_part() {
    // Where hang-ups may be kept off unseen, they are left to the system.
    let hang_up = cfg!(target_os = "linux").then_some(("HUP", 129));
    for (signal, code) in [("INT", 130), ("TERM", 143)].into_iter().chain(hang_up) {
        let desk = Desk::new(&pressed());
        let child = started(&desk, "simulate scene.json --seconds 100000 --report r.json --series s.csv --out frames");
        wait_until(|| desk.path("frames/frame_000005.obj").exists());
        send(signal, &child);
        let (ended, out, err) = ended(child);
        assert_eq!(ended, Some(code), "{err}");
        assert!(err.starts_with(&format!("interrupted: by SIG{signal} at ")), "{err}");
        assert!(err.contains("marked as incomplete") && err.lines().count() == 1, "{err}");
        let report = desk.json("r.json");
        assert_eq!(report["complete"], false);
        let frames = report["frames"].as_u64().expect("a number") as usize;
        assert!(frames >= 5);
        assert_eq!(desk.text("s.csv").lines().count(), frames + 2);
        assert_eq!(names(&desk.path("frames")).len(), frames + 1);
        assert!(out.lines().next().is_some_and(|line| line.ends_with(", interrupted")), "{out}");
        // What there is is that of a run that was asked for no more.
        let seconds = report["seconds"].as_f64().expect("a number");
        desk.done(&format!("simulate scene.json --seconds {seconds} --report whole.json"));
        let whole = desk.json("whole.json");
        assert_eq!(whole["complete"], true);
        assert_eq!(whole["bodies"][0]["state_hash"], report["bodies"][0]["state_hash"]);
    }
}

/// `nohup` starts a program so.
#[test]
#[cfg(target_os = "linux")]
fn a_hang_up_that_is_kept_off_ends_nothing() {
    let desk = Desk::new(&pressed());
    let mut command = Command::new("sh");
    let program = program().get_program().to_owned();
    let line = "trap '' HUP; exec \"$0\" simulate scene.json --seconds 100000 --report r.json --out frames";
    command.args(["-c", line]).arg(program).current_dir(desk.folder.path());
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("a shell");
    wait_until(|| desk.path("frames/frame_000001.obj").exists());
    send("HUP", &child);
    let frames = names(&desk.path("frames")).len();
    wait_until(|| names(&desk.path("frames")).len() > frames + 2);
    send("INT", &child);
    let (code, _, err) = ended(child);
    assert_eq!(code, Some(130), "{err}");
    assert!(err.starts_with("interrupted: by SIGINT"), "{err}");
}

#[test]
fn a_signal_ends_a_frame_that_takes_long() {
    let desk = Desk::new(&pressed());
    // One frame of more steps than anybody waits for.
    let step = r#"/time/step={"manual":{"dt":1e-6,"substeps_per_frame":1000000}}"#;
    let text = format!("simulate scene.json --seconds 100 --set {step} --report r.json --out frames");
    let mut child = started(&desk, &text);
    wait_until(|| desk.path("frames/frame_000000.obj").exists());
    send("INT", &child);
    wait_until(|| child.try_wait().expect("a state").is_some());
    let (code, _, err) = ended(child);
    assert_eq!(code, Some(130));
    assert!(err.starts_with("interrupted: by SIGINT at 0 s "), "{err}");
    assert_eq!(desk.json("r.json")["complete"], false);
    assert!(!desk.path("frames/frame_000001.obj").exists());
}

#[test]
fn a_sweep_that_is_interrupted_gives_the_rows_that_it_has() {
    let mut scene = pressed();
    scene["bodies"][0]["colour"] = json!("red");
    let desk = Desk::new(&scene);
    let mut child = started(&desk, "sweep scene.json --vary /time/duration=0.02,900000 --threads 1 --report r.json");
    let mut err = BufReader::new(child.stderr.take().expect("a pipe"));
    let mut line = String::new();
    // It is told what is odd about the scene when all rows have been looked at.
    err.read_line(&mut line).expect("a line");
    assert!(line.starts_with("warning: /bodies/0/colour: "), "{line}");
    send("TERM", &child);
    line.clear();
    err.read_line(&mut line).expect("a line");
    assert!(line.starts_with("interrupted: by SIGTERM when "), "{line}");
    let (code, out, _) = ended(child);
    assert_eq!(code, Some(143));
    assert!(out.contains("report written to r.json"), "{out}");
    let report = desk.json("r.json");
    assert_eq!(report["complete"], false);
    let rows = report["rows"].as_array().expect("a list");
    let whole = |row: &Value| row["values"]["/time/duration"] == 0.02 && row["seconds"].as_f64() > Some(0.019);
    assert!(rows.len() <= 1 && rows.iter().all(whole), "{report}");
    desk.run("sweep scene.json --vary /time/duration=0.02 --report r.json");
    assert_eq!(desk.json("r.json")["complete"], true);
}
