//! Examples as documents, and their models put where a scene is saved.

use super::examples::{Example, shipped};
use crate::io::{IoError, put_beside};
use crate::scene::Scene;
use crate::ui::document::Document;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Whether a model of this name ships.
pub(crate) fn is_shipped(name: &str) -> bool {
    shipped(name).is_some()
}

/// The bytes of a model of this name that ships.
pub(crate) fn shipped_bytes(name: &str) -> Option<&'static [u8]> {
    shipped(name)
}

/// Puts a model that ships into a folder; gives the name that it has there.
///
/// # Errors
/// It cannot be written, or no model of that name ships.
pub(crate) fn shipped_beside(folder: &Path, name: &str) -> Result<String, IoError> {
    put_beside(folder, name, shipped(name).ok_or(IoError::Missing)?)
}

/// The scene of an example as it can be saved in a folder: its models are put there beside it.
///
/// # Errors
/// A model cannot be written.
pub(crate) fn with_models_in(folder: &Path, scene: &Scene) -> Result<Scene, IoError> {
    let mut scene = scene.clone();
    for path in scene.model_paths_mut() {
        if let Some(bytes) = shipped(path) {
            *path = put_beside(folder, path, bytes)?;
        }
    }
    Ok(scene)
}

impl Document {
    /// An example: a document without a file, whose models come with the program.
    ///
    /// # Errors
    /// None for what ships.
    pub fn of_example(example: &Example) -> Result<Self, IoError> {
        let (scene, assets) = example.load()?;
        let note = Some(format!("Opened {}: {}", example.title, example.line));
        Ok(Self { scene, assets: Arc::new(assets), path: None, folder: PathBuf::new(), note, asks: None })
    }
}
