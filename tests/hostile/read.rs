//! Readers, each tried on a file of any bytes: what it holds is taken and sound, or refused in a sentence.

use crate::files::in_own_folder;
use sinew::geometry::Solid;
use sinew::io::{
    IoError, load_assets, load_model, load_scene, scene_from_json, scene_to_json, unknown_fields, write_glb,
};
use sinew::scene::{Body, Follow, Leader, Scene};
use sinew::test_support::io::points_of_lines;
use std::fs;
use std::path::{Path, PathBuf};

/// Whether a file was taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    Taken,
    Refused,
}

/// Words of programs that no person should read.
const DUMPS: [&str; 9] = [
    "panicked",
    "unwrap",
    "called `",
    "thread '",
    "it is damaged",
    "invalid type",
    "missing field `",
    "os error 0",
    "Some(",
];

/// What is said of a file that is refused: one sentence, in words.
pub fn refused(said: &str) -> Verdict {
    assert!(!said.trim().is_empty() && !said.chars().any(char::is_control), "no line: {said:?}");
    assert!(said.len() < 2000, "too long: {said:?}");
    assert!(DUMPS.iter().all(|dump| !said.contains(dump)), "a parser's words: {said:?}");
    Verdict::Refused
}

fn refused_by(error: &IoError) -> Verdict {
    refused(&error.to_string())
}

/// A scene: valid, and the same when it is saved and opened again.
pub fn scene(path: &Path) -> Verdict {
    let scene = match load_scene(path) {
        Ok(scene) => scene,
        Err(error) => return refused_by(&error),
    };
    comes_back(&scene);
    unknown_fields(&scene);
    Verdict::Taken
}

/// A scene that was taken is the same when it is saved and opened again.
pub fn comes_back(scene: &Scene) {
    assert!(scene.validate().is_ok());
    let text = scene_to_json(scene);
    let again = scene_from_json(&text).unwrap_or_else(|error| panic!("saved, and then refused: {error}"));
    assert!(again == *scene && scene_to_json(&again) == text, "saved and opened again it is another scene");
}

/// Triangles of which an inside is looked for.
const SOLID: usize = 200;

/// A model: whole, and the same when it is written and read again.
pub fn model(path: &Path) -> Verdict {
    let model = match load_model(path) {
        Ok(model) => model,
        Err(error) => return refused_by(&error),
    };
    let count = model.positions.len();
    assert!(model.triangles.iter().flatten().all(|&corner| (corner as usize) < count), "a corner of nothing");
    assert!(model.positions.iter().all(|position| position.is_finite()), "a vertex at no place");
    assert!(model.normals.iter().all(|normal| normal.is_finite()), "a normal of no direction");
    assert!([0, count].contains(&model.normals.len()) && [0, count].contains(&model.colours.len()), "half of a list");
    assert!(model.parts.iter().all(|part| part.triangles.end <= model.triangles.len()), "a part of nothing");
    in_own_folder("copies", |folder| {
        let copy = folder.join("copy.glb");
        if !model.triangles.is_empty() && write_glb(&copy, &model, "copy").is_ok() {
            let again = load_model(&copy).unwrap_or_else(|error| panic!("written, and then refused: {error}"));
            assert_eq!(again.triangles.len(), model.triangles.len(), "written and read again");
        }
    });
    if model.triangles.len() <= SOLID {
        match Solid::new(&model) {
            Ok(solid) => assert!(solid.volume > 0.0 && solid.volume.is_finite(), "a volume of {}", solid.volume),
            Err(refusal) => {
                refused(&refusal.to_string());
            }
        }
    }
    Verdict::Taken
}

/// A motion that a body follows: the skeleton of a glTF file, or a point cache.
pub fn motion(path: &Path) -> Verdict {
    let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
    let is_skeleton = name.ends_with("glb") || name.ends_with("gltf");
    let leader: Leader = serde_json::from_value(if is_skeleton {
        serde_json::json!({"skeleton": {"path": name}})
    } else {
        serde_json::json!({"cache": {"path": name}})
    })
    .expect("a leader");
    let follow: Follow = serde_json::from_value(serde_json::json!({"id": "all", "leader": leader})).expect("a follow");
    let mut body = Body::cuboid("cube", [0.03; 3]);
    body.follows.push(follow);
    let scene = Scene::new("Follows").with_body(body);
    match load_assets(&scene, path.parent().expect("a folder"), &mut |_| {}) {
        Ok(_) => Verdict::Taken,
        Err(error) => refused_by(&error),
    }
}

/// Lines that become fibres.
pub fn lines(path: &Path) -> Verdict {
    match points_of_lines(path) {
        Ok(points) => {
            assert!(points.iter().all(|point| point.is_finite()), "a point at no place");
            Verdict::Taken
        }
        Err(said) => refused(&said),
    }
}

/// Writes a file and has it read.
pub fn as_file(name: &str, bytes: &[u8], read: fn(&Path) -> Verdict) -> Verdict {
    /// Takes the file away, however reading it ends: the next is read without it.
    struct Gone(PathBuf);
    impl Drop for Gone {
        fn drop(&mut self) {
            fs::remove_file(&self.0).ok();
        }
    }
    in_own_folder("read", |folder| {
        let path = Gone(folder.join(name));
        fs::write(&path.0, bytes).expect("written");
        read(&path.0)
    })
}
