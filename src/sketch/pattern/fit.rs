//! How far into a solid a layout goes, so that its fibres lie in the material and not in what the box around it leaves
//! empty.
//!
//! A ball leaves the corners of its box empty, a figure most of it. So a layout that sticks out is laid further in,
//! with a wider margin: the least one at which all fibres lie in the material, or else the one at which most of their
//! vertices do. Where of some fibre nothing would be left at any margin, as of one along the side of a figure, the
//! layout goes into a smaller box about the same middle.

use super::layout::Polyline;
use super::parametric::Pattern;
use crate::geometry::neighbours::PointGrid;
use glam::DVec3;

/// By how much wider the margin is at each try, as a share of the box's least extent.
const WIDER: f64 = 0.025;

/// What is left of the box's extents at each try after those.
const SMALLER: [f64; 8] = [0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2];

/// A place lies in the material if so many particles are within so many of their spacings: on a lattice up to its
/// faces, and not beyond its edges.
const LEAST: usize = 4;
const NEAR: f64 = 1.25;

/// Vertices in a row without which nothing is left of a fibre.
const RUN: usize = 3;

/// Of so many particles the spacing is taken.
const ASKED: usize = 63;

/// A layout in a solid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Laid {
    /// The fibres' vertices [m], model frame.
    pub fibres: Vec<Polyline>,
    /// Least and greatest corner of the box that it is kept to [m], where that is further in than was asked for.
    pub further_in: Option<[DVec3; 2]>,
    /// Fibres that stick out all the same, where nothing better was found.
    pub outside: usize,
}

impl Pattern {
    /// [`Pattern::lay`] in a box around a solid of these particles [m]; further in where fibres would stick out of
    /// them.
    pub fn lay_into(&self, values: &[f64], [min, max]: [DVec3; 2], particles: &[DVec3]) -> Laid {
        let held = self.held(values);
        let (Some(margin), Some((&asked, _))) = (self.parameters.last(), held.split_last()) else {
            return Laid::default();
        };
        let Some(spacing) = spacing(particles) else {
            return Laid { fibres: self.lay(values, min, max), ..Laid::default() };
        };
        let grid = PointGrid::new(particles, NEAR * spacing);
        let is_in = |at: &DVec3| grid.within(*at).len() >= LEAST;
        let widest = margin.range[1];
        let steps = ((widest - asked) / WIDER).ceil().max(0.0) as usize;
        let wider = (0..=steps).map(|k| ((asked + WIDER * k as f64).min(widest), 1.0));
        let smaller = SMALLER.into_iter().map(|share| (asked, share));
        let (middle, half) = (0.5 * (min + max), 0.5 * (max - min));
        let mut best: Option<([usize; 2], Laid)> = None;
        for (k, (margin, share)) in wider.chain(smaller).enumerate() {
            if best.as_ref().is_some_and(|(bad, _)| bad[1] == 0 || (bad[0] == 0 && share < 1.0)) {
                break;
            }
            let [low, high] = if share < 1.0 { [middle - share * half, middle + share * half] } else { [min, max] };
            let mut values = held.clone();
            values.iter_mut().last().into_iter().for_each(|last| *last = margin);
            let fibres = self.lay(&values, low, high);
            let places: Vec<Vec<bool>> = fibres.iter().map(|fibre| fibre.iter().map(is_in).collect()).collect();
            // Fibres of which nothing is left, and vertices that stick out.
            let gone = places.iter().filter(|places| !places.windows(RUN).any(|run| run.iter().all(|is_in| *is_in)));
            let bad = [gone.count(), places.iter().flatten().filter(|is_in| !**is_in).count()];
            if best.as_ref().is_none_or(|(least, _)| bad < *least) {
                let free = margin * (high - low).min_element();
                let further_in = (k > 0).then_some([low + free, high - free]);
                let outside = places.iter().filter(|places| places.contains(&false)).count();
                best = Some((bad, Laid { fibres, further_in, outside }));
            }
        }
        best.map(|(_, laid)| laid).unwrap_or_default()
    }
}

/// How far particles are from the one that is nearest to each [m], of most of them; none where there are no two.
fn spacing(particles: &[DVec3]) -> Option<f64> {
    let nearest = |k: usize| {
        let others = particles.iter().enumerate().filter(|(other, _)| *other != k);
        others.map(|(_, at)| at.distance_squared(particles[k])).fold(f64::INFINITY, f64::min).sqrt()
    };
    let mut found: Vec<f64> =
        (0..particles.len()).step_by(particles.len().div_ceil(ASKED).max(1)).map(nearest).collect();
    found.sort_by(f64::total_cmp);
    found.get(found.len() / 2).copied().filter(|spacing| spacing.is_finite() && *spacing > 0.0)
}
