//! The spacing at which every part of a solid has two layers of particles.

use super::placement::{collect, looked_at, placements, prune};
use super::solid::Solid;
use std::ops::ControlFlow;

/// Lattice points of the bounding box that are looked at for one particle that is allowed, at most.
pub(crate) const BOX_SHARE: f64 = 50.0;

/// Share of the particles that may lie in single layers without a word: rims and tips.
pub(crate) const FEW: f64 = 0.01;

/// Steps in which finer spacings are tried, how many, and the particles up to which they are.
const FINER: f64 = 0.9;
pub(crate) const FINER_TRIES: i32 = 6;
const TRIED: f64 = 60_000.0;

/// The spacing that the solid's thickness asks for, and the first of ever finer ones at which hardly a particle lies in
/// a single layer, as far as that is soon found out; none if it would take more than `limit` particles. `progress` is
/// asked before each whether to go on.
pub(crate) fn two_layer_spacing(
    solid: &Solid,
    spacing: f64,
    reach: f64,
    limit: f64,
    progress: &mut dyn FnMut() -> ControlFlow<()>,
) -> ControlFlow<(), Option<f64>> {
    progress()?;
    let thin = solid.thickness().of_all_but(FEW).map_or(spacing, |thickness| 0.5 * thickness);
    let first = thin.min(FINER * spacing);
    let particles = |spacing: f64| solid.volume / spacing.powi(3);
    let affordable = |spacing: &f64| particles(*spacing) <= limit && looked_at(solid, *spacing) <= BOX_SHARE * limit;
    let finer = (0..FINER_TRIES).map(|k| first * FINER.powi(k)).take_while(affordable);
    let mut last = None;
    for spacing in finer {
        last = Some(spacing);
        if particles(spacing) > TRIED {
            break;
        }
        progress()?;
        let (lattices, _) = placements(solid, spacing);
        let error = |count: usize| (count as f64 * spacing.powi(3) / solid.volume - 1.0).abs();
        let best = lattices.into_iter().min_by(|a, b| error(a.0).total_cmp(&error(b.0)));
        let does = best.is_some_and(|(_, _, lattice)| {
            let filling = prune(solid, collect(solid, lattice), reach);
            let thin = filling.pruned + filling.thinness.single;
            !filling.sample.points.is_empty() && thin as f64 <= FEW * filling.sample.points.len() as f64
        });
        if does {
            break;
        }
    }
    ControlFlow::Continue(last)
}
