//! The three orthographic drawing views.

use glam::{DVec2, DVec3, Vec2Swizzles};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt;

/// An orthographic drawing view. Horizontal runs right on the screen, vertical up; but Z runs down in the top view,
/// which looks from above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum View {
    /// X horizontal, Y vertical.
    Front,
    /// Z horizontal, Y vertical.
    Side,
    /// X horizontal, Z vertical.
    Top,
}

impl View {
    /// All three views.
    pub const ALL: [Self; 3] = [Self::Front, Self::Side, Self::Top];

    /// Indices of the horizontal and vertical axes (0 = X, 1 = Y, 2 = Z).
    pub fn axes(self) -> [usize; 2] {
        match self {
            Self::Front => [0, 1],
            Self::Side => [2, 1],
            Self::Top => [0, 2],
        }
    }

    /// Index of the axis that two different views have in common; none for the same view twice.
    pub fn shared_axis(self, other: Self) -> Option<usize> {
        (self != other).then(|| self.axes().into_iter().find(|axis| other.axes().contains(axis))).flatten()
    }

    /// A point of space [m] as it is seen in this view, (horizontal, vertical) [m].
    pub fn project(self, point: DVec3) -> DVec2 {
        let [horizontal, vertical] = self.axes();
        DVec2::new(point[horizontal], point[vertical])
    }
}

impl fmt::Display for View {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Front => "front",
            Self::Side => "side",
            Self::Top => "top",
        })
    }
}

/// The axes of a pair of drawing views: each view sees the shared axis and one of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pair {
    /// The two views, in drawing order.
    pub(super) views: [View; 2],
    /// Index of the axis that both views see.
    pub(super) shared: usize,
}

impl Pair {
    /// The axes of two views; none for the same view twice.
    pub(super) fn new(first: View, second: View) -> Option<Self> {
        Some(Self { views: [first, second], shared: first.shared_axis(second)? })
    }

    /// Index of the axis that only view `which` (0 or 1) sees.
    pub(super) fn own(self, which: usize) -> usize {
        let [horizontal, vertical] = self.views[which].axes();
        if horizontal == self.shared { vertical } else { horizontal }
    }

    /// The view that is not in the pair.
    pub(super) fn third(self) -> View {
        View::ALL.into_iter().find(|view| !self.views.contains(view)).unwrap_or(View::Front)
    }

    /// Turns (horizontal, vertical) of view `which` into (own, shared). The same swap turns it back.
    pub(super) fn swap(self, which: usize, point: DVec2) -> DVec2 {
        if self.views[which].axes()[0] == self.shared { point.yx() } else { point }
    }

    /// The point of space whose coordinates are the given ones along the pair's axes.
    pub(super) fn join(self, first_own: f64, shared: f64, second_own: f64) -> DVec3 {
        let mut point = DVec3::ZERO;
        point[self.own(0)] = first_own;
        point[self.shared] = shared;
        point[self.own(1)] = second_own;
        point
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_takes_a_point_apart_and_joins_it_again() {
        let point = DVec3::new(1.0, 2.0, 3.0);
        for first in View::ALL {
            for second in View::ALL {
                let Some(pair) = Pair::new(first, second) else {
                    assert_eq!(first, second);
                    continue;
                };
                assert!(pair.third() != first && pair.third() != second);
                let [a, b] = [0, 1].map(|which| pair.swap(which, pair.views[which].project(point)));
                assert_eq!(a.y, b.y, "both see the shared axis");
                assert_eq!(pair.join(a.x, a.y, b.x), point);
            }
        }
        assert_eq!(View::Front.shared_axis(View::Side), Some(1));
        assert_eq!(View::Top.shared_axis(View::Front), Some(0));
        assert_eq!(View::Side.shared_axis(View::Top), Some(2));
    }
}
