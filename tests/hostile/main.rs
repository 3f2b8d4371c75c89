//! What comes from outside and does harm: files of any bytes, files that ask for the whole machine, disks that fail.

#![allow(
    clippy::print_stdout,
    reason = "programs that are started by a test, and the long forms, tell what they found"
)]

mod bombs;
mod drawn;
mod exports;
mod faults;
mod files;
mod fuzz;
mod kills;
mod mutate;
mod peak;
mod read;
mod run;

/// Commands of every kind at random, as the tests of the editor have them.
#[path = "../edit/any_commands.rs"]
#[allow(dead_code, reason = "here all kinds are alike")]
mod any_commands;
/// Fibres to edit.
#[path = "../edit/shapes.rs"]
#[allow(dead_code, reason = "here commands alone ask for them")]
mod shapes;

use sinew::io::scene_from_json;
use sinew::scene::Scene;

/// A scene of everything that a scene may hold.
fn every_field() -> Scene {
    scene_from_json(include_str!("../scene_files/every_field.json")).expect("a scene")
}
