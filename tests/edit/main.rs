//! What can be done to an open document.

mod any_commands;
mod commands;
mod drives;
mod fibre_ops;
mod history;
mod random;
mod shapes;

use sinew::io::{load_scene, scene_from_json};
use sinew::scene::Scene;
use std::path::Path;

/// The paper's short bar.
fn scene() -> Scene {
    load_scene(&Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/short_bar.json")).expect("a scene")
}

/// A scene of two bodies, five two-layer bodies and everything else that a scene may hold.
fn every_field() -> Scene {
    scene_from_json(include_str!("../scene_files/every_field.json")).expect("a scene")
}
