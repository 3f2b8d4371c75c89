//! Momenta that nothing from outside gave: an error of the integration, or of forces that do not cancel.

use super::state::ParticleState;
use glam::DVec3;

/// Linear momentum [kg m/s], and angular momentum [kg m²/s] about the centre of mass or the world's origin.
pub(super) type Momenta = [DVec3; 2];

/// What has drifted so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Drift {
    /// What they had at the beginning of the present frame, where nothing that is not known of acts on them.
    before: Option<Momenta>,
    /// What has come to them from nowhere.
    drifted: Momenta,
    /// For how long that was followed [s].
    followed: f64,
}

impl Drift {
    /// Takes note of where a frame begins; none where what acts on them is not known.
    pub(super) fn begin(&mut self, now: Option<Momenta>) {
        self.before = now;
    }

    /// Whether a frame that has begun is followed.
    pub(super) fn is_followed(&self) -> bool {
        self.before.is_some()
    }

    /// Counts a frame of so many seconds in which all that was known of gave them so much; none where something else
    /// may have.
    pub(super) fn end(&mut self, seconds: f64, now: Option<Momenta>, given: Momenta) {
        if let (Some(before), Some(now)) = (self.before.take(), now) {
            for (k, drifted) in self.drifted.iter_mut().enumerate() {
                *drifted += now[k] - before[k] - given[k];
            }
            self.followed += seconds;
        }
    }

    /// Sizes of what has drifted, and for how long that was followed [s]; none where it never was.
    pub(super) fn size(&self) -> Option<([f64; 2], f64)> {
        (self.followed > 0.0).then(|| (self.drifted.map(DVec3::length), self.followed))
    }
}

/// Momenta of a body, the angular one about its centre of mass.
pub(super) fn momenta(state: &ParticleState) -> Momenta {
    let linear = state.linear_momentum();
    [linear, state.angular_momentum() - state.center().cross(linear)]
}
