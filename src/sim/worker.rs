//! The thread that runs a world beside a window: bounded requests in, the newest picture of the world out.
//!
//! The window never waits for the solver and the solver never waits for the window. The worker paces the [`Runner`]'s
//! frames by the clock and takes no other step than the command line does.

use super::side_by_side::SideBySide;
use super::status::{Published, Status};
use super::{Runner, SimCommand};
use crate::scene::{Assets, IntegratorKind, Scene};
use crate::solver::snapshot::Snapshot;
use baking::describe;
use glam::DVec3;
pub use records::RecordedSeries;
use replay::Replay;
use sights::Sights;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Requests that may wait; more than a person can make while one frame is computed.
const WAITING: usize = 256;

/// Wall time over which rates are averaged.
const RATE_WINDOW: Duration = Duration::from_millis(500);

/// A frame this late is not made up for: the simulation is in slow motion then.
const GREATEST_DEBT: Duration = Duration::from_millis(100);

type Slot = Arc<Mutex<Option<Arc<Published>>>>;
type Shared = Arc<Mutex<RecordedSeries>>;

/// The running simulation, seen from the window.
pub struct Worker {
    sender: Option<SyncSender<SimCommand>>,
    slot: Slot,
    records: Shared,
    thread: Option<JoinHandle<()>>,
}

impl Worker {
    /// Starts a thread that runs `scene`; `notify` is called whenever there is a new picture.
    pub fn start(scene: Arc<Scene>, assets: Arc<Assets>, playing: bool, notify: impl Fn() + Send + 'static) -> Self {
        let (sender, receiver) = sync_channel(WAITING);
        let slot: Slot = Arc::default();
        let records = Shared::default();
        let out = Out { slot: Arc::clone(&slot), records: Arc::clone(&records), notify: Box::new(notify) };
        let thread = std::thread::Builder::new()
            .name("solver".into())
            .spawn(move || Loop::new(scene, assets, playing, out).run(&receiver))
            .ok();
        Self { sender: Some(sender), slot, records, thread }
    }

    /// Asks for something; false if too much is waiting already or the thread is gone.
    pub fn send(&self, command: SimCommand) -> bool {
        match self.sender.as_ref().map(|sender| sender.try_send(command)) {
            Some(Ok(())) => true,
            Some(Err(TrySendError::Full(_) | TrySendError::Disconnected(_))) | None => false,
        }
    }

    /// The newest picture since the last call.
    pub fn take(&self) -> Option<Arc<Published>> {
        self.slot.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    /// Looks at what was recorded of every frame. The solver waits meanwhile: to be read, not to be worked with.
    pub fn time_series<T>(&self, read: impl FnOnce(&RecordedSeries) -> T) -> T {
        read(&self.records.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // Without a sender the thread ends after its present frame.
        self.sender = None;
        if let Some(thread) = self.thread.take() {
            // A failure in there has been reported as a status.
            let _ = thread.join();
        }
    }
}

struct Out {
    slot: Slot,
    records: Shared,
    notify: Box<dyn Fn() + Send>,
}

impl Out {
    fn publish(&self, published: Published) {
        *self.slot.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::new(published));
        (self.notify)();
    }
}

/// The thread's own state.
struct Loop {
    scene: Arc<Scene>,
    assets: Arc<Assets>,
    start: Option<Arc<Runner>>,
    runner: Option<Runner>,
    at_rest: Arc<Snapshot>,
    placed: Option<[DVec3; 2]>,
    /// An edit that waits until everything that was asked for has been heard: only the last of several is baked.
    edited: bool,
    speed: f64,
    /// Body of the grab that follows the pointer; it is the last of the body's grabs.
    grabbed: Option<usize>,
    /// Integrators and step [s] that are compared, and the comparison.
    wanted: (Vec<IntegratorKind>, f64),
    side_by_side: Option<SideBySide>,
    sights: Sights,
    replay: Replay,
    status: Status,
    out: Out,
    rate: Rate,
}

/// Frames counted over a window of wall time.
struct Rate {
    since: Instant,
    frames: u32,
}

impl Rate {
    fn new() -> Self {
        Self { since: Instant::now(), frames: 0 }
    }
}

impl Loop {
    fn new(scene: Arc<Scene>, assets: Arc<Assets>, playing: bool, out: Out) -> Self {
        Self {
            scene,
            assets,
            start: None,
            runner: None,
            at_rest: Arc::default(),
            placed: None,
            edited: false,
            speed: 1.0,
            grabbed: None,
            wanted: (Vec::new(), 0.0),
            side_by_side: None,
            sights: Sights::default(),
            replay: Replay::default(),
            status: Status { playing, ..Status::default() },
            out,
            rate: Rate::new(),
        }
    }

