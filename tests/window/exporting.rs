//! Motions, clips and fibres leave the window for other programs and come in, by the menus and dialogs that people use.

use super::{Window, advance, click, click_on, hold, open, press_key, reset, until, until_seen};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;
use sinew::cli::{Cli, Console, run};
use sinew::ui::Document;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A prism in millimetres that stands on Z, as a file has it: caps of six corners, a vertex that no face uses.
const PRISM: &str = "v 3 3 3\n\
    v 30 0 0\nv 15 26 0\nv -15 26 0\nv -30 0 0\nv -15 -26 0\nv 15 -26 0\n\
    v 30 0 40\nv 15 26 40\nv -15 26 40\nv -30 0 40\nv -15 -26 40\nv 15 -26 40\n\
    f 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 7 13 12\nf 7 2 8 13\nf 7 6 5 4 3 2\nf 8 9 10 11 12 13\n";

/// It falls, with a fibre in it.
const SCENE: &str = r#"{"version": 1, "name": "Prism", "time": {"duration": 0.2, "frames_per_second": 50}, "bodies": [{
    "id": "prism", "name": "Prism",
    "shape": {"mesh": {"path": "prism.obj", "scale": 0.001, "up": "z", "particles": 120}},
    "placement": {"translation": [0.1, 0.5, -0.2], "rotation": {"axis": [0, 1, 0], "degrees": 90}},
    "material": {"young_modulus": 1e4, "mass": {"density": 1000}, "support_radius": 0.012},
    "fibres": [{"id": "axis", "stiffness": {"rigidity": {"ea": 1, "ei": 1e-6}},
        "source": {"vertices": [[0, 0.01, 0], [0, 0.02, 0], [0, 0.03, 0]]}}]}]}"#;

/// The window on the prism, held at its start; and the folder in which it lies.
fn prism() -> (Window, TempDir) {
    let desk = tempfile::tempdir().expect("a folder");
    fs::write(desk.path().join("prism.obj"), PRISM).expect("written");
    fs::write(desk.path().join("scene.json"), SCENE).expect("written");
    let mut window = open(Document::load(Some(desk.path().join("scene.json"))).expect("a scene"));
    hold(&mut window);
    reset(&mut window);
    (window, desk)
}

/// Opens a menu's entry.
fn choose(window: &mut Window, menu: &str, entry: &str) {
    click(window, menu);
    click(window, entry);
    window.run_steps(3);
}

/// Types into a field of a name in place of what it holds.
fn type_into(window: &mut Window, role: Role, label: &str, text: &str) {
    click_on(window, role, label);
    press_key(window, Modifiers::COMMAND, Key::A);
    window.event(Event::Text(text.to_owned()));
    window.step();
    if role == Role::SpinButton {
        press_key(window, Modifiers::NONE, Key::Enter);
    }
    window.run_steps(2);
}

/// Files of a folder by their names, those of folders in it too.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        if path.is_dir() {
            all.extend(contents(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else {
            all.insert(name, fs::read(path).expect("a file"));
        }
    }
    all
}

#[test]
fn what_the_window_exports_is_what_the_command_line_writes() {
    let (mut window, desk) = prism();
    for _ in 0..8 {
        advance(&mut window);
    }
    choose(&mut window, "File", "Export motion…");
    until_seen(&mut window, |window| window.query_by_label_contains("13 vertices, 8 faces, 1 fibre").is_some());
    for format in ["PC2", "OBJ", "CSV"] {
        click_on(&mut window, Role::CheckBox, format);
    }
    click_on(&mut window, Role::Button, "Maya");
    let spins = window.get_all_by_role(Role::SpinButton).count();
    assert!(spins >= 3);
    type_into(&mut window, Role::SpinButton, "From", "1");
    type_into(&mut window, Role::SpinButton, "to", "7");
    type_into(&mut window, Role::SpinButton, "every", "2");
    let folder = desk.path().join("kept");
    type_into(&mut window, Role::TextInput, "Folder", &folder.display().to_string());
    for told in ["4 frames, 0.16 s at 25 a second", "frame_000000.obj to frame_000003.obj", "without fibres, particles"]
    {
        assert!(window.query_all_by_label_contains(told).next().is_some(), "{told}");
    }
    click_on(&mut window, Role::Button, "Export");
    until(&mut window, |app| app.written().is_some());
    let told = window.state().written().unwrap_or_default().to_owned();
    assert!(told.contains("PC2 cache of 4 frames") && told.contains("4 OBJ files written to"), "{told}");
    window.run_steps(2);
    assert!(window.query_by_label("Show in folder").is_some());

    // The same of a run from the start, and by the command line.
    choose(&mut window, "File", "Export motion…");
    until_seen(&mut window, |window| window.query_by_label_contains("13 vertices").is_some());
    click_on(&mut window, Role::RadioButton, "Computed anew");
    type_into(&mut window, Role::SpinButton, "to", "7");
    type_into(&mut window, Role::SpinButton, "From", "1");
    type_into(&mut window, Role::SpinButton, "every", "2");
    let again = desk.path().join("anew");
    type_into(&mut window, Role::TextInput, "Folder", &again.display().to_string());
    click_on(&mut window, Role::Button, "Export");
    until(&mut window, |app| app.written().is_some_and(|told| told.contains("anew")));
    let headless = desk.path().join("headless");
    let arguments =
        ["sinew", "simulate", "--format", "usd,pc2,obj,csv", "--for", "maya", "--frames", "1..7", "--step", "2"];
    let paths = [desk.path().join("scene.json"), "--out".into(), headless.clone()];
    let arguments = arguments.map(Into::into).into_iter().chain(paths);
    let command = <Cli as clap::Parser>::parse_from(arguments).command.expect("a command");
    run(&command, &mut Console::new(Box::new(std::io::sink()), Box::new(std::io::sink()), false));
    let expected = contents(&headless);
    assert_eq!(expected.keys().filter(|name| name.starts_with("frame_")).count(), 4);
    for folder in [folder, again] {
        let found = contents(&folder);
        assert_eq!(found.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>());
        for (name, bytes) in &found {
            assert!(*bytes == expected[name], "{name} in {}", folder.display());
        }
    }
}

