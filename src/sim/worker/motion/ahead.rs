//! Computing ahead: frames as fast as they come, and then all of them as fast as they were meant to be seen.

use super::Motion;
use crate::sim::command::SimCommand;
use crate::sim::journal::Asked;

impl Motion {
    /// Computes so many seconds from where the simulation has come to.
    pub(super) fn compute_ahead(&mut self, seconds: f64) {
        self.replay.leave();
        let Some(runner) = self.runs.live.runner().filter(|_| !self.comparison.is_running() && seconds > 0.0) else {
            return;
        };
        let from = runner.world().time();
        self.owed = 0;
        self.note(Asked::Play);
        self.playback.hurry(true);
        self.playback.play();
        self.status.ahead = Some([from, from + seconds]);
    }

    /// Nothing is computed ahead any more, if something was.
    pub(super) fn leave_ahead(&mut self) {
        self.playback.hurry(false);
        self.status.ahead = None;
    }

    /// Leaves it for a command that wants the motion otherwise.
    pub(super) fn leave_ahead_for(&mut self, command: &SimCommand) {
        let lets_it_go_on = matches!(
            command,
            SimCommand::Speed(_)
                | SimCommand::Field(_)
                | SimCommand::Tension(_)
                | SimCommand::Activation(_)
                | SimCommand::Memory(_)
                | SimCommand::Release
        );
        if !lets_it_go_on {
            self.leave_ahead();
        }
    }

    /// Shows what was computed, once all of it is there or nothing more comes.
    pub(super) fn show_what_was_ahead(&mut self) {
        let Some([from, until]) = self.status.ahead else { return };
        let is_there = self.shown_time() + 0.5 * self.frame_seconds() >= until;
        if is_there || !self.is_running() {
            self.leave_ahead();
            self.note(Asked::Pause);
            self.playback.set_playing(false);
            self.show(self.replay.recording().nearest(from));
            self.start_replay();
        }
    }
}
