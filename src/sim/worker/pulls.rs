//! What is done to bodies by hand: pulls on the world, and on its like in the ghost.

use super::Loop;
use crate::sim::{Runner, SimCommand};
use crate::solver::body::Body;
use crate::solver::forces::Grab;
use glam::DVec3;

impl Loop {
    /// Does to bodies what was asked for by hand.
    pub(super) fn obey_hand(&mut self, command: &SimCommand) {
        match *command {
            SimCommand::Strike { body, impulse } => {
                self.go_on();
                self.bodies_mut(body).into_iter().for_each(|body| body.strike(impulse));
            }
            SimCommand::Grab { body, vertex, target } => {
                // A point of another build of the body may be another point of this one.
                let is_here = !self.sees_another_scene();
                self.go_on();
                if is_here {
                    self.grab(body, vertex, target);
                }
            }
            SimCommand::MoveGrab(target) => {
                for grab in self.grabs().filter_map(|grabs| grabs.last_mut()) {
                    grab.target = target;
                }
            }
            SimCommand::Release => self.let_go(),
            SimCommand::PinGrab => self.grabbed = None,
            // There is nothing to do to an earlier frame in which nothing is held.
            SimCommand::ReleaseAll if self.in_replay() && !self.shown().is_some_and(Runner::is_held) => {}
            SimCommand::ReleaseAll => {
                self.go_on();
                self.grabbed = None;
                self.runner.iter_mut().chain(self.sights.runner_mut()).for_each(Runner::release_all);
            }
            _ => {}
        }
    }

    /// Lets go of what follows the pointer.
    pub(super) fn let_go(&mut self) {
        for grabs in self.grabs() {
            grabs.pop();
        }
        self.grabbed = None;
    }

    /// Takes hold of a point of a body, and of the same point of its like.
    pub(super) fn grab(&mut self, body: usize, vertex: usize, target: DVec3) {
        let mut found = false;
        for held in self.bodies_mut(body) {
            let Some(point) = held.point(vertex) else { continue };
            held.grab(point, target);
            found = true;
        }
        self.grabbed = found.then_some(body).or(self.grabbed);
    }

    /// Pulls on the body that follows the pointer, and on its like.
    pub(super) fn grabs(&mut self) -> impl Iterator<Item = &mut Vec<Grab>> {
        let bodies = self.grabbed.map_or_else(Vec::new, |body| self.bodies_mut(body));
        bodies.into_iter().map(Body::grabs_mut)
    }
}
