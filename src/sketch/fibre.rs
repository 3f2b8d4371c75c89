//! A curve becomes a row of structure particles.

use super::message::SketchError;
use crate::geometry::curve::{arc_length, resample};
use glam::DVec3;
use std::ops::RangeInclusive;

/// Fewest and most structure particles on a fibre.
pub(super) const PARTICLE_COUNT: RangeInclusive<usize> = 4..=64;

/// Samples a curve [m] with structure particles about `spacing` [m] apart: round(length / spacing) + 1 of them, held
/// within `PARTICLE_COUNT`, uniform in arc length from end to end.
///
/// # Errors
/// A spacing that is not a positive length, or a curve without a measurable length.
pub fn structure_particles(curve: &[DVec3], spacing: f64) -> Result<Vec<DVec3>, SketchError> {
    if !(spacing > 0.0 && spacing.is_finite()) {
        return Err(SketchError::Spacing(spacing));
    }
    let length = arc_length(curve);
    if !(length > 0.0 && length.is_finite()) {
        return Err(SketchError::Curve);
    }
    // As floats until it is clamped: the quotient may exceed any integer.
    let count = ((length / spacing).round() + 1.0).clamp(*PARTICLE_COUNT.start() as f64, *PARTICLE_COUNT.end() as f64);
    Ok(resample(curve, count as usize))
}
