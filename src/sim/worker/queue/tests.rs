//! What is heard of what was sent, and when.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::scene::Scene;
use glam::DVec3;

fn document(name: &str) -> Arc<Scene> {
    Arc::new(Scene { name: name.to_owned(), ..serde_json::from_str(r#"{"version": 1}"#).unwrap() })
}

fn edit(name: &str) -> SimCommand {
    SimCommand::Edit(document(name))
}

fn open(name: &str) -> SimCommand {
    SimCommand::Open(document(name), Arc::default())
}

fn ghost(name: &str) -> SimCommand {
    SimCommand::Ghost(Some(document(name)))
}

/// What is heard of commands that were sent in this order: words, and the documents that each stands for.
fn heard(commands: impl IntoIterator<Item = SimCommand>) -> Vec<(String, u64)> {
    let (sender, receiver) = command_queue();
    for command in commands {
        assert!(sender.send(command));
    }
    let word = |command: &SimCommand| match command {
        SimCommand::Edit(scene) => format!("edit {}", scene.name),
        SimCommand::Open(scene, _) => format!("open {}", scene.name),
        SimCommand::Ghost(Some(scene)) => format!("ghost {}", scene.name),
        other => format!("{other:?}"),
    };
    receiver.begin(Some(Instant::now())).unwrap();
    let requests = std::iter::from_fn(|| receiver.next());
    requests.map(|request| (word(&request.command), request.documents)).collect()
}

fn words(commands: impl IntoIterator<Item = SimCommand>) -> Vec<String> {
    heard(commands).into_iter().map(|(word, _)| word).collect()
}

#[test]
fn of_documents_that_follow_each_other_the_newest_is_heard_and_all_are_counted() {
    let edits = (0..400).flat_map(|k| [edit(&k.to_string()), ghost(&k.to_string())]);
    assert_eq!(heard(edits), [("edit 399".to_owned(), 400), ("ghost 399".to_owned(), 0)]);
    let opened = [edit("a"), SimCommand::Step, ghost("b"), open("c"), SimCommand::Pause, edit("d"), edit("e")];
    let expected = [("edit a", 1), ("Step", 0), ("open c", 1), ("Pause", 0), ("edit e", 2)];
    assert_eq!(heard(opened), expected.map(|(word, documents)| (word.to_owned(), documents)));
    assert_eq!(heard([edit("a"), ghost("b"), open("c"), open("d")]), [("open d".to_owned(), 3)]);
    // Whether time runs outlives a document, and what a document is played from.
    assert_eq!(words([open("a"), SimCommand::Play, open("b")]), ["open a", "Play", "open b"]);
    // A ghost joins the scene that was edited before it.
    assert_eq!(words([edit("a"), ghost("b"), edit("c")]), ["edit c", "ghost b"]);
}

#[test]
fn what_is_done_to_a_document_comes_after_it_and_before_the_next() {
    let grab = SimCommand::Grab { body: 0, vertex: 0, target: DVec3::ZERO };
    for between in [SimCommand::Reset, SimCommand::Step, SimCommand::Show(1.0), SimCommand::ContinueHere, grab] {
        let word = format!("{between:?}");
        assert_eq!(words([edit("a"), between, edit("b")]), ["edit a", &word, "edit b"]);
    }
    assert_eq!(words([edit("a"), SimCommand::Play, edit("b"), SimCommand::Reset]), ["edit b", "Play", "Reset"]);
}

#[test]
fn of_settings_and_drags_the_newest_counts_and_nothing_else_is_lost() {
    let at = |x: f64| SimCommand::MoveGrab(DVec3::new(x, 0.0, 0.0));
    let drag = [at(0.0), SimCommand::Speed(0.1), at(1.0), SimCommand::PinGrab, at(2.0), SimCommand::Speed(0.2)];
    let kept = [&at(1.0), &SimCommand::PinGrab, &at(2.0), &SimCommand::Speed(0.2)];
    assert_eq!(words(drag), kept.map(|command| format!("{command:?}")));
    let shown = [SimCommand::Show(0.1), SimCommand::Show(0.2), SimCommand::StepBack, SimCommand::Show(0.3)];
    assert_eq!(words(shown), ["Show(0.2)", "StepBack", "Show(0.3)"]);
    let ghosts = [ghost("a"), ghost("b"), SimCommand::Ghost(None), ghost("c"), ghost("d")];
    assert_eq!(words(ghosts), ["Ghost(None)", "ghost d"]);
    let steps = std::iter::repeat_n(SimCommand::Step, 1000);
    assert_eq!(words(steps).len(), 1000);
}

#[test]
fn what_is_put_together_ends_for_what_replaces_it_and_for_nothing_else() {
    let cases: [(SimCommand, Vec<SimCommand>, bool); 12] = [
        (edit("a"), vec![edit("b")], true),
        (edit("a"), vec![open("b")], true),
        (open("a"), vec![SimCommand::Play, SimCommand::Speed(0.5), edit("b")], true),
        (open("a"), vec![ghost("g"), edit("b")], true),
        (SimCommand::Compare { integrators: Vec::new(), dt: 1e-3 }, vec![edit("b")], true),
        (ghost("a"), vec![ghost("b")], true),
        (ghost("a"), vec![open("b")], true),
        // A ghost is as wanted beside the edited document.
        (ghost("a"), vec![edit("b")], false),
        (edit("a"), vec![ghost("b")], false),
        // What is done to the document first is done to this one.
        (edit("a"), vec![SimCommand::Step, edit("b")], false),
        (open("a"), vec![SimCommand::Reset, edit("b"), edit("c")], false),
        (SimCommand::Step, vec![edit("b")], false),
    ];
    for (present, newer, ends) in cases {
        let (sender, receiver) = command_queue();
        let words = format!("{present:?} {newer:?}");
        assert!(sender.send(present));
        receiver.begin(None).unwrap();
        receiver.next().unwrap();
        for command in newer {
            assert!(!receiver.stop().is_set(), "{words}");
            assert!(sender.send(command));
        }
        assert_eq!(receiver.stop().is_set(), ends, "{words}");
        assert!(!receiver.stop().is_asked());
        // What is heard next is not stopped by what stopped the last.
        receiver.begin(None).unwrap();
        receiver.next().unwrap();
        assert!(!receiver.stop().is_set(), "{words}");
    }
}

#[test]
fn an_edit_comes_before_the_ghost_that_was_asked_for_beside_what_it_replaces() {
    let (sender, receiver) = command_queue();
    for command in [edit("a"), SimCommand::Play] {
        assert!(sender.send(command));
    }
    assert_eq!(receiver.begin(None), Some(2));
    receiver.next().unwrap();
    for command in [ghost("g"), edit("b"), SimCommand::Step] {
        assert!(sender.send(command));
    }
    let next = || receiver.next().map(|request| request.command);
    // It belongs to those that are heard before the next frame; what came later does not.
    assert!(matches!(next(), Some(SimCommand::Edit(scene)) if scene.name == "b"));
    assert!(matches!(next(), Some(SimCommand::Play)));
    assert!(next().is_none());
    assert_eq!(receiver.begin(None), Some(2));
    assert!(matches!(next(), Some(SimCommand::Ghost(_))));
    assert!(matches!(next(), Some(SimCommand::Step)));
}

#[test]
fn what_is_put_together_can_be_stopped_and_what_moves_cannot() {
    let (sender, receiver) = command_queue();
    // The first document.
    sender.stop();
    assert!(receiver.stop().is_asked());
    assert!(sender.send(SimCommand::Step));
    receiver.begin(None).unwrap();
    receiver.next().unwrap();
    sender.stop();
    assert!(!receiver.stop().is_set());
    assert!(receiver.next().is_none());
    drop(sender);
    assert!(receiver.stop().is_set(), "nobody waits for it any more");
}

#[test]
fn either_end_learns_that_the_other_is_gone() {
    let (sender, receiver) = command_queue();
    let waiting = std::thread::spawn(move || receiver.begin(None).is_none());
    drop(sender);
    assert!(waiting.join().unwrap());
    let (sender, receiver) = command_queue();
    drop(receiver);
    assert!(!sender.send(SimCommand::Play));
}

#[test]
fn what_only_holds_or_looks_is_heard_while_a_document_is_put_together() {
    let word = |command: Option<SimCommand>| command.map(|command| format!("{command:?}"));
    let (sender, receiver) = command_queue();
    let early = receiver.early();
    assert!(early.next().is_none());
    let sent = [
        SimCommand::Pause,
        SimCommand::Show(0.5),
        SimCommand::Reset,
        SimCommand::Play,
        SimCommand::Field(None),
        SimCommand::StepBack,
        SimCommand::Pause,
    ];
    for command in sent {
        assert!(sender.send(command));
    }
    for expected in ["Pause", "Show(0.5)", "Reset", "Play", "Field(None)"] {
        assert_eq!(word(early.next()).as_deref(), Some(expected));
    }
    // What is looked at behind a reset is there after it, and nothing overtakes that.
    assert!(early.next().is_none());
    assert_eq!(receiver.begin(None), Some(3));
    let left: Vec<_> =
        std::iter::from_fn(|| receiver.next()).filter_map(|request| word(Some(request.command))).collect();
    assert_eq!(left, ["Reset", "StepBack", "Pause"]);
    // Within what is heard before the next frame, too.
    for command in [edit("a"), SimCommand::Pause, SimCommand::Step, SimCommand::Play] {
        assert!(sender.send(command));
    }
    assert_eq!(receiver.begin(None), Some(4));
    receiver.next().unwrap();
    assert_eq!(word(early.next()).as_deref(), Some("Pause"));
    assert!(early.next().is_none(), "a step is no matter of looking");
    let left: Vec<_> =
        std::iter::from_fn(|| receiver.next()).filter_map(|request| word(Some(request.command))).collect();
    assert_eq!(left, ["Step", "Play"]);
}

#[test]
fn a_frame_goes_on_for_a_while_after_something_waits_however_much_comes_behind() {
    let (sender, receiver) = command_queue();
    let ends = receiver.stop().of_frame();
    for command in [SimCommand::Step, SimCommand::MoveGrab(DVec3::ZERO), SimCommand::Speed(1.0)] {
        assert!(sender.send(command));
    }
    let begun = Instant::now();
    assert!(!ends());
    assert!(sender.send(SimCommand::Pause));
    assert!(!ends() || begun.elapsed() > Duration::from_millis(100), "it may be nearly there");
    while !ends() {
        // Each takes the place of the one before it, and waits since then.
        assert!(sender.send(edit("newer")));
        assert!(begun.elapsed() < Duration::from_mins(2), "it never ends");
        std::thread::yield_now();
    }
    // Those that were heard before it do not give it more time.
    assert_eq!(receiver.begin(None), Some(5));
    receiver.next().unwrap();
    assert!(ends());
    let (sender, receiver) = command_queue();
    let ends = receiver.stop().of_frame();
    assert!(sender.send(SimCommand::Reset));
    assert!(ends(), "nothing is left of it");
}
