//! Scene files: what is accepted, what is refused and how the refusal reads.

mod any_element;
mod any_parts;
mod building;
mod damage;
mod errors;
mod files;
mod killing;
mod page;
mod recovery;
mod round_trip;
mod schema;
mod sets;

use sinew::io::scene_from_json;
use sinew::scene::Scene;

/// A scene that uses every field and every alternative of the format.
const EVERY_FIELD: &str = include_str!("every_field.json");

/// The scene of [`EVERY_FIELD`].
fn every_field() -> Scene {
    scene_from_json(EVERY_FIELD).expect("the example is a valid scene")
}

/// Whether a message is what a person can read in one glance: a line, not empty.
fn is_one_line(message: &str) -> bool {
    !message.trim().is_empty() && !message.chars().any(char::is_control)
}
