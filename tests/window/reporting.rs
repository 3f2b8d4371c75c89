//! A report of a fault: one archive, which holds what makes the motion again to the same bits.

use super::editing::type_path;
use super::{Window, advance, click, hold, open, press_key, reset, until, until_seen};
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;
use sinew::io::{load_assets, load_scene};
use sinew::scene::{Assets, Scene};
use sinew::sim::{Journal, Rerun};
use sinew::ui::Document;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Files of an archive that are stored as they are, by their names, as its directory tells of them.
fn unpacked(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let number = |at: usize, length: usize| {
        bytes[at..at + length].iter().rev().fold(0, |number, &byte| number << 8 | usize::from(byte))
    };
    let end = bytes.len() - 22;
    assert_eq!(&bytes[end..end + 4], b"PK\x05\x06");
    let (count, mut at) = (number(end + 10, 2), number(end + 16, 4));
    let mut files = BTreeMap::new();
    for _ in 0..count {
        assert_eq!(&bytes[at..at + 4], b"PK\x01\x02");
        let (length, name_length, offset) = (number(at + 24, 4), number(at + 28, 2), number(at + 42, 4));
        let name = String::from_utf8(bytes[at + 46..at + 46 + name_length].to_vec()).expect("a name");
        assert_eq!(&bytes[offset..offset + 4], b"PK\x03\x04");
        let start = offset + 30 + number(offset + 26, 2) + number(offset + 28, 2);
        let content = bytes[start..start + length].to_vec();
        assert_eq!(number(at + 16, 4) as u32, checksum(&content), "{name}");
        files.insert(name, content);
        at += 46 + name_length;
    }
    files
}

/// CRC-32 as ISO 3309 has it, bit by bit.
fn checksum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum: u32, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |sum, _| if sum & 1 == 1 { sum >> 1 ^ 0xedb8_8320 } else { sum >> 1 })
    })
}

/// Asks for a report in a file and waits for it.
fn report(window: &mut Window, path: &Path) {
    type_path(window, path);
    until(window, |app| app.message().is_some_and(|said| said.starts_with("Wrote") && said.contains(".zip")));
}

/// Puts an archive into a folder and makes the motion in it again; gives its frames.
fn made_again(archive: &Path, folder: &Path) -> (u64, BTreeMap<String, Vec<u8>>) {
    let files = unpacked(&fs::read(archive).expect("there"));
    for (name, content) in &files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        fs::write(path, content).expect("written");
    }
    let scene = load_scene(&folder.join("scene.json")).expect("a scene");
    load_assets(&scene, folder, &mut |_| {}).expect("its models went along");
    let journal: Journal = serde_json::from_slice(&files["recording.journal.json"]).expect("a journal");
    let assets = journal.scenes().fold(Assets::default(), |_, scene: &std::sync::Arc<Scene>| {
        load_assets(scene, folder, &mut |_| {}).expect("its models went along")
    });
    let frames = journal.frames();
    let mut rerun = Rerun::new(journal, assets).expect("a scene that bakes");
    while rerun.advance().expect("it goes on") {
        assert!(rerun.agrees(), "frame {}", rerun.frame());
    }
    (frames, files)
}

#[test]
fn one_archive_holds_scene_models_recording_log_and_versions() {
    let root = tempfile::tempdir().expect("a folder");
    fs::create_dir(root.path().join("models")).expect("made");
    // A model that names another file, in a folder of its own.
    let model = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/gltf/cube.gltf"));
    fs::write(root.path().join("models/cube.gltf"), model.expect("there")).expect("written");
    let scene = root.path().join("scene.json");
    let text = r#"{"version": 1, "gravity": [0, 0, 0], "bodies": [{"id": "cube",
        "shape": {"mesh": {"path": "models/cube.gltf", "scale": 0.03}}, "initial": {"velocity": [0.1, 0, 0]},
        "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.015}}]}"#;
    fs::write(&scene, text).expect("written");
    let mut window = open(Document::load(Some(scene)).expect("a scene"));
    hold(&mut window);
    reset(&mut window);
    for _ in 0..2 {
        advance(&mut window);
    }
    super::editing::set(&mut window, "Young's modulus", "2e5");
    advance(&mut window);
    // By the menu.
    click(&mut window, "Help");
    click(&mut window, "Report a fault…");
    let archive = root.path().join("fault.zip");
    report(&mut window, &archive);
    let (frames, files) = made_again(&archive, &root.path().join("unpacked"));
    assert_eq!(frames, 3);
    assert!(files.keys().any(|name| name.starts_with("models/") && name.ends_with("cube.gltf")), "{:?}", files.keys());
    let text = |name: &str| String::from_utf8(files[name].clone()).expect("text");
    assert!(text("versions.txt").contains(&format!("sinew {}", env!("CARGO_PKG_VERSION"))), "{}", text("versions.txt"));
    assert!(text("versions.txt").contains("threads: ") && text("versions.txt").contains("pictures: none"));
    assert!(files.contains_key("log.txt"));
    // What is there is not written over.
    click(&mut window, "Help");
    click(&mut window, "Report a fault…");
    type_path(&mut window, &archive);
    until_seen(&mut window, |window| window.query_by_label("Save a report of a fault").is_some());
    assert!(window.state().message().is_some_and(|said| said.contains("there is such a file already")));
}

#[test]
fn the_palette_finds_it_and_models_that_ship_go_along() {
    let root = tempfile::tempdir().expect("a folder");
    let mut window = open(Document::load(None).expect("the built-in scene"));
    press_key(&mut window, Modifiers::COMMAND, Key::E);
    window.run_steps(10);
    click(&mut window, "A snapping stalk");
    until(&mut window, |app| app.published().at_rest.bodies.iter().any(|body| body.name != "Soft bar"));
    hold(&mut window);
    press_key(&mut window, Modifiers::COMMAND, Key::P);
    window.run_steps(2);
    window.event(Event::Text("report a fault".to_owned()));
    window.run_steps(2);
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    let archive = root.path().join("example.zip");
    report(&mut window, &archive);
    let files = unpacked(&fs::read(&archive).expect("there"));
    let folder = root.path().join("unpacked");
    for (name, content) in &files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        fs::write(path, content).expect("written");
    }
    let scene = load_scene(&folder.join("scene.json")).expect("a scene");
    load_assets(&scene, &folder, &mut |_| {}).expect("its models went along");
}
