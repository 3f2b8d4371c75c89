//! What the window opens: a scene and the models that it names, or a model alone.

use crate::io::{
    IoError, OpenedModel, Stages, is_model, load_assets_unless, load_scene, open_model_unless, path_from,
    refuse_outside, resolved, scene_from_json, unknown_fields,
};
use crate::scene::{Assets, Scene};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The built-in scene.
const BUILT_IN: &str = include_str!("../../scenes/short_bar_soft.json");

/// Share of critical damping with which the floor of an empty scene is met: what lands there comes to rest.
const LANDING: f64 = 0.2;

/// A scene as it was read.
#[derive(Clone, Debug)]
pub struct Document {
    /// The scene.
    pub scene: Scene,
    /// The models that it names.
    pub assets: Arc<Assets>,
    /// Where it was read from; none for what is not a scene's file.
    pub path: Option<PathBuf>,
    /// Folder from which the scene names its models.
    pub folder: PathBuf,
    /// What is to be said about it.
    pub note: Option<String>,
    /// A scene that was asked for and is not opened before the person lets it read these files; this document stands in
    /// its place meanwhile.
    pub asks: Option<(PathBuf, Vec<PathBuf>)>,
}

impl Document {
    /// Reads a scene and its models, or makes a scene of a model; the built-in one unless a path is given. Its models
    /// are read wherever they lie.
    ///
    /// # Errors
    /// A file that cannot be used.
    pub fn load(path: Option<PathBuf>) -> Result<Self, IoError> {
        Self::load_unless(path, true, &mut |_| ControlFlow::Continue(()))
    }

    /// [`Self::load`] of a file that may be anybody's: where it names models outside of its folder, the window asks
    /// before it opens it.
    ///
    /// # Errors
    /// As [`Self::load`].
    pub fn load_or_ask(path: Option<PathBuf>) -> Result<Self, IoError> {
        match Self::load_unless(path.clone(), false, &mut |_| ControlFlow::Continue(())) {
            Err(error) => match (error.bare(), path) {
                (IoError::Outside { files }, Some(path)) => {
                    let note =
                        Some(format!("{} is not open yet: it reads files outside of its folder", path.display()));
                    Ok(Self { note, asks: Some((path, files.clone())), ..Self::empty() })
                }
                _ => Err(error),
            },
            read => read,
        }
    }

    /// [`Self::load`], and `progress` hears what is being worked on and breaks it off. Models outside of the scene's
    /// folder are read only where `outside` says so.
    ///
    /// # Errors
    /// As [`Self::load`], [`IoError::Outside`] and [`IoError::Cancelled`].
    pub(super) fn load_unless(
        path: Option<PathBuf>,
        outside: bool,
        progress: &mut Stages<'_>,
    ) -> Result<Self, IoError> {
        if let Some(path) = path.as_deref().filter(|path| is_model(path)) {
            return Self::of_model(path, progress);
        }
        let scene = path.as_deref().map_or_else(|| scene_from_json(BUILT_IN), load_scene)?;
        let folder = path.as_deref().and_then(Path::parent).unwrap_or(Path::new("")).to_owned();
        if let Some(path) = path.as_deref().filter(|_| !outside) {
            refuse_outside(&scene, path)?;
        }
        let assets = Arc::new(load_assets_unless(&scene, &folder, progress)?);
        let note = path.as_deref().and_then(|path| unknown(path, &scene));
        Ok(Self { scene, assets, path, folder, note, asks: None })
    }

    /// A scene with nothing in it but a floor.
    pub(super) fn empty() -> Self {
        let mut scene = Scene::new("").with_floor(0.0);
        scene.room.contact_damping = LANDING;
        Self { scene, assets: Arc::default(), path: None, folder: PathBuf::new(), note: None, asks: None }
    }

    /// Whether it is what the window starts with unless it is given something else.
    pub(super) fn is_built_in(&self) -> bool {
        self.path.is_none() && self.note.is_none()
    }

    /// A soft solid in the shape of a model, just above a floor.
    fn of_model(path: &Path, progress: &mut Stages<'_>) -> Result<Self, IoError> {
        let opened = open_model_unless(path, progress)?;
        let note = format!("Opened {} as {}", opened.scene.name, opened.said());
        let OpenedModel { scene, assets, .. } = opened;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        Ok(Self { scene, assets: Arc::new(assets), path: None, folder, note: Some(note), asks: None })
    }
}

/// What is to be said of fields that this program does not know.
fn unknown(path: &Path, scene: &Scene) -> Option<String> {
    let fields = unknown_fields(scene);
    let (first, more) = (fields.first()?, fields.len() - 1);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    Some(format!("Opened {}: {first}{more} is unknown here; it is kept but does nothing", path.display()))
}

/// `scene` with the models that it names from the folder `from` named from the folder `to`.
pub(super) fn moved(scene: &Scene, from: &Path, to: &Path) -> Scene {
    let mut scene = scene.clone();
    let (Some(from), Some(to)) = (resolved(from), resolved(to)) else { return scene };
    if from == to {
        return scene;
    }
    for path in scene.model_paths_mut() {
        *path = path_from(&to, &from.join(&*path));
    }
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::load_assets;
    use crate::scene::Shape;

    fn asset(name: &str) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("assets").join(name)
    }

    #[test]
    fn a_scene_saved_elsewhere_still_finds_its_models() {
        let document = Document::load(Some(asset("leaf.glb"))).expect("the model is there");
        let elsewhere = tempfile::tempdir().expect("a folder");
        let moved = moved(&document.scene, &document.folder, elsewhere.path());
        assert!(document.path.is_none() && document.note.is_some());
        let Shape::Mesh(shape) = &moved.bodies[0].shape else { panic!("a mesh") };
        assert!(shape.path.contains(".."), "{}", shape.path);
        load_assets(&moved, elsewhere.path(), &mut |_| {}).expect("the model is found");
        assert_eq!(super::moved(&document.scene, &document.folder, &document.folder), document.scene);
    }
}
