//! What was done to the motion outlives the program: kept as it grows, found at the next start, saved and made again.

use super::super::editing::type_path;
use super::super::loading::copied_ball;
use super::super::{Window, advance, click, hold, open_with, press_key, reset, until, until_seen};
use super::{close, folder, shows, until_shown};
use egui::{Event, Key, Modifiers};
use sinew::io::load_assets;
use sinew::scene::Assets;
use sinew::sim::{Journal, Rerun};
use sinew::test_support::io::left_recordings;
use sinew::ui::Document;
use std::env;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What the program that is killed works on, and where it keeps what it does.
const SCENE: &str = "SINEW_TEST_RECORDED_SCENE";
const KEPT: &str = "SINEW_TEST_RECORDED_FOLDER";
/// Frames that it computes.
const FRAMES: usize = 5;

fn recording(document: Document, folder: &Path) -> Window {
    let folder = folder.to_owned();
    open_with(document, move |app| app.with_recovery(folder))
}

/// What the recordings in a folder hold just now, whoever has them open.
fn recorded_in(folder: &Path) -> String {
    let files = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let recordings = files.filter(|path| path.extension().is_some_and(|ending| ending == "recording"));
    recordings.map(|path| fs::read_to_string(path).unwrap_or_default()).collect()
}

/// Frames of them.
fn frames_in(folder: &Path) -> usize {
    recorded_in(folder).matches("\"frame\":\"").count()
}

/// The program that is killed: no test of its own.
#[test]
#[ignore = "works until it is killed, by the test below"]
#[allow(clippy::print_stdout, reason = "it tells how far it has come")]
fn works_until_killed() {
    let (Some(scene), Some(folder)) = (env::var_os(SCENE), env::var_os(KEPT).map(PathBuf::from)) else { return };
    let mut window = recording(Document::load(Some(scene.into())).expect("a scene"), &folder);
    hold(&mut window);
    reset(&mut window);
    for _ in 0..FRAMES {
        advance(&mut window);
    }
    super::super::editing::set(&mut window, "Young's modulus", "2e5");
    advance(&mut window);
    until(&mut window, |_| frames_in(&folder) == FRAMES + 1);
    println!("\nrecorded");
    loop {
        window.step();
    }
}

/// A program that is killed, whatever happens to the test.
struct Killed(std::process::Child);

impl Drop for Killed {
    fn drop(&mut self) {
        self.0.kill().expect("killed");
        self.0.wait().expect("ended");
    }
}

#[test]
fn a_program_that_is_killed_leaves_the_recording_up_to_then() {
    let (root, kept) = (folder(), folder());
    let path = root.path().join("scene.json");
    fs::write(&path, super::super::pulling::CUBE).expect("written");
    let mut child = Command::new(env::current_exe().expect("this program"))
        .args(["--exact", "autosave::recording::works_until_killed", "--ignored", "--nocapture"])
        .env(SCENE, &path)
        .env(KEPT, kept.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .map(Killed)
        .expect("started");
    let mut lines = BufReader::new(child.0.stdout.take().expect("piped")).lines();
    assert!(lines.any(|line| line.expect("text") == "recorded"), "it ended before that");
    assert!(left_recordings(kept.path()).is_empty(), "it is still open");
    drop(child);
    assert_eq!(left_recordings(kept.path()).len(), 1);
    // The next start offers it, and it can be saved from there.
    let mut window = recording(Document::load(None).expect("the built-in scene"), kept.path());
    let is_there = |window: &Window| {
        shows(window, "Keep the recording?")
            || window.state().message().is_some_and(|said| said.contains("Recover unsaved"))
            || shows(window, "Recover unsaved changes?")
    };
    until_seen(&mut window, is_there);
    if !shows(&window, "Save recording…") {
        click(&mut window, "File");
        click(&mut window, "Recover unsaved…");
    }
    until_shown(&mut window, "6 frames");
    click(&mut window, "Save recording…");
    let saved = root.path().join("again.journal.json");
    type_path(&mut window, &saved);
    until(&mut window, |app| app.message().is_some_and(|said| said.contains("Wrote 6 frames")));
    assert!(left_recordings(kept.path()).is_empty(), "it is offered once");
    let journal: Journal = serde_json::from_str(&fs::read_to_string(&saved).expect("there")).expect("a journal");
    assert!(journal.asked.iter().any(|entry| matches!(entry.what, sinew::sim::Asked::Edit(_))));
    let assets = load_assets(&journal.scene, root.path(), &mut |_| {}).unwrap_or_else(|_| Assets::default());
    let mut rerun = Rerun::new(journal, assets).expect("a scene that bakes");
    let mut frames = 0;
    while rerun.advance().expect("it goes on") {
        assert!(rerun.agrees(), "frame {}", rerun.frame());
        frames += 1;
    }
    assert_eq!(frames, FRAMES + 1);
}

#[test]
fn a_window_that_is_closed_leaves_no_recording() {
    let (root, kept) = (folder(), folder());
    let path = root.path().join("scene.json");
    fs::write(&path, super::super::pulling::CUBE).expect("written");
    let mut window = recording(Document::load(Some(path)).expect("a scene"), kept.path());
    until(&mut window, |_| frames_in(kept.path()) > 2);
    // Another motion takes its place.
    hold(&mut window);
    press_key(&mut window, Modifiers::COMMAND, Key::R);
    until(&mut window, |_| frames_in(kept.path()) == 0);
    assert!(!shows(&window, "Recover"));
    close(&mut window);
    drop(window);
    assert_eq!(fs::read_dir(kept.path()).expect("a folder").count(), 0, "not even a lock is left");
}

#[test]
fn that_models_ship_from_now_on_is_told_to_the_recording() {
    let kept = folder();
    let mut window = recording(Document::load(None).expect("the built-in scene"), kept.path());
    hold(&mut window);
    until(&mut window, |_| recorded_in(kept.path()).contains("\"shipped\":false"));
    window.event(Event::Paste(copied_ball(Path::new("leaf.glb"))));
    until(&mut window, |app| app.scene().bodies.len() == 2);
    // The last place that a recording names is the one that counts.
    until(&mut window, |_| {
        let recorded = recorded_in(kept.path());
        recorded.lines().rfind(|line| line.contains("\"place\"")).is_some_and(|line| line.contains("\"shipped\":true"))
    });
}
