//! Any sequence of commands, undo and redo leaves the history whole.

use crate::any_commands::{KINDS, any_command, kind};
use crate::every_field;
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use sinew::edit::{Command, Editor};
use sinew::io::scene_to_json;

#[derive(Clone, Debug)]
enum Action {
    Change(Box<Command>, Option<u64>),
    Undo,
    Redo,
}

fn action() -> impl Strategy<Value = Action> {
    let gesture = option::weighted(0.3, 0..2u64);
    let change = (any_command(), gesture).prop_map(|(command, gesture)| Action::Change(Box::new(command), gesture));
    prop_oneof![6 => change, 2 => Just(Action::Undo), 1 => Just(Action::Redo)]
}

/// One step of the history as it ought to be.
#[derive(Clone)]
struct Step {
    name: String,
    gesture: Option<u64>,
    /// The document before and after.
    before: String,
    after: String,
    /// What made it.
    commands: Vec<Command>,
}

/// The history as it ought to be, by whole texts.
#[derive(Default)]
struct Model {
    done: Vec<Step>,
    undone: Vec<Step>,
}

impl Model {
    fn change(&mut self, command: &Command, gesture: Option<u64>, before: String, after: String) {
        self.undone.clear();
        let name = command.name();
        match self.done.last_mut() {
            Some(step) if gesture.is_some() && step.gesture == gesture && step.name == name => {
                step.after = after;
                step.commands.push(command.clone());
            }
            _ => self.done.push(Step { name, gesture, before, after, commands: vec![command.clone()] }),
        }
    }

    /// Moves a step over; a gesture ends there.
    fn shift(from: &mut Vec<Step>, to: &mut Vec<Step>) -> Option<Step> {
        let step = Step { gesture: None, ..from.pop()? };
        to.push(step.clone());
        Some(step)
    }
}

fn text(editor: &Editor) -> String {
    scene_to_json(editor.scene())
}

#[test]
fn commands_of_every_kind_are_tried_and_taken() {
    let mut runner = TestRunner::deterministic();
    let (mut taken, mut refused) = ([0; KINDS], 0);
    let (any, document) = (any_command(), every_field());
    for _ in 0..2000 {
        let command = any.new_tree(&mut runner).expect("a command").current();
        match Editor::new(document.clone()).apply(&command) {
            Ok(()) => taken[kind(&command)] += 1,
            Err(_) => refused += 1,
        }
    }
    assert!(taken.iter().all(|count| *count > 5), "{taken:?}");
    assert!((100..1500).contains(&refused), "{refused} of 2000 refused");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn any_actions_undone_fully_give_the_first_document_and_redone_the_last(actions in vec(action(), 1..40)) {
        let first = scene_to_json(&every_field());
        let mut editor = Editor::new(every_field());
        let mut model = Model::default();
        for action in &actions {
            let before = text(&editor);
            match action {
                Action::Change(command, gesture) => {
                    let made = editor.apply_in(command, *gesture).is_ok();
                    let after = text(&editor);
                    prop_assert!(made || after == before, "a refused change leaves the document");
                    if after != before {
                        model.change(command, *gesture, before, after);
                    }
                }
                Action::Undo => {
                    let step = Model::shift(&mut model.done, &mut model.undone);
                    prop_assert_eq!(editor.undo(), step.is_some());
                    prop_assert_eq!(text(&editor), step.map_or(before, |step| step.before));
                }
                Action::Redo => {
                    let step = Model::shift(&mut model.undone, &mut model.done);
                    prop_assert_eq!(editor.redo(), step.is_some(), "nothing to redo past a new branch");
                    prop_assert_eq!(text(&editor), step.map_or(before, |step| step.after));
                }
            }
            prop_assert_eq!(editor.undo_name(), model.done.last().map(|step| step.name.as_str()));
            prop_assert_eq!(editor.redo_name(), model.undone.last().map(|step| step.name.as_str()));
            prop_assert!(editor.scene().validate().is_ok());
        }
        let last = text(&editor);
        // The document is the replay of what is in effect.
        let mut replay = Editor::new(every_field());
        for command in model.done.iter().flat_map(|step| &step.commands) {
            prop_assert!(replay.apply(command).is_ok());
        }
        prop_assert_eq!(text(&replay), last);
        while editor.redo() {}
        let end = text(&editor);
        let mut steps = 0;
        while editor.undo() {
            steps += 1;
        }
        prop_assert_eq!(steps, model.done.len() + model.undone.len());
        prop_assert_eq!(text(&editor), first);
        prop_assert!(!editor.is_changed());
        while editor.redo() {}
        prop_assert_eq!(text(&editor), end);
    }
}
