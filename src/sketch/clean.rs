//! From a stroke as drawn to a clean polyline: checked, freed of repeats, smoothed.

use super::message::{SketchError, Which};
use super::stroke::Stroke;
use super::view::{Pair, View};
use crate::geometry::curve::{arc_length, refine, smooth};
use glam::DVec2;

/// Passes of [1/4 1/2 1/4] over a stroke.
const SMOOTHING_PASSES: usize = 4;
/// Before it is smoothed, no segment of a stroke is longer than its length over this. A stroke by hand has a sample
/// every 2 px and stays as it is; one of a few clicked or written points keeps its corners.
const REFINED_SEGMENTS: f64 = 64.0;
/// Shortest stroke, as a fraction of the model's diagonal.
const SHORTEST: f64 = 1e-6;
/// Largest coordinate, in model diagonals: beyond it f64 resolves less than 1e-7 of the model.
const FARTHEST: f64 = 1e9;
/// Usable model diagonals [m]: their squares, times that of `FARTHEST`, stay finite and clear of zero.
const MODEL_SIZES: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

/// Checks two views and a model diagonal [m].
pub(super) fn checked_pair(first: View, second: View, model_diagonal: f64) -> Result<Pair, SketchError> {
    if !MODEL_SIZES.contains(&model_diagonal) {
        return Err(SketchError::ModelSize(model_diagonal));
    }
    Pair::new(first, second).ok_or(SketchError::SameView(first))
}

/// The clean polyline of one stroke, as (own, shared) coordinates relative to `origin` [m].
///
/// Working near the origin keeps the digits and makes the result independent of where the model stands.
///
/// # Errors
/// Points that are not finite or out of all proportion, and strokes without length.
pub(super) fn clean(
    stroke: &Stroke,
    which: Which,
    pair: Pair,
    origin: DVec2,
    model_diagonal: f64,
) -> Result<Vec<DVec2>, SketchError> {
    let mut points: Vec<DVec2> = Vec::with_capacity(stroke.points.len());
    for (i, &drawn) in stroke.points.iter().enumerate() {
        if !drawn.is_finite() {
            return Err(SketchError::NotFinite { which, point: i + 1 });
        }
        if drawn.abs().max_element() > FARTHEST * model_diagonal {
            return Err(SketchError::TooFar { which, point: i + 1 });
        }
        let point = pair.swap(which.index(), drawn) - origin;
        // A resting pen repeats its point; the repeats would pin the smoothing there.
        if points.last() != Some(&point) {
            points.push(point);
        }
    }
    let mut points = refine(&points, arc_length(&points) / REFINED_SEGMENTS);
    smooth(&mut points, SMOOTHING_PASSES);
    let length = arc_length(&points);
    if length > SHORTEST * model_diagonal { Ok(points) } else { Err(SketchError::TooShort { which, length }) }
}

/// Where a pair's working coordinates have their origin: the own axes at each stroke's first point, the shared axis at
/// that of the first stroke [m]. Strokes that are empty or not finite are refused later, by `clean`.
pub(super) fn origins(first: &Stroke, second: &Stroke, pair: Pair) -> [DVec2; 2] {
    let [a, b] = [(0, first), (1, second)].map(|(which, stroke)| {
        let start = stroke.points.first().copied().filter(|point| point.is_finite()).unwrap_or_default();
        pair.swap(which, start)
    });
    [a, DVec2::new(b.x, a.y)]
}

impl Which {
    /// 0 for the first, 1 for the second.
    pub(super) fn index(self) -> usize {
        match self {
            Self::First => 0,
            Self::Second => 1,
        }
    }
}
