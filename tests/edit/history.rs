//! The document's history: every change is one step back and one step forth.

use crate::scene;
use sinew::edit::{Command, EditError, Editor};

#[test]
fn a_refused_change_leaves_the_document_and_its_history() {
    let mut editor = Editor::new(scene());
    let mut material = editor.scene().bodies[0].material.clone();
    material.poisson_ratio = 0.6;
    let refused = editor.apply(&Command::SetMaterial { body: "bar".into(), material });
    assert!(matches!(refused, Err(EditError::Invalid(_))), "{refused:?}");
    let missing = editor.apply(&Command::RemoveFibre { body: "bar".into(), fibre: "none".into() });
    assert!(matches!(missing, Err(EditError::Missing(_))), "{missing:?}");
    assert!(!editor.is_changed() && editor.undo_name().is_none());
    assert_eq!(**editor.scene(), scene());
}

#[test]
fn redo_ends_where_another_change_begins() {
    let mut editor = Editor::new(scene());
    editor.apply(&Command::SetGravity([0.0, -1.0, 0.0])).expect("a change");
    editor.apply(&Command::SetGravity([0.0, -2.0, 0.0])).expect("a change");
    assert!(editor.undo());
    assert_eq!(editor.redo_name(), Some("Change gravity"));
    editor.apply(&Command::RemoveFibre { body: "bar".into(), fibre: "fibre-1".into() }).expect("a change");
    assert!(!editor.redo());
    assert_eq!(editor.undo_name(), Some("Delete fibre"));
    editor.mark_saved();
    assert!(!editor.is_changed() && editor.undo() && editor.is_changed());
}

#[test]
fn a_document_that_no_file_holds_is_changed_until_it_is_saved() {
    let mut editor = Editor::new(scene());
    editor.apply(&Command::SetGravity([0.0, -1.0, 0.0])).expect("a change");
    editor.mark_unsaved();
    assert!(editor.is_changed() && editor.undo() && editor.is_changed(), "undo leads to nothing that is saved");
    editor.mark_saved();
    assert!(!editor.is_changed() && editor.redo() && editor.is_changed());
}
