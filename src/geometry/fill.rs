//! Filling a solid with particles: the lattice is placed, and its spacing changed a little, so that the particles'
//! volume comes closest to the solid's; where its faces are flat, between two layers ([`super::lattice_fit`]).
//!
//! A section three or four spacings wide holds 0.88 to 1.18 of its area depending on where the lattice falls. Geometry
//! dominates every other error there, so the search is worth its time.

use super::filling::{Filling, KnownFilling};
use super::placement::{LatticePlacement, collect, looked_at, placements, prune, with_shares};
use super::progress::Progress;
use super::solid::Solid;
use super::two_layers::{BOX_SHARE, FINER_TRIES, two_layer_spacing};
use std::ops::ControlFlow;
use thiserror::Error;

/// How fine to fill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FillResolution {
    /// Spacing of the lattice [m], kept to a few per cent.
    Spacing(f64),
    /// Number of particles, from which the spacing follows.
    Particles(u32),
}

/// A solid that cannot be filled as asked.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum FillError {
    /// It was no longer wanted: whoever heard how far it had come broke it off.
    #[error("the filling was stopped")]
    Cancelled,
    /// More particles than are allowed, or more lattice points to look at than is sensible.
    #[error("about {wanted:.1e} lattice points would be needed where {limit:.1e} are allowed")]
    TooMany {
        /// Number of lattice points.
        wanted: f64,
        /// Greatest number.
        limit: f64,
    },
    /// Its pieces lie further apart than lattice points can be counted.
    #[error(
        "its parts lie {layers:.1e} layers of particles apart; take away what is far from the rest, or use larger particles"
    )]
    TooFarApart {
        /// Layers of the lattice along its greatest extent.
        layers: f64,
    },
    /// The solid, or much of it, is thinner than two layers.
    #[error(
        "{flat} of {total} lattice points inside have too few others around them at a spacing of {spacing:.3e} m{}",
        two_layers(*.suggested)
    )]
    TooThin {
        /// Points that nothing could hold in place.
        flat: usize,
        /// Points inside.
        total: usize,
        /// Spacing [m].
        spacing: f64,
        /// Spacing at which every part has two layers or nearly so [m]; none where that would take too many particles.
        suggested: Option<f64>,
    },
}

fn two_layers(suggested: Option<f64>) -> String {
    suggested.map_or_else(String::new, |spacing| format!("; {spacing:.3e} m gives two layers"))
}

/// Least and greatest change of the spacing that is tried, and by how much they are stepped through.
const STEPS: i32 = 6;
const STEP: f64 = 0.005;

/// Cost of a per cent of change in spacing, in per cent of error in volume: a spacing that was asked for is left
/// alone unless the gain is clear.
const CHANGE: f64 = 0.5;

/// Cost of a lattice that does not lie symmetrically to the solid's extents.
const ASKEW: f64 = 5e-4;

/// Cost below which the search ends, for a closed surface and for one with holes.
const GOOD: f64 = 1.5e-3;
const GOOD_ENOUGH: f64 = 1e-2;

/// Candidates whose thin parts are compared, for a closed surface and for one with holes.
const FINALISTS: usize = 6;
const OPEN_FINALISTS: usize = 2;

/// Weight of the share of particles in single layers.
const THIN: f64 = 1.0;

/// Layers of the lattice along the extent of a solid, at most: so many can be counted with room to spare.
const MOST_LAYERS: f64 = 1e8;

/// Share of the points inside that may be left out at tips.
const MOST_PRUNED: f64 = 0.05;

/// Rows after which no further spacing is tried, for a closed surface and for one with holes, of which each takes far
/// longer; and faces that were looked at, a row and a winding number counting as so many.
const MOST_ROWS: usize = 1_000_000;
const MOST_LOOKS: f64 = 16e6;
const LOOKS_A_ROW: f64 = 8.0;
const LOOKS_A_WINDING: f64 = 200.0;
const MOST_OPEN_ROWS: usize = 20_000;

