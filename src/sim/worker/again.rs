//! A journal's motion, made again without a window, a clock or a thread of its own: by the same simulation that heard
//! it.

use super::queue::command_queue;
use super::shared::{Outlet, Shared};
use super::simulation::Simulation;
use crate::scene::Assets;
use crate::sim::command::SimCommand;
use crate::sim::journal::Journal;
use crate::sim::runner::Runner;
use std::sync::Arc;

/// The motion of a journal, frame by frame.
pub struct Rerun {
    journal: Journal,
    /// How many of what was asked has been done.
    done: usize,
    simulation: Simulation,
    shared: Shared,
}

impl Rerun {
    /// At the start. `assets` are the models of every scene in the journal.
    ///
    /// # Errors
    /// Why the scene cannot be put together.
    pub fn new(journal: Journal, assets: Assets) -> Result<Self, String> {
        let shared = Shared::default();
        let outlet = Outlet::new(shared.clone(), || {});
        let stop = command_queue().1.stop();
        stop.clear();
        let scene = Arc::clone(&journal.scene);
        let mut simulation = Simulation::new(scene, Arc::new(assets), false, outlet, stop);
        simulation.start();
        // Nobody looks back.
        simulation.handle(SimCommand::Memory(0), 0);
        let rerun = Self { journal, done: 0, simulation, shared };
        rerun.failure().map_or(Ok(rerun), Err)
    }

    fn failure(&self) -> Option<String> {
        self.simulation.motion.status.failure.clone()
    }

    /// The run as it stands; none after a failure of the solver.
    pub fn runner(&self) -> Option<&Runner> {
        self.simulation.motion.runs.live.runner()
    }

    /// Frames that have been computed.
    pub fn frame(&self) -> u64 {
        self.shared.with_journal(|journal| journal.frames())
    }

    /// Does what was asked before the next frame. True while there is one.
    ///
    /// # Errors
    /// Why it cannot go on.
    pub(crate) fn ask(&mut self) -> Result<bool, String> {
        let frame = self.frame();
        while let Some(entry) = self.journal.asked.get(self.done).filter(|entry| entry.frame <= frame) {
            match entry.what.command() {
                Some(SimCommand::Edit(scene)) => self.simulation.change(scene),
                Some(command) => self.simulation.handle(command, 0),
                None => {}
            }
            self.done += 1;
        }
        self.failure().map_or(Ok(frame < self.journal.frames()), Err)
    }

    /// Does what was asked before the next frame, and computes that. True while there is one.
    ///
    /// # Errors
    /// Why it cannot go on.
    pub fn advance(&mut self) -> Result<bool, String> {
        if !self.ask()? {
            return Ok(false);
        }
        self.simulation.motion.advance();
        match self.failure() {
            Some(problem) => Err(problem),
            None => Ok(true),
        }
    }

    /// Whether the frame that was computed last has the hash of the journal.
    pub fn agrees(&self) -> bool {
        self.shared.with_journal(|ours| {
            let last = ours.hashes.len().checked_sub(1);
            last.is_none_or(|last| ours.hashes.get(last) == self.journal.hashes.get(last))
        })
    }
}
