//! Loading what a scene refers to.

use super::{IoError, load_model};
#[cfg(feature = "gui")]
use super::{collect::from_folder, paths::resolved};
use crate::geometry::model::Model;
use crate::geometry::solid::Solid;
use crate::scene::{Assets, ModelFile, Scene};
use std::path::Path;
use std::sync::Arc;

/// Loads and checks the models that a scene names, relative to `folder`, that of the scene file. `progress` hears
/// what is being worked on.
///
/// # Errors
/// [`IoError::Asset`] with the pointer and the file: it cannot be read, or what it holds has no inside.
pub fn load_assets(scene: &Scene, folder: &Path, progress: &mut dyn FnMut(&str)) -> Result<Assets, IoError> {
    let mut assets = Assets::default();
    complete_assets(&mut assets, scene, folder, progress)?;
    Ok(assets)
}

/// [`load_assets`] for models that lie elsewhere than in files: `read` gives what a scene names.
///
/// # Errors
/// As [`load_assets`].
#[cfg(feature = "gui")]
pub(crate) fn load_assets_by(scene: &Scene, read: &dyn Fn(&Path) -> Result<Model, IoError>) -> Result<Assets, IoError> {
    let mut assets = Assets::default();
    complete(&mut assets, scene, Path::new(""), read, &mut |_| {})?;
    Ok(assets)
}

/// [`load_assets`] for those that are not there yet.
///
/// # Errors
/// As [`load_assets`]; those loaded before it stay.
pub(crate) fn complete_assets(
    assets: &mut Assets,
    scene: &Scene,
    folder: &Path,
    progress: &mut dyn FnMut(&str),
) -> Result<(), IoError> {
    complete(assets, scene, folder, &load_model, progress)
}

fn complete(
    assets: &mut Assets,
    scene: &Scene,
    folder: &Path,
    read: &dyn Fn(&Path) -> Result<Model, IoError>,
    progress: &mut dyn FnMut(&str),
) -> Result<(), IoError> {
    for (pointer, shape) in scene.meshes() {
        if assets.solid(shape).is_some() {
            continue;
        }
        let path = folder.join(shape.path);
        let asset = |error: IoError| IoError::Asset { pointer: format!("{pointer}/path"), error: Box::new(error) };
        progress(&format!("{}: reading", shape.path));
        let mut model = read(&path).map_err(asset)?;
        model.stand_up(shape.up_axis(), shape.scale);
        progress(&format!("{}: looking for an inside", shape.path));
        let solid = Solid::new(&model).map_err(|refusal| asset(IoError::from(refusal).within(&path)))?;
        assets.insert(shape, Arc::new(solid));
    }
    for (pointer, mesh) in scene.collider_meshes() {
        if assets.obstacle(mesh).is_some() {
            continue;
        }
        let path = folder.join(&mesh.path);
        let asset = |error: IoError| IoError::Asset { pointer: format!("{pointer}/path"), error: Box::new(error) };
        progress(&format!("{}: reading", mesh.path));
        let mut model = read(&path).map_err(asset)?;
        let file = ModelFile::from(mesh);
        model.stand_up(file.up_axis(), file.scale);
        assets.insert_obstacle_of(file, &model).map_err(|refusal| asset(IoError::from(refusal).within(&path)))?;
    }
    Ok(())
}

/// Reads the model of a file for a collider and puts it in; gives the path by which a scene whose paths are relative to
/// `folder` names it.
///
/// # Errors
/// A file that cannot be read, or that has no face.
#[cfg(feature = "gui")]
pub(crate) fn add_collider_model(assets: &mut Assets, file: &Path, folder: &Path) -> Result<String, IoError> {
    let model = load_model(file)?;
    let path = match resolved(file).zip(resolved(folder).filter(|_| !folder.as_os_str().is_empty())) {
        Some((file, folder)) => from_folder(&file, &folder),
        None => resolved(file).unwrap_or_else(|| file.to_owned()).to_string_lossy().into_owned(),
    };
    let refused = |refusal| IoError::from(refusal).within(file);
    assets.insert_obstacle_of(path.as_str(), &model).map_err(refused)?;
    Ok(path)
}