/// Fills a solid with at most `limit` particles. `reach` is the support radius over the spacing, h / D: it decides
/// which particles hold each other.
///
/// # Errors
/// [`FillError`].
pub fn fill(solid: &Solid, resolution: FillResolution, reach: f64, limit: usize) -> Result<Filling, FillError> {
    fill_with_progress(solid, resolution, reach, limit, &mut |_, _| ControlFlow::Continue(()))
}

/// Lattices that may be tried: at every spacing, those that come to the final, and those of two layers.
const LATTICES: usize = 2 * STEPS as usize + 1 + FINALISTS + FINER_TRIES as usize;

/// How many of them were tried.
struct Tried<'a, 'b> {
    done: usize,
    progress: &'a mut Progress<'b>,
}

impl Tried<'_, '_> {
    fn tell(&mut self) -> ControlFlow<()> {
        (self.progress)(self.done.min(LATTICES), LATTICES)
    }

    /// So many were, or need not be.
    fn reach(&mut self, done: usize) -> Result<(), FillError> {
        self.done = done;
        if self.tell().is_break() { Err(FillError::Cancelled) } else { Ok(()) }
    }
}

/// [`fill`], and `progress` hears how far it has come.
///
/// # Errors
/// [`FillError`]; [`FillError::Cancelled`] where `progress` broke off, which is not asked again then.
pub(crate) fn fill_with_progress(
    solid: &Solid,
    resolution: FillResolution,
    reach: f64,
    limit: usize,
    progress: &mut Progress<'_>,
) -> Result<Filling, FillError> {
    if let Some(known) = known(solid, resolution, reach, limit) {
        return match progress(LATTICES, LATTICES) {
            ControlFlow::Continue(()) => Ok(known.clone()),
            ControlFlow::Break(()) => Err(FillError::Cancelled),
        };
    }
    let spacing = match resolution {
        FillResolution::Spacing(spacing) => spacing,
        FillResolution::Particles(count) => (solid.volume / f64::from(count.max(1))).cbrt(),
    };
    let limit = limit as f64;
    check_size(solid, spacing, limit)?;
    let mut tried = Tried { done: 0, progress };
    let candidates = candidates(solid, resolution, spacing, &mut tried)?;
    match best(solid, &candidates, reach, &mut tried)? {
        Some(filling) if !is_flat(&filling) => {
            tried.reach(LATTICES)?;
            let fits = match resolution {
                FillResolution::Spacing(spacing) => Some(spacing),
                // As many as were asked for.
                FillResolution::Particles(_) => None,
            };
            match with_shares(solid, filling, reach, fits, &mut || tried.tell()) {
                ControlFlow::Continue(filling) => Ok(filling),
                ControlFlow::Break(()) => Err(FillError::Cancelled),
            }
        }
        best => {
            let (flat, total) = best.map_or((0, 0), |found| (found.pruned, found.pruned + found.sample.points.len()));
            let mut one_more = || {
                tried.done += 1;
                tried.tell()
            };
            match two_layer_spacing(solid, spacing, reach, limit, &mut one_more) {
                ControlFlow::Continue(suggested) => Err(FillError::TooThin { flat, total, spacing, suggested }),
                ControlFlow::Break(()) => Err(FillError::Cancelled),
            }
        }
    }
}

/// The filling that was found while it was looked how finely a solid is filled, where the same is asked for.
fn known(solid: &Solid, resolution: FillResolution, reach: f64, limit: usize) -> Option<&Filling> {
    let known = solid.known_filling.get()?;
    let is_same =
        resolution == FillResolution::Particles(known.particles) && (known.reach, known.limit) == (reach, limit);
    is_same.then_some(&known.filling)
}

/// [`fill_with_progress`] with so many particles, kept with the solid for whoever asks for the same, and what is wrong
/// where it cannot be filled so.
///
/// # Errors
/// As [`fill_with_progress`].
pub(crate) fn try_filling(
    solid: &Solid,
    (particles, reach, limit): (u32, f64, usize),
    progress: &mut Progress<'_>,
) -> Result<(), FillError> {
    let filling = fill_with_progress(solid, FillResolution::Particles(particles), reach, limit, progress)?;
    solid.known_filling.get_or_init(|| KnownFilling { particles, reach, limit, filling });
    Ok(())
}

