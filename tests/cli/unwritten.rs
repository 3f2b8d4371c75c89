//! Runs whose files cannot all be written: what was computed is told and written as far as it can be.

use super::{Desk, pressed};
use std::fs;
#[cfg(unix)]
use std::process::Command;

#[test]
fn a_frame_that_cannot_be_written_ends_the_run_with_its_report_and_series() {
    let desk = Desk::new(&pressed());
    fs::create_dir_all(desk.path("frames/frame_000003.obj/in")).unwrap();
    let said = desk.run("simulate scene.json --report r.json --series s.csv --out frames");
    assert_eq!(said.code, Some(2), "{said:?}");
    assert!(said.err.contains("frame_000003.obj"), "{}", said.err);
    let report = desk.json("r.json");
    assert_eq!(report["complete"], false);
    // Files are written beside the run, which may be a frame or two further by then.
    let frames = report["frames"].as_u64().expect("a number") as usize;
    assert!((3..6).contains(&frames), "{frames}");
    assert_eq!(desk.text("s.csv").lines().count(), 2 + frames);
    assert!(said.out.contains("report written to r.json"), "{}", said.out);
    assert!(desk.path("frames/frame_000002.obj").is_file());
}

#[cfg(unix)]
#[test]
fn what_a_run_shows_is_told_though_its_report_does_not_fit_on_the_disk() {
    let desk = Desk::new(&pressed());
    // No file may have more than a block, as on a disk that is full.
    let text = "trap '' XFSZ; ulimit -f 1; exec \"$0\" simulate scene.json --report r.json --series s.csv";
    let mut command = Command::new("sh");
    command.args(["-c", text, env!("CARGO_BIN_EXE_sinew")]).current_dir(desk.folder.path());
    let said = super::said(&mut command);
    assert_eq!(said.code, Some(2), "{said:?}");
    assert!(said.out.contains("Block"), "the summary is told: {}", said.out);
    let files: Vec<&str> = said.err.lines().filter(|line| line.contains("r.json") || line.contains("s.csv")).collect();
    assert_eq!(files.len(), 2, "both are told: {}", said.err);
    assert_eq!(desk.files(), ["scene.json"], "nothing is left of them");
}
