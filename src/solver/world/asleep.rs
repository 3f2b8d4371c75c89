//! Bodies at rest, with all that touches them at rest, which nothing has to be computed for.
//!
//! Whether a body sleeps through a frame follows from the state at its start alone: so it wakes in the same frame
//! however a run is divided, replayed or shared among threads.

use super::World;
use crate::solver::body::Body;
use glam::DVec3;

/// Opposite corners of the box that a body can reach in a frame [m].
#[derive(Clone, Copy, Debug)]
struct Reach {
    low: DVec3,
    high: DVec3,
}

impl Reach {
    fn of(body: &Body, seconds: f64) -> Self {
        let state = body.state();
        let (mut low, mut high, mut fastest) = (DVec3::INFINITY, DVec3::NEG_INFINITY, 0.0);
        for (x, v) in state.positions.iter().zip(&state.velocities) {
            low = low.min(*x);
            high = high.max(*x);
            fastest = f64::max(fastest, v.length());
        }
        // Twice as far as its present speed carries it, as it may be hurried on the way.
        let margin = DVec3::splat(2.0 * fastest * seconds + body.parts().contact.radius + body.parts().reach);
        Self { low: low - margin, high: high + margin }
    }

    fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }
}

impl World {
    /// Whether every body is at rest, every prescribed motion has ended and no panel moves.
    pub fn at_rest(&self) -> bool {
        let time = self.time();
        if self.eased.end() > time {
            return false;
        }
        self.bodies.iter().all(|body| body.at_rest(time)) && self.panels.iter().all(|panel| panel.is_still(time))
    }

    /// Which bodies sleep through the frame that begins now.
    pub(super) fn asleep(&self) -> Vec<bool> {
        let time = self.time();
        let mut awake: Vec<bool> = self.bodies.iter().map(|body| !body.may_sleep(time)).collect();
        // One that falls is never sure to lie still.
        let panels_move = self.panels.iter().any(|panel| panel.driven.is_none() || !panel.is_still(time));
        if panels_move || self.eased.end() > time || self.contact_is_unknown() {
            return vec![false; awake.len()];
        }
        if awake.contains(&true) && awake.contains(&false) {
            let reaches: Vec<Reach> = self.bodies.iter().map(|body| Reach::of(body, self.plan.frame_seconds)).collect();
            let mut next: Vec<usize> = (0..awake.len()).filter(|&body| awake[body]).collect();
            while let Some(body) = next.pop() {
                for other in 0..awake.len() {
                    if !awake[other] && reaches[body].meets(&reaches[other]) {
                        awake[other] = true;
                        next.push(other);
                    }
                }
            }
        }
        awake.into_iter().map(|awake| !awake).collect()
    }

    /// Whether contact between bodies and with panels would have to be evaluated to know what they do to each other.
    fn contact_is_unknown(&self) -> bool {
        !self.contact_current && (self.bodies.len() > 1 || !self.panels.is_empty())
    }
}
