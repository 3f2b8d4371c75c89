//! What is kept of a changed document, and what becomes of it at the next start.

use super::super::editing::drop_file;
use super::super::{Window, click, open_with, press_key, still, until};
use super::{answer, close, edit, fibres, file, focus, folder, load, name, new, said, shows, until_shown};
use egui::{Key, Modifiers, ViewportCommand};
use egui_kittest::kittest::Queryable;
use sinew::io::load_scene;
use sinew::test_support::io::recoverable_documents;
use sinew::ui::Document;
use std::fs;
use std::path::{Path, PathBuf};

/// Documents that are kept in a folder just now.
fn kept(folder: &Path) -> usize {
    let is_document = |entry: &fs::DirEntry| entry.path().extension().is_some_and(|extension| extension == "json");
    fs::read_dir(folder).map_or(0, |entries| entries.flatten().filter(is_document).count())
}

/// A window on a file that keeps its document in a folder.
fn keeping(document: Document, folder: &Path) -> Window {
    let folder = folder.to_owned();
    open_with(document, move |app| app.with_recovery(folder))
}

#[test]
fn changes_are_kept_until_they_are_saved_or_given_up() {
    let (folder, scenes) = (folder(), folder());
    let path = file(scenes.path(), "First");
    let mut window = keeping(load(&path), folder.path());
    let kept = || kept(folder.path());
    assert_eq!(kept(), 0);
    // By itself, a few seconds after the change.
    edit(&mut window);
    until(&mut window, |_| kept() == 1);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    until(&mut window, |_| kept() == 0);
    // At once when the person turns to another window.
    let change = |window: &mut Window| {
        edit(window);
        focus(window, false);
        until(window, |_| kept() == 1);
    };
    change(&mut window);
    press_key(&mut window, Modifiers::COMMAND, Key::S);
    until(&mut window, |_| kept() == 0);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    focus(&mut window, false);
    until(&mut window, |_| kept() == 1);
    new(&mut window);
    click(&mut window, "Discard");
    until(&mut window, |_| kept() == 0);
    change(&mut window);
    close(&mut window);
    window.step();
    assert!(answer(&mut window, "Discard").contains(&ViewportCommand::Close));
    drop(window);
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0, "not even a lock is left");
    let mut window = keeping(load(&path), folder.path());
    focus(&mut window, false);
    assert!(!shows(&window, "Recover"), "there is nothing to recover");
}

/// Leaves changed documents behind, as by a crash, the last one last.
fn leave_behind(documents: impl IntoIterator<Item = Document>, folder: &Path) {
    let mut windows: Vec<Window> = documents.into_iter().map(|document| keeping(document, folder)).collect();
    for window in &mut windows {
        let before = kept(folder);
        edit(window);
        focus(window, false);
        until(window, |_| kept(folder) > before);
    }
}

#[test]
fn to_look_at_a_fibre_changes_nothing() {
    let mut window = still();
    let before = window.state().scene().clone();
    press_key(&mut window, Modifiers::NONE, Key::A);
    window.run_steps(3);
    assert_eq!(*window.state().scene(), before);
    new(&mut window);
    assert!(!shows(&window, "Save the changes to "));
}

#[test]
fn what_was_left_behind_is_recovered_as_changed() {
    let (folder, scenes) = (folder(), folder());
    let path = file(scenes.path(), "First");
    leave_behind([load(&path)], folder.path());
    assert_eq!(recoverable_documents(folder.path()).len(), 1);
    let mut window = keeping(Document::load(None).expect("the built-in scene"), folder.path());
    until_shown(&mut window, "Recover unsaved changes?");
    assert!(shows(&window, "First") && shows(&window, "just now") && shows(&window, &path.display().to_string()));
    assert!(!shows(&window, "The file was written after this"));
    click(&mut window, "Recover");
    assert_eq!((name(&window).as_str(), fibres(&window)), ("First", 0), "{}", said(&window));
    // It is kept under this window's name now, and there once only.
    until(&mut window, |_| kept(folder.path()) == 1 && recoverable_documents(folder.path()).is_empty());
    new(&mut window);
    assert!(shows(&window, "Save the changes to First?"));
    click(&mut window, "Cancel");
    press_key(&mut window, Modifiers::COMMAND, Key::S);
    assert!(load_scene(&path).expect("a scene").bodies[0].fibres.is_empty(), "it knows its file");
    until(&mut window, |_| kept(folder.path()) == 0);
}

