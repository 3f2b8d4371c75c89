//! A scene as it is written into a folder.

use super::document::moved;
use super::gallery::with_models_in;
use crate::io::IoError;
use crate::scene::Scene;
use std::path::Path;

/// `scene` for a file in the folder `to`: with the models that it names from the folder `from` named from there, and
/// those that came with the program put beside it.
///
/// # Errors
/// A model that cannot be put there.
pub(crate) fn placed(scene: &Scene, from: &Path, is_example: bool, to: &Path) -> Result<Scene, IoError> {
    if is_example { with_models_in(to, scene) } else { Ok(moved(scene, from, to)) }
}
