//! The thread that keeps the changed document where it can be recovered, and looks after its file: the window waits for
//! no disk.

use super::offer::RecoveryOffer;
use super::recorder::{Recorder, recordings_in};
use super::requests::{AutosaveReport, AutosaveRequest};
use crate::io::{
    FileStamp, FileState, IoError, Kept, Origin, RecoverableDocument, RecoveryFile, load_scene, recoverable_documents,
};
use crate::scene::Scene;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// A document is kept this long after its last change,
const QUIET: Duration = Duration::from_secs(5);
/// and this long after its first one at the latest: who never pauses is kept too.
const LATEST: Duration = Duration::from_secs(30);
/// Who ends the program waits this long for the document to be kept.
const PATIENCE: Duration = Duration::from_secs(3);
/// The recording is kept this often: what ends the program takes no more of it.
const RECORDED: Duration = Duration::from_millis(500);
/// The file of the document is looked at this often.
const EVERY: Duration = Duration::from_secs(2);

/// A document that waits in the slot.
struct WaitingDocument {
    number: u64,
    origin: Origin,
    scene: Arc<Scene>,
}

/// The newest document that is to be kept: earlier ones are of no use.
type LatestSlot = Arc<Mutex<Option<WaitingDocument>>>;

/// The thread, seen from the window.
pub(super) struct AutosaveThread {
    requests: Sender<AutosaveRequest>,
    reports: Receiver<AutosaveReport>,
    slot: LatestSlot,
    /// Of the document that was put in the slot last.
    number: u64,
    thread: Option<JoinHandle<()>>,
}

impl AutosaveThread {
    /// Starts the thread; `wake` is called whenever there is something to tell.
    pub(super) fn start(wake: impl Fn() + Send + Sync + 'static) -> Self {
        let (requests, asked) = channel();
        let (told, reports) = channel();
        let slot = LatestSlot::default();
        let autosaver = Autosaver::new(Arc::clone(&slot), told, wake);
        let thread = std::thread::Builder::new().name("autosave".into()).spawn(move || autosaver.run(&asked)).ok();
        Self { requests, reports, slot, number: 0, thread }
    }

    pub(super) fn send(&self, request: AutosaveRequest) {
        // The thread outlives every request; without it nothing is kept.
        let _ = self.requests.send(request);
    }

    /// Has changes kept as they are by then, from any thread, and waits for that a while.
    pub(super) fn keeping(&self) -> impl Fn() + Send + 'static {
        let requests = self.requests.clone();
        move || {
            let (done, said) = channel();
            if requests.send(AutosaveRequest::KeepAndSay(done)).is_ok() {
                // What a disk holds up is given up.
                let _ = said.recv_timeout(PATIENCE);
            }
        }
    }

    pub(super) fn keep(&mut self, origin: Origin, scene: Arc<Scene>) {
        self.number += 1;
        *locked(&self.slot) = Some(WaitingDocument { number: self.number, origin, scene });
        self.send(AutosaveRequest::Keep);
    }

    pub(super) fn forget(&self) {
        self.send(AutosaveRequest::Forget(self.number));
    }

    pub(super) fn report(&self) -> Option<AutosaveReport> {
        self.reports.try_recv().ok()
    }
}

impl Drop for AutosaveThread {
    fn drop(&mut self) {
        self.send(AutosaveRequest::End(std::thread::panicking()));
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

fn locked(slot: &LatestSlot) -> MutexGuard<'_, Option<WaitingDocument>> {
    slot.lock().unwrap_or_else(PoisonError::into_inner)
}

struct Watched {
    number: u64,
    stamp: FileStamp,
    /// What was told of it last.
    told: FileState,
    next: Instant,
}

/// When the document is to be kept.
struct Due {
    first: Instant,
    last: Instant,
}

impl Due {
    fn at(&self) -> Instant {
        (self.last + QUIET).min(self.first + LATEST)
    }
}

/// The thread's own state.
struct Autosaver {
    slot: LatestSlot,
    folder: Option<PathBuf>,
    /// Where this document is kept, from the first time on.
    place: Option<RecoveryFile>,
    /// Number of the document that is kept there.
    kept: u64,
    recovered: Vec<RecoverableDocument>,
    /// Keeps the recording, and when it does so next.
    recorder: Option<(Recorder, Instant)>,
    due: Option<Due>,
    watched: Option<Watched>,
    /// Whether it was told that nothing can be kept: once is enough.
    has_failed: bool,
    /// The same of the recording.
    cannot_record: bool,
    /// Whether it was told that the recording is as long as it may become.
    is_full: bool,
    reports: Sender<AutosaveReport>,
    wake: Arc<dyn Fn() + Send + Sync>,
}

impl Autosaver {
    fn new(slot: LatestSlot, reports: Sender<AutosaveReport>, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            slot,
            folder: None,
            place: None,
            kept: 0,
            recovered: Vec::new(),
            recorder: None,
            due: None,
            watched: None,
            has_failed: false,
            cannot_record: false,
            is_full: false,
            reports,
            wake: Arc::new(wake),
        }
    }

