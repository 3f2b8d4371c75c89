//! Transforms that take axes to axes, and what becomes of strokes under them.

use crate::scene::{StrokePair, ViewStroke};
use crate::sketch::View;
use glam::DVec3;

/// Where a transform that takes axes to axes takes each of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct AxisMap {
    /// Index of the axis that an axis goes to.
    pub(super) to: [usize; 3],
    /// How far along it, backwards below zero: 1 or -1 but for a scaling.
    pub(super) factor: [f64; 3],
    /// Where the origin goes [m].
    pub(super) offset: DVec3,
}

/// A stroke of the moved, turned or mirrored curve: it is seen in the view of the axes to which its own went.
pub(super) fn carried_stroke(stroke: &ViewStroke, map: &AxisMap) -> ViewStroke {
    let targets = stroke.view.axes().map(|axis| map.to[axis]);
    let view = View::ALL.into_iter().find(|view| targets.iter().all(|axis| view.axes().contains(axis)));
    let view = view.unwrap_or(stroke.view);
    let points = stroke.points.iter().map(|point| {
        view.axes().map(|axis| {
            let from = usize::from(targets[1] == axis);
            map.factor[stroke.view.axes()[from]] * point[from] + map.offset[axis]
        })
    });
    ViewStroke { view, points: points.collect(), extra: stroke.extra.clone() }
}

/// Both strokes of the moved, turned or mirrored curve.
pub(super) fn carried(pair: &StrokePair, map: &AxisMap) -> StrokePair {
    let [first, second] = [&pair.first, &pair.second].map(|stroke| carried_stroke(stroke, map));
    StrokePair { first, second, ..pair.clone() }
}
