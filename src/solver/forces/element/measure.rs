//! What elements without code measure, and its gradient by their points.

use super::contract::Local;
use crate::solver::forces::fibre::between::Between;
use crate::solver::forces::sheet::hinge::{hinge_angle, hinge_slopes};
use glam::DVec3;

/// What an element measures of its points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Measure {
    /// Distance of two points [m].
    Length,
    /// Angle by which a line through three points turns at the second [rad], 0 where it is straight.
    Turn,
    /// Area of the triangle of three points [m²].
    Area,
    /// Volume of the tetrahedron of four points [m³], below zero where it is turned inside out.
    Volume,
    /// Angle at the edge from the first point to the second between the triangles with the third and the fourth [rad],
    /// 0 where they lie in one plane.
    Dihedral,
    /// Angle by which the material around the second point is turned against that around the first about the line
    /// between them at rest [rad], which is this unit vector of the model frame.
    Twist(DVec3),
}

impl Measure {
    /// Number of points.
    pub(crate) fn points(self) -> usize {
        match self {
            Self::Length | Self::Twist(_) => 2,
            Self::Turn | Self::Area => 3,
            Self::Volume | Self::Dihedral => 4,
        }
    }

    /// Whether it is an angle; else a size.
    pub(super) fn is_angle(self) -> bool {
        matches!(self, Self::Turn | Self::Dihedral | Self::Twist(_))
    }

    /// Its value.
    pub(crate) fn value(self, at: &Local<'_>) -> f64 {
        let x = at.points;
        match self {
            Self::Length => x[0].distance(x[1]),
            Self::Turn => {
                let (before, after) = (x[1] - x[0], x[2] - x[1]);
                before.cross(after).length().atan2(before.dot(after))
            }
            Self::Area => 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).length(),
            Self::Volume => (x[1] - x[0]).dot((x[2] - x[0]).cross(x[3] - x[0])) / 6.0,
            Self::Dihedral => hinge_angle([x[0], x[1], x[2], x[3]]),
            Self::Twist(axis) => Between::new(axis, at.turns).angle,
        }
    }

    /// Calls `point` and `turn` with every derivative of the value, by the points and by turns of the material. None
    /// where it has no direction: of a line without length, or of one that is straight.
    pub(super) fn slopes(
        self,
        at: &Local<'_>,
        point: &mut dyn FnMut(usize, DVec3),
        turn: &mut dyn FnMut(usize, DVec3),
    ) {
        let x = at.points;
        match self {
            Self::Length => {
                let along = (x[1] - x[0]).normalize_or_zero();
                point(0, -along);
                point(1, along);
            }
            Self::Turn => {
                let (before, after) = (x[1] - x[0], x[2] - x[1]);
                let normal = before.cross(after).normalize_or_zero();
                // Across each edge, away from the other, over its length.
                let by_before = before.cross(normal) / before.length_squared();
                let by_after = normal.cross(after) / after.length_squared();
                if by_before.is_finite() && by_after.is_finite() {
                    point(0, -by_before);
                    point(1, by_before - by_after);
                    point(2, by_after);
                }
            }
            Self::Area => {
                let (a, b) = (x[1] - x[0], x[2] - x[0]);
                let normal = 0.5 * a.cross(b).normalize_or_zero();
                let (by_a, by_b) = (b.cross(normal), normal.cross(a));
                point(0, -by_a - by_b);
                point(1, by_a);
                point(2, by_b);
            }
            Self::Volume => {
                let [a, b, c] = [x[1] - x[0], x[2] - x[0], x[3] - x[0]];
                let [a, b, c] = [b.cross(c) / 6.0, c.cross(a) / 6.0, a.cross(b) / 6.0];
                point(0, -a - b - c);
                point(1, a);
                point(2, b);
                point(3, c);
            }
            Self::Dihedral => {
                if let Some(slopes) = hinge_slopes([x[0], x[1], x[2], x[3]]) {
                    slopes.into_iter().enumerate().for_each(|(k, slope)| point(k, slope));
                }
            }
            Self::Twist(axis) => {
                let spins = Between::new(axis, at.turns).spins(axis);
                spins.into_iter().enumerate().for_each(|(k, spin)| turn(k, spin));
            }
        }
    }
}
