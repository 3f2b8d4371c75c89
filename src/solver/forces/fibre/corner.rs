//! Bending at one vertex of a fibre (eqs. 6 and 7).

use glam::DVec3;

/// Turning cosine below which the bending energy continues linearly.
pub(super) const FOLD: f64 = -0.5;

/// `(1 - c) / (1 + c)`, continued linearly where the fibre folds.
pub(super) fn straight_energy(c: f64) -> f64 {
    if c < FOLD { -1.0 - 8.0 * c } else { (1.0 - c) / (1.0 + c) }
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
