//! The document's history: every change is one step back and one step forth.

use crate::scene;
use proptest::prelude::*;
use sinew::edit::{Command, EditError, Editor};
use sinew::io::scene_to_json;
use sinew::scene::FibreSource;

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

fn command() -> impl Strategy<Value = Command> {
    let original = scene();
    let fibre = original.bodies[0].fibres[0].clone();
    let material = original.bodies[0].material.clone();
    prop_oneof![
        (-20.0..20.0f64).prop_map(|g| Command::SetGravity([0.0, g, 0.0])),
        (0..8u32, 0.0..1.0f64).prop_map({
            let fibre = fibre.clone();
            move |(k, fraction)| {
                let mut fibre = fibre.clone();
                fibre.id = format!("new-{k}");
                fibre.volume_fraction = fraction;
                Command::AddFibre { body: "bar".into(), fibre }
            }
        }),
        (1..5u32, -0.01..0.01f64).prop_map(move |(k, x)| {
            let mut fibre = fibre.clone();
            fibre.id = format!("fibre-{k}");
            fibre.source = FibreSource::Vertices(vec![[x, 0.0, 0.0], [x, 0.03, 0.0], [x, 0.06, 0.0]]);
            Command::SetFibre { body: "bar".into(), fibre }
        }),
        (1..8u32).prop_map(|k| Command::RemoveFibre { body: "bar".into(), fibre: format!("fibre-{k}") }),
        (1e4..1e8f64).prop_map(move |young_modulus| {
            let mut material = material.clone();
            material.young_modulus = young_modulus;
            Command::SetMaterial { body: "bar".into(), material }
        }),
    ]
}

proptest! {
    #[test]
    fn any_commands_undone_fully_give_the_first_document_and_redone_the_last(
        commands in prop::collection::vec(command(), 1..30)
    ) {
        let mut editor = Editor::new(scene());
        let mut made = Vec::new();
        for command in &commands {
            // Some are refused: a fibre that is gone cannot be changed.
            if editor.apply(command).is_ok() {
                made.push(command.clone());
            }
        }
        let last = scene_to_json(editor.scene());
        // The document is the replay of what was accepted.
        let mut replay = Editor::new(scene());
        for command in &made {
            prop_assert!(replay.apply(command).is_ok());
        }
        prop_assert_eq!(&scene_to_json(replay.scene()), &last);
        while editor.undo() {}
        prop_assert_eq!(scene_to_json(editor.scene()), scene_to_json(&scene()));
        prop_assert!(!editor.is_changed());
        while editor.redo() {}
        prop_assert_eq!(scene_to_json(editor.scene()), last);
    }
}
