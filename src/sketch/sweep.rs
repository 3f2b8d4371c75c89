//! A pair of strokes becomes a surface: the first is carried along the second.

use super::clean::{checked_pair, clean, origins};
use super::message::{SketchError, Which};
use super::stroke::Stroke;
use crate::geometry::curve::{arc_length, resample};
use glam::DVec3;

/// Most steps along either stroke.
const MOST_STEPS: f64 = 200.0;
/// Share of the product of both strokes' lengths that the surface must have: less, and they run side by side.
const LEAST_AREA: f64 = 0.1;

/// A surface that two strokes sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// Its vertices [m], row after row; rows run along the first stroke.
    pub vertices: Vec<DVec3>,
    /// Vertices to a row, two or more.
    pub to_a_row: usize,
}

impl Sweep {
    /// Number of rows, two or more.
    pub fn rows(&self) -> usize {
        self.vertices.len() / self.to_a_row
    }
}

/// Carries the first stroke along the second, drawn in two of the three orthographic views: `P = A(u) + B(v) - B(0)`.
/// Each stroke is cleaned and cut into steps of `spacing` [m] or a little more; A begins as deep as B does, and B takes
/// nothing across its own view.
///
/// # Errors
/// One view twice, unusable points, a stroke without length, a spacing that is no length, or strokes that run side by
/// side.
pub fn sweep(first: &Stroke, second: &Stroke, model_diagonal: f64, spacing: f64) -> Result<Sweep, SketchError> {
    if !(spacing > 0.0 && spacing.is_finite()) {
        return Err(SketchError::Spacing(spacing));
    }
    let pair = checked_pair(first.view, second.view, model_diagonal)?;
    let origins = origins(first, second, pair);
    let cleaned = [(Which::First, first), (Which::Second, second)];
    let [a, b] = cleaned.map(|(which, stroke)| clean(stroke, which, pair, origins[which.index()], model_diagonal));
    let (a, b) = (a?, b?);
    // In (own, shared) coordinates of each view; the own axis of one is what the other does not see.
    let carried: Vec<DVec3> = a.iter().map(|point| pair.join(point.x, point.y, 0.0)).collect();
    let start = b[0];
    let along: Vec<DVec3> = b.iter().map(|point| pair.join(0.0, point.y - start.y, point.x)).collect();
    let [carried, along] = [carried, along].map(|curve| stepped(&curve, spacing));
    let origin = pair.join(origins[0].x, origins[0].y, origins[1].x);
    let vertices: Vec<DVec3> = along.iter().flat_map(|&b| carried.iter().map(move |&a| origin + a + b)).collect();
    let lengths = arc_length(&carried) * arc_length(&along);
    let area: f64 = edges(&carried).map(|a| edges(&along).map(|b| a.cross(b).length()).sum::<f64>()).sum();
    // As a share of what it could be, also where a length is no number.
    if area.is_nan() || area < LEAST_AREA * lengths {
        return Err(SketchError::SideBySide { share: area / lengths });
    }
    Ok(Sweep { vertices, to_a_row: carried.len() })
}

/// A curve in equal steps no shorter than `spacing` [m], one at least.
fn stepped(curve: &[DVec3], spacing: f64) -> Vec<DVec3> {
    // A length of whole steps may come out just short of them.
    let steps = (arc_length(curve) / spacing * (1.0 + 1e-9)).floor().clamp(1.0, MOST_STEPS);
    resample(curve, steps as usize + 1)
}

fn edges(curve: &[DVec3]) -> impl Iterator<Item = DVec3> + '_ {
    curve.windows(2).map(|ends| ends[1] - ends[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sketch::View;
    use glam::DVec2;

    fn stroke(view: View, points: &[[f64; 2]]) -> Stroke {
        Stroke { view, points: points.iter().copied().map(DVec2::from_array).collect() }
    }

    #[test]
    fn straight_strokes_sweep_a_parallelogram_in_whole_steps() {
        let across = stroke(View::Front, &[[-0.02, 0.01], [0.02, 0.01]]);
        let deep = stroke(View::Side, &[[-0.03, 0.05], [0.03, 0.08]]);
        let swept = sweep(&across, &deep, 0.1, 0.01).expect("a surface");
        // 40 mm in four steps, 67 mm in six.
        assert_eq!((swept.to_a_row, swept.rows()), (5, 7));
        let corners = [0, 4, 30, 34].map(|k| swept.vertices[k]);
        let expected = [[-0.02, 0.01, -0.03], [0.02, 0.01, -0.03], [-0.02, 0.04, 0.03], [0.02, 0.04, 0.03]];
        for (corner, expected) in corners.into_iter().zip(expected) {
            assert!(corner.distance(DVec3::from_array(expected)) < 1e-12, "{corner}, not {expected:?}");
        }
        // The second stroke's own height does not count, only its way.
        let lower = stroke(View::Side, &[[-0.03, 0.0], [0.03, 0.03]]);
        assert!(sweep(&across, &lower, 0.1, 0.01).expect("a surface").vertices[34].distance(corners[3]) < 1e-12);
    }

    #[test]
    fn strokes_side_by_side_sweep_nothing() {
        let upright = stroke(View::Front, &[[0.0, 0.0], [0.0, 0.06]]);
        let beside = stroke(View::Side, &[[0.0, 0.0], [0.001, 0.06]]);
        let error = sweep(&upright, &beside, 0.1, 0.01).expect_err("nothing");
        assert!(matches!(error, SketchError::SideBySide { share } if share < 0.03), "{error}");
        let once_more = stroke(View::Front, &[[0.0, 0.0], [0.05, 0.0]]);
        assert_eq!(sweep(&upright, &once_more, 0.1, 0.01), Err(SketchError::SameView(View::Front)));
        assert!(matches!(sweep(&upright, &beside, 0.1, 0.0), Err(SketchError::Spacing(_))));
    }
}
