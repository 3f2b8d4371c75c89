//! A scene with its models beside it: a folder that opens wherever it is moved, copied or sent.

use super::beside::put_beside;
use super::model::companions;
use super::paths::resolved;
use super::read::{open_file, read_bytes};
use super::{IoError, make_folder, scene_to_json, write_atomically};
use crate::scene::Scene;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::ffi::OsStr;
use std::io::{self, BufRead, BufReader};
use std::path::{Component, Path, PathBuf};

/// Larger models than this are not read [bytes].
const LARGEST: u64 = 4 << 30;

/// What was put into the folder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Collected {
    /// The scene file.
    pub(crate) scene: PathBuf,
    /// Models that went with it.
    pub(crate) models: usize,
    /// Models that name files which are not there, with the names.
    pub(crate) missing: Vec<(PathBuf, Vec<String>)>,
}

/// A file that goes along.
pub(super) struct Companion {
    /// Its path in the folder that it goes into.
    pub(super) name: PathBuf,
    pub(super) source: PathBuf,
}

/// Puts a scene of this name into a folder, with its models and the files that these name; nothing that is there is
/// written over. `from` is the folder that the scene's paths are relative to.
///
/// # Errors
/// A model that cannot be read or names files that cannot go along, before anything is written; a file that cannot be
/// written.
pub(crate) fn collect_scene(scene: &Scene, from: &Path, name: &OsStr, into: &Path) -> Result<Collected, IoError> {
    scene.validate()?;
    let mut scene = scene.clone();
    let mut files: BTreeMap<PathBuf, Vec<Companion>> = BTreeMap::new();
    let mut missing = Vec::new();
    for path in scene.model_paths_mut() {
        let source = from.join(&*path);
        if let Entry::Vacant(vacant) = files.entry(source) {
            let (found, lost) = files_of(vacant.key())?;
            if !lost.is_empty() {
                missing.push((vacant.key().clone(), lost));
            }
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
    Ok(Collected { scene: into.join(name), models: files.len(), missing })
}

/// A model's own file first, by its name, then those that it names, by their paths from its folder; and the names of
/// those that are not there.
pub(super) fn files_of(source: &Path) -> Result<(Vec<Companion>, Vec<String>), IoError> {
    let bytes = read_bytes(source, LARGEST).map_err(|error| error.within(source))?;
    let folder = source.parent().unwrap_or(Path::new(""));
    let named = companions(source, &bytes).map_err(|error| error.within(source))?;
    let own = PathBuf::from(source.file_name().unwrap_or_default());
    let mut files = vec![Companion { name: own, source: source.to_owned() }];
    for path in named.there {
        let is_inside = path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
        if !is_inside {
            return Err(IoError::CompanionOutside { file: path }.within(source));
        }
        let source = folder.join(&path);
        // Whether it can be read is found out before anything is written.
        open_file(&source).map_err(|error| error.within(&source))?;
        files.push(Companion { name: path, source });
    }
    Ok((files, named.missing))
}

/// Puts a model beside the scene, or with the files that it names into a folder of its own. Gives its path from there.
fn put(files: &[Companion], into: &Path) -> Result<String, IoError> {
    let [model, named @ ..] = files else { return Ok(String::new()) };
    let name = model.name.to_string_lossy();
    if named.is_empty() {
        let bytes = read_bytes(&model.source, LARGEST).map_err(|error| error.within(&model.source))?;
        return put_beside(into, &name, &bytes);
    }
    let stem = model.name.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let names = std::iter::once(stem.clone()).chain((2..).map(|number| format!("{stem}-{number}")));
    for folder_name in names {
        let folder = into.join(&folder_name);
        if folder.is_file() || !all_free(files, &folder)? {
            continue;
        }
        for Companion { name, source } in files {
            let path = folder.join(name);
            make_folder(path.parent().unwrap_or(&folder))?;
            let (mut file, _) = open_file(source).map_err(|error| error.within(source))?;
            write_atomically(&path, |mut out| io::copy(&mut file, &mut out).map(drop))?;
        }
        return Ok(format!("{folder_name}/{name}"));
    }
    Ok(String::new())
}

/// Whether nothing else than the files themselves is in their places in a folder.
fn all_free(files: &[Companion], folder: &Path) -> Result<bool, IoError> {
    for Companion { name, source } in files {
        let (file, length) = open_file(source).map_err(|error| error.within(source))?;
        let is_free = match open_file(&folder.join(name)) {
            Ok((there, of)) => {
                let same = || Ok(of == length && is_same(BufReader::new(there), BufReader::new(file))?);
                same().map_err(|error| IoError::Read(error).within(source))?
            }
            Err(error) => matches!(error, IoError::Missing),
        };
        if !is_free {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Whether two files have the same content, however long they are.
fn is_same(mut a: impl BufRead, mut b: impl BufRead) -> io::Result<bool> {
    loop {
        let (left, right) = (a.fill_buf()?, b.fill_buf()?);
        let length = left.len().min(right.len());
        if length == 0 {
            return Ok(left.len() == right.len());
        }
        if left[..length] != right[..length] {
            return Ok(false);
        }
        a.consume(length);
        b.consume(length);
    }
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
pub(super) fn from_folder(file: &Path, folder: &Path) -> String {
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
        // What has no way in common is named as it is, as files on another drive are.
        assert_eq!(path("b/c.obj", "/a/b"), "b/c.obj");
        #[cfg(windows)]
        {
            assert_eq!(path(r"D:\b\c.obj", r"C:\a\b"), r"D:\b\c.obj");
            assert_eq!(path(r"C:\a\c.obj", r"C:\a\b"), "../c.obj");
        }
    }
}
