//! Smoothing and resampling a whole fibre.

use super::edited::{Edited, LEAST_VERTICES, MOST_VERTICES, Sampling, with_vertices};
use super::error::FibreEditError;
use super::vertices::{curve, vertices};
use crate::geometry::curve;
use crate::scene::Fibre;

/// How closely a fibre is resampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ResampleTo {
    /// Into this many vertices, 3 or more.
    Count(usize),
    /// Into vertices about this far apart [m], 3 at least.
    Spacing(f64),
}

/// Smooths a fibre by passes of [1/4 1/2 1/4] over its vertices; both ends stay.
///
/// # Errors
/// Neighbours that would lie in one place, or strokes that give no curve.
pub fn smooth(fibre: &Fibre, passes: usize, sampling: Sampling) -> Result<Edited, FibreEditError> {
    let mut vertices = vertices(fibre, sampling)?;
    curve::smooth(&mut vertices, passes);
    with_vertices(fibre, &vertices)
}

/// Spaces vertices evenly along a fibre; both ends stay. A pair of strokes is sampled along its whole curve.
///
/// # Errors
/// Fewer than 3 vertices or more than [`MOST_VERTICES`], a spacing that is no length, a fibre without length, or
/// strokes that give no curve.
pub fn resample(fibre: &Fibre, to: ResampleTo, sampling: Sampling) -> Result<Edited, FibreEditError> {
    let points = curve(fibre, sampling)?;
    let wanted = match to {
        ResampleTo::Count(count) if count < LEAST_VERTICES => return Err(FibreEditError::Count(count)),
        ResampleTo::Count(count) => count as f64,
        ResampleTo::Spacing(spacing) if !(spacing > 0.0 && spacing.is_finite()) => {
            return Err(FibreEditError::Spacing(spacing));
        }
        ResampleTo::Spacing(spacing) => {
            ((curve::arc_length(&points) / spacing).round() + 1.0).max(LEAST_VERTICES as f64)
        }
    };
    // As a float until here: a length over a tiny spacing may exceed any integer.
    if wanted > MOST_VERTICES as f64 {
        return Err(FibreEditError::TooMany { wanted, limit: MOST_VERTICES });
    }
    with_vertices(fibre, &curve::resample(&points, wanted as usize))
}
