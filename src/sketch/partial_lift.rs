//! The preview while the second stroke is still being drawn.

use super::clean::{checked_pair, clean, origins};
use super::correspond::{MatchEnd, Sequences, correspond};
use super::lift::{REVERSE_RATIO, SAMPLES, merge, reversed};
use super::message::{SketchError, Which};
use super::stroke::Stroke;
use crate::geometry::curve::resample;
use glam::{DVec2, DVec3};

/// Where an unfinished second stroke stands.
#[derive(Clone, Debug, PartialEq)]
pub struct PartialLift {
    /// The point of the first stroke that matches the pen, (horizontal, vertical) in the first view [m].
    pub tick: DVec2,
    /// The curve so far, [`SAMPLES`] points uniform in arc length [m].
    pub curve: Vec<DVec3>,
}

/// Matches an unfinished second stroke with the part of the first that it has reached.
///
/// The match ends on the first stroke wherever the mean cost is least. Arc length has no say, since nobody knows how
/// much of the second stroke is still to come. A second stroke that fits far better from the first one's end is taken
/// to run backwards.
///
/// # Errors
/// One view twice, unusable points, or a stroke without length. Ranges of the shared axis are not compared yet.
pub fn partial_lift(first: &Stroke, second_so_far: &Stroke, model_diagonal: f64) -> Result<PartialLift, SketchError> {
    let pair = checked_pair(first.view, second_so_far.view, model_diagonal)?;
    let origins = origins(first, second_so_far, pair);
    let first = resample(&clean(first, Which::First, pair, origins[0], model_diagonal)?, SAMPLES);
    let second = resample(&clean(second_so_far, Which::Second, pair, origins[1], model_diagonal)?, SAMPLES);
    let from_end = reversed(&first);
    let match_from = |first: &[DVec2]| {
        correspond(Sequences {
            samples: [first, &second],
            arc_weight: 0.0,
            scale: model_diagonal,
            end: MatchEnd::Anywhere,
        })
    };
    let (forward, backward) = (match_from(&first), match_from(&from_end));
    let (first, found) =
        if backward.mean_cost < REVERSE_RATIO * forward.mean_cost { (from_end, backward) } else { (first, forward) };
    let reached = found.pairs.last().map_or(0, |&[i, _]| i);
    Ok(PartialLift {
        tick: pair.swap(0, first[reached] + origins[0]),
        curve: merge(&first, &second, &found, pair, origins),
    })
}
