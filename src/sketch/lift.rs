//! A pair of strokes becomes one curve in space.

use super::clean::{checked_pair, clean, origins};
use super::correspond::{ARC_LENGTH_WEIGHT, Match, MatchEnd, Sequences, correspond};
use super::message::{SketchError, SketchNote, Which};
use super::range::to_one_range;
use super::stroke::Stroke;
use super::view::{Pair, View};
use crate::geometry::curve::{distance_to_polyline, resample, smooth};
use glam::{DVec2, DVec3};

/// Samples M on each stroke and on the curve.
pub const SAMPLES: usize = 192;
/// The second stroke is reversed where that costs less than this share of keeping its direction.
pub(crate) const REVERSE_RATIO: f64 = 0.25;
/// Root-mean cost, as a fraction of the model's diagonal, above which a pair is doubtful.
pub(crate) const POOR_COST: f64 = 0.03;
/// Deviation, as a fraction of the model's diagonal, that the curve is to keep from its strokes; beyond it a note says
/// so. Averaging halves a difference between the strokes, but where one turn or end is higher in one view than in the
/// other no curve fits both.
pub const STRAY_LIMIT: f64 = 0.01;
/// Passes of [1/4 1/2 1/4] over the merged curve: they take the steps out of the path, which moves on one stroke or
/// the other by whole samples.
const CURVE_SMOOTHING_PASSES: usize = 4;

/// How a pair of strokes is lifted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiftOptions {
    /// Run the second stroke the other way from what the lift would choose by itself.
    pub flip_second: bool,
    /// Stretch the second stroke onto the range of the first, however far they differ, instead of clipping both.
    pub stretch: bool,
    /// Diagonal H of the model's bounding box [m].
    pub model_diagonal: f64,
}

/// A curve in space, and how it came out of its pair of strokes.
#[derive(Clone, Debug, PartialEq)]
pub struct Lifted {
    /// [`SAMPLES`] points, uniform in arc length [m].
    pub curve: Vec<DVec3>,
    /// Root-mean cost of the correspondence, as a fraction of the model's diagonal.
    pub cost: f64,
    /// Largest distance of the curve, as a drawing view sees it, from its stroke in `strokes`, as a fraction of the
    /// model's diagonal.
    pub deviation: f64,
    /// Whether the second stroke runs against its drawing order.
    pub reversed: bool,
    /// The cleaned strokes that were matched, stretched or clipped: [`SAMPLES`] points each, (horizontal, vertical) in
    /// its own view [m]. A reversed second stroke is listed in the order in which it was matched.
    pub strokes: [Vec<DVec2>; 2],
    /// Index pairs into `strokes`, from the start to the end of both.
    pub matches: Vec<[usize; 2]>,
    /// The parts of each stroke outside the range that both share, (horizontal, vertical) in its view [m]; drawn
    /// dashed.
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
        correspond(Sequences { samples: [&first, second], arc_weight, scale, end: MatchEnd::Last })
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
    let curve = merge(&first, &second, &found, pair, origins);
    let strokes = [(0, first), (1, second)].map(|(which, points)| in_view(&points, which, pair, origins));
    let deviation = deviation(&curve, &strokes, pair) / options.model_diagonal;
    if cost > POOR_COST {
        notes.push(SketchNote::PoorMatch { cost });
    } else if deviation > STRAY_LIMIT {
        notes.push(SketchNote::Strays { deviation, axis: pair.shared });
    }
    let [first_clipped, second_clipped] = ranged.clipped;
    let clipped = [(0, first_clipped), (1, second_clipped)]
        .map(|(which, parts)| parts.iter().map(|part| in_view(part, which, pair, origins)).collect());
    Ok(Lifted { curve, cost, deviation, reversed: is_reversed, strokes, matches: found.pairs, clipped, notes })
}

/// Working coordinates of stroke `which` as (horizontal, vertical) in its view [m].
fn in_view(points: &[DVec2], which: usize, pair: Pair, origins: [DVec2; 2]) -> Vec<DVec2> {
    points.iter().map(|&point| pair.swap(which, point + origins[which])).collect()
}

/// Largest distance of the curve from either stroke, as seen in the view of that stroke [m].
fn deviation(curve: &[DVec3], strokes: &[Vec<DVec2>; 2], pair: Pair) -> f64 {
    let from = |(stroke, view): (&Vec<DVec2>, View)| {
        curve.iter().map(|&point| distance_to_polyline(view.project(point), stroke)).fold(0.0, f64::max)
    };
    strokes.iter().zip(pair.views).map(from).fold(0.0, f64::max)
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
