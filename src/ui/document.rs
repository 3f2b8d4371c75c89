//! What the window opens: a scene and the models that it names.

use crate::io::{IoError, load_assets, load_scene, scene_from_json};
use crate::scene::{Assets, Scene};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The built-in scene.
const BUILT_IN: &str = include_str!("../../scenes/short_bar_soft.json");

/// A scene as it was read.
#[derive(Clone, Debug)]
pub struct Document {
    /// The scene.
    pub scene: Scene,
    /// The models that it names.
    pub assets: Arc<Assets>,
    /// Where it was read from.
    pub path: Option<PathBuf>,
}

impl Document {
    /// Reads a scene and its models; the built-in one unless a path is given.
    ///
    /// # Errors
    /// A file that cannot be used.
    pub fn load(path: Option<PathBuf>) -> Result<Self, IoError> {
        let scene = path.as_deref().map_or_else(|| scene_from_json(BUILT_IN), load_scene)?;
        let folder = path.as_deref().and_then(Path::parent).unwrap_or(Path::new(""));
        let assets = Arc::new(load_assets(&scene, folder, &mut |_| {})?);
        Ok(Self { scene, assets, path })
    }
}
