//! Loading what a scene refers to.

use super::IoError;
#[cfg(feature = "gui")]
use super::load_model;
use super::model::{is_model, model_bytes, read_cache, read_model, read_skeleton};
#[cfg(feature = "gui")]
use super::{collect::from_folder, paths::resolved};
use crate::geometry::solid::Solid;
use crate::scene::{AnyBody, Assets, Leader, MAX_PARTICLES, ModelFile, Scene, Shape, TwoLayerShape};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

/// Loads and checks the models that a scene names, relative to `folder`, that of the scene file. `progress` hears
/// what is being worked on.
///
/// # Errors
/// [`IoError::Asset`] with the pointer and the file: it cannot be read, or what it holds has no inside.
pub fn load_assets(scene: &Scene, folder: &Path, progress: &mut dyn FnMut(&str)) -> Result<Assets, IoError> {
    load_assets_unless(scene, folder, &mut never(progress))
}

/// Hears what is being worked on; breaks off what is no longer wanted.
pub(crate) type Stages<'a> = dyn FnMut(&str) -> ControlFlow<()> + 'a;

/// What only hears.
pub(super) fn never(progress: &mut dyn FnMut(&str)) -> impl FnMut(&str) -> ControlFlow<()> {
    |said| {
        progress(said);
        ControlFlow::Continue(())
    }
}

/// [`load_assets`], unless `progress` breaks it off.
///
/// # Errors
/// As [`load_assets`], and [`IoError::Cancelled`].
pub(crate) fn load_assets_unless(scene: &Scene, folder: &Path, progress: &mut Stages<'_>) -> Result<Assets, IoError> {
    let mut assets = Assets::default();
    let bytes = |path: &Path| model_bytes(path).map_err(|error| error.within(path));
    complete(&mut assets, scene, folder, &bytes, progress)?;
    Ok(assets)
}

/// Tells of it.
fn tell(progress: &mut Stages<'_>, said: &str) -> Result<(), IoError> {
    if progress(said).is_break() { Err(IoError::Cancelled) } else { Ok(()) }
}

/// [`load_assets`] for files that lie elsewhere: `bytes` gives those of what a scene names.
///
/// # Errors
/// As [`load_assets`].
#[cfg(feature = "gui")]
pub(crate) fn load_assets_by(scene: &Scene, bytes: &Bytes<'_>) -> Result<Assets, IoError> {
    let mut assets = Assets::default();
    complete(&mut assets, scene, Path::new(""), bytes, &mut |_| ControlFlow::Continue(()))?;
    Ok(assets)
}

/// Loads what the bodies of a scene name that is not there yet, for bodies that stand in no file; `given` has the bytes
/// of what needs no file. `progress` hears what is being worked on.
///
/// # Errors
/// As [`load_assets_unless`], without the place in the scene.
#[cfg(feature = "gui")]
pub(crate) fn add_models_of(
    assets: &mut Assets,
    scene: &Scene,
    folder: &Path,
    given: &dyn Fn(&Path) -> Option<&'static [u8]>,
    progress: &mut Stages<'_>,
) -> Result<(), IoError> {
    let bytes = |path: &Path| match given(path) {
        Some(bytes) => Ok(bytes.to_vec()),
        None => model_bytes(path).map_err(|error| error.within(path)),
    };
    complete(assets, scene, folder, &bytes, progress).map_err(without_pointer)
}

/// What is wrong with a file that no written scene names.
pub(super) fn without_pointer(error: IoError) -> IoError {
    match error {
        IoError::Asset { error, .. } => *error,
        other => other,
    }
}

/// What gives the bytes of a file by its path.
type Bytes<'a> = dyn Fn(&Path) -> Result<Vec<u8>, IoError> + 'a;

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
    let bytes = |path: &Path| model_bytes(path).map_err(|error| error.within(path));
    complete(assets, scene, folder, &bytes, &mut never(progress))
}

fn complete(
    assets: &mut Assets,
    scene: &Scene,
    folder: &Path,
    bytes: &Bytes<'_>,
    progress: &mut Stages<'_>,
) -> Result<(), IoError> {
    let read = |path: &Path| {
        if !is_model(path) {
            return Err(IoError::UnknownModel.within(path));
        }
        read_model(path, &bytes(path)?)
    };
    for (pointer, shape) in scene.meshes() {
        if assets.solid(shape).is_some() {
            continue;
        }
        let path = folder.join(shape.path);
        let asset = |error: IoError| IoError::Asset { pointer: format!("{pointer}/path"), error: Box::new(error) };
        tell(progress, &format!("{}: reading", shape.path))?;
        let mut model = read(&path).map_err(asset)?;
        model.stand_up(shape.up_axis(), shape.scale);
        let mut looked = |done, of| progress(&format!("{}: looking for an inside, {} %", shape.path, 100 * done / of));
        let ControlFlow::Continue(solid) = Solid::with_progress(&model, &mut looked) else {
            return Err(IoError::Cancelled);
        };
        let solid = solid.map_err(|refusal| asset(IoError::from(refusal).within(&path)))?;
        assets.insert(shape, Arc::new(solid));
    }
    for (pointer, mesh) in scene.collider_meshes() {
        if assets.obstacle(mesh).is_some() {
            continue;
        }
        let path = folder.join(&mesh.path);
        let asset = |error: IoError| IoError::Asset { pointer: format!("{pointer}/path"), error: Box::new(error) };
        tell(progress, &format!("{}: reading", mesh.path))?;
        let mut model = read(&path).map_err(asset)?;
        let file = ModelFile::from(mesh);
        model.stand_up(file.up_axis(), file.scale);
        assets.insert_obstacle_of(file, &model).map_err(|refusal| asset(IoError::from(refusal).within(&path)))?;
    }
    for (pointer, leader) in scene.leaders() {
        complete_leader(assets, &pointer, leader, folder, bytes, progress)?;
    }
    check_particles(assets, scene)
}

