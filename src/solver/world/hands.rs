//! Hands that lead the drives of bodies.

use super::World;
use crate::solver::hand::LATE;

impl World {
    /// Has a hand lead a shared drive of a body over the frame that begins now to a value, no further than the drive
    /// ever goes by itself, and hold it there; or let go of it. False where there is no such drive.
    pub(crate) fn lead(&mut self, body: usize, drive: &str, aim: Option<f64>) -> bool {
        // As the next frame's time will be.
        let next = self.since + (self.frame + 1) as f64 * self.plan.frame_seconds;
        let times = [self.time() + LATE * self.plan.frame_seconds, next];
        self.bodies.get_mut(body).is_some_and(|body| body.lead(drive, times, aim))
    }
}
