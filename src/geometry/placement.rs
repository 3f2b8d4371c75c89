//! A lattice placed in a solid: which of its points lie inside, and which of those others hold.

use super::cell_shares::cell_shares;
use super::filling::Filling;
use super::lattice::LatticeSample;
use super::lattice_fit::FittedLattice;
use super::solid::Solid;
use super::thinness::thinness;
use glam::{DMat3, DVec3, IVec3, Vec3Swizzles};
use rayon::prelude::*;
use std::ops::{ControlFlow, RangeInclusive};

/// Quarters of the spacing by which the lattice is moved along each axis.
const SHIFTS: i32 = 4;

/// Rows through a surface with holes, and winding numbers that are looked at along them, from which on the lattice is
/// moved along them only.
const MANY_OPEN_ROWS: f64 = 3000.0;
const MANY_WINDINGS: f64 = 20_000.0;

/// A lattice: its spacing [m] and the position of one of its points [m].
#[derive(Clone, Copy, Debug)]
pub(crate) struct LatticePlacement {
    /// Spacing [m].
    pub spacing: f64,
    origin: DVec3,
}

/// Lattice points in the boxes around the pieces of a solid: a float, for it may be more than any integer holds.
pub(crate) fn looked_at(solid: &Solid, spacing: f64) -> f64 {
    solid.boxes().map(|[min, max]| ((max - min) / spacing + 1.0).element_product()).sum()
}

fn lattice_at(solid: &Solid, spacing: f64, quarters: [i32; 3]) -> (u32, LatticePlacement) {
    let shift = DVec3::from_array(quarters.map(|q| f64::from(q) / f64::from(SHIFTS)));
    let askew = quarters.iter().filter(|&&q| 2 * q % SHIFTS != 0).count() as u32;
    (askew, LatticePlacement { spacing, origin: 0.5 * (solid.min + solid.max) + spacing * shift })
}

/// Rows of the lattice that come near a solid: runs of layers along y, by the layer along z, in order.
fn rows_near(solid: &Solid, lattice: &LatticePlacement) -> Vec<(i32, Vec<RangeInclusive<i32>>)> {
    let boxes: Vec<[IVec3; 2]> = solid
        .boxes()
        .map(|[min, max]| {
            let [first, last] = [min, max].map(|corner| (corner - lattice.origin) / lattice.spacing);
            [first.floor().as_ivec3(), last.ceil().as_ivec3()]
        })
        .collect();
    let mut layers: Vec<i32> = boxes.iter().flat_map(|[first, last]| first.z..=last.z).collect();
    layers.sort_unstable();
    layers.dedup();
    let runs = |z: i32| {
        let mut runs: Vec<[i32; 2]> =
            boxes.iter().filter(|[first, last]| first.z <= z && z <= last.z).map(|[f, l]| [f.y, l.y]).collect();
        runs.sort_unstable();
        let mut joined: Vec<[i32; 2]> = Vec::new();
        for [from, to] in runs {
            match joined.last_mut() {
                Some(last) if last[1] >= from => last[1] = last[1].max(to),
                _ => joined.push([from, to]),
            }
        }
        joined.into_iter().map(|[from, to]| from..=to).collect()
    };
    layers.into_iter().map(|z| (z, runs(z))).collect()
}

/// Points of a row's stretches, as lattice indices along x.
fn cells_along(stretches: &[[f64; 2]], lattice: &LatticePlacement) -> impl Iterator<Item = RangeInclusive<i32>> {
    let LatticePlacement { spacing, origin } = *lattice;
    stretches.iter().map(move |[from, to]| {
        let at = |cell: i32| origin.x + spacing * f64::from(cell);
        let mut first = ((from - origin.x) / spacing).ceil() as i32;
        let mut last = ((to - origin.x) / spacing).floor() as i32;
        // The position that a particle gets is what counts, to the last bit.
        first += i32::from(at(first) < *from);
        last -= i32::from(at(last) > *to);
        first..=last
    })
}