/// Refuses models of which more particles are to be made than are allowed in a scene; one that is too much by itself
/// is told of where it is filled.
fn check_particles(assets: &Assets, scene: &Scene) -> Result<(), IoError> {
    let (mut particles, most) = (0.0, MAX_PARTICLES as f64);
    for (index, body) in scene.all_bodies().enumerate() {
        let own = match body {
            AnyBody::Solid(body) => {
                let solid = if let Shape::Mesh(shape) = &body.shape { assets.solid(shape) } else { None };
                body.about_particles(solid.map(|solid| solid.volume))
            }
            AnyBody::TwoLayer(body) => {
                let solid = if let TwoLayerShape::Mesh(mesh) = &body.shape { assets.solid(mesh) } else { None };
                body.about_particles(solid.map(|solid| solid.surface.points.len()))
            }
        };
        let own = own.unwrap_or_default();
        particles += own;
        if particles > most && own <= most {
            let (place, what) = match body {
                AnyBody::Solid(_) => ("material/support_radius", "the bodies larger support radii"),
                AnyBody::TwoLayer(_) => ("shape/mesh/path", "coarser models"),
            };
            let pointer = format!("{}/{place}", scene.body_pointer(index));
            let error = Box::new(IoError::TooManyParticles { particles, most, what });
            return Err(IoError::Asset { pointer, error });
        }
    }
    Ok(())
}

/// Loads what a body follows.
fn complete_leader(
    assets: &mut Assets,
    pointer: &str,
    leader: &Leader,
    folder: &Path,
    bytes: &Bytes<'_>,
    progress: &mut Stages<'_>,
) -> Result<(), IoError> {
    let at = |place: &str, error: IoError| {
        let pointer = format!("{pointer}/{place}");
        IoError::Asset { pointer, error: Box::new(error) }
    };
    let path = folder.join(leader.path());
    match leader {
        Leader::Skeleton(of) if assets.skeleton(&of.path).is_none() => {
            tell(progress, &format!("{}: reading its skeleton", of.path))?;
            let skeleton = bytes(&path).and_then(|bytes| read_skeleton(&path, &bytes));
            assets.insert_skeleton(&of.path, skeleton.map_err(|error| at("skeleton/path", error))?);
        }
        Leader::Cache(of) => {
            if assets.cache(&of.path).is_none() {
                tell(progress, &format!("{}: reading", of.path))?;
                let cache = bytes(&path).and_then(|bytes| read_cache(&path, &bytes));
                assets.insert_cache(&of.path, cache.map_err(|error| at("cache/path", error))?);
            }
            if let Some(rest) = of.rest.as_ref().filter(|rest| assets.rest_mesh(rest).is_none()) {
                tell(progress, &format!("{rest}: reading"))?;
                let file = folder.join(rest);
                let model = bytes(&file).and_then(|bytes| read_model(&file, &bytes));
                let model = model.map_err(|error| at("cache/rest", error))?;
                assets.insert_rest_mesh(rest, model.file.unwrap_or_default());
            }
        }
        Leader::Skeleton(_) => {}
    }
    Ok(())
}

/// Reads what a leader names and puts it in, for a scene whose paths are relative to `folder`. `progress` hears what is
/// being worked on.
///
/// # Errors
/// A file that cannot be read, or that holds no such motion.
#[cfg(feature = "gui")]
pub(crate) fn add_leader(
    assets: &mut Assets,
    leader: &Leader,
    folder: &Path,
    progress: &mut Stages<'_>,
) -> Result<(), IoError> {
    let bytes = |path: &Path| model_bytes(path).map_err(|error| error.within(path));
    complete_leader(assets, "", leader, folder, &bytes, progress).map_err(without_pointer)
}

/// The path by which a scene whose paths are relative to `folder` names a file.
#[cfg(feature = "gui")]
pub(crate) fn path_from(folder: &Path, file: &Path) -> String {
    let file = resolved(file).unwrap_or_else(|| file.to_owned());
    match resolved(folder).filter(|_| !folder.as_os_str().is_empty()) {
        Some(folder) => from_folder(&file, &folder),
        None => file.to_string_lossy().into_owned(),
    }
}

/// Reads the model of a file for a collider and puts it in; gives the path by which a scene whose paths are relative to
/// `folder` names it. `progress` hears what is being worked on.
///
/// # Errors
/// A file that cannot be read, or that has no face.
#[cfg(feature = "gui")]
pub(crate) fn add_collider_model(
    assets: &mut Assets,
    file: &Path,
    folder: &Path,
    progress: &mut Stages<'_>,
) -> Result<String, IoError> {
    tell(progress, &format!("{}: reading", file.display()))?;
    let model = load_model(file)?;
    tell(progress, &format!("{}: looking at its surface", file.display()))?;
    let path = path_from(folder, file);
    let refused = |refusal| IoError::from(refusal).within(file);
    assets.insert_obstacle_of(path.as_str(), &model).map_err(refused)?;
    Ok(path)
}
