//! What is done to bodies by hand.

use super::Motion;
use crate::sim::journal::Asked;
use glam::DVec3;

impl Motion {
    pub(super) fn grab(&mut self, body: usize, vertex: usize, target: DVec3) {
        // A point of another build of the body may be another point of this one.
        let is_here = !self.replay.is_of_another_scene(self.runs.live.start());
        self.continue_here();
        if is_here {
            self.note(Asked::Grab { body, vertex, target: target.to_array() });
            self.grab.grab(&mut self.runs, body, vertex, target);
        }
    }

    pub(super) fn move_grab(&mut self, target: DVec3) {
        if self.grab.body().is_some() {
            self.note(Asked::MoveGrab(target.to_array()));
            self.grab.move_to(&mut self.runs, target);
        }
    }

    pub(super) fn release(&mut self) {
        if self.grab.body().is_some() {
            self.note(Asked::Release);
            self.grab.release(&mut self.runs);
        }
    }

    pub(super) fn pin_grab(&mut self) {
        if self.grab.body().is_some() {
            self.note(Asked::PinGrab);
            self.grab.pin();
        }
    }

    pub(super) fn strike(&mut self, body: usize, impulse: DVec3) {
        self.continue_here();
        self.note(Asked::Strike { body, impulse: impulse.to_array() });
        self.runs.bodies_mut(body).into_iter().for_each(|body| body.strike(impulse));
    }

    pub(super) fn lead(&mut self, body: usize, drive: &str, aim: Option<f64>) {
        self.continue_here();
        self.note(Asked::Lead { body, drive: drive.to_owned(), aim });
        self.runs.lead(body, drive, aim);
    }

    pub(super) fn unpin(&mut self, body: usize, grab: usize) {
        self.continue_here();
        self.note(Asked::Unpin { body, grab });
        for held in self.runs.bodies_mut(body) {
            if grab < held.grabs().len() {
                held.grabs_mut().remove(grab);
            }
        }
    }

    pub(super) fn release_all(&mut self) {
        // There is nothing to do to an earlier frame in which nothing is held.
        if self.replay.shown().is_some_and(|shown| !shown.is_held()) {
            return;
        }
        self.continue_here();
        self.note(Asked::ReleaseAll);
        self.grab.pin();
        self.runs.release_all();
    }
}