/// A lattice with how many of its points fall inside, and along how many axes it lies askew.
pub(crate) type Counted = (usize, u32, LatticePlacement);

/// Positions of a lattice of this spacing, and how many rows were looked at.
pub(crate) fn placements(solid: &Solid, spacing: f64) -> (Vec<Counted>, usize) {
    // Rows through a surface with holes cost more: they are tried at half spacings only, or in the middle.
    let rows: f64 = solid.boxes().map(|[min, max]| (max - min) / spacing + 1.0).map(|rows| rows.y * rows.z).sum();
    let (shifts, quarters) = match solid.report.closed {
        true => (SHIFTS, 1),
        false if rows < MANY_OPEN_ROWS && rows * solid.windings_a_row() < MANY_WINDINGS => (SHIFTS / 2, 2),
        false => (1, 0),
    };
    let found: Vec<(Vec<Counted>, usize)> = (0..shifts * shifts)
        .into_par_iter()
        .map(|k| {
            let (y, z) = (quarters * (k % shifts), quarters * (k / shifts));
            let lattices: Vec<_> = (0..SHIFTS).map(|x| lattice_at(solid, spacing, [x, y, z])).collect();
            // Rows are shared by the lattices that differ along x only.
            let origin = lattices[0].1.origin;
            let rows: Vec<(i32, i32)> = rows_near(solid, &lattices[0].1)
                .into_iter()
                .flat_map(|(z, runs)| runs.into_iter().flatten().map(move |y| (y, z)))
                .collect();
            let counts: Vec<[usize; SHIFTS as usize]> = rows
                .par_iter()
                .map(|&(y, z)| {
                    let row = solid.scanline(origin.y + spacing * f64::from(y), origin.z + spacing * f64::from(z));
                    std::array::from_fn(|x| cells_along(&row, &lattices[x].1).map(Iterator::count).sum())
                })
                .collect();
            let count = |x: usize| counts.iter().map(|row| row[x]).sum();
            let lattices = lattices.into_iter().enumerate().map(|(x, (askew, lattice))| (count(x), askew, lattice));
            (lattices.collect(), rows.len())
        })
        .collect();
    let rows = found.iter().map(|(_, rows)| rows).sum();
    (found.into_iter().flat_map(|(found, _)| found).collect(), rows)
}

pub(crate) fn collect(solid: &Solid, lattice: LatticePlacement) -> LatticeSample {
    let LatticePlacement { spacing, origin } = lattice;
    let rows: Vec<Vec<IVec3>> = rows_near(solid, &lattice)
        .into_par_iter()
        .map(|(z, runs)| {
            let mut cells = Vec::new();
            for y in runs.into_iter().flatten() {
                let row = solid.scanline(origin.y + spacing * f64::from(y), origin.z + spacing * f64::from(z));
                cells.extend(cells_along(&row, &lattice).flatten().map(|x| IVec3::new(x, y, z)));
            }
            cells
        })
        .collect();
    let cells: Vec<IVec3> = rows.into_iter().flatten().collect();
    let points = cells.iter().map(|cell| origin + spacing * cell.as_dvec3()).collect();
    LatticeSample { spacing, axes: DMat3::IDENTITY, stretch: DVec3::ONE, points, cells }
}

/// Leaves out points that have hardly any others around them, as at a tip finer than the lattice: nothing could hold
/// them in place.
pub(crate) fn prune(solid: &Solid, mut sample: LatticeSample, reach: f64) -> Filling {
    let before = sample.points.len();
    let (mut found, mut stray) = thinness(&sample.cells, reach);
    // Without the strays others may be strays: at a needle, all of them in turn.
    let mut left_out = Vec::new();
    while stray.iter().any(|&stray| stray) {
        left_out.extend(sample.points.iter().zip(&stray).filter(|(_, stray)| **stray).map(|(&at, _)| at));
        let mut keep = stray.iter().map(|stray| !stray);
        sample.points.retain(|_| keep.next().unwrap_or(true));
        let mut keep = stray.iter().map(|stray| !stray);
        sample.cells.retain(|_| keep.next().unwrap_or(true));
        (found, stray) = thinness(&sample.cells, reach);
    }
    let volume_error = sample.points.len() as f64 * sample.cell_volume() / solid.volume - 1.0;
    let pruned = before - sample.points.len();
    Filling { volume_error, thinness: found, pruned, left_out, shares: None, sample }
}