#[test]
fn a_changed_example_is_recovered_with_the_models_that_came_with_it() {
    let folder = folder();
    {
        let mut window = keeping(Document::load(None).expect("the built-in scene"), folder.path());
        press_key(&mut window, Modifiers::COMMAND, Key::E);
        window.run_steps(10);
        click(&mut window, "A snapping stalk");
        until(&mut window, |app| app.published().at_rest.bodies.iter().any(|body| body.name != "Soft bar"));
        edit(&mut window);
        focus(&mut window, false);
        until(&mut window, |_| kept(folder.path()) == 1);
    }
    let mut window = keeping(Document::load(None).expect("the built-in scene"), folder.path());
    until_shown(&mut window, "Recover unsaved changes?");
    assert!(shows(&window, "Never saved to a file"));
    click(&mut window, "Recover");
    assert!(said(&window).starts_with("Recovered"), "{}", said(&window));
    assert_eq!(fibres(&window), 0);
    until(&mut window, |app| app.published().at_rest.bodies.iter().any(|body| body.name != "Soft bar"));
    assert_eq!(window.state().published().status.failure, None);
}

#[test]
fn a_recovered_document_asks_before_it_replaces_a_later_file() {
    let (folder, scenes) = (folder(), folder());
    let path = file(scenes.path(), "First");
    leave_behind([load(&path)], folder.path());
    let later = recoverable_documents(folder.path())[0].written + std::time::Duration::from_secs(10);
    fs::File::options().write(true).open(&path).and_then(|file| file.set_modified(later)).expect("a time of change");
    let mut window = keeping(Document::load(None).expect("the built-in scene"), folder.path());
    until_shown(&mut window, "The file was written after this");
    click(&mut window, "Recover");
    press_key(&mut window, Modifiers::COMMAND, Key::S);
    window.step();
    assert!(shows(&window, "Replace First.json?"));
    assert!(load_scene(&path).expect("a scene").bodies[0].fibres.len() > 1);
}

#[test]
fn what_was_left_behind_waits_until_it_is_decided() {
    let (folder, scenes) = (folder(), folder());
    let built_in = || Document::load(None).expect("the built-in scene");
    leave_behind([load(&file(scenes.path(), "First")), built_in()], folder.path());
    let mut window = keeping(built_in(), folder.path());
    until_shown(&mut window, "Never saved to a file");
    click(&mut window, "Decide later");
    assert!(!shows(&window, "Recover unsaved changes?"));
    click(&mut window, "File");
    click(&mut window, "Recover unsaved…");
    // The one that was left last stands first.
    window.get_all_by_label("Discard").next().expect("two of them").click();
    window.run_steps(2);
    assert!(shows(&window, "First") && !shows(&window, "Never saved to a file"));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    window.step();
    assert_eq!(recoverable_documents(folder.path()).len(), 1);
    drop(window);
    let mut window = keeping(built_in(), folder.path());
    until_shown(&mut window, "Recover unsaved changes?");
    click(&mut window, "Discard");
    assert!(!shows(&window, "Recover unsaved changes?"));
    assert!(recoverable_documents(folder.path()).is_empty() && kept(folder.path()) == 0);
}

#[test]
fn all_that_was_left_behind_can_be_discarded_at_once() {
    let (folder, scenes) = (folder(), folder());
    let paths = ["First", "Second", "Third"].map(|name| file(scenes.path(), name));
    leave_behind(paths.iter().map(|path| load(path)), folder.path());
    let mut window = keeping(Document::load(None).expect("the built-in scene"), folder.path());
    until_shown(&mut window, "Recover unsaved changes?");
    click(&mut window, "Discard all");
    window.run_steps(3);
    assert!(!shows(&window, "Recover unsaved changes?"), "{}", said(&window));
    assert!(recoverable_documents(folder.path()).is_empty() && kept(folder.path()) == 0);
}

#[test]
fn a_folder_that_cannot_be_written_is_said_once() {
    let folder = folder();
    let place = folder.path().join("recovery");
    fs::write(&place, "a file where the folder should be").expect("written");
    let mut window = keeping(Document::load(None).expect("the built-in scene"), &place);
    edit(&mut window);
    focus(&mut window, false);
    until(&mut window, |app| app.message().is_some_and(|text| text.contains("not kept for recovery")));
    // Something else is said, and the next attempts fail in silence.
    press_key(&mut window, Modifiers::ALT, Key::O);
    press_key(&mut window, Modifiers::ALT, Key::O);
    drop_file(&mut window, PathBuf::from("/nowhere/at/all.json"));
    window.step();
    click(&mut window, "Discard");
    let before = said(&window);
    assert!(before.contains("all.json"), "{before}");
    focus(&mut window, false);
    window.step();
    // With room again it is kept after all.
    fs::remove_file(&place).expect("removed");
    focus(&mut window, false);
    until(&mut window, |_| kept(&place) == 1);
    window.step();
    assert_eq!(said(&window), before);
}