#[test]
fn an_export_is_cancelled_with_whole_files_while_the_window_goes_on() {
    let (mut window, desk) = prism();
    advance(&mut window);
    choose(&mut window, "File", "Export motion…");
    until_seen(&mut window, |window| window.query_by_label_contains("13 vertices").is_some());
    click_on(&mut window, Role::CheckBox, "USD");
    assert!(window.query_by_label_contains("Choose a format").is_some());
    click_on(&mut window, Role::CheckBox, "PC2");
    click_on(&mut window, Role::RadioButton, "Computed anew");
    type_into(&mut window, Role::SpinButton, "to", "9000000");
    let folder = desk.path().join("out");
    type_into(&mut window, Role::TextInput, "Folder", &folder.display().to_string());
    click_on(&mut window, Role::Button, "Export");
    let cache = folder.join("Prism.pc2");
    until(&mut window, |_| cache.is_file());
    // What is simulated and seen goes on meanwhile; nothing else is written at the same time.
    advance(&mut window);
    choose(&mut window, "File", "Save clip…");
    assert!(window.query_by_label("Save").is_none());
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    click_on(&mut window, Role::Button, "Cancel export");
    until(&mut window, |app| app.written().is_some());
    let told = window.state().written().unwrap_or_default().to_owned();
    assert!(told.starts_with("Cancelled; until then: PC2 cache of "), "{told}");
    let bytes = fs::read(&cache).expect("the cache");
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
    assert_eq!((word(16), bytes.len()), (13, 32 + 12 * 13 * word(28)));
}

#[test]
fn fibres_come_in_as_lines_and_go_out_again() {
    let (mut window, desk) = prism();
    // In millimetres, Z up, where the model's file has them.
    let lines = desk.path().join("lines.csv");
    fs::write(&lines, "fibre,x,y,z\nmine,0,5,10\nmine,0,5,20\nmine,0,5,30\n").expect("written");
    choose(&mut window, "Fibre", "Import fibres…");
    type_into(&mut window, Role::TextInput, "File", &lines.display().to_string());
    click_on(&mut window, Role::Button, "Import");
    until_seen(&mut window, |window| window.query_by_label_contains("outside of body").is_some());
    assert!(window.query_by_label_contains("such as millimetres").is_some());
    assert_eq!(window.state().scene().bodies[0].fibres.len(), 1);
    click_on(&mut window, Role::ComboBox, "Unit");
    click(&mut window, "Millimetres");
    click_on(&mut window, Role::Button, "Z up");
    click_on(&mut window, Role::RadioButton, "Model");
    click_on(&mut window, Role::Button, "Import");
    until(&mut window, |app| app.scene().bodies[0].fibres.len() == 2);
    assert_eq!(window.state().selected_names(), ["mine"]);
    assert_eq!(window.state().undo_name(), Some("Import mine"));

    // The selected one goes out, into the world's frame.
    let out = desk.path().join("out.json");
    choose(&mut window, "Fibre", "Export fibres…");
    assert!(window.query_by_label("Export 1 fibre").is_some());
    type_into(&mut window, Role::TextInput, "File", &out.display().to_string());
    click_on(&mut window, Role::Button, "Export");
    until(&mut window, |app| app.message().is_some_and(|said| said.starts_with("Wrote 1 fibre")));
    let written: serde_json::Value = serde_json::from_slice(&fs::read(&out).expect("a file")).expect("JSON");
    let vertices: Vec<[f64; 3]> = serde_json::from_value(written["fibres"][0]["vertices"].clone()).expect("vertices");
    // Z of the file is up: (x, y, z) stands at (x, z, -y), is turned about the vertical and moved.
    let expected = [10.0, 20.0, 30.0].map(|z| [0.1 - 0.005, 0.5 + 1e-3 * z, -0.2]);
    for (found, expected) in vertices.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-9, "{vertices:?}");
    }
}
