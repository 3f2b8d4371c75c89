//! What a scene and its models are, in a number: another content has another one, and the same has the same on any
//! machine and with any compiler.

use super::collect::files_of;
use super::read::open_file;
use crate::scene::Scene;
use crate::text::fnv::Fnv;
use std::collections::BTreeSet;
use std::io::Read;
use std::path::Path;

/// Adds the content of a file, and its length behind it, so that what stands in two files is not the same in one. A
/// file that cannot be read is like none.
fn add_file(hash: &mut Fnv, path: &Path) {
    let Ok((mut file, _)) = open_file(path) else { return };
    let (mut part, mut length) = (vec![0; 1 << 16], 0_u64);
    while let Ok(count @ 1..) = file.read(&mut part) {
        hash.add(&part[..count]);
        length += count as u64;
    }
    hash.add(&length.to_le_bytes());
}

/// That of a scene with all that was set in it, of the files of its models, which it names from `folder`, and of those
/// that these name.
pub(crate) fn fingerprint(scene: &Scene, folder: &Path) -> String {
    let mut hash = Fnv::START;
    // A value has its members in the order of their names.
    hash.add(serde_json::json!(scene).to_string().as_bytes());
    let mut scene = scene.clone();
    let models: BTreeSet<String> = scene.model_paths_mut().map(|path| path.clone()).collect();
    for model in models {
        let path = folder.join(model);
        match files_of(&path) {
            Ok((files, _)) => files.iter().for_each(|file| add_file(&mut hash, &file.source)),
            Err(_) => add_file(&mut hash, &path),
        }
    }
    hash.hex()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_has_the_same_one_everywhere() {
        let scene = Scene::new("Nothing");
        let text = serde_json::json!(scene).to_string();
        let mut hash = Fnv::START;
        hash.add(text.as_bytes());
        assert_eq!(fingerprint(&scene, Path::new("anywhere")), hash.hex());
        assert_ne!(fingerprint(&scene, Path::new("")), fingerprint(&Scene::new("Something"), Path::new("")));
    }
}