    fn run(mut self, receiver: &Receiver<SimCommand>) {
        self.put_together(false);
        self.take_readings();
        self.publish();
        let mut due = Instant::now();
        loop {
            // Everything that waits is taken before the next frame, so that a drag is never behind.
            let mut asked = false;
            loop {
                let wait =
                    if self.runs() { due.saturating_duration_since(Instant::now()) } else { Duration::from_secs(1) };
                match receiver.recv_timeout(if asked { Duration::ZERO } else { wait }) {
                    Ok(command) => {
                        self.obey(command);
                        asked = true;
                    }
                    Err(RecvTimeoutError::Timeout) => break,
                    Err(RecvTimeoutError::Disconnected) => return,
                }
            }
            self.show_wanted();
            if std::mem::take(&mut self.edited) {
                self.put_together(true);
            }
            self.put_ghost_together();
            if asked {
                self.take_readings();
            }
            let advances = self.runs() && Instant::now() >= due;
            if advances {
                self.advance();
                let frame = self.frame_seconds() / self.speed.max(1e-3);
                let now = Instant::now();
                let earliest = now.checked_sub(GREATEST_DEBT).unwrap_or(now);
                due = (due + Duration::from_secs_f64(frame.min(1.0))).max(earliest);
            } else if !self.runs() {
                due = Instant::now();
            }
            // What has just stopped everything is to be seen too.
            if asked || advances {
                self.publish();
            }
        }
    }

    fn runs(&self) -> bool {
        let moves = |runner: &Runner| self.side_by_side.is_some() || !runner.all_stopped();
        self.status.playing && (self.in_replay() || self.runner.as_ref().is_some_and(moves))
    }

    fn frame_seconds(&self) -> f64 {
        self.shown().map_or(1.0, |runner| runner.world().plan().frame_seconds)
    }

    fn obey(&mut self, command: SimCommand) {
        if let SimCommand::Show(time) = command {
            self.replay.wanted = Some(time);
            return;
        }
        self.show_wanted();
        match command {
            SimCommand::Play => {
                self.replay.goes_on = true;
                self.play();
            }
            SimCommand::Pause => self.hold(),
            SimCommand::Step => {
                self.hold();
                self.step();
            }
            SimCommand::Show(_) => {}
            SimCommand::StepBack => self.step_back(),
            SimCommand::Replay => {
                self.rate = Rate::new();
                self.start_replay();
            }
            SimCommand::ContinueHere => {
                self.go_on();
                self.play();
            }
            SimCommand::Live => self.live(),
            SimCommand::Memory(limit) => {
                let time = self.shown_time();
                self.replay.recording.set_limit(limit);
                self.replay.wanted = self.in_replay().then_some(time);
            }
            SimCommand::Compare { integrators, dt } => {
                self.look_ahead();
                self.wanted = (integrators, dt);
                self.start_comparison();
            }
            SimCommand::Reset => {
                self.grabbed = None;
                self.sights.reset();
                self.start_comparison();
                if let Some(start) = &self.start {
                    self.runner = Some((**start).clone());
                    self.status.failure = None;
                    self.record_anew();
                } else {
                    self.put_together(false);
                }
                self.take_readings();
            }
            SimCommand::Field(kind) => self.sights.choose(kind),
            SimCommand::Tension(on) => self.sights.choose_tension(on),
            SimCommand::Ghost(scene) => {
                self.sights.want(scene);
                // An edit that waits is put together first: the ghost starts from where that is.
                if !self.edited {
                    self.put_ghost_together();
                }
            }
            SimCommand::Speed(speed) => self.speed = speed,
            SimCommand::Edit(scene) => {
                self.status.edits += 1;
                // What only looks otherwise moves as it did.
                if !self.scene.moves_like(&scene) {
                    self.go_on();
                    self.edited = true;
                }
                self.scene = scene;
            }
            SimCommand::Open(scene, assets) => {
                self.scene = scene;
                self.assets = assets;
                self.status.edits += 1;
                self.grabbed = None;
                self.sights.drop_ghost();
                self.wanted.0.clear();
                self.forget();
                self.put_together(false);
                self.take_readings();
            }
            by_hand => self.obey_hand(&by_hand),
        }
    }

    fn play(&mut self) {
        self.status.playing = true;
        self.rate = Rate::new();
    }

    /// One frame, of the world or of a replay.
    fn advance(&mut self) {
        if self.in_replay() {
            self.replay_frame();
        } else {
            self.solve();
        }
        self.rate.frames += 1;
        let elapsed = self.rate.since.elapsed();
        if elapsed >= RATE_WINDOW {
            let rate = f64::from(self.rate.frames) / elapsed.as_secs_f64();
            self.status.frames_per_second = rate;
            self.status.real_time_factor = rate * self.frame_seconds();
            self.rate = Rate::new();
        }
    }

    fn solve(&mut self) {
        let seconds = self.frame_seconds();
        let Some(runner) = &mut self.runner else { return };
        let outcome = catch_unwind(AssertUnwindSafe(|| match &mut self.side_by_side {
            Some(side_by_side) => side_by_side.advance(seconds),
            None => runner.advance_frame(),
        }));
        if let Err(panic) = outcome {
            // What the world holds after a panic cannot be trusted; the document and the last picture can.
            self.runner = None;
            self.status.playing = false;
            self.status.failure = Some(describe(panic.as_ref()));
        }
        if self.side_by_side.is_none() {
            self.advance_ghost();
            self.record();
            self.take_readings();
        }
    }
}

mod baking;
mod publishing;
mod pulls;
mod records;
mod replay;
mod sights;
#[cfg(test)]
mod tests;
