//! Nothing is lost: changes are asked for, kept and recovered; files are remembered, and watched for other programs.

mod keeping;
mod recording;
mod watching;

use super::editing::{drop_file, type_path};
use super::{Window, click, open, press_key, still, until, until_seen};
use egui::{Event, Key, Modifiers, ViewportCommand, ViewportEvent, ViewportId};
use egui_kittest::kittest::Queryable;
use sinew::io::{load_scene, save_scene};
use sinew::scene::Scene;
use sinew::ui::Document;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

fn built_in() -> Scene {
    Document::load(None).expect("the built-in scene").scene
}

/// A scene's file.
fn file(folder: &Path, name: &str) -> PathBuf {
    let path = folder.join(format!("{name}.json"));
    save_scene(&path, &Scene { name: name.to_owned(), ..built_in() }).expect("written");
    path
}

fn load(path: &Path) -> Document {
    Document::load(Some(path.to_owned())).expect("a scene")
}

/// Deletes every fibre of the body.
fn edit(window: &mut Window) {
    press_key(window, Modifiers::NONE, Key::A);
    press_key(window, Modifiers::NONE, Key::Delete);
    assert_eq!(fibres(window), 0, "{:?}", window.state().message());
}

fn fibres(window: &Window) -> usize {
    window.state().scene().bodies[0].fibres.len()
}

fn name(window: &Window) -> String {
    window.state().scene().name.clone()
}

fn said(window: &Window) -> String {
    window.state().message().unwrap_or_default().to_owned()
}

fn shows(window: &Window, text: &str) -> bool {
    window.query_all_by_label_contains(text).next().is_some()
}

/// One frame with a key going down in it; what it asked of the window's frame.
fn key(window: &mut Window, modifiers: Modifiers, key: Key) -> Vec<ViewportCommand> {
    window.input_mut().events.push(Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers });
    window.step();
    asked(window)
}

fn asked(window: &Window) -> Vec<ViewportCommand> {
    window.output().viewport_output[&ViewportId::ROOT].commands.clone()
}

/// Clicks on a button; what that asked of the window's frame.
fn answer(window: &mut Window, label: &str) -> Vec<ViewportCommand> {
    window.get_by_label(label).click();
    window.step();
    asked(window)
}

/// One frame with the window being closed by its frame.
fn close(window: &mut Window) -> Vec<ViewportCommand> {
    window.input_mut().viewports.entry(ViewportId::ROOT).or_default().events.push(ViewportEvent::Close);
    window.step();
    asked(window)
}

fn focus(window: &mut Window, focused: bool) {
    window.event(Event::WindowFocused(focused));
    window.step();
}

fn new(window: &mut Window) {
    key(window, Modifiers::COMMAND, Key::N);
    window.step();
}

fn until_shown(window: &mut Window, text: &str) {
    until_seen(window, |window| shows(window, text));
}

/// A way out of the document, on to another one of this path if it needs one.
type Way = fn(&mut Window, &Path);

#[test]
fn every_way_out_asks_first_where_there_are_changes() {
    let folder = folder();
    let other = file(folder.path(), "Other");
    let mut window = open(load(&file(folder.path(), "First")));
    // Each with the name of what is gone on to.
    let ways: [(Way, &str); 4] = [
        (|window, _| new(window), &built_in().name),
        (
            |window, other| {
                press_key(window, Modifiers::COMMAND, Key::O);
                type_path(window, other);
                window.step();
            },
            "Other",
        ),
        (
            |window, other| {
                drop_file(window, other.to_owned());
                window.step();
            },
            "Other",
        ),
        (
            |window, _| {
                click(window, "File");
                click(window, "Open recent");
                click(window, "First.json");
            },
            "First",
        ),
    ];
    for (k, (way, wanted)) in ways.into_iter().enumerate() {
        edit(&mut window);
        let before = window.state().scene().clone();
        way(&mut window, &other);
        assert!(shows(&window, "Save the changes to "), "way {k}");
        // No key does anything while it is asked.
        press_key(&mut window, Modifiers::COMMAND, Key::Z);
        click(&mut window, "Cancel");
        assert!(!shows(&window, "Save the changes to ") && *window.state().scene() == before, "way {k}");
        way(&mut window, &other);
        press_key(&mut window, Modifiers::NONE, Key::Escape);
        window.step();
        assert!(!shows(&window, "Save the changes to ") && *window.state().scene() == before, "way {k}");
        way(&mut window, &other);
        click(&mut window, "Discard");
        assert_eq!(name(&window), wanted, "way {k}: {}", said(&window));
        assert!(fibres(&window) > 0);
        until(&mut window, |app| !app.published().at_rest.bodies.is_empty());
    }
}

#[test]
fn the_window_closes_only_when_changes_are_saved_or_given_up() {
    let folder = folder();
    let mut window = open(load(&file(folder.path(), "First")));
    assert!(!close(&mut window).contains(&ViewportCommand::CancelClose), "nothing was changed");
    edit(&mut window);
    assert!(close(&mut window).contains(&ViewportCommand::CancelClose));
    assert!(close(&mut window).contains(&ViewportCommand::CancelClose), "who is impatient is asked too");
    window.step();
    assert!(answer(&mut window, "Cancel").is_empty());
    assert!(!key(&mut window, Modifiers::COMMAND, Key::Q).contains(&ViewportCommand::Close));
    window.step();
    assert!(answer(&mut window, "Discard").contains(&ViewportCommand::Close));
    // That comes back as a request to close.
    assert!(!close(&mut window).contains(&ViewportCommand::CancelClose));
    assert!(load_scene(&folder.path().join("First.json")).expect("a scene").bodies[0].fibres.len() > 1);
    // Enter saves.
    let mut window = open(load(&folder.path().join("First.json")));
    edit(&mut window);
    close(&mut window);
    window.run_steps(2);
    assert!(key(&mut window, Modifiers::NONE, Key::Enter).contains(&ViewportCommand::Close), "{}", said(&window));
    assert_eq!(load_scene(&folder.path().join("First.json")).expect("a scene"), **window.state().scene());
    assert!(!close(&mut window).contains(&ViewportCommand::CancelClose));
}

