//! What the second view shows of the first stroke, to draw the second one by.

use super::clean::{checked_pair, clean, origins};
use super::message::{SketchError, Which};
use super::range::range;
use super::stroke::Stroke;
use super::view::View;
use crate::geometry::curve::turning_points;

/// Smallest turn that gets a guide, as a fraction of the diagonal of the stroke's own box.
const TURN_PROMINENCE: f64 = 0.03;

/// Guides along the shared axis [m].
#[derive(Clone, Debug, PartialEq)]
pub struct Guides {
    /// Index of the shared axis (0 = X, 1 = Y, 2 = Z). Where it runs horizontally in the second view, the guides are
    /// vertical.
    pub axis: usize,
    /// Lowest and highest shared coordinate of the first stroke.
    pub band: [f64; 2],
    /// Shared coordinate of its start.
    pub start: f64,
    /// Shared coordinate of its end.
    pub end: f64,
    /// Shared coordinates of its turning points, in drawing order.
    pub turns: Vec<f64>,
}

/// Guides that the first stroke gives for a second one in `second_view`, for a model of diagonal `model_diagonal` [m].
///
/// # Errors
/// Views without a shared axis, unusable points, or a stroke without length.
pub fn guides(first: &Stroke, second_view: View, model_diagonal: f64) -> Result<Guides, SketchError> {
    let pair = checked_pair(first.view, second_view, model_diagonal)?;
    let [origin, _] = origins(first, first, pair);
    let points = clean(first, Which::First, pair, origin, model_diagonal)?;
    let shared: Vec<f64> = points.iter().map(|point| point.y + origin.y).collect();
    let [left, right] = range(points.iter().map(|point| point.x));
    let band = range(shared.iter().copied());
    let prominence = TURN_PROMINENCE * (right - left).hypot(band[1] - band[0]);
    Ok(Guides {
        axis: pair.shared,
        band,
        start: shared.first().copied().unwrap_or_default(),
        end: shared.last().copied().unwrap_or_default(),
        turns: turning_points(&shared, prominence).into_iter().map(|i| shared[i]).collect(),
    })
}
