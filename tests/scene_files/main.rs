//! Scene files: what is accepted, what is refused and how the refusal reads.

mod round_trip;
mod schema;

use sinew::io::scene_from_json;
use sinew::scene::Scene;

/// A scene that uses every field and every alternative of the format.
const EVERY_FIELD: &str = include_str!("every_field.json");

/// The scene of [`EVERY_FIELD`].
fn every_field() -> Scene {
    scene_from_json(EVERY_FIELD).expect("the example is a valid scene")
}
