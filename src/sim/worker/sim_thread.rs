//! The thread: hears what was asked for, computes the frame that is due, and shows what has come of both.

use super::queue::{CommandReceiver, QueuedCommand};
use super::simulation::Simulation;

/// A simulation and what is asked of it.
pub(super) struct SimThread {
    simulation: Simulation,
    commands: CommandReceiver,
}

impl SimThread {
    pub(super) fn new(simulation: Simulation, commands: CommandReceiver) -> Self {
        Self { simulation, commands }
    }

    /// Runs until the window is gone.
    pub(super) fn run(mut self) {
        self.simulation.start();
        // Everything that waits is heard before the next frame, so that a grab is never behind.
        while let Some(count) = self.commands.begin(self.simulation.motion.due()) {
            let was_asked = count > 0;
            while let Some(QueuedCommand { command, documents, .. }) = self.commands.next() {
                self.simulation.handle(command, documents);
            }
            if self.commands.is_closed() {
                return;
            }
            self.simulation.settle(was_asked);
            // What was done is seen before a frame that may take long.
            if was_asked && self.simulation.motion.may_take_long() {
                self.simulation.motion.publish();
            }
            // What has just stopped everything is to be seen too.
            if self.simulation.motion.advance_if_due() || was_asked {
                self.simulation.motion.publish();
            }
        }
    }
}
