//! A camera on its way to where it was sent.

use crate::render::Camera;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// How long a camera takes to where it was sent [s].
const EASE_SECONDS: f64 = 0.18;

/// A camera on its way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ease {
    from: Camera,
    to: Camera,
    /// When it started [s].
    start: f64,
}

impl Ease {
    /// A camera that starts on its way now [s].
    pub(crate) fn new(from: Camera, to: Camera, start: f64) -> Self {
        Self { from, to, start }
    }

    /// Goes along with what moves [m].
    pub(crate) fn shift(&mut self, by: DVec3) {
        self.from.target += by;
        self.to.target += by;
    }

    /// Where it is, and whether it has arrived.
    pub(crate) fn at(&self, time: f64) -> (Camera, bool) {
        let share = ((time - self.start) / EASE_SECONDS).clamp(0.0, 1.0);
        if share == 1.0 {
            return (self.to, true);
        }
        let eased = share * share * (3.0 - 2.0 * share);
        // The shorter way round.
        let turn = (self.to.yaw - self.from.yaw + PI).rem_euclid(TAU) - PI;
        let camera = Camera {
            target: self.from.target.lerp(self.to.target, eased),
            yaw: self.from.yaw + eased * turn,
            pitch: self.from.pitch + eased * (self.to.pitch - self.from.pitch),
            height: self.from.height * (self.to.height / self.from.height).powf(eased),
            projection: self.to.projection,
        };
        (camera, false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_camera_eases_the_shorter_way_and_arrives() {
        let from = Camera { yaw: 0.1, height: 1.0, ..Camera::perspective() };
        let to = Camera { yaw: TAU - 0.1, height: 4.0, ..from };
        let ease = Ease { from, to, start: 2.0 };
        let (half, arrived) = ease.at(2.0 + 0.5 * EASE_SECONDS);
        assert!(!arrived && half.yaw.abs() < 1e-12 && (half.height - 2.0).abs() < 1e-12, "{half:?}");
        assert_eq!(ease.at(3.0), (to, true));
    }
}
