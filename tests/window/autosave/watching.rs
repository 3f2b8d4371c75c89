//! What other programs do to the document's file.

use super::super::{Window, click, open, press_key, until};
use super::{answer, built_in, close, edit, fibres, file, focus, folder, load, name, said, shows, until_shown};
use egui::{Key, Modifiers, ViewportCommand};
use sinew::io::{load_scene, save_scene};
use sinew::scene::Scene;
use sinew::test_support::ui::App;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

fn write_as(path: &Path, name: &str) {
    save_scene(path, &Scene { name: name.to_owned(), ..built_in() }).expect("written");
}

#[test]
fn a_file_that_another_program_changed_is_reloaded_or_kept() {
    let folder = folder();
    let path = file(folder.path(), "First");
    let mut window = open(load(&path));
    // Noticed by itself.
    write_as(&path, "Theirs");
    until_shown(&mut window, "First.json was changed by another program");
    assert!(shows(&window, "has no changes of its own"));
    click(&mut window, "Reload");
    assert_eq!(name(&window), "Theirs");
    // Noticed at once when the person comes back.
    edit(&mut window);
    write_as(&path, "Theirs again");
    focus(&mut window, true);
    until_shown(&mut window, "First.json was changed by another program");
    assert!(shows(&window, "reloading loses them"));
    click(&mut window, "Keep mine");
    assert_eq!((name(&window).as_str(), fibres(&window)), ("Theirs", 0));
    let save = |window: &mut Window| {
        press_key(window, Modifiers::COMMAND, Key::S);
        window.step();
        if shows(window, "was changed by another program") {
            // It was noticed by itself just then.
            click(window, "Keep mine");
            press_key(window, Modifiers::COMMAND, Key::S);
            window.step();
        }
        assert!(shows(window, "Replace First.json?") && shows(window, "Another program changed it"));
    };
    save(&mut window);
    click(&mut window, "Cancel");
    assert_eq!(load_scene(&path).expect("a scene").name, "Theirs again");
    save(&mut window);
    click(&mut window, "Replace");
    assert_eq!(load_scene(&path).expect("a scene"), **window.state().scene());
    // The own save is no change by another program.
    for _ in 0..3 {
        focus(&mut window, true);
        let start = Instant::now();
        until(&mut window, |_| start.elapsed() > Duration::from_millis(20));
    }
    assert!(!shows(&window, "was changed by another program"));
    // What was written before anything was looked at is found by saving.
    write_as(&path, "Theirs once more");
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    save(&mut window);
}

#[test]
fn what_is_kept_against_a_changed_file_is_not_closed_without_asking() {
    let folder = folder();
    let path = file(folder.path(), "First");
    let document = load(&path);
    // While the window opened.
    write_as(&path, "Theirs");
    let mut window = open(document);
    until_shown(&mut window, "First.json was changed by another program");
    click(&mut window, "Keep mine");
    assert!(close(&mut window).contains(&ViewportCommand::CancelClose), "no file holds it now");
    window.step();
    click(&mut window, "Cancel");
    // By a command: the document counts as changed.
    click(&mut window, "File");
    click(&mut window, "Reload");
    assert!(shows(&window, "Reload First.json?"));
    click(&mut window, "Reload");
    assert_eq!(name(&window), "Theirs");
    assert!(!close(&mut window).contains(&ViewportCommand::CancelClose));
}

#[test]
fn a_file_that_vanished_is_said_and_written_anew() {
    let folder = folder();
    let path = file(folder.path(), "First");
    let mut window = open(load(&path));
    fs::remove_file(&path).expect("removed");
    focus(&mut window, true);
    until(&mut window, |app: &App| {
        app.message().is_some_and(|text| text.contains("is no longer there; saving writes"))
    });
    assert!(close(&mut window).contains(&ViewportCommand::CancelClose), "it is in no file");
    window.step();
    assert!(answer(&mut window, "Save").contains(&ViewportCommand::Close), "{}", said(&window));
    assert_eq!(load_scene(&path).expect("a scene"), **window.state().scene());
}
