//! Bending at one vertex of a fibre (eqs. 6 and 7).

use crate::solver::neighbourhood::outer;
use glam::{DMat3, DVec3};

/// Turning cosine below which the bending energy continues linearly.
pub(super) const FOLD: f64 = -0.5;

/// `(1 - c) / (1 + c)`, continued linearly where the fibre folds.
pub(super) fn straight_energy(c: f64) -> f64 {
    if c < FOLD { -1.0 - 8.0 * c } else { (1.0 - c) / (1.0 + c) }
}

/// Gradients by both edges [N] of `4 S` times that energy, S a stiffness [N m].
pub(super) fn straight_gradients(corner: &Corner, stiffness: f64) -> [DVec3; 2] {
    let c = corner.cosine;
    let slope = -8.0 * stiffness * if c < FOLD { 4.0 } else { (1.0 + c).powi(-2) };
    let (before, after) = (corner.before, corner.after);
    [
        (after.tangent - before.tangent * c) * (slope / before.length),
        (before.tangent - after.tangent * c) * (slope / after.length),
    ]
}

/// `1 / (1 + c)` and its derivative, continued likewise.
fn inverse_half(c: f64) -> (f64, f64) {
    if c < FOLD { (4.0 - 4.0 * (1.0 + c), -4.0) } else { (1.0 / (1.0 + c), -1.0 / (1.0 + c).powi(2)) }
}

/// Curvature binormal of eq. 6 from the unit tangents of two consecutive edges.
pub(crate) fn curvature_binormal(before: DVec3, after: DVec3) -> DVec3 {
    2.0 * inverse_half(before.dot(after)).0 * before.cross(after)
}

/// An edge between two vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    /// Unit tangent.
    pub(super) tangent: DVec3,
    /// Length [m].
    pub(super) length: f64,
}

impl Edge {
    /// The edge from one point to another [m]; its tangent is zero if it has no length.
    fn between(from: DVec3, to: DVec3) -> Self {
        let edge = to - from;
        let length = edge.length();
        Self { tangent: if length > 0.0 { edge / length } else { DVec3::ZERO }, length }
    }
}

/// Two consecutive edges.
pub(super) struct Corner {
    pub(super) before: Edge,
    pub(super) after: Edge,
    /// Cosine of the turning angle.
    pub(super) cosine: f64,
}

impl Corner {
    /// The corner between two edges; none if one of them has no length.
    pub(super) fn between(before: Edge, after: Edge) -> Option<Self> {
        let cosine = before.tangent.dot(after.tangent);
        (before.length > 0.0 && after.length > 0.0).then_some(Self { before, after, cosine })
    }

    /// The corner at inner vertex `k + 1` of vertices at `x`.
    pub(super) fn at(x: &[DVec3], k: usize) -> Option<Self> {
        Self::between(Edge::between(x[k], x[k + 1]), Edge::between(x[k + 1], x[k + 2]))
    }

    /// Curvature binormal of eq. 6.
    pub(super) fn binormal(&self) -> DVec3 {
        curvature_binormal(self.before.tangent, self.after.tangent)
    }

    /// Derivatives of the curvature binormal by the two edges [1/m].
    pub(super) fn binormal_derivatives(&self) -> [DMat3; 2] {
        let (before, after) = (self.before.tangent, self.after.tangent);
        let (g, dg) = inverse_half(self.cosine);
        let turned = before.cross(after) * dg;
        // From derivatives by the unit tangents to derivatives by the edges.
        let by_edge = |edge: &Edge, by_tangent: DMat3| {
            (by_tangent - outer(by_tangent * edge.tangent, edge.tangent)) * (2.0 / edge.length)
        };
        let by_before = outer(turned, after) - crossing(after) * g;
        let by_after = outer(turned, before) + crossing(before) * g;
        [by_edge(&self.before, by_before), by_edge(&self.after, by_after)]
    }

    /// Gradients by the two edges [N] of an energy whose gradient by the curvature binormal is `y`.
    pub(super) fn curved_gradients(&self, y: DVec3) -> (DVec3, DVec3) {
        let (before, after) = (self.before.tangent, self.after.tangent);
        let (g, dg) = inverse_half(self.cosine);
        let along = 2.0 * dg * y.dot(before.cross(after));
        // From gradients by the unit tangents to gradients by the edges.
        let across = |edge: &Edge, slope: DVec3| (slope - edge.tangent * edge.tangent.dot(slope)) / edge.length;
        let (by_before, by_after) =
            (along * after + 2.0 * g * after.cross(y), along * before + 2.0 * g * y.cross(before));
        (across(&self.before, by_before), across(&self.after, by_after))
    }
}

/// The matrix that takes a vector v to `a x v`.
fn crossing(a: DVec3) -> DMat3 {
    DMat3::from_cols(a.cross(DVec3::X), a.cross(DVec3::Y), a.cross(DVec3::Z))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_of_binormals_are_their_differences() {
        // Turned a little, beyond a right angle, and folded.
        for last in [DVec3::new(2.1, 0.4, 0.3), DVec3::new(0.8, 0.9, -0.2), DVec3::new(0.2, 0.3, 0.4)] {
            let x = [DVec3::ZERO, DVec3::new(1.0, 0.1, 0.0), last];
            let derivatives = Corner::at(&x, 0).expect("edges with lengths").binormal_derivatives();
            let [by_before, by_after] = derivatives;
            for (vertex, derivative) in [-by_before, by_before - by_after, by_after].into_iter().enumerate() {
                for axis in DMat3::IDENTITY.to_cols_array_2d().map(DVec3::from_array) {
                    let at = |by: f64| {
                        let mut x = x;
                        x[vertex] += by * axis;
                        Corner::at(&x, 0).expect("edges with lengths").binormal()
                    };
                    let difference = (at(1e-6) - at(-1e-6)) / 2e-6;
                    assert!((derivative * axis).distance(difference) < 1e-7 * difference.length().max(1.0), "{vertex}");
                }
            }
        }
    }
}
