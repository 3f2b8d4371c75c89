//! A scene with its models beside it: a folder that opens wherever it is moved, copied or sent.

use super::beside::put_beside;
use super::model::companions;
use super::paths::resolved;
use super::read::read_bytes;
use super::{IoError, make_folder, scene_to_json, write_atomically};
use crate::scene::Scene;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};

/// Larger files than this are not copied [bytes].
const LARGEST: u64 = 4 << 30;

/// What was put into the folder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Collected {
    /// The scene file.
    pub(crate) scene: PathBuf,
    /// Models that went with it.
    pub(crate) models: usize,
}

/// Puts a scene of this name into a folder, with its models and the files that these name; nothing that is there is written
/// over. `from` is the folder that the scene's paths are relative to.
///
/// # Errors
/// A model that cannot be read or names files that cannot go along, before anything is written; a file that cannot be
/// written.
pub(crate) fn collect_scene(scene: &Scene, from: &Path, name: &OsStr, into: &Path) -> Result<Collected, IoError> {
    scene.validate()?;
    let mut scene = scene.clone();
    let mut files: BTreeMap<PathBuf, Vec<(PathBuf, Vec<u8>)>> = BTreeMap::new();
    for path in scene.model_paths_mut() {
        let source = from.join(&*path);
        if let Entry::Vacant(vacant) = files.entry(source) {
            let found = files_of(vacant.key())?;
            vacant.insert(found);
        }
    }
    make_folder(into)?;
    let mut placed = BTreeMap::new();
    for (source, files) in &files {
        placed.insert(source.clone(), put(files, into)?);
    }
    for path in scene.model_paths_mut() {
        if let Some(name) = placed.get(&from.join(&*path)) {
            path.clone_from(name);
        }
    }
    let name = put_beside(into, &name.to_string_lossy(), scene_to_json(&scene).as_bytes())?;
    Ok(Collected { scene: into.join(name), models: files.len() })
}

/// A model's own file first, by its name, then those that it names, by their paths from its folder; with their content.
fn files_of(source: &Path) -> Result<Vec<(PathBuf, Vec<u8>)>, IoError> {
    let bytes = read_bytes(source, LARGEST).map_err(|error| error.within(source))?;
    let folder = source.parent().unwrap_or(Path::new(""));
    let named = companions(source, &bytes).map_err(|error| error.within(source))?;
    let mut files = vec![(PathBuf::from(source.file_name().unwrap_or_default()), bytes)];
    for path in named {
        let is_inside = path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
        match read_bytes(&folder.join(&path), LARGEST) {
            // What is missing is missing where it was, too: the model does without.
            Err(IoError::Missing) => {}
            Ok(_) if !is_inside => return Err(IoError::CompanionOutside { file: path }.within(source)),
            Ok(bytes) => files.push((path, bytes)),
            Err(error) => return Err(error.within(&folder.join(&path))),
        }
    }
    Ok(files)
}

/// Puts a model beside the scene, or with the files that it names into a folder of its own. Gives its path from there.
fn put(files: &[(PathBuf, Vec<u8>)], into: &Path) -> Result<String, IoError> {
    let [(name, bytes), named @ ..] = files else { return Ok(String::new()) };
    if named.is_empty() {
        return put_beside(into, &name.to_string_lossy(), bytes);
    }
    let stem = name.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let names = std::iter::once(stem.clone()).chain((2..).map(|number| format!("{stem}-{number}")));
    for folder_name in names {
        let folder = into.join(&folder_name);
        let is_free = |(name, bytes): &(PathBuf, Vec<u8>)| match read_bytes(&folder.join(name), LARGEST) {
            Ok(there) => there == *bytes,
            Err(error) => matches!(error, IoError::Missing),
        };
        if folder.is_file() || !files.iter().all(is_free) {
            continue;
        }
        for (name, bytes) in files {
            let path = folder.join(name);
            make_folder(path.parent().unwrap_or(&folder))?;
            write_atomically(&path, |out| out.write_all(bytes))?;
        }
        return Ok(format!("{folder_name}/{}", name.to_string_lossy()));
    }
    Ok(String::new())
}

/// A scene whose models are named from the folder of `path` in place of `from`.
///
/// # Errors
/// A folder that is not there.
pub(crate) fn with_models_from(mut scene: Scene, from: &Path, path: &Path) -> Result<Scene, IoError> {
    let to = path.parent().unwrap_or(Path::new(""));
    let whole = |folder: &Path| resolved(folder).ok_or_else(|| IoError::Missing.within(folder));
    if scene.model_paths_mut().next().is_none() {
        return Ok(scene);
    }
    let (from, to) = (whole(from)?, whole(to)?);
    if from != to {
        for path in scene.model_paths_mut() {
            let model = from.join(&*path);
            let model = resolved(&model).unwrap_or(model);
            *path = from_folder(&model, &to);
        }
    }
    Ok(scene)
}

/// The path of a file from a folder, both whole, with slashes as every system reads them.
fn from_folder(file: &Path, folder: &Path) -> String {
    let (file, folder): (Vec<_>, Vec<_>) = (file.components().collect(), folder.components().collect());
    let shared = file.iter().zip(&folder).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        // Another drive.
        return file.iter().collect::<PathBuf>().to_string_lossy().into_owned();
    }
    let up = folder[shared..].iter().map(|_| "..".to_owned());
    let down = file[shared..].iter().map(|part| part.as_os_str().to_string_lossy().into_owned());
    up.chain(down).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_lead_from_one_folder_to_another() {
        let path = |file: &str, folder: &str| from_folder(Path::new(file), Path::new(folder));
        assert_eq!(path("/a/b/c.obj", "/a/b"), "c.obj");
        assert_eq!(path("/a/b/c.obj", "/a/d/e"), "../../b/c.obj");
    }
}
