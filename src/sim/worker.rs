//! The simulation beside a window: requests in, the newest picture of the world out.
//!
//! The window never waits for the solver and the solver never waits for the window. The thread paces the frames of a
//! [`super::Runner`] by the clock and takes no other step than the command line does.

mod again;
mod build;
mod comparison;
mod effect;
mod ghost;
mod grabs;
mod live;
mod models;
mod motion;
mod playback;
mod queue;
mod replay;
mod runs;
mod shared;
mod sim_thread;
mod simulation;
mod stop;
#[cfg(test)]
mod tests;
mod time_series_set;
mod views;

pub use again::Rerun;
pub use time_series_set::TimeSeriesSet;

use super::command::SimCommand;
use super::journal::Journal;
#[cfg(feature = "gui")]
use super::journal_line::JournalLine;
use super::status::Published;
use crate::scene::{Assets, Scene};
use models::NewestModels;
use queue::{CommandSender, command_queue};
use shared::{Outlet, Shared};
use sim_thread::SimThread;
use simulation::Simulation;
use std::sync::Arc;
use std::thread::JoinHandle;

/// The running simulation, seen from the window.
pub struct Worker {
    commands: Option<CommandSender>,
    shared: Shared,
    models: NewestModels,
    thread: Option<JoinHandle<()>>,
}

impl Worker {
    /// Starts a thread that runs `scene`; `notify` is called whenever there is a new picture.
    pub fn start(scene: Arc<Scene>, assets: Arc<Assets>, playing: bool, notify: impl Fn() + Send + 'static) -> Self {
        let (commands, receiver) = command_queue();
        let shared = Shared::default();
        let models = NewestModels::default();
        let newest = models.clone();
        let outlet = Outlet::new(shared.clone(), notify);
        let thread = std::thread::Builder::new()
            .name("solver".into())
            .spawn(move || {
                let simulation = Simulation::new(scene, assets, playing, outlet, receiver.stop());
                let simulation = simulation.with_models(newest).with_early(receiver.early());
                SimThread::new(simulation, receiver).run();
            })
            .ok();
        Self { commands: Some(commands), shared, models, thread }
    }

    /// Asks for something, which is done in the order in which it was asked for, within 0.2 s: a frame that is being
    /// computed is ended for it if it takes longer, also one that was asked for before, which then follows. Not so for
    /// what only further frames show: another place of a grab, a drive that is led, a step, the speed, the memory. What
    /// only looks at the motion or holds it is done while a scene is put together, too. What a later request makes
    /// pointless may be left out: of a grab that moves, of settings and of documents that follow each other only the
    /// newest counts. False if the thread is gone.
    pub fn send(&self, command: SimCommand) -> bool {
        if matches!(command, SimCommand::Open(..)) {
            self.models.set(None);
        }
        self.commands.as_ref().is_some_and(|commands| commands.send(command))
    }

    /// Hands over the models of the document, with those that came into it since it was opened: edits that follow may
    /// name them.
    pub fn set_models(&self, models: Arc<Assets>) {
        self.models.set(Some(models));
    }

    /// Ends the putting together of a scene, if one is being put together just now: what was there before goes on, and
    /// [`Status::stopped`](super::Status::stopped) tells of it until the next document or a reset puts the scene
    /// together.
    pub fn stop_building(&self) {
        if let Some(commands) = &self.commands {
            commands.stop();
        }
    }

    /// The newest picture since the last call.
    pub fn take(&self) -> Option<Arc<Published>> {
        self.shared.take()
    }

    /// Looks at the numbers that were recorded of every frame. The solver waits meanwhile: to be read, not to be worked
    /// with.
    pub fn time_series<T>(&self, read: impl FnOnce(&TimeSeriesSet) -> T) -> T {
        self.shared.with_series(|series| read(series))
    }

    /// What was asked of the motion since its start, and what each frame came to.
    pub fn journal(&self) -> Journal {
        self.shared.with_journal(|journal| journal.clone())
    }

    /// The journal as it grows, to be kept from any thread.
    #[cfg(feature = "gui")]
    pub(crate) fn journal_tail(&self) -> JournalTail {
        JournalTail(self.shared.clone())
    }

    /// Whether hands have led any shared drive since the start of the motion.
    pub fn was_performed(&self) -> bool {
        self.shared.with_journal(|journal| journal.was_performed())
    }
}

/// The journal of a worker's motion as it grows: each of its lines is told once.
#[cfg(feature = "gui")]
pub(crate) struct JournalTail(Shared);

#[cfg(feature = "gui")]
impl JournalTail {
    /// The lines that have come since the last time. A start of a motion comes first of its lines.
    pub(crate) fn news(&self) -> Vec<JournalLine> {
        self.0.with_journal(Journal::news)
    }

    /// Has all lines told once more, from the start of the motion.
    pub(crate) fn tell_anew(&self) {
        self.0.with_journal(Journal::tell_anew);
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // Without a sender the thread ends after what it is doing just now; what waits is dropped.
        self.commands = None;
        if let Some(thread) = self.thread.take() {
            // A failure in there has been reported as a status.
            let _ = thread.join();
        }
    }
}
