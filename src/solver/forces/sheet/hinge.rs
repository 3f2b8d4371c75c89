//! One edge between two triangles of a sheet: bending.
//!
//! `k/2 (theta - theta0)²` with theta the angle between both normals. With `k = l_s Db L² / (A1 + A2)` on the edges of
//! a rectangular grid and `k = 2 l_s Db (A1 + A2) / L²` on its alternating diagonals, L the edge's length and A the
//! areas at rest, a flat grid bends to any cylinder with the same stiffness Db; the first weight on all edges, which is
//! used for triangles that are no grid, is right for equilateral ones and up to 1.5 times too stiff in some directions
//! of a grid. Poisson's coupling is left out.

use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A hinge at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HingeRest {
    /// Its vertices among the sheet's: the edge's ends, then those opposite, of the first triangle and of the second.
    pub vertices: [u32; 4],
    /// k [N m].
    pub stiffness: f64,
    /// theta0 [rad].
    pub angle: f64,
    /// What a curvature along and across the sheet [rad/m] adds to it [m].
    pub curl: DVec2,
}

impl HingeRest {
    /// Energy [J] at an angle [rad] where curvatures [rad/m] are wanted beside those at rest.
    pub(super) fn energy(&self, angle: f64, curvature: DVec2) -> f64 {
        0.5 * self.stiffness * (angle - self.angle - self.curl.dot(curvature)).powi(2)
    }
}

/// Angles that curvatures of 1 rad/m along two directions of space make of a hinge at rest, towards the side that its
/// normals look to: to first order, as of a surface `z = s² / 2` over what is flat.
pub(super) fn hinge_curls(x: [DVec3; 4], along: DVec3) -> DVec2 {
    let [x0, x1, x2, x3] = x;
    let edge = x1 - x0;
    let up = (edge.cross(x2 - x0) + (x3 - x0).cross(edge)).normalize_or_zero();
    let first = (along - up * up.dot(along)).normalize_or_zero();
    let second = up.cross(first);
    let Some(slopes) = hinge_slopes(x) else { return DVec2::ZERO };
    let of = |way: DVec3| -> f64 {
        let height = |at: DVec3| 0.5 * (at - x0).dot(way).powi(2);
        slopes.iter().zip(x).map(|(slope, at)| slope.dot(up) * height(at)).sum()
    };
    DVec2::new(of(first), of(second))
}

/// k over `l_s Db` of an edge of this length [m] between areas [m²].
pub(super) fn hinge_weight(length: f64, areas: [f64; 2], diagonal: bool) -> f64 {
    let both = areas[0] + areas[1];
    if diagonal { 2.0 * both / length.powi(2) } else { length.powi(2) / both }
}

/// The angle [rad] at an edge from x0 to x1 with x2 and x3 opposite, from -pi to pi; zero where it is flat.
pub(in crate::solver::forces) fn hinge_angle([x0, x1, x2, x3]: [DVec3; 4]) -> f64 {
    let edge = x1 - x0;
    let (n1, n2) = (edge.cross(x2 - x0), (x3 - x0).cross(edge));
    let sine = n1.cross(n2).dot(edge) / edge.length();
    if sine.is_nan() { 0.0 } else { sine.atan2(n1.dot(n2)) }
}

/// The angle nearest to `last` [rad] among those that are `angle` but for whole turns.
pub(super) fn unwound(angle: f64, last: f64) -> f64 {
    angle + TAU * ((last - angle) / TAU).round()
}

/// Gradients of the angle by the four points [rad/m]; none where a triangle has no area.
pub(in crate::solver::forces) fn hinge_slopes([x0, x1, x2, x3]: [DVec3; 4]) -> Option<[DVec3; 4]> {
    let edge = x1 - x0;
    let length = edge.length();
    let (n1, n2) = (edge.cross(x2 - x0), (x3 - x0).cross(edge));
    let (u1, u2) = (n1 / n1.length_squared(), n2 / n2.length_squared());
    let t = edge / length;
    let slopes = [
        u1 * (x1 - x2).dot(t) + u2 * (x1 - x3).dot(t),
        u1 * (x2 - x0).dot(t) + u2 * (x3 - x0).dot(t),
        -length * u1,
        -length * u2,
    ];
    slopes.iter().all(|slope| slope.is_finite()).then_some(slopes)
}
