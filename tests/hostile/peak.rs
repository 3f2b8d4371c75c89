//! How much memory and time a piece of work takes: it is done in a program of its own, which tells how much it held at
//! most and how long its threads ran.

use std::env;
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a piece of work is done on, in the program that does it.
const GIVEN: &str = "SINEW_TEST_PEAK";

/// What came of a piece of work.
#[derive(Debug)]
pub struct Peak {
    /// Memory that it took [bytes]; none where the system does not tell.
    pub bytes: Option<u64>,
    /// Time for which its threads ran, whatever else the machine did [s].
    pub seconds: Option<f64>,
    /// What it said.
    pub said: String,
}

/// Does the work of an ignored test, which gives it to [`told`], on a file.
pub fn of(test: &str, file: &Path) -> Peak {
    let out = Command::new(env::current_exe().expect("this program"))
        .args(["--exact", test, "--ignored", "--nocapture", "--test-threads=1"])
        .env(GIVEN, file)
        .output()
        .expect("started");
    let text = String::from_utf8_lossy(&out.stdout);
    let line = |mark: &str| text.lines().find_map(|line| line.split_once(mark).map(|(_, rest)| rest.to_owned()));
    let said = line("said: ").unwrap_or_else(|| {
        panic!("{}: {} {text} {}", file.display(), out.status, String::from_utf8_lossy(&out.stderr))
    });
    let number = |mark: &str| line(mark).and_then(|text| text.parse::<f64>().ok());
    Peak { bytes: number("peak: ").map(|bytes| bytes as u64), seconds: number("ran: "), said }
}

/// The work itself: nothing where it is not asked for.
pub fn told<T: Display, E: Display>(work: impl FnOnce(&Path) -> Result<T, E>) {
    let Some(file) = env::var_os(GIVEN).map(PathBuf::from) else { return };
    let before = held("VmRSS:");
    let begun = ran();
    let said = match work(&file) {
        Ok(found) => format!("read: {found}"),
        Err(error) => format!("refused: {error}"),
    };
    if let (Some(before), Some(most)) = (before, held("VmHWM:")) {
        println!("\npeak: {}", most.saturating_sub(before));
    }
    if let (Some(begun), Some(ended)) = (begun, ran()) {
        println!("\nran: {}", ended - begun);
    }
    println!("\nsaid: {said}");
}

/// Memory of this program [bytes], as Linux counts it.
fn held(what: &str) -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(what))?;
    line.split_whitespace().next()?.parse::<u64>().ok().map(|kilobytes| kilobytes * 1024)
}

/// For how long the threads of this program ran [s], as Linux counts it: by hundredths, after the name of the program.
fn ran() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    let after = stat.rsplit_once(')')?.1;
    let ticks: Vec<f64> = after.split_whitespace().skip(11).take(2).filter_map(|word| word.parse().ok()).collect();
    Some(ticks.iter().sum::<f64>() / 100.0)
}