/// Whether there are few enough lattice points to be looked at.
fn check_size(solid: &Solid, spacing: f64, limit: f64) -> Result<(), FillError> {
    let particles = solid.volume / spacing.powi(3);
    let in_boxes = looked_at(solid, spacing);
    for (wanted, limit) in [(particles, limit), (in_boxes, BOX_SHARE * limit)] {
        if wanted.is_nan() || wanted > limit {
            return Err(FillError::TooMany { wanted, limit });
        }
    }
    let layers = (solid.max - solid.min).max_element() / spacing;
    if layers > MOST_LAYERS { Err(FillError::TooFarApart { layers }) } else { Ok(()) }
}

/// Lattices by what speaks against each, the best first.
fn candidates(
    solid: &Solid,
    resolution: FillResolution,
    spacing: f64,
    tried: &mut Tried<'_, '_>,
) -> Result<Vec<(f64, LatticePlacement)>, FillError> {
    let cost = |count: usize, lattice: &LatticePlacement| {
        let volume_error = count as f64 * lattice.spacing.powi(3) / solid.volume - 1.0;
        let off = match resolution {
            FillResolution::Spacing(spacing) => CHANGE * (lattice.spacing / spacing - 1.0),
            FillResolution::Particles(wanted) => count as f64 / f64::from(wanted) - 1.0,
        };
        volume_error.abs() + off.abs()
    };
    let mut candidates: Vec<(f64, LatticePlacement)> = Vec::new();
    let mut rows = 0;
    let (good, most_rows) = if solid.report.closed { (GOOD, MOST_ROWS) } else { (GOOD_ENOUGH, MOST_OPEN_ROWS) };
    let looks_a_row = LOOKS_A_ROW + solid.faces_a_row() + LOOKS_A_WINDING * solid.windings_a_row();
    for k in 0..=2 * STEPS {
        tried.reach(k as usize)?;
        // 0, +1, -1, +2, -2, ... steps away.
        let steps = if k % 2 == 0 { -(k / 2) } else { k / 2 + 1 };
        let (found, looked_through) = placements(solid, spacing * (1.0 + STEP * f64::from(steps)));
        rows += looked_through;
        candidates.extend(
            found
                .into_iter()
                .filter(|(count, ..)| *count > 0)
                .map(|(count, askew, lattice)| (cost(count, &lattice) + ASKEW * f64::from(askew), lattice)),
        );
        let is_enough = rows > most_rows || rows as f64 * looks_a_row > MOST_LOOKS;
        if is_enough || candidates.iter().any(|(cost, _)| *cost < good) {
            break;
        }
    }
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(candidates)
}

/// Of the first candidates the one whose particles lie least in thin parts; none where all of them lose every particle.
fn best(
    solid: &Solid,
    candidates: &[(f64, LatticePlacement)],
    reach: f64,
    tried: &mut Tried<'_, '_>,
) -> Result<Option<Filling>, FillError> {
    let finalists = if solid.report.closed { FINALISTS } else { OPEN_FINALISTS };
    let mut best: Option<(f64, Filling)> = None;
    for (k, &(cost, lattice)) in candidates.iter().take(finalists).enumerate() {
        tried.reach(2 * STEPS as usize + 1 + k)?;
        let filling = prune(solid, collect(solid, lattice), reach);
        let thin = filling.thinness.single + filling.pruned;
        let count = filling.sample.points.len();
        let cost = cost + THIN * thin as f64 / count.max(1) as f64;
        if count > 0 && best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, filling));
        }
        // The rest would cost more in volume alone.
        if thin == 0 {
            break;
        }
    }
    // What the final did not take.
    tried.done = LATTICES - FINER_TRIES as usize;
    Ok(best.map(|(_, filling)| filling))
}

/// Whether so many points had to be left out that the shape is no longer there.
fn is_flat(filling: &Filling) -> bool {
    let total = filling.pruned + filling.sample.points.len();
    filling.sample.points.is_empty() || filling.pruned as f64 > MOST_PRUNED * total as f64
}
