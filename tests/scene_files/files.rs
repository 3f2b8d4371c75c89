//! Files on the disk: what is no scene file, and saves that happen wholly or not at all.

use super::{EVERY_FIELD, every_field, is_one_line};
use sinew::io::{IoError, load_scene, save_scene, scene_to_json};
use sinew::scene::Scene;
use sinew::test_support::io::{MAX_SCENE_BYTES, write_atomically};
use std::fs::{self, File};
use std::io;
use std::path::Path;
use tempfile::{TempDir, tempdir};

fn folder() -> TempDir {
    tempdir().expect("a folder")
}

/// The error, without the file, of loading a path. Its message names the file.
fn refusal(path: &Path) -> IoError {
    let error = load_scene(path).expect_err("refused");
    let message = error.to_string();
    assert!(is_one_line(&message) && message.starts_with(&path.display().to_string()), "{message}");
    let IoError::InFile { file, error } = error else { panic!("{message}") };
    assert_eq!(file, path);
    *error
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("listed");
    entries.map(|entry| entry.expect("listed").file_name().to_string_lossy().into_owned()).collect()
}

#[test]
fn scenes_are_saved_and_loaded() {
    let folder = folder();
    let path = folder.path().join("scene.json");
    save_scene(&path, &every_field()).expect("saved");
    assert_eq!(load_scene(&path).expect("loaded"), every_field());
    save_scene(&path, &Scene::default()).expect("saved over");
    assert_eq!(load_scene(&path).expect("loaded"), Scene::default());
    assert_eq!(names(folder.path()), ["scene.json"]);
}

#[test]
fn what_is_no_scene_file_is_refused() {
    let folder = folder();
    let path = folder.path().join("scene.json");
    assert!(matches!(refusal(&path), IoError::Missing));
    assert!(matches!(refusal(folder.path()), IoError::NotAFile("a folder")));
    fs::write(&path, b"{\"name\": \"\xff\"}").expect("written");
    assert!(matches!(refusal(&path), IoError::NotUtf8 { at: 10 }));
    fs::write(&path, "{\n\"version\": 1,\n}").expect("written");
    assert!(matches!(refusal(&path), IoError::Syntax { line: 3, .. }));
    fs::write(&path, "{\"version\": 2}").expect("written");
    assert!(matches!(refusal(&path), IoError::Version(_)));
    fs::write(&path, "{\"version\": 1, \"gravity\": [0, 1e16, 0]}").expect("written");
    assert!(matches!(refusal(&path), IoError::Invalid(_)));
    // A sparse file: as large as it says, without taking the room.
    File::create(&path).and_then(|file| file.set_len(MAX_SCENE_BYTES + 1)).expect("made");
    assert!(matches!(refusal(&path), IoError::TooLarge { .. }));
}

#[cfg(unix)]
#[test]
fn devices_are_not_waited_for() {
    assert!(matches!(refusal(Path::new("/dev/zero")), IoError::NotAFile("a pipe or device")));
}

#[test]
fn a_failed_write_leaves_the_old_file() {
    let folder = folder();
    let path = folder.path().join("scene.json");
    fs::write(&path, EVERY_FIELD).expect("written");
    let broken = write_atomically(&path, |out| {
        out.write_all(b"{\"version\": 1, \"name\": \"half")?;
        Err(io::Error::other("the disk is full"))
    });
    let message = broken.expect_err("fails").to_string();
    assert!(message.contains("the disk is full") && is_one_line(&message), "{message}");
    assert_eq!(fs::read_to_string(&path).expect("still there"), EVERY_FIELD);
    assert_eq!(names(folder.path()), ["scene.json"]);
}

#[test]
fn a_scene_that_could_not_be_loaded_is_not_saved() {
    let folder = folder();
    let path = folder.path().join("scene.json");
    save_scene(&path, &every_field()).expect("saved");
    let bad = Scene { gravity: [f64::NAN; 3], ..Scene::default() };
    let error = save_scene(&path, &bad).expect_err("refused");
    assert!(matches!(error.bare(), IoError::Invalid(_)), "{error}");
    assert_eq!(fs::read_to_string(&path).expect("still there"), scene_to_json(&every_field()));
}

#[test]
fn places_that_cannot_be_written_are_refused() {
    let folder = folder();
    let missing = folder.path().join("missing").join("scene.json");
    for path in [missing.as_path(), folder.path()] {
        let error = save_scene(path, &every_field()).expect_err("refused");
        assert!(matches!(error.bare(), IoError::Write(_)) && is_one_line(&error.to_string()), "{error}");
    }
    assert!(names(folder.path()).is_empty());
}

#[cfg(unix)]
#[test]
fn a_read_only_folder_keeps_its_file() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder();
    let path = folder.path().join("scene.json");
    fs::write(&path, EVERY_FIELD).expect("written");
    fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o555)).expect("set");
    // The superuser writes where it likes; there is nothing to see then.
    if File::create(folder.path().join("probe")).is_err() {
        let error = save_scene(&path, &Scene::default()).expect_err("refused");
        assert!(matches!(error.bare(), IoError::Write(_)), "{error}");
        assert_eq!(fs::read_to_string(&path).expect("still there"), EVERY_FIELD);
    }
    fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o755)).expect("set back");
}

#[cfg(unix)]
#[test]
fn permissions_and_links_survive_a_save() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = folder();
    let (real, link) = (folder.path().join("real.json"), folder.path().join("link.json"));
    fs::write(&real, EVERY_FIELD).expect("written");
    fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).expect("set");
    symlink(&real, &link).expect("linked");
    save_scene(&link, &Scene::default()).expect("saved");
    assert!(fs::symlink_metadata(&link).expect("there").is_symlink());
    assert_eq!(load_scene(&real).expect("loaded"), Scene::default());
    assert_eq!(fs::metadata(&real).expect("there").permissions().mode() & 0o777, 0o640);
    // One that leads nowhere is neither followed nor replaced.
    let loose = folder.path().join("loose.json");
    symlink(folder.path().join("gone.json"), &loose).expect("linked");
    let error = save_scene(&loose, &Scene::default()).expect_err("refused");
    assert!(error.to_string().contains("a link to a file that is not there"), "{error}");
    assert!(fs::symlink_metadata(&loose).expect("there").is_symlink());
    // A new file is no more private than any other that a program makes.
    let (new, plain) = (folder.path().join("new.json"), folder.path().join("plain"));
    save_scene(&new, &Scene::default()).expect("saved");
    File::create(&plain).expect("made");
    let mode = |path: &Path| fs::metadata(path).expect("there").permissions().mode();
    assert_eq!(mode(&new), mode(&plain));
}
