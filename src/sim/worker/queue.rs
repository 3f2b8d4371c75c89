//! What the window has asked for and the simulation thread has not heard yet.
//!
//! Commands are heard in the order in which they were sent, and the window never waits. A command that a newer one
//! makes pointless leaves the queue for it, so that it stays as short as what a person can ask for while a frame is
//! computed. Whether it does is decided by what lies between them: nothing may, that would turn out otherwise without
//! the older one.

use super::shared::lock;
use crate::sim::command::SimCommand;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// A command, and how many documents it stands for: itself, if it brings one, and those that it superseded.
#[derive(Clone, Debug)]
pub(super) struct Request {
    pub(super) command: SimCommand,
    pub(super) documents: u64,
}

#[derive(Default)]
struct Queue {
    waiting: Mutex<Waiting>,
    changed: Condvar,
}

#[derive(Default)]
struct Waiting {
    requests: Vec<Request>,
    closed: bool,
}

/// The window's end of the queue.
pub(super) struct CommandSender(Arc<Queue>);

/// The thread's end of the queue.
pub(super) struct CommandReceiver(Arc<Queue>);

/// An empty queue. When one of its ends is dropped, the other one learns of that.
pub(super) fn command_queue() -> (CommandSender, CommandReceiver) {
    let queue = Arc::default();
    (CommandSender(Arc::clone(&queue)), CommandReceiver(queue))
}

impl CommandSender {
    /// Appends a command; false where nobody will hear it.
    pub(super) fn send(&self, command: SimCommand) -> bool {
        let mut waiting = lock(&self.0.waiting);
        if !waiting.closed {
            waiting.push(command);
            self.0.changed.notify_one();
        }
        !waiting.closed
    }
}

impl CommandReceiver {
    /// All that waits, as soon as something does; nothing if nothing has come by `deadline`, where there is one. None
    /// once the window is gone.
    pub(super) fn take_all(&self, deadline: Option<Instant>) -> Option<Vec<Request>> {
        let mut waiting = lock(&self.0.waiting);
        while waiting.requests.is_empty() && !waiting.closed {
            let left = deadline.map(|deadline| deadline.saturating_duration_since(Instant::now()));
            waiting = match left {
                None => self.0.changed.wait(waiting).unwrap_or_else(PoisonError::into_inner),
                Some(Duration::ZERO) => break,
                Some(left) => self.0.changed.wait_timeout(waiting, left).unwrap_or_else(PoisonError::into_inner).0,
            };
        }
        (!waiting.closed).then(|| std::mem::take(&mut waiting.requests))
    }

    /// Whether the window is gone.
    pub(super) fn is_closed(&self) -> bool {
        lock(&self.0.waiting).closed
    }
}

impl Drop for CommandSender {
    fn drop(&mut self) {
        self.0.close();
    }
}

impl Drop for CommandReceiver {
    fn drop(&mut self) {
        self.0.close();
    }
}

impl Queue {
    fn close(&self) {
        *lock(&self.waiting) = Waiting { requests: Vec::new(), closed: true };
        self.changed.notify_one();
    }
}

impl Waiting {
    /// Appends a command without the older ones that it supersedes. An edit comes where the one was that it supersedes: a
    /// ghost that was asked for behind that begins from where the edited scene is.
    fn push(&mut self, command: SimCommand) {
        let mut documents = u64::from(matches!(command, SimCommand::Edit(_) | SimCommand::Open(..)));
        let mut place = None;
        for index in (0..self.requests.len()).rev() {
            match effect(&command, &self.requests[index].command) {
                Effect::Supersedes => {
                    documents += self.requests.remove(index).documents;
                    place = matches!(command, SimCommand::Edit(_)).then_some(index);
                }
                Effect::Passes => {}
                Effect::Stops => break,
            }
        }
        self.requests.insert(place.unwrap_or(self.requests.len()), Request { command, documents });
    }
}

/// What a command does to an older one that still waits. Of documents and ghosts that follow each other only the newest is
/// put together, whatever the others would have been.
enum Effect {
    /// It takes its place: with or without the older one all comes to the same.
    Supersedes,
    /// It leaves it where it is, and may supersede even older ones.
    Passes,
    /// Nothing before the older one is superseded.
    Stops,
}

fn effect(newer: &SimCommand, older: &SimCommand) -> Effect {
    use SimCommand::{Edit, Field, Ghost, MoveGrab, Open, Pause, Play, Show, Speed, Tension};
    match (newer, older) {
        // A ghost that is ended and wanted again starts anew from where the world is.
        (Ghost(Some(_)), Ghost(None)) => Effect::Stops,
        // Another document leaves nothing of the last one, whatever was done to it.
        (Open(..), Open(..) | Edit(_) | Ghost(_))
        | (Edit(_), Edit(_))
        | (Ghost(_), Ghost(_))
        | (Speed(_), Speed(_))
        | (Field(_), Field(_))
        | (Tension(_), Tension(_))
        | (Show(_), Show(_))
        | (MoveGrab(_), MoveGrab(_)) => Effect::Supersedes,
        // Settings and all the rest do not heed each other. Whether time runs is all the same to an edit and a ghost: no
        // frame is computed between two commands.
        (Speed(_) | Field(_) | Tension(_), _)
        | (_, Speed(_) | Field(_) | Tension(_))
        | (Edit(_) | Ghost(_), Edit(_) | Ghost(_) | Play | Pause) => Effect::Passes,
        _ => Effect::Stops,
    }
}

#[cfg(test)]
mod tests {
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
        let requests = receiver.take_all(Some(Instant::now())).unwrap();
        requests.iter().map(|request| (word(&request.command), request.documents)).collect()
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
    fn either_end_learns_that_the_other_is_gone() {
        let (sender, receiver) = command_queue();
        let waiting = std::thread::spawn(move || receiver.take_all(None).is_none());
        drop(sender);
        assert!(waiting.join().unwrap());
        let (sender, receiver) = command_queue();
        drop(receiver);
        assert!(!sender.send(SimCommand::Play));
    }
}
