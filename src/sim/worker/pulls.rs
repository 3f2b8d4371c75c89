//! What is done to bodies by hand: pulls on the world, and on its like in the ghost.

use super::Loop;
use crate::solver::body::Body;
use crate::solver::grab::Grab;
use glam::DVec3;

impl Loop {
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
            let grab = Grab::on(held, point, target);
            held.grabs_mut().push(grab);
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
