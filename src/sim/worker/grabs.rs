//! The grab that follows the pointer.

use super::runs::Runs;
use crate::sim::runner::Runner;
use crate::sim::status::PinnedPoint;
use crate::solver::body::Body;
use crate::solver::forces::Grab;
use glam::DVec3;

/// What the pointer holds. Grabs that were pinned are none of its concern.
#[derive(Default)]
pub(super) struct PointerGrab {
    /// The body; the grab is the last one of it.
    body: Option<usize>,
    /// From the point that is pulled to the one that is held [m].
    arm: DVec3,
}

impl PointerGrab {
    /// Takes hold of a point of a body, and of the same point of its like.
    pub(super) fn grab(&mut self, runs: &mut Runs, body: usize, vertex: usize, target: DVec3) {
        let mut is_held = false;
        for held in runs.bodies_mut(body) {
            let Some(point) = held.point(vertex) else { continue };
            if !is_held {
                self.arm = held.arm(vertex);
            }
            held.grab(point, target - self.arm);
            is_held = true;
        }
        if is_held {
            self.body = Some(body);
        }
    }

    /// Pulls to another place [m].
    pub(super) fn move_to(&self, runs: &mut Runs, target: DVec3) {
        for body in self.body.map_or_else(Vec::new, |body| runs.bodies_mut(body)) {
            if let Some(grab) = body.grabs_mut().last_mut() {
                grab.target = target - self.arm;
            }
        }
    }

    /// Lets go.
    pub(super) fn release(&mut self, runs: &mut Runs) {
        for body in self.body.take().map_or_else(Vec::new, |body| runs.bodies_mut(body)) {
            body.grabs_mut().pop();
        }
    }

    /// Leaves the grab where it is held now.
    pub(super) fn pin(&mut self) {
        self.body = None;
    }

    /// Lets go of what the pointer held in a state that the runs were brought to: a body of this identifier.
    pub(super) fn release_stored(&mut self, runs: &mut Runs, id: Option<&str>) {
        self.body = id.and_then(|id| runs.live.runner()?.find(id));
        self.release(runs);
    }

    /// The body that is held.
    pub(super) fn body(&self) -> Option<usize> {
        self.body
    }
}

/// The points at which grabs stay pinned; `pointer` is the body whose last grab follows the pointer.
pub(super) fn pinned_points(runner: &Runner, pointer: Option<usize>) -> Vec<PinnedPoint> {
    let bodies = runner.world().bodies().iter().enumerate();
    let of = |(body, held): (usize, &Body)| {
        let count = held.grabs().len() - usize::from(pointer == Some(body) && !held.grabs().is_empty());
        let point = |(grab, each): (usize, &Grab)| {
            // What the scene itself pulls for a while is nobody's pin.
            let is_pin = each.until.is_infinite();
            let at = each.point.gather(&held.state().positions);
            is_pin.then_some(PinnedPoint { body, grab, at, target: each.target })
        };
        held.grabs().iter().take(count).enumerate().filter_map(point).collect::<Vec<_>>()
    };
    bodies.flat_map(of).collect()
}
