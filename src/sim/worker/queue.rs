//! What the window has asked for and the simulation thread has not heard yet.
//!
//! Commands are heard in the order in which they were sent, and the window never waits. A command that a newer one
//! makes pointless leaves the queue for it, so that it stays as short as what a person can ask for while a frame is
//! computed. Whether it does is decided by what lies between them: nothing may, that would turn out otherwise without
//! the older one. What is being done just now is treated as if it still waited, as far as it can be stopped: the work
//! on a document that a newer one replaces ends.

use super::effect::{Effect, effect};
use super::shared::lock;
use super::stop::{Stop, Urgency};
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
    stop: Stop,
}

/// What is being put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Work {
    Document,
    Ghost,
}

impl Work {
    fn of(command: &SimCommand) -> Option<Self> {
        match command {
            SimCommand::Open(..) | SimCommand::Edit(_) | SimCommand::Compare { .. } | SimCommand::Reset => {
                Some(Self::Document)
            }
            SimCommand::Ghost(_) => Some(Self::Ghost),
            _ => None,
        }
    }

    /// Whether it is put together anew anyway once a command is heard.
    fn is_outdated_by(self, newer: &SimCommand) -> bool {
        match newer {
            SimCommand::Open(..) => true,
            SimCommand::Edit(_) => self == Self::Document,
            SimCommand::Ghost(_) => self == Self::Ghost,
            _ => false,
        }
    }
}

#[derive(Default)]
struct Waiting {
    requests: Vec<Request>,
    /// How many of them are heard before the next frame.
    batch: usize,
    /// What is being done just now, where it can be stopped.
    present: Option<Work>,
    closed: bool,
}

/// The window's end of the queue.
pub(super) struct CommandSender(Arc<Queue>);

/// The thread's end of the queue.
pub(super) struct CommandReceiver(Arc<Queue>);

/// An empty queue of a thread that puts its first document together. When one of its ends is dropped, the other one
/// learns of that.
pub(super) fn command_queue() -> (CommandSender, CommandReceiver) {
    let queue = Arc::<Queue>::default();
    lock(&queue.waiting).present = Some(Work::Document);
    (CommandSender(Arc::clone(&queue)), CommandReceiver(queue))
}

impl CommandSender {
    /// Appends a command; false where nobody will hear it.
    pub(super) fn send(&self, command: SimCommand) -> bool {
        let mut waiting = lock(&self.0.waiting);
        if !waiting.closed {
            self.0.stop.hurry(Urgency::of(&command));
            if waiting.push(command) {
                self.0.stop.outdate();
            }
            self.0.changed.notify_one();
        }
        !waiting.closed
    }

    /// Ends what is being put together just now, if anything is.
    pub(super) fn stop(&self) {
        let waiting = lock(&self.0.waiting);
        if waiting.present.is_some() {
            self.0.stop.ask();
        }
    }
}

impl CommandReceiver {
    /// How many commands wait, as soon as one does; zero if none has come by `deadline`, where there is one. So many
    /// [`Self::next`] gives before the next call. None once the window is gone.
    pub(super) fn begin(&self, deadline: Option<Instant>) -> Option<usize> {
        let mut waiting = lock(&self.0.waiting);
        waiting.present = None;
        while waiting.requests.is_empty() && !waiting.closed {
            let left = deadline.map(|deadline| deadline.saturating_duration_since(Instant::now()));
            waiting = match left {
                None => self.0.changed.wait(waiting).unwrap_or_else(PoisonError::into_inner),
                Some(Duration::ZERO) => break,
                Some(left) => self.0.changed.wait_timeout(waiting, left).unwrap_or_else(PoisonError::into_inner).0,
            };
        }
        waiting.batch = waiting.requests.len();
        (!waiting.closed).then_some(waiting.batch)
    }

    /// The next of those that waited; nothing stops it yet.
    pub(super) fn next(&self) -> Option<Request> {
        let mut waiting = lock(&self.0.waiting);
        self.0.stop.clear();
        let request = (waiting.batch > 0 && !waiting.closed).then(|| waiting.requests.remove(0));
        waiting.batch = waiting.batch.saturating_sub(1);
        waiting.present = request.as_ref().and_then(|request| Work::of(&request.command));
        // What waits behind it does not wait long for a frame that comes now.
        waiting.requests.iter().for_each(|later| self.0.stop.hurry(Urgency::of(&later.command)));
        request
    }

    /// What ends the work on the request that was heard last.
    pub(super) fn stop(&self) -> Stop {
        self.0.stop.clone()
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
        *lock(&self.waiting) = Waiting { closed: true, ..Waiting::default() };
        self.stop.outdate();
        self.stop.hurry(Urgency::Drop);
        self.changed.notify_one();
    }
}

impl Waiting {
    /// Appends a command without the older ones that it supersedes. An edit comes where the one was that it supersedes:
    /// a ghost that was asked for behind that begins from where the edited scene is. True where it makes pointless what
    /// is being done just now.
    fn push(&mut self, command: SimCommand) -> bool {
        let mut documents = u64::from(matches!(command, SimCommand::Edit(_) | SimCommand::Open(..)));
        let mut place = None;
        let mut stops = false;
        for index in (0..self.requests.len()).rev() {
            match effect(&command, &self.requests[index].command) {
                Effect::Supersedes => {
                    documents += self.requests.remove(index).documents;
                    self.batch -= usize::from(index < self.batch);
                    place = matches!(command, SimCommand::Edit(_)).then_some(index);
                }
                Effect::Passes => {}
                Effect::Stops => {
                    stops = true;
                    break;
                }
            }
        }
        let outdates = !stops && self.present.is_some_and(|work| work.is_outdated_by(&command));
        if outdates && matches!(command, SimCommand::Edit(_)) {
            place = Some(0);
        }
        let place = place.unwrap_or(self.requests.len());
        self.batch += usize::from(place < self.batch);
        self.requests.insert(place, Request { command, documents });
        outdates
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
}
