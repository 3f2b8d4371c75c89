//! The range of the shared axis that each stroke covers, and what to do where the two differ.

use super::message::{SketchError, SketchNote, Which};
use super::view::Pair;
use crate::geometry::curve::{Point, arc_length};
use glam::DVec2;

/// Mismatch of the shared ranges, as a fraction of the larger one, up to which the second stroke is stretched silently.
pub(super) const STRETCH_LIMIT: f64 = 0.05;
/// Mismatch of the shared ranges up to which both strokes are clipped to what they share; beyond it they are refused.
pub(super) const CLIP_LIMIT: f64 = 0.25;
/// Shared extent over the length of the longer stroke under which a pair cannot give depth.
const DEGENERATE: f64 = 0.1;
/// Shared extent over that of the other stroke under which a stroke counts as flat: stretching it would draw noise.
const FLAT: f64 = 0.05;

/// Lowest and highest value.
pub(super) fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

fn extent([low, high]: [f64; 2]) -> f64 {
    (high - low).max(0.0)
}

/// Two strokes over one range of their shared axis, as (own, shared) [m].
pub(super) struct Ranged {
    /// The strokes, stretched or clipped.
    pub(super) strokes: [Vec<DVec2>; 2],
    /// The parts that were clipped off each.
    pub(super) clipped: [Vec<Vec<DVec2>>; 2],
    /// What was done.
    pub(super) note: Option<SketchNote>,
}

/// Brings two clean strokes to one range of the shared axis.
///
/// Up to [`STRETCH_LIMIT`], or at any mismatch if `stretch` is set, the second stroke is stretched onto the range of
/// the first; up to [`CLIP_LIMIT`] both are clipped to their overlap.
///
/// # Errors
/// A pair that cannot give depth, one flat stroke, or too large a mismatch.
pub(super) fn to_one_range(strokes: [Vec<DVec2>; 2], pair: Pair, stretch: bool) -> Result<Ranged, SketchError> {
    let axis = pair.shared;
    let ranges = strokes.each_ref().map(|points| range(points.iter().map(|point| point.y)));
    let extents = ranges.map(extent);
    refuse_degenerate(&strokes, extents, pair)?;
    let larger = extents[0].max(extents[1]);
    for which in [Which::First, Which::Second] {
        if extents[which.index()] < FLAT * larger {
            return Err(SketchError::Flat { which, axis });
        }
    }
    let band = [ranges[0][0].max(ranges[1][0]), ranges[0][1].min(ranges[1][1])];
    let overlap = extent(band) / larger;
    if stretch || 1.0 - overlap <= STRETCH_LIMIT {
        let [first, mut second] = strokes;
        let factor = extents[0] / extents[1];
        for point in &mut second {
            point.y = ranges[0][0] + (point.y - ranges[1][0]) * factor;
        }
        let strokes = [first, second];
        // Stretching may have flattened the second stroke.
        refuse_degenerate(&strokes, [extents[0]; 2], pair)?;
        let note = (1.0 - overlap > STRETCH_LIMIT).then_some(SketchNote::Stretched { factor, axis });
        return Ok(Ranged { strokes, clipped: Default::default(), note });
    }
    if 1.0 - overlap > CLIP_LIMIT {
        return Err(SketchError::Overlap { overlap, axis });
    }
    let [(first, first_clipped), (second, second_clipped)] = strokes.map(|points| clip(&points, band));
    Ok(Ranged {
        strokes: [first, second],
        clipped: [first_clipped, second_clipped],
        note: Some(SketchNote::Clipped { overlap, axis }),
    })
}

/// Refuses two strokes that both hardly move along the shared axis, and names the view that would help.
fn refuse_degenerate(strokes: &[Vec<DVec2>; 2], extents: [f64; 2], pair: Pair) -> Result<(), SketchError> {
    let length = strokes.iter().map(|points| arc_length(points)).fold(0.0, f64::max);
    let share = extents[0].max(extents[1]) / length;
    if share >= DEGENERATE {
        return Ok(());
    }
    // The stroke that moves farther along its own axis gives the better shared range with the third view.
    let own = strokes.each_ref().map(|points| extent(range(points.iter().map(|point| point.x))));
    let keep = pair.views[usize::from(own[1] > own[0])];
    Err(SketchError::Degenerate { axis: pair.shared, share, keep, instead: pair.third() })
}

/// Clips a polyline to lowest <= y <= highest: its ends are cut off where it first enters and last leaves the band,
/// an excursion in between is flattened onto the edge, so that one stroke stays one stroke.
///
/// Returns what is left and, as drawn, every part outside the band with the points where it crosses the edge.
fn clip(points: &[DVec2], [lowest, highest]: [f64; 2]) -> (Vec<DVec2>, Vec<Vec<DVec2>>) {
    let cut = cut_at(points, [lowest, highest]);
    let inside = |point: &DVec2| (lowest..=highest).contains(&point.y);
    let mut outside: Vec<Vec<DVec2>> = Vec::new();
    let mut open = false;
    for ends in cut.windows(2) {
        let leaves = !ends.iter().all(inside);
        if leaves && !open {
            outside.push(vec![ends[0]]);
        }
        if let (true, Some(part)) = (leaves, outside.last_mut()) {
            part.push(ends[1]);
        }
        open = leaves;
    }
    let (Some(from), Some(to)) = (cut.iter().position(inside), cut.iter().rposition(inside)) else {
        return (Vec::new(), outside);
    };
    let kept = cut[from..=to].iter().map(|point| DVec2::new(point.x, point.y.clamp(lowest, highest))).collect();
    (kept, outside)
}

/// The same polyline with a vertex wherever it crosses one of the levels of y.
fn cut_at(points: &[DVec2], levels: [f64; 2]) -> Vec<DVec2> {
    let mut cut: Vec<DVec2> = points.first().copied().into_iter().collect();
    for ends in points.windows(2) {
        let [a, b] = [ends[0], ends[1]];
        let ordered = if a.y < b.y { levels } else { [levels[1], levels[0]] };
        for level in ordered {
            if (a.y < level && level < b.y) || (b.y < level && level < a.y) {
                cut.push(DVec2::new(a.mix(b, (level - a.y) / (b.y - a.y)).x, level));
            }
        }
        cut.push(b);
    }
    cut
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clipping_cuts_ends_and_flattens_excursions() {
        let points = [(0.0, -1.0), (1.0, 1.0), (2.0, 3.0), (3.0, 1.0), (4.0, 0.0), (5.0, -2.0)];
        let points = points.map(|(x, y)| DVec2::new(x, y));
        let (kept, outside) = clip(&points, [0.0, 2.0]);
        let expected = [(0.5, 0.0), (1.0, 1.0), (1.5, 2.0), (2.0, 2.0), (2.5, 2.0), (3.0, 1.0), (4.0, 0.0)];
        assert_eq!(kept, expected.map(|(x, y)| DVec2::new(x, y)));
        let expected =
            [vec![(0.0, -1.0), (0.5, 0.0)], vec![(1.5, 2.0), (2.0, 3.0), (2.5, 2.0)], vec![(4.0, 0.0), (5.0, -2.0)]];
        assert_eq!(outside, expected.map(|part| part.into_iter().map(|(x, y)| DVec2::new(x, y)).collect::<Vec<_>>()));
    }
}
