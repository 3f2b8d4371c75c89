//! A pair of strokes becomes one curve in space.

use super::clean::{checked_pair, clean, origins};
use super::correspond::{ARC_LENGTH_WEIGHT, End, Match, Sequences, correspond};
use super::message::{SketchError, SketchNote, Which};
use super::range::to_one_range;
use super::view::Pair;
use super::{LiftOptions, Stroke};
use crate::geometry::curve::{resample, smooth};
use glam::{DVec2, DVec3};

/// Samples M on each stroke and on the curve.
pub const SAMPLES: usize = 192;
/// The second stroke is reversed where that costs less than this share of keeping its direction.
pub const REVERSE_RATIO: f64 = 0.25;
/// Root-mean cost, as a fraction of the model's diagonal, above which a pair is doubtful.
pub const POOR_COST: f64 = 0.03;
/// Passes of [1/4 1/2 1/4] over the merged curve: they take the steps out of the path, which moves on one stroke or
/// the other by whole samples.
const CURVE_SMOOTHING_PASSES: usize = 8;

/// A curve in space, and how it came out of its pair of strokes.
#[derive(Clone, Debug, PartialEq)]
pub struct Lifted {
    /// [`SAMPLES`] points, uniform in arc length [m].
    pub curve: Vec<DVec3>,
    /// Root-mean cost of the correspondence, as a fraction of the model's diagonal.
    pub cost: f64,
    /// Whether the second stroke runs against its drawing order.
    pub reversed: bool,
    /// The cleaned strokes that were matched, stretched or clipped: [`SAMPLES`] points each, (horizontal, vertical) in
    /// its own view [m]. A reversed second stroke is listed in the order in which it was matched.
    pub strokes: [Vec<DVec2>; 2],
    /// Index pairs into `strokes`, from the start to the end of both.
    pub matches: Vec<[usize; 2]>,
    /// The parts of each stroke outside the range that both share, (horizontal, vertical) in its view [m]; drawn dashed.
    pub clipped: [Vec<Vec<DVec2>>; 2],
    /// What was done without being asked, or looks doubtful.
    pub notes: Vec<SketchNote>,
}

/// Lifts a pair of strokes, drawn in two of the three orthographic views, to one curve in space.
///
/// The strokes are cleaned, brought to one range of their shared axis, resampled, matched and merged into
/// (own coordinate of the first, mean of the shared coordinates, own coordinate of the second).
///
/// # Errors
/// One view twice, unusable points, a stroke without length, a pair that cannot give depth, or ranges of the shared
/// axis that differ by more than [`CLIP_LIMIT`](super::CLIP_LIMIT) without [`LiftOptions::stretch`].
pub fn lift(first: &Stroke, second: &Stroke, options: &LiftOptions) -> Result<Lifted, SketchError> {
    let pair = checked_pair(first.view, second.view, options.model_diagonal)?;
    let origins = origins(first, second, pair);
    let first = clean(first, Which::First, pair, origins[0], options.model_diagonal)?;
    let second = clean(second, Which::Second, pair, origins[1], options.model_diagonal)?;
    let ranged = to_one_range([first, second], pair, options.stretch)?;
    let mut notes: Vec<SketchNote> = ranged.note.into_iter().collect();

    let [first, mut second] = ranged.strokes.map(|points| resample(&points, SAMPLES));
    let match_with = |second: &[DVec2]| {
        let (scale, arc_weight) = (options.model_diagonal, ARC_LENGTH_WEIGHT);
        correspond(Sequences { samples: [&first, second], arc_weight, scale, end: End::Last })
    };
    let forward = match_with(&second);
    let backward = match_with(&reversed(&second));
    let runs_against = backward.mean_cost < REVERSE_RATIO * forward.mean_cost;
    let is_reversed = runs_against != options.flip_second;
    let found = if is_reversed {
        second.reverse();
        backward
    } else {
        forward
    };
    if runs_against && is_reversed {
        notes.push(SketchNote::Reversed);
    }
    let cost = found.mean_cost.sqrt();
    if cost > POOR_COST {
        notes.push(SketchNote::PoorMatch { cost });
    }
    let in_view = |which: usize, point: DVec2| pair.swap(which, point + origins[which]);
    Ok(Lifted {
        curve: merge(&first, &second, &found, pair, origins),
        cost,
        reversed: is_reversed,
        strokes: [first.iter().map(|&p| in_view(0, p)).collect(), second.iter().map(|&p| in_view(1, p)).collect()],
        matches: found.pairs,
        clipped: [0, 1].map(|which| {
            ranged.clipped[which].iter().map(|part| part.iter().map(|&p| in_view(which, p)).collect()).collect()
        }),
        notes,
    })
}

/// The curve through all matched pairs, uniform in arc length [m].
pub(super) fn merge(first: &[DVec2], second: &[DVec2], found: &Match, pair: Pair, origins: [DVec2; 2]) -> Vec<DVec3> {
    let joined = |&[i, j]: &[usize; 2]| pair.join(first[i].x, 0.5 * (first[i].y + second[j].y), second[j].x);
    let mut curve: Vec<DVec3> = found.pairs.iter().map(joined).collect();
    smooth(&mut curve, CURVE_SMOOTHING_PASSES);
    let origin = pair.join(origins[0].x, origins[0].y, origins[1].x);
    resample(&curve, SAMPLES).into_iter().map(|point| point + origin).collect()
}

/// The samples from last to first.
pub(super) fn reversed(samples: &[DVec2]) -> Vec<DVec2> {
    samples.iter().rev().copied().collect()
}
