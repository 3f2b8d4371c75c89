//! What a scene and its models are, in a number: another content has another one, and the same has the same on any
//! machine and with any compiler.

use super::collect::files_of;
use super::read::open_file;
use crate::scene::Scene;
use std::collections::BTreeSet;
use std::io::Read;
use std::path::Path;

/// The hash FNV-1a of 64 bits (Fowler, Noll, Vo; RFC 9923).
#[derive(Clone, Copy, Debug)]
struct Fnv(u64);

impl Fnv {
    const START: Self = Self(0xcbf2_9ce4_8422_2325);
    const PRIME: u64 = 0x0100_0000_01b3;

    fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(Self::PRIME);
        }
    }

    /// Adds the content of a file, and its length behind it, so that what stands in two files is not the same in one. A
    /// file that cannot be read is like none.
    fn add_file(&mut self, path: &Path) {
        let Ok((mut file, _)) = open_file(path) else { return };
        let (mut part, mut length) = (vec![0; 1 << 16], 0_u64);
        while let Ok(count @ 1..) = file.read(&mut part) {
            self.add(&part[..count]);
            length += count as u64;
        }
        self.add(&length.to_le_bytes());
    }
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
            Ok((files, _)) => files.iter().for_each(|file| hash.add_file(&file.source)),
            Err(_) => hash.add_file(&path),
        }
    }
    format!("{:016x}", hash.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_texts_have_their_known_hashes() {
        for (text, known) in
            [("", 0xcbf2_9ce4_8422_2325), ("a", 0xaf63_dc4c_8601_ec8c), ("foobar", 0x8594_4171_f739_67e8)]
        {
            let mut hash = Fnv::START;
            hash.add(text.as_bytes());
            assert_eq!(hash.0, known, "{text}");
        }
    }

    #[test]
    fn a_scene_has_the_same_one_everywhere() {
        let scene = Scene::new("Nothing");
        let text = serde_json::json!(scene).to_string();
        let mut hash = Fnv::START;
        hash.add(text.as_bytes());
        assert_eq!(fingerprint(&scene, Path::new("anywhere")), format!("{:016x}", hash.0));
        assert_ne!(fingerprint(&scene, Path::new("")), fingerprint(&Scene::new("Something"), Path::new("")));
    }
}