/// Rows through a surface with holes from which on the parts of its cells are not measured.
const MOST_OPEN_ROWS: usize = 2_000;

/// Faces that are looked at, a row counting as some more, up to which a lattice is looked for that fits a solid's
/// second moments.
const MOST_LOOKS: f64 = 4e6;
const LOOKS_A_ROW: f64 = 8.0;

/// Share of the particles in parts of two layers or fewer from which on no other lattice is looked for: none makes
/// sections right that are so thin.
const THIN: f64 = 0.25;

/// The lattice of a filling.
fn lattice_of(sample: &LatticeSample) -> Option<FittedLattice> {
    let (&point, cell) = (sample.points.first()?, sample.cells.first()?);
    let LatticeSample { spacing, stretch, .. } = *sample;
    Some(FittedLattice { spacing, stretch, origin: point - spacing * (stretch * cell.as_dvec3()) })
}

/// The lattice that fits a solid best, where that is soon found.
fn fitted_to(
    solid: &Solid,
    (spacing, is_thin): (f64, bool),
    progress: &mut dyn FnMut() -> ControlFlow<()>,
) -> ControlFlow<(), Option<FittedLattice>> {
    let looks = FittedLattice::rows_through(solid, spacing) * (LOOKS_A_ROW + solid.faces_a_row());
    if !is_thin && FittedLattice::TRIED * looks < MOST_LOOKS {
        return FittedLattice::to(solid, spacing, progress);
    }
    let is_soon_filled = looks < MOST_LOOKS;
    ControlFlow::Continue(if is_soon_filled { FittedLattice::between_faces(solid, spacing) } else { None })
}

/// A filling with what its particles stand for. With `fits` it may be another one, by a lattice that the solid's faces
/// or its second moments fit, if no more of it is thin. Rows through a surface with holes cost much: it stays as it is,
/// and is only measured where it has few of them. `progress` is asked from time to time whether to go on.
pub(crate) fn with_shares(
    solid: &Solid,
    mut filling: Filling,
    reach: f64,
    fits: Option<f64>,
    progress: &mut dyn FnMut() -> ControlFlow<()>,
) -> ControlFlow<(), Filling> {
    let sample = &filling.sample;
    let rows = sample.cells.chunk_by(|a, b| a.yz() == b.yz()).count();
    if !solid.report.closed && rows > MOST_OPEN_ROWS {
        return ControlFlow::Continue(filling);
    }
    let Some(lattice) = lattice_of(sample) else { return ControlFlow::Continue(filling) };
    progress()?;
    filling.shares = cell_shares(solid, &lattice, &sample.cells);
    let thin = (filling.thinness.single + filling.thinness.double) as f64;
    let is_thin = thin > THIN * sample.points.len() as f64;
    if let (Some(spacing), true, true) = (fits, solid.report.closed, filling.shares.is_some())
        && let Some(fitted) = fitted_to(solid, (spacing, is_thin), progress)?
    {
        progress()?;
        let mut refilled = prune(solid, fitted.collect(solid), reach);
        let is_thinner = refilled.pruned > filling.pruned || refilled.thinness.single > filling.thinness.single;
        if !is_thinner && !refilled.sample.points.is_empty() {
            refilled.shares = cell_shares(solid, &fitted, &refilled.sample.cells);
            filling = refilled;
        }
    }
    if let Some(shares) = &filling.shares {
        let volume = shares.volumes.iter().sum::<f64>() * filling.sample.cell_volume();
        filling.volume_error = volume / solid.volume - 1.0;
    }
    ControlFlow::Continue(filling)
}