    fn run(mut self, requests: &Receiver<AutosaveRequest>) {
        let by_a_fault = loop {
            match self.wait(requests) {
                Ok(AutosaveRequest::End(by_a_fault)) => break by_a_fault,
                Err(RecvTimeoutError::Disconnected) => break true,
                Ok(request) => self.go(request),
                Err(RecvTimeoutError::Timeout) => {}
            }
            let now = Instant::now();
            if self.recorder.as_ref().is_some_and(|(_, next)| *next <= now) {
                self.record();
            }
            if self.due.as_ref().is_some_and(|due| due.at() <= now) {
                self.keep();
            }
            if self.watched.as_ref().is_some_and(|watched| watched.next <= now) {
                self.look();
            }
        };
        self.keep();
        self.record();
        // Of a session that ended as it was meant to nothing has to be found.
        if let Some(place) = self.place.as_ref().filter(|place| !by_a_fault && !place.has_document()) {
            place.clear_recording().ok();
        }
    }

    fn wait(&self, requests: &Receiver<AutosaveRequest>) -> Result<AutosaveRequest, RecvTimeoutError> {
        let due = self.due.as_ref().map(Due::at);
        let record = self.recorder.as_ref().filter(|_| self.folder.is_some()).map(|(_, next)| *next);
        let next = due.into_iter().chain(self.watched.as_ref().map(|watched| watched.next)).chain(record).min();
        match next {
            Some(next) => requests.recv_timeout(next.saturating_duration_since(Instant::now())),
            None => requests.recv().map_err(|_| RecvTimeoutError::Disconnected),
        }
    }

    fn go(&mut self, request: AutosaveRequest) {
        let now = Instant::now();
        match request {
            AutosaveRequest::Folder(folder) => {
                let found = recoverable_documents(&folder).into_iter().map(RecoveryOffer::new).collect();
                self.folder = Some(folder.clone());
                self.tell(AutosaveReport::Offers(found));
                self.look_for_recordings(folder);
            }
            AutosaveRequest::Keep => self.due.get_or_insert(Due { first: now, last: now }).last = now,
            AutosaveRequest::KeepNow => self.keep(),
            AutosaveRequest::Record(tail, origin) => self.recorder = Some((Recorder::new(tail, origin), now)),
            AutosaveRequest::Opened(origin) => {
                if let Some((recorder, _)) = &mut self.recorder {
                    recorder.of(origin);
                }
            }
            AutosaveRequest::Placed(origin) => {
                if let Some((recorder, _)) = &mut self.recorder {
                    recorder.placed(origin);
                }
            }
            AutosaveRequest::KeepAndSay(done) => {
                self.keep();
                self.record();
                // Whoever asked may have lost patience.
                let _ = done.send(());
            }
            // The loop ends by it.
            AutosaveRequest::End(_) => {}
            AutosaveRequest::Forget(number) => self.forget(number),
            AutosaveRequest::Recovered(what) => self.recovered.push(what),
            AutosaveRequest::Watch(number, stamp) => {
                self.watched = stamp.map(|stamp| Watched { number, stamp, told: FileState::Same, next: now + EVERY });
            }
            AutosaveRequest::Compare(scene) => self.compare(&scene),
            AutosaveRequest::Look => self.look(),
        }
    }