#[test]
fn a_clean_document_asks_nothing() {
    let folder = folder();
    let mut window = open(load(&file(folder.path(), "First")));
    assert!(key(&mut window, Modifiers::COMMAND, Key::Q).contains(&ViewportCommand::Close));
    let mut window = open(load(&folder.path().join("First.json")));
    let before = window.state().scene().clone();
    edit(&mut window);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(*window.state().scene(), before);
    new(&mut window);
    assert_eq!(name(&window), built_in().name, "what was taken back is no change");
}

#[test]
fn saving_first_asks_for_a_path_and_then_goes_on() {
    let folder = folder();
    let mut window = still();
    edit(&mut window);
    new(&mut window);
    click(&mut window, "Save");
    assert!(shows(&window, "Save the scene"));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(fibres(&window), 0, "not saved, so nothing goes on");
    // A save that fails holds the rest up and says why.
    new(&mut window);
    click(&mut window, "Save");
    type_path(&mut window, &folder.path().join("no such folder").join("mine.json"));
    assert!(said(&window).contains("mine.json") && said(&window).contains("cannot be written"), "{}", said(&window));
    assert_eq!(fibres(&window), 0);
    new(&mut window);
    click(&mut window, "Save");
    let mine = folder.path().join("mine.json");
    type_path(&mut window, &mine);
    assert!(load_scene(&mine).expect("it was written").bodies[0].fibres.is_empty());
    assert!(fibres(&window) > 0, "the built-in scene is open");
}

#[test]
fn another_file_is_replaced_only_after_asking() {
    let folder = folder();
    let other = file(folder.path(), "Other");
    let held = fs::read(&other).expect("bytes");
    let mut window = still();
    edit(&mut window);
    let save_there = |window: &mut Window| {
        press_key(window, CTRL_SHIFT, Key::S);
        type_path(window, &other);
        window.step();
        assert!(shows(window, "Replace Other.json?"), "{}", said(window));
    };
    save_there(&mut window);
    click(&mut window, "Cancel");
    save_there(&mut window);
    click(&mut window, "Save as…");
    assert!(shows(&window, "Save the scene"));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(fs::read(&other).expect("bytes"), held);
    save_there(&mut window);
    click(&mut window, "Replace");
    assert_eq!(load_scene(&other).expect("a scene"), **window.state().scene());
    // From now on it is the document's own.
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    press_key(&mut window, Modifiers::COMMAND, Key::S);
    assert_eq!(load_scene(&other).expect("a scene"), **window.state().scene());
}

#[test]
fn the_history_outlives_a_save() {
    let folder = folder();
    let path = file(folder.path(), "First");
    let mut window = open(load(&path));
    let count = fibres(&window);
    edit(&mut window);
    press_key(&mut window, Modifiers::COMMAND, Key::S);
    assert!(load_scene(&path).expect("a scene").bodies[0].fibres.is_empty());
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(fibres(&window), count);
    new(&mut window);
    assert!(shows(&window, "Save the changes to First?"), "what was undone is a change of the saved scene");
}

/// What the window remembers, without a file.
#[derive(Default)]
pub(super) struct Memory(HashMap<String, String>);

impl eframe::Storage for Memory {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.to_owned(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}

fn recent(window: &mut Window) {
    click(window, "File");
    click(window, "Open recent");
}

#[test]
fn recent_files_are_listed_remembered_and_forgotten() {
    let folder = folder();
    let [one, two, three] = ["One", "Two", "Three"].map(|name| file(folder.path(), name));
    let mut window = still();
    recent(&mut window);
    assert!(shows(&window, "Files that you open or save are listed here"));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    for path in [&one, &two, &three] {
        drop_file(&mut window, path.clone());
        window.step();
    }
    recent(&mut window);
    let top = |window: &Window, name: &str| window.get_by_label(name).rect().top();
    assert!(top(&window, "Three.json") < top(&window, "Two.json"));
    assert!(top(&window, "Two.json") < top(&window, "One.json"));
    click(&mut window, "One.json");
    assert_eq!(name(&window), "One");
    // The request for a path lists them too.
    press_key(&mut window, Modifiers::COMMAND, Key::O);
    window.step();
    click(&mut window, "Two.json");
    assert_eq!(name(&window), "Two");
    // What has vanished is said, and taken off.
    fs::remove_file(&three).expect("removed");
    recent(&mut window);
    click(&mut window, "Three.json");
    assert!(said(&window).contains("Three.json is no longer there"), "{}", said(&window));
    recent(&mut window);
    assert!(window.query_by_label("Three.json").is_none() && shows(&window, "One.json"));
    // The next start.
    let mut memory = Memory::default();
    eframe::App::save(window.state_mut(), &mut memory);
    fs::remove_file(&one).expect("removed");
    let mut window = still();
    let ctx = window.ctx.clone();
    window.state_mut().recall(&ctx, &memory);
    recent(&mut window);
    assert!(shows(&window, "Two.json") && !shows(&window, "One.json"));
    click(&mut window, "Clear");
    recent(&mut window);
    assert!(shows(&window, "Files that you open or save are listed here") && !shows(&window, "Two.json"));
}
