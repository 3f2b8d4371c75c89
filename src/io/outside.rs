//! Files that a scene names outside of where its own things lie: read only where a person says so.

use super::IoError;
use super::paths::resolved;
use crate::scene::Scene;
use std::path::{Component, Path, PathBuf, absolute};

/// A folder of this name beside the scene's own is its own, too: scenes in one folder share their models there.
const SHARED: &str = "assets";

/// Refuses the scene of a file that names others outside of where its own lie.
///
/// # Errors
/// [`IoError::Outside`] with them, within [`IoError::InFile`].
pub(crate) fn refuse_outside(scene: &Scene, file: &Path) -> Result<(), IoError> {
    let files = files_outside(scene, file.parent().unwrap_or(Path::new("")));
    if files.is_empty() { Ok(()) } else { Err(IoError::Outside { files }.within(file)) }
}

/// The files that a scene names which lie neither in its folder, nor in a folder `assets` beside that, wherever links
/// lead, in the order of their names. Whether they are there is not told.
fn files_outside(scene: &Scene, folder: &Path) -> Vec<PathBuf> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let own = whole(folder);
    let shared = own.parent().map(|above| whole(&above.join(SHARED)));
    let is_within = |file: &Path| {
        let file = whole(file);
        file.starts_with(&own) || shared.as_ref().is_some_and(|shared| file.starts_with(shared))
    };
    let mut scene = scene.clone();
    let mut found: Vec<PathBuf> =
        scene.model_paths_mut().map(|path| folder.join(path)).filter(|file| !is_within(file)).collect();
    found.sort();
    found.dedup();
    found
}

/// A path from the root, with links followed as far as it leads to anything, and without steps up.
fn whole(path: &Path) -> PathBuf {
    if let Some(path) = resolved(path) {
        return path;
    }
    let path = absolute(path).unwrap_or_else(|_| path.to_owned());
    // Of what is not there the longest part that is.
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(plain.pop()),
            Component::CurDir => {}
            other => plain.push(other),
        }
        plain = resolved(&plain).unwrap_or(plain);
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Body, MeshShape};
    use std::fs;

    /// Whether a scene in `folder` that names a file reaches outside.
    fn reaches(folder: &Path, path: &str) -> bool {
        let scene = Scene::new("").with_body(Body::from_mesh("model", MeshShape::new(path)));
        !files_outside(&scene, folder).is_empty()
    }

    #[test]
    fn what_lies_in_the_folder_or_in_the_assets_beside_it_is_the_scenes_own() {
        let root = tempfile::tempdir().expect("a folder");
        let folder = root.path().join("scenes");
        for made in ["scenes/models", "assets", "other"] {
            fs::create_dir_all(root.path().join(made)).expect("made");
        }
        for file in ["scenes/a.obj", "scenes/models/a.obj", "assets/a.obj", "other/a.obj", "a.obj"] {
            fs::write(root.path().join(file), "").expect("written");
        }
        let whole = |file: &str| root.path().join(file).to_string_lossy().into_owned();
        for (path, is_outside) in [
            ("a.obj", false),
            ("models/a.obj", false),
            ("models/../a.obj", false),
            ("../assets/a.obj", false),
            ("../scenes/a.obj", false),
            (&whole("scenes/a.obj"), false),
            ("nowhere.obj", false),
            ("../a.obj", true),
            ("../other/a.obj", true),
            ("../assets/../other/a.obj", true),
            ("models/../../a.obj", true),
            ("../nowhere.obj", true),
            ("nowhere/../../a.obj", true),
            (&whole("other/a.obj"), true),
            ("/etc/hostname", true),
        ] {
            assert_eq!(reaches(&folder, path), is_outside, "{path}");
        }
        #[cfg(unix)]
        {
            let link = |to: &str, at: &str| std::os::unix::fs::symlink(root.path().join(to), folder.join(at));
            link("other", "linked").and_then(|()| link("other/a.obj", "link.obj")).expect("linked");
            assert!(
                reaches(&folder, "linked/a.obj") && reaches(&folder, "link.obj") && reaches(&folder, "linked/b.obj")
            );
        }
        // As it is named from where the program runs.
        assert!(reaches(Path::new(""), "../a.obj") && !reaches(Path::new(""), "a.obj"));
    }
}
