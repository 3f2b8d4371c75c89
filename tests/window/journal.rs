//! What was done to a motion in the window is written down, and makes it again.

use super::editing::drop_file;
use super::{advance, click, hold, open, reset, until};
use egui_kittest::kittest::Queryable;
use sinew::scene::Assets;
use sinew::sim::{Journal, Rerun};
use sinew::ui::Document;
use std::fs;

#[test]
fn a_journal_that_is_saved_makes_the_motion_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.json");
    fs::write(&path, super::pulling::CUBE).expect("written");
    let mut window = open(Document::load(Some(path)).expect("a scene"));
    hold(&mut window);
    reset(&mut window);
    for _ in 0..3 {
        advance(&mut window);
    }
    click(&mut window, "File");
    click(&mut window, "Save journal");
    let said = window.state().message().unwrap_or_default().to_owned();
    assert!(said.contains("3 frames") && said.contains("scene.journal.json"), "{said}");
    let text = fs::read_to_string(folder.path().join("scene.journal.json")).expect("it is there");
    let journal: Journal = serde_json::from_str(&text).expect("a journal");
    let mut rerun = Rerun::new(journal, Assets::default()).expect("a scene that bakes");
    let mut frames = 0;
    while rerun.advance().expect("it goes on") {
        assert!(rerun.agrees(), "frame {}", rerun.frame());
        frames += 1;
    }
    assert_eq!(frames, 3);
}

#[test]
fn a_file_that_is_opened_but_cannot_be_read_leaves_the_document() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("model.stl");
    fs::write(&path, "solid nothing\nfacet normal 0 0\n").expect("written");
    let mut window = super::still();
    let before = window.state().scene().clone();
    drop_file(&mut window, path);
    until(&mut window, |app| app.message().is_some_and(|said| said.contains("model.stl")));
    assert_eq!(*window.state().scene(), before);
    assert!(window.query_by_label("Cancel").is_none());
}
