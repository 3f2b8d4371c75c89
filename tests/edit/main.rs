//! What can be done to an open document.

mod fibre_ops;
mod history;
mod shapes;

use sinew::io::load_scene;
use sinew::scene::Scene;
use std::path::Path;

/// The paper's short bar.
fn scene() -> Scene {
    load_scene(&Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/short_bar.json")).expect("a scene")
}
