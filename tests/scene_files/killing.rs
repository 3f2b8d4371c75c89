//! A program that is killed while it saves: the file holds one whole version, always.

use super::every_field;
use sinew::io::{save_scene, scene_to_json};
use sinew::scene::Scene;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

/// Where the program that is to be killed saves to.
const TARGET: &str = "SINEW_TEST_SAVE_UNTIL_KILLED";
const KILLS: u32 = 200;
/// Latest moment of a kill after the first save. A machine that is too busy to save by then is given twice the time for
/// as many kills more, and so on up to the greatest.
const LATEST: Duration = Duration::from_millis(12);
const GREATEST: Duration = Duration::from_millis(200);

/// Two scenes of different length, large enough for a kill to meet the writing itself.
fn versions() -> [Scene; 2] {
    [("first", 150_000), ("second", 220_000)].map(|(name, length)| Scene {
        name: name.to_owned(),
        description: "x".repeat(length),
        ..every_field()
    })
}

/// The program that is killed: no test of its own.
#[test]
#[ignore = "saves until it is killed, by the test below"]
fn saves_until_killed() {
    let Some(path) = std::env::var_os(TARGET).map(PathBuf::from) else { return };
    let scenes = versions();
    for round in 0.. {
        save_scene(&path, &scenes[round % 2]).expect("saved");
        if round == 0 {
            eprintln!("saving");
        }
    }
}

fn saver(path: &Path) -> Child {
    let mut child = Command::new(std::env::current_exe().expect("this program"))
        .args(["--exact", "killing::saves_until_killed", "--ignored", "--nocapture"])
        .env(TARGET, path)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("started");
    let mut lines = BufReader::new(child.stderr.take().expect("piped")).lines();
    assert!(lines.any(|line| line.expect("text") == "saving"), "the program ended before it saved");
    child
}

fn left_behind(folder: &Path) -> usize {
    let names = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    names.filter(|name| name.to_string_lossy().ends_with(".tmp")).count()
}

#[test]
#[allow(clippy::disallowed_methods, reason = "the moment of a kill is to be any")]
fn a_save_that_is_killed_leaves_one_whole_version() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.json");
    let texts = versions().map(|scene| scene_to_json(&scene));
    let started = Instant::now();
    let seed = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).expect("after 1970").subsec_nanos();
    let mut random = u64::from(seed) | 1;
    let (mut found, mut interrupted) = ([0, 0], 0);
    let (mut kill, mut latest) = (0, LATEST);
    while kill == 0 || found[0].min(found[1]).min(interrupted) <= 10 {
        assert!(latest <= GREATEST, "of {kill} kills, {found:?} met a version and {interrupted} the writing itself");
        for _ in 0..KILLS {
            kill += 1;
            let mut child = saver(&path);
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            sleep(latest.mul_f64((random >> 11) as f64 / (1_u64 << 53) as f64));
            child.kill().expect("killed");
            let status = child.wait().expect("ended");
            assert!(!status.success(), "it saves until it is killed");
            let text = fs::read_to_string(&path).expect("the file is there, as text");
            let version = texts.iter().position(|whole| *whole == text);
            let version = version.unwrap_or_else(|| panic!("kill {kill}, seed {seed}: {} bytes are none", text.len()));
            found[version] += 1;
            // What one kill leaves is gone with the first save of the next program.
            let strays = left_behind(folder.path());
            assert!(strays <= 1, "kill {kill}, seed {seed}: {strays} temporary files");
            interrupted += strays;
        }
        latest *= 2;
    }
    println!("{found:?} found, {interrupted} of {kill} saves interrupted, {:.1} s", started.elapsed().as_secs_f64());
    // A save that is not killed leaves nothing, not even of others.
    save_scene(&path, &every_field()).expect("saved");
    assert_eq!(left_behind(folder.path()), 0);
}

#[test]
fn a_file_that_is_being_written_is_not_swept_away() {
    let folder = tempfile::tempdir().expect("a folder");
    let [busy, other] = ["busy.json", "other.json"].map(|name| folder.path().join(name));
    sinew::test_support::io::write_atomically(&busy, |out| {
        out.write_all(b"half")?;
        save_scene(&other, &every_field()).expect("saved");
        assert_eq!(left_behind(folder.path()), 1, "the half that is being written");
        out.write_all(b" and half")
    })
    .expect("written");
    assert_eq!(fs::read_to_string(&busy).expect("text"), "half and half");
    // A folder or a link of such a name is not ours.
    fs::create_dir(folder.path().join(".sinew-folder.tmp")).expect("made");
    fs::write(folder.path().join(".sinew-stray.tmp"), "left behind").expect("written");
    save_scene(&other, &every_field()).expect("saved");
    assert_eq!(left_behind(folder.path()), 1);
}