    fn keep(&mut self) {
        self.due = None;
        let Some(folder) = self.folder.clone() else { return };
        let Some(kept) = locked(&self.slot).take() else { return };
        let outcome = self.place(&folder).and_then(|place| place.write(&kept.origin, &kept.scene));
        let Err(error) = outcome else {
            self.has_failed = false;
            self.kept = kept.number;
            self.drop_recovered();
            return;
        };
        // It is tried again: a full disk may have room later.
        let now = Instant::now();
        locked(&self.slot).get_or_insert(kept);
        self.due = Some(Due { first: now, last: now });
        if !std::mem::replace(&mut self.has_failed, true) {
            self.tell(AutosaveReport::NotKept(error));
        }
    }

    /// The place where things are kept. A folder that vanished is made again.
    fn place(&mut self, folder: &Path) -> Result<&RecoveryFile, IoError> {
        let place = if let Some(place) = self.place.take().filter(RecoveryFile::is_there) {
            place
        } else {
            if let Some((recorder, _)) = &mut self.recorder {
                recorder.moved();
            }
            RecoveryFile::open(folder)?
        };
        Ok(self.place.insert(place))
    }

    /// Keeps what has come to the recording.
    fn record(&mut self) {
        let Some(folder) = self.folder.clone() else { return };
        let Some((mut recorder, _)) = self.recorder.take() else { return };
        let had_place = self.place.as_ref().is_some_and(RecoveryFile::is_there);
        if !had_place {
            recorder.moved();
        }
        let outcome = self.place(&folder).and_then(|place| recorder.keep(place));
        self.recorder = Some((recorder, Instant::now() + RECORDED));
        match outcome {
            Ok(kept) => {
                self.cannot_record = false;
                let was_full = std::mem::replace(&mut self.is_full, kept != Kept::Whole);
                if let Kept::UpTo(bytes) = kept
                    && !was_full
                {
                    self.tell(AutosaveReport::RecordedUpTo(bytes));
                }
            }
            Err(error) => {
                if !std::mem::replace(&mut self.cannot_record, true) {
                    self.tell(AutosaveReport::NotRecorded(error));
                }
            }
        }
    }

    /// Looks through the recordings that were left behind, beside all else: they may be long.
    fn look_for_recordings(&self, folder: PathBuf) {
        let (reports, wake) = (self.reports.clone(), Arc::clone(&self.wake));
        let look = move || {
            // The window may be gone.
            let _ = reports.send(AutosaveReport::Recordings(recordings_in(&folder)));
            wake();
        };
        // Without a thread the next start offers them.
        std::thread::Builder::new().name("recordings".into()).spawn(look).ok();
    }

    fn forget(&mut self, number: u64) {
        // What was put in the slot since then waits.
        locked(&self.slot).take_if(|kept| kept.number <= number);
        // A newer document that is kept there already stays.
        if let Some(place) = self.place.as_ref().filter(|_| self.kept <= number) {
            // What cannot be removed is offered at the next start: too much, but nothing is lost.
            place.clear().ok();
        }
        self.drop_recovered();
    }

    /// What is kept here, or wanted no more, need not be offered again.
    fn drop_recovered(&mut self) {
        for what in std::mem::take(&mut self.recovered) {
            // One that cannot be removed is offered once more: nothing is lost.
            what.discard().ok();
        }
    }

    fn compare(&mut self, scene: &Scene) {
        let Some(watched) = &self.watched else { return };
        if load_scene(watched.stamp.path()).is_ok_and(|found| found != *scene) {
            self.tell(AutosaveReport::File(watched.number, FileState::Changed));
        }
    }

    fn look(&mut self) {
        let Some(watched) = &mut self.watched else { return };
        watched.next = Instant::now() + EVERY;
        let state = watched.stamp.state();
        let is_news = state != watched.told && state != FileState::Same;
        watched.told = state;
        if state == FileState::Changed
            && let Ok(stamp) = FileStamp::of(watched.stamp.path())
        {
            // From here on it is looked for the next change.
            (watched.stamp, watched.told) = (stamp, FileState::Same);
        }
        if is_news {
            let number = watched.number;
            self.tell(AutosaveReport::File(number, state));
        }
    }

    fn tell(&self, report: AutosaveReport) {
        // The window may be gone.
        let _ = self.reports.send(report);
        (self.wake)();
    }
}

#[cfg(test)]
mod tests;
