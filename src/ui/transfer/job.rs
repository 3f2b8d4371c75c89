//! What is written beside the window, how far it has come and what became of it.

use crate::transfer::{TransferError, Written};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread::JoinHandle;
use std::time::Instant;

/// How far the work has come, and whether it is to end.
#[derive(Default)]
pub(super) struct Progress {
    is_cancelled: AtomicBool,
    done: AtomicU64,
}

impl Progress {
    /// Whether the work is to end with the piece at hand.
    pub(super) fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }

    /// A piece is done.
    pub(super) fn step(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }
}

/// What became of the work: what was written, and why it ended early, where it failed.
pub(super) struct TransferReport {
    pub(super) written: Vec<Written>,
    pub(super) problem: Option<String>,
}

impl TransferReport {
    /// Of work that has written something and came to this.
    pub(super) fn of(written: Vec<Written>, result: Result<(), TransferError>) -> Self {
        Self { written, problem: result.err().map(|error| error.to_string()) }
    }
}

impl From<TransferError> for TransferReport {
    fn from(error: TransferError) -> Self {
        Self::of(Vec::new(), Err(error))
    }
}

/// Work on a thread of its own.
pub(super) struct Job {
    /// What it is, to be said before how far it has come.
    pub(super) name: &'static str,
    /// What its pieces are called.
    pub(super) pieces: &'static str,
    /// How many there are.
    pub(super) all: u64,
    started: Instant,
    progress: Arc<Progress>,
    report: Receiver<TransferReport>,
    thread: Option<JoinHandle<()>>,
}

impl Job {
    /// Starts to work; `notify` is called when it has ended.
    pub(super) fn start(
        [name, pieces]: [&'static str; 2],
        all: u64,
        notify: impl FnOnce() + Send + 'static,
        work: impl FnOnce(&Progress) -> TransferReport + Send + 'static,
    ) -> Self {
        let (sender, report) = channel();
        let progress = Arc::<Progress>::default();
        let seen = Arc::clone(&progress);
        let thread = std::thread::Builder::new().name("export".into()).spawn(move || {
            let worked = catch_unwind(AssertUnwindSafe(|| work(&seen)));
            let failed = |_| TransferReport {
                written: Vec::new(),
                problem: Some("The work ended by a failure of the program; files until then are whole".to_owned()),
            };
            // The window may be gone by now.
            sender.send(worked.unwrap_or_else(failed)).ok();
            notify();
        });
        Self { name, pieces, all: all.max(1), started: Instant::now(), progress, report, thread: thread.ok() }
    }

    /// How many pieces are done.
    pub(super) fn done(&self) -> u64 {
        self.progress.done.load(Ordering::Relaxed).min(self.all)
    }

    /// Time that is left, as far as can be told from what it took so far [s].
    pub(super) fn seconds_left(&self) -> Option<f64> {
        let done = self.done();
        let left = (self.all - done) as f64 / done as f64;
        (done > 0).then(|| left * self.started.elapsed().as_secs_f64())
    }

    /// Ends it with the piece at hand.
    pub(super) fn cancel(&self) {
        self.progress.is_cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether it is to end.
    pub(super) fn is_cancelled(&self) -> bool {
        self.progress.is_cancelled()
    }

    /// What became of it, once it has ended.
    pub(super) fn report(&self) -> Option<TransferReport> {
        match self.report.try_recv() {
            Ok(report) => Some(report),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(TransferReport {
                written: Vec::new(),
                problem: Some("No thread could be started; try again".to_owned()),
            }),
        }
    }
}

impl Drop for Job {
    fn drop(&mut self) {
        // What is written is whole once the thread has ended.
        self.cancel();
        if let Some(thread) = self.thread.take() {
            thread.join().ok();
        }
    }
}
