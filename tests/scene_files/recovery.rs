//! Changed documents are found again after a program that ended without asking, and only then.

use super::every_field;
use sinew::scene::Scene;
use sinew::test_support::io::{Origin, RecoveryFile, recoverable_documents};
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, SystemTime};

/// Where the program that is to be killed keeps its document.
const TARGET: &str = "SINEW_TEST_KEEP_UNTIL_KILLED";

fn named(name: &str) -> Scene {
    Scene { name: name.into(), ..every_field() }
}

fn origin() -> Origin {
    Origin {
        file: Some(PathBuf::from("/scenes/bar.json")),
        folder: PathBuf::from("/scenes"),
        doubtful: true,
        shipped: true,
    }
}

fn files(folder: &Path) -> usize {
    fs::read_dir(folder).map_or(0, Iterator::count)
}

#[test]
fn a_document_is_kept_until_it_is_saved_or_closed() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path().join("made").join("when needed");
    assert!(recoverable_documents(&folder).is_empty());
    let recovery = RecoveryFile::open(&folder).expect("a place");
    for name in ["first", "second"] {
        recovery.write(&origin(), &named(name)).expect("kept");
        assert!(recoverable_documents(&folder).is_empty(), "it is open here");
    }
    assert_eq!(files(&folder), 2);
    recovery.clear().expect("forgotten");
    recovery.clear().expect("nothing to forget");
    recovery.write(&origin(), &named("third")).expect("kept again");
    recovery.clear().expect("forgotten");
    drop(recovery);
    assert_eq!(files(&folder), 0);
}

#[test]
fn what_was_left_behind_is_offered_with_time_and_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let before = SystemTime::now() - Duration::from_millis(2);
    let [older, newer, open] = [(); 3].map(|()| RecoveryFile::open(folder).expect("a place"));
    older.write(&origin(), &named("Older")).expect("kept");
    // Times are told apart by milliseconds.
    let written = SystemTime::now();
    while SystemTime::now() < written + Duration::from_millis(5) {
        std::thread::yield_now();
    }
    newer.write(&Origin::default(), &named("Newer")).expect("kept");
    open.write(&origin(), &named("Open")).expect("kept");
    drop((older, newer));
    let found = recoverable_documents(folder);
    let names: Vec<&str> = found.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names, ["Newer", "Older"]);
    assert!(found.iter().all(|one| one.written >= before && one.written <= SystemTime::now()));
    assert_eq!(found[1].origin, origin());
    // A document that was never saved names its models from where the program ran.
    let here = std::env::current_dir().expect("a folder");
    assert_eq!(found[0].origin, Origin { file: None, folder: here, doubtful: false, shipped: false });
    assert_eq!(found[1].load().expect("a scene"), named("Older"));
    found[1].discard().expect("forgotten");
    assert_eq!(recoverable_documents(folder), found[..1]);
    found[0].discard().expect("forgotten");
    found[0].discard().expect("nothing to forget");
    drop(open);
    assert_eq!(recoverable_documents(folder).len(), 1, "closed without clearing");
}

#[test]
fn a_file_that_was_written_later_is_known() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("bar.json");
    let kept = Origin { file: Some(file.clone()), folder: folder.path().to_owned(), doubtful: false, shipped: false };
    let recovery = RecoveryFile::open(folder.path()).expect("a place");
    recovery.write(&kept, &named("Bar")).expect("kept");
    drop(recovery);
    let found = recoverable_documents(folder.path());
    assert!(!found[0].is_older_than_its_file(), "there is no file");
    let (written, offset) = (found[0].written, Duration::from_secs(10));
    for (time, is_older) in [(written - offset, false), (written + offset, true)] {
        fs::write(&file, "{}").expect("written");
        fs::File::options().write(true).open(&file).and_then(|file| file.set_modified(time)).expect("a time of change");
        assert_eq!(found[0].is_older_than_its_file(), is_older);
    }
}

#[test]
fn other_files_and_damaged_ones_are_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for (name, text) in [
        ("recovery-a.json", "{\"written\": 1, \"scene\": {\"version\": 1"),
        ("recovery-b.json", "[]"),
        ("scene.json", "{\"version\": 1}"),
        ("recovery-c.json", "{\"written\": 1, \"scene\": {\"version\": 1, \"gravity\": [0, 1e99, 0]}}"),
        ("recovery-d.lock", ""),
    ] {
        fs::write(folder.join(name), text).expect("written");
    }
    let found = recoverable_documents(folder);
    assert_eq!(found.len(), 1);
    let error = found[0].load().expect_err("out of range").to_string();
    assert!(error.contains("/gravity/1: 1e99 is out of range") || error.contains("/gravity/1: 1e+99"), "{error}");
    assert_eq!(files(folder), 4, "the lock that nobody held is gone");
    let recovery = RecoveryFile::open(folder).expect("a place");
    let scene = Scene { gravity: [f64::NAN; 3], ..every_field() };
    assert!(recovery.write(&origin(), &scene).is_err());
    let file = folder.join("scene.json");
    assert!(RecoveryFile::open(&file).is_err(), "a file is no folder");
}

/// The program that is killed: no test of its own.
#[test]
#[ignore = "waits until it is killed, by the test below"]
fn keeps_until_killed() {
    let Some(folder) = std::env::var_os(TARGET).map(PathBuf::from) else { return };
    let recovery = RecoveryFile::open(&folder).expect("a place");
    recovery.write(&origin(), &named("Killed")).expect("kept");
    eprintln!("kept");
    // Nothing ever comes: this waits until it is killed, or the test that would do so is gone.
    std::io::stdin().lines().next();
}

#[test]
fn the_document_of_a_killed_program_is_recovered() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut child = Command::new(std::env::current_exe().expect("this program"))
        .args(["--exact", "recovery::keeps_until_killed", "--ignored", "--nocapture"])
        .env(TARGET, folder.path())
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("started");
    let mut lines = BufReader::new(child.stderr.take().expect("piped")).lines();
    assert!(lines.any(|line| line.expect("text") == "kept"));
    assert!(recoverable_documents(folder.path()).is_empty(), "open in another program");
    child.kill().expect("killed");
    child.wait().expect("ended");
    let found = recoverable_documents(folder.path());
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].name.as_str(), &found[0].origin), ("Killed", &origin()));
    assert_eq!(found[0].load().expect("a scene"), named("Killed"));
    found[0].discard().expect("forgotten");
    assert_eq!(files(folder.path()), 0);
}
