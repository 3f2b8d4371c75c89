//! What the window has asked for and the simulation thread has not heard yet.
//!
//! Commands are heard in the order in which they were sent, and the window never waits. A command that a newer one
//! makes pointless leaves the queue for it, so that it stays as short as what a person can ask for while a frame is
//! computed. Whether it does is decided by what lies between them: nothing may, that would turn out otherwise without
//! the older one. What is being done just now is treated as if it still waited, as far as it can be stopped: the work
//! on a document that a newer one replaces ends. While it goes on, what only looks at the motion or holds it is heard
//! out of turn: it comes to the same before and after.

use super::effect::{Effect, effect};
use super::shared::lock;
use super::stop::Stop;
use crate::sim::command::SimCommand;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// A command, and how many documents it stands for: itself, if it brings one, and those that it superseded.
#[derive(Clone, Debug)]
pub(super) struct QueuedCommand {
    pub(super) command: SimCommand,
    pub(super) documents: u64,
    /// Since when it waits, or the oldest of those that it superseded.
    since: Instant,
    /// Whether it was heard out of turn already.
    was_heard: bool,
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
    requests: Vec<QueuedCommand>,
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
            let now = Instant::now();
            self.0.stop.hurry(&command, now);
            if waiting.push(command, now) {
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
    pub(super) fn next(&self) -> Option<QueuedCommand> {
        let mut waiting = lock(&self.0.waiting);
        self.0.stop.clear();
        let request = (waiting.batch > 0 && !waiting.closed).then(|| waiting.requests.remove(0));
        waiting.batch = waiting.batch.saturating_sub(1);
        waiting.present = request.as_ref().and_then(|request| Work::of(&request.command));
        // What waits behind it does not wait long for a frame that comes now.
        waiting.requests.iter().for_each(|later| self.0.stop.hurry(&later.command, later.since));
        request
    }

    /// What ends the work on the request that was heard last.
    pub(super) fn stop(&self) -> Stop {
        self.0.stop.clone()
    }

    /// What can be heard while a document is put together.
    pub(super) fn early(&self) -> EarlyCommands {
        EarlyCommands(Some(Arc::clone(&self.0)))
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
        self.stop.end();
        self.changed.notify_one();
    }
}

impl Waiting {
    /// Appends a command without the older ones that it supersedes. An edit comes where the one was that it supersedes:
    /// a ghost that was asked for behind that begins from where the edited scene is. True where it makes pointless what
    /// is being done just now.
    fn push(&mut self, command: SimCommand, mut since: Instant) -> bool {
        let mut documents = u64::from(matches!(command, SimCommand::Edit(_) | SimCommand::Open(..)));
        let mut place = None;
        let mut stops = false;
        for index in (0..self.requests.len()).rev() {
            match effect(&command, &self.requests[index].command) {
                Effect::Supersedes => {
                    let older = self.requests.remove(index);
                    documents += older.documents;
                    since = since.min(older.since);
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
        self.requests.insert(place, QueuedCommand { command, documents, since, was_heard: false });
        outdates
    }
}

/// Commands that are heard while a document is put together: those that come to the same before it and after it, and
/// follow each other at the head of the queue.
#[derive(Clone, Default)]
pub(super) struct EarlyCommands(Option<Arc<Queue>>);

impl EarlyCommands {
    /// The next of them. A reset puts what still moves back to its start, and is heard again in its turn.
    pub(super) fn next(&self) -> Option<SimCommand> {
        let mut waiting = lock(&self.0.as_ref()?.waiting);
        let index = waiting.requests.iter().position(|request| !request.was_heard)?;
        let request = &mut waiting.requests[index];
        match request.command {
            SimCommand::Reset => {
                request.was_heard = true;
                return Some(SimCommand::Reset);
            }
            SimCommand::Play
            | SimCommand::Pause
            | SimCommand::Speed(_)
            | SimCommand::Field(_)
            | SimCommand::Tension(_)
            | SimCommand::Activation(_) => {}
            // Behind a reset there is nothing earlier to be looked at.
            SimCommand::Show(_) | SimCommand::StepBack | SimCommand::Live if index == 0 => {}
            _ => return None,
        }
        waiting.batch -= usize::from(index < waiting.batch);
        Some(waiting.requests.remove(index).command)
    }
}

#[cfg(test)]
mod tests;
