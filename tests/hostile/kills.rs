//! Programs that are killed while they write: whatever they were at, one whole version is there, and the next start
//! leaves nothing else.

use crate::faults::{KINDS, Kind, litter};
use crate::files::in_new_folder;
use crate::mutate::Random;
use std::env;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// What the program that is killed writes, and where to.
const KIND: &str = "SINEW_TEST_KILL_KIND";
const FOLDER: &str = "SINEW_TEST_KILL_FOLDER";

/// How many kills of each kind the long form does, and how many the one of the suite.
const ASKED: &str = "SINEW_KILLS";
const LONG: u32 = 1000;
const SHORT: u32 = 6;

/// Latest moment of a kill after the first write.
const LATEST: Duration = Duration::from_millis(30);

/// The program that is killed: no test of its own.
#[test]
#[ignore = "writes until it is killed, by those below"]
fn writes_until_killed() {
    let (Ok(name), Some(folder)) = (env::var(KIND), env::var_os(FOLDER).map(PathBuf::from)) else { return };
    let kind = KINDS.iter().find(|kind| kind.name == name).expect("a kind");
    for round in 0.. {
        (kind.write)(&folder, round % 2).expect("written");
        if round == 0 {
            eprintln!("writing");
        }
    }
}

fn writer(kind: &Kind, folder: &Path) -> Child {
    let mut child = Command::new(env::current_exe().expect("this program"))
        .args(["--exact", "kills::writes_until_killed", "--ignored", "--nocapture"])
        .env(KIND, kind.name)
        .env(FOLDER, folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("started");
    let mut lines = BufReader::new(child.stderr.take().expect("piped")).lines();
    assert!(lines.any(|line| line.expect("text") == "writing"), "{}: it ended before it wrote", kind.name);
    child
}

/// Kills it so often; gives how many left a file half written behind.
#[allow(clippy::disallowed_methods, reason = "the moment of a kill is to be any")]
fn killed(kind: &Kind, kills: u32, random: &mut Random) -> u32 {
    let mut interrupted = 0;
    for kill in 0..kills {
        in_new_folder(|folder| {
            let mut child = writer(kind, folder);
            sleep(LATEST.mul_f64(random.below(1000) as f64 * 1e-3));
            child.kill().expect("killed");
            child.wait().expect("ended");
            // Each that is there is a whole one: others are told by a panic.
            let found = (kind.versions)(folder);
            assert!(!found.is_empty(), "{}, kill {kill}: nothing is left", kind.name);
            interrupted += u32::from(litter(folder).iter().any(|path| path.extension().is_some_and(|e| e == "tmp")));
            (kind.start)(folder);
            let left = litter(folder);
            assert!(left.is_empty(), "{}, kill {kill}: {left:?} are left", kind.name);
            let left = (kind.versions)(folder).len();
            assert!(left == found.len(), "{}, kill {kill}: the start took one", kind.name);
        });
    }
    interrupted
}

#[test]
fn a_few_kills_of_every_kind_leave_whole_versions_and_no_litter() {
    for kind in &KINDS {
        killed(kind, SHORT, &mut Random(5));
    }
}

#[test]
#[ignore = "minutes: SINEW_KILLS=1000 cargo test --release --test hostile -- --ignored --nocapture a_thousand_kills"]
fn a_thousand_kills_of_every_kind_leave_whole_versions_and_no_litter() {
    let kills = env::var(ASKED).map_or(LONG, |kills| kills.parse().expect("a number"));
    for kind in &KINDS {
        let interrupted = killed(kind, kills, &mut Random(u64::from(kills)));
        println!("{}: {kills} kills, {interrupted} of them within a write", kind.name);
        assert!(interrupted > kills / 100, "{}: hardly one met the writing itself", kind.name);
    }
}
