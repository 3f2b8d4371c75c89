//! How the material at two places is turned against each other.

use glam::{DQuat, DVec3};

/// The turn from one end of an edge to the other.
pub(in crate::solver::forces) struct Between {
    /// Angle about the axis [rad].
    pub(in crate::solver::forces) angle: f64,
    w: f64,
    q: DVec3,
    /// q along the edge.
    along: f64,
}

impl Between {
    /// Of the turns at both ends of what lies along an axis at rest, a unit vector of the model frame.
    pub(in crate::solver::forces) fn new(axis: DVec3, ends: &[DQuat]) -> Self {
        let turn = ends[0].conjugate() * ends[1];
        // The one of its two quaternions that turns by less than half round.
        let turn = if turn.w < 0.0 { -turn } else { turn };
        let q = DVec3::new(turn.x, turn.y, turn.z);
        let along = q.dot(axis);
        Self { angle: 2.0 * along.atan2(turn.w), w: turn.w, q, along }
    }

    /// Derivatives of the angle by small turns of the material at both ends, each in its own frame.
    pub(in crate::solver::forces) fn spins(&self, axis: DVec3) -> [DVec3; 2] {
        let Self { w, q, along, .. } = self;
        let square = w * w + along * along;
        if square == 0.0 {
            return [DVec3::ZERO; 2];
        }
        let (straight, across) = (w * w * axis + along * *q, *w * axis.cross(*q));
        [(across - straight) / square, (across + straight) / square]
    }
}
