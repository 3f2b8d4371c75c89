//! Points that lie just outside of the particles, and so cannot carry force where they are.

use crate::solver::embedding::Embedder;
use glam::DVec3;

/// Greatest `sum phi²` of a point that carries force: beyond it the point shrinks the stable step.
pub(super) const GREATEST_SQUARE_SUM: f64 = 1.0;

/// Whether a point may carry force where it is.
pub(super) fn holds(embedder: &Embedder<'_>, at: DVec3) -> bool {
    embedder.vertex_weights(at).is_some_and(|weights| weights.square_sum() <= GREATEST_SQUARE_SUM)
}

/// The nearest point on the way to the centroid of the particles around a point at which it may carry force; none
/// where it already may.
pub(super) fn slide_in(embedder: &Embedder<'_>, point: DVec3) -> Option<DVec3> {
    let holds = |at: DVec3| holds(embedder, at);
    if holds(point) {
        return None;
    }
    let inwards = embedder.centroid(point) - point;
    let (mut outside, mut inside) = (0.0, 1.0);
    while !holds(point + inside * inwards) && inside < 8.0 {
        outside = inside;
        inside *= 2.0;
    }
    for _ in 0..30 {
        let middle = 0.5 * (outside + inside);
        if holds(point + middle * inwards) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    Some(point + inside * inwards)
}
