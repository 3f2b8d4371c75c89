//! The unit and axes of another program.

use crate::geometry::model::UpAxis;
use glam::DVec3;

/// Unit and axes in which a motion is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Space {
    /// The axis that points up there: Y or Z.
    pub(crate) up: UpAxis,
    /// Units to a metre.
    pub(crate) scale: f64,
}

impl Default for Space {
    /// Metres, Y up.
    fn default() -> Self {
        Self { up: UpAxis::Y, scale: 1.0 }
    }
}

impl Space {
    /// A unit vector of the world there.
    pub(crate) fn direction(self, v: DVec3) -> DVec3 {
        match self.up {
            UpAxis::X => DVec3::new(v.y, -v.x, v.z),
            UpAxis::Y => v,
            UpAxis::Z => DVec3::new(v.x, -v.z, v.y),
        }
    }

    /// A place [m] or velocity [m/s] of the world there.
    pub(crate) fn place(self, v: DVec3) -> DVec3 {
        self.scale * self.direction(v)
    }

    /// A place there [m] of the world.
    pub(crate) fn back(self, v: DVec3) -> DVec3 {
        self.up.stand_up(v) / self.scale
    }

    /// Places or velocities of the world there.
    pub(crate) fn places(self, mut all: Vec<DVec3>) -> Vec<DVec3> {
        if self != Self::default() {
            for v in &mut all {
                *v = self.place(*v);
            }
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stood_up_lies_down_again() {
        for up in [UpAxis::X, UpAxis::Y, UpAxis::Z] {
            let v = DVec3::new(1.0, 2.0, 3.0);
            let space = Space { up, scale: 100.0 };
            assert_eq!(space.place(up.stand_up(v)), 100.0 * v);
            assert_eq!(space.back(space.place(v)), v);
        }
    }
}
