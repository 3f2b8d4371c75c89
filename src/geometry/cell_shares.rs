//! How much of a shape each particle of a lattice in it stands for: one at a surface seldom stands for a whole cell.

use super::lattice_fit::{FittedLattice, OWN_MOMENT, Target};
use super::rows::Rows;
use glam::{DMat3, DVec3, IVec3};
use rayon::prelude::*;
use std::array::from_fn;
use std::collections::HashMap;

/// What particles stand for, in cells.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CellShares {
    /// Volume of the shape that is nearest to each particle; all of them are the shape's.
    pub(crate) volumes: Vec<f64>,
    /// Volume that each counts as when it resists, by which the second moments of the whole are the shape's, too.
    pub(crate) stiffness: Vec<f64>,
}

/// Rows through a cell along y and z, each, and where there are so many particles that each weighs little.
const ROWS: i32 = 6;
const FEW_ROWS: i32 = 2;
const MANY: usize = 60_000;

/// A share that is nearer to one is one.
const WHOLE: f64 = 1e-9;

/// Least and greatest share in the stiffness.
const BOUNDS: [f64; 2] = [0.15, 2.5];

/// Rounds in which shares are brought to the moments, since the bounds are in the way.
const ROUNDS: usize = 4;

/// How far off a volume without a particle may be taken over, in spacings.
const REACH: i32 = 2;

/// The shares of the particles in these cells of a lattice in a shape; none where each stands for a whole cell.
pub(crate) fn cell_shares(shape: &dyn Rows, lattice: &FittedLattice, cells: &[IVec3]) -> Option<CellShares> {
    let numbers: HashMap<IVec3, usize> = cells.iter().enumerate().map(|(i, &cell)| (cell, i)).collect();
    let mut volumes = vec![0.0; cells.len()];
    let spacings = lattice.spacings();
    let is_large = cells.len() > MANY;
    for (cell, volume) in filled_cells(shape, lattice, if is_large { FEW_ROWS } else { ROWS }) {
        if let Some(&i) = numbers.get(&cell) {
            volumes[i] += volume;
        } else {
            let nearest = nearest(cell, &numbers, spacings);
            for &i in &nearest {
                volumes[i] += volume / nearest.len() as f64;
            }
        }
    }
    for volume in &mut volumes {
        if (*volume - 1.0).abs() < WHOLE {
            *volume = 1.0;
        }
    }
    if volumes.iter().all(|volume| *volume == 1.0) {
        return None;
    }
    scale_parts(&mut volumes, shape.volume() / spacings.element_product());
    let stiffness = if is_large { volumes.clone() } else { fitted(shape, lattice, cells, &volumes) };
    Some(CellShares { volumes, stiffness })
}

/// What rows may miss of the parts of cells, at most: more of it is no error of theirs.
const MISSED: f64 = 0.2;

/// Brings the parts of cells to where all volumes add up to the whole.
fn scale_parts(volumes: &mut [f64], whole: f64) {
    let is_part = |volume: &f64| *volume != 1.0;
    let parts: f64 = volumes.iter().filter(|volume| is_part(volume)).sum();
    let full = volumes.iter().filter(|volume| !is_part(volume)).count() as f64;
    let scale = (whole - full) / parts;
    if (scale - 1.0).abs() < MISSED {
        volumes.iter_mut().filter(|volume| is_part(volume)).for_each(|volume| *volume *= scale);
    }
}

/// By how much each cell is filled, of those that are, in order, by so many rows along y and z through each.
fn filled_cells(shape: &dyn Rows, lattice: &FittedLattice, through: i32) -> Vec<(IVec3, f64)> {
    let [min, max] = shape.bounds();
    let (spacings, origin) = (lattice.spacings(), lattice.origin);
    let first = ((min - origin) / spacings).round().as_ivec3();
    let last = ((max - origin) / spacings).round().as_ivec3();
    let rows: Vec<(i32, i32)> = (first.z..=last.z).flat_map(|z| (first.y..=last.y).map(move |y| (y, z))).collect();
    let each = f64::from(through * through).recip();
    let of_row = |&(y, z): &(i32, i32)| {
        let mut filled = vec![0.0; (last.x - first.x + 1) as usize];
        for k in 0..through * through {
            let within = |k: i32| (f64::from(k) + 0.5) / f64::from(through) - 0.5;
            let at = |axis: usize, cell: i32, k: i32| origin[axis] + spacings[axis] * (f64::from(cell) + within(k));
            for [from, to] in shape.row(at(1, y, k % through), at(2, z, k / through)) {
                // In cells, from the lower end of the first.
                let along = |x: f64| (x - origin.x) / spacings.x + 0.5 - f64::from(first.x);
                let [from, to] = [along(from), along(to)];
                let (begin, end) = (from.floor().max(0.0) as usize, (to.ceil() as usize).min(filled.len()));
                for (cell, filled) in filled.iter_mut().enumerate().take(end).skip(begin) {
                    let cell = cell as f64;
                    *filled += each * (to.min(cell + 1.0) - from.max(cell)).max(0.0);
                }
            }
        }
        let cells = (first.x..).zip(filled).filter(|(_, filled)| *filled > 0.0);
        cells.map(|(x, filled)| (IVec3::new(x, y, z), filled)).collect()
    };
    let rows: Vec<Vec<(IVec3, f64)>> = rows.par_iter().map(of_row).collect();
    rows.into_iter().flatten().collect()
}

/// The particles that lie nearest to a cell without one.
fn nearest(cell: IVec3, numbers: &HashMap<IVec3, usize>, spacings: DVec3) -> Vec<usize> {
    let mut least = f64::INFINITY;
    let mut found = Vec::new();
    let along = || -REACH..=REACH;
    for step in along().flat_map(|z| along().flat_map(move |y| along().map(move |x| IVec3::new(x, y, z)))) {
        let Some(&i) = numbers.get(&(cell + step)) else { continue };
        let distance = (spacings * step.as_dvec3()).length();
        if distance < least * (1.0 - 1e-9) {
            least = distance;
            found.clear();
        }
        if distance < least * (1.0 + 1e-9) {
            found.push(i);
        }
    }
    found
}

/// Numbers by which a share may differ from the volume: 1, x, y, z, xx, yy, zz, xy, yz, zx.
const TERMS: usize = 10;

/// Shares near the volumes by which volume, centre and second moments are the shape's.
fn fitted(shape: &dyn Rows, lattice: &FittedLattice, cells: &[IVec3], volumes: &[f64]) -> Vec<f64> {
    let spacings = lattice.spacings();
    let [min, max] = shape.bounds();
    let center = 0.5 * (min + max);
    let Target { to_unit, gravity, .. } = Target::of(shape, center);
    let own = to_unit * DMat3::from_diagonal(OWN_MOMENT * spacings * spacings) * to_unit.transpose();
    let terms: Vec<[f64; TERMS]> = cells
        .iter()
        .map(|cell| {
            let DVec3 { x, y, z } = to_unit * (lattice.origin - center - gravity + spacings * cell.as_dvec3());
            let (own, mixed) = (
                DVec3::new(own.x_axis.x, own.y_axis.y, own.z_axis.z),
                DVec3::new(own.x_axis.y, own.y_axis.z, own.z_axis.x),
            );
            [
                1.0,
                x,
                y,
                z,
                x * x + own.x,
                y * y + own.y,
                z * z + own.z,
                x * y + mixed.x,
                y * z + mixed.y,
                z * x + mixed.z,
            ]
        })
        .collect();
    let whole = volumes.iter().sum::<f64>();
    let target: [f64; TERMS] = [1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0].map(|of| of * whole);
    let mut shares: Vec<f64> = volumes.to_vec();
    for _ in 0..ROUNDS {
        let mut gram = [[0.0; TERMS]; TERMS];
        let mut missing = target;
        for (share, terms) in shares.iter().zip(&terms) {
            for (row, a) in gram.iter_mut().zip(terms) {
                for (entry, b) in row.iter_mut().zip(terms) {
                    *entry += share * a * b;
                }
            }
            for (missing, term) in missing.iter_mut().zip(terms) {
                *missing -= share * term;
            }
        }
        let by = solved(gram, missing);
        for (share, terms) in shares.iter_mut().zip(&terms) {
            let change: f64 = by.iter().zip(terms).map(|(by, term)| by * term).sum();
            *share = (*share * (1.0 + change)).clamp(BOUNDS[0], BOUNDS[1]);
        }
    }
    shares
}

/// Keeps what the particles cannot tell apart, as two layers cannot a square from a constant, from having a part.
const RIDGE: f64 = 1e-6;

/// Solves a symmetric, positive system by its factor.
fn solved(mut a: [[f64; TERMS]; TERMS], mut b: [f64; TERMS]) -> [f64; TERMS] {
    for k in 0..TERMS {
        a[k][k] *= 1.0 + RIDGE;
    }
    for k in 0..TERMS {
        for j in 0..k {
            let dot: f64 = (0..j).map(|l| a[k][l] * a[j][l]).sum();
            a[k][j] = (a[k][j] - dot) / a[j][j];
        }
        let squares: f64 = a[k][..k].iter().map(|x| x * x).sum();
        a[k][k] = (a[k][k] - squares).max(f64::MIN_POSITIVE).sqrt();
    }
    for k in 0..TERMS {
        b[k] = (b[k] - (0..k).map(|j| a[k][j] * b[j]).sum::<f64>()) / a[k][k];
    }
    for k in (0..TERMS).rev() {
        b[k] = (b[k] - (k + 1..TERMS).map(|j| a[j][k] * b[j]).sum::<f64>()) / a[k][k];
    }
    b
}

impl CellShares {
    /// Those of the particles that are kept.
    pub(crate) fn chosen(&self, kept: &[u32]) -> Self {
        let of = |shares: &[f64]| kept.iter().map(|&i| shares[i as usize]).collect();
        Self { volumes: of(&self.volumes), stiffness: of(&self.stiffness) }
    }

    /// Least and greatest volume.
    pub(crate) fn range(&self) -> [f64; 2] {
        let volumes = || self.volumes.iter().copied();
        from_fn(|k| if k == 0 { volumes().fold(f64::INFINITY, f64::min) } else { volumes().fold(0.0, f64::max) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::rows::AskewBox;
    use std::ops::ControlFlow;

    fn fitted_to(size: DVec3, axes: DMat3) -> (AskewBox, FittedLattice, Vec<IVec3>) {
        let shape = AskewBox::new(&Cuboid { center: DVec3::ZERO, size }, axes);
        let ControlFlow::Continue(Some(lattice)) = FittedLattice::to(&shape, 1.0, &mut || ControlFlow::Continue(()))
        else {
            panic!("a small one")
        };
        let cells = lattice.collect(&shape).cells;
        (shape, lattice, cells)
    }

    #[test]
    fn a_box_along_the_lattice_has_whole_particles_whatever_its_size() {
        for size in [DVec3::new(3.0, 4.0, 12.0), DVec3::new(3.25, 4.5, 20.7), DVec3::new(2.5, 5.75, 9.1)] {
            let (shape, lattice, cells) = fitted_to(size, DMat3::IDENTITY);
            assert_eq!(cell_shares(&shape, &lattice, &cells), None, "{size}");
            let volume = cells.len() as f64 * lattice.spacings().element_product();
            assert!((volume / size.element_product() - 1.0).abs() < 1e-12, "{size}: {volume}");
        }
    }

    #[test]
    fn a_turned_box_has_its_volume_and_second_moments() {
        for (n, size) in [3.0, 3.25, 3.5, 4.25, 5.75].into_iter().enumerate() {
            for degrees in [15.0_f64, 22.5, 30.0, 45.0] {
                let size = DVec3::new(size, size, 20.0);
                let axes = [DMat3::from_rotation_z, DMat3::from_rotation_x][n % 2](degrees.to_radians());
                let (shape, lattice, cells) = fitted_to(size, axes);
                let shares = cell_shares(&shape, &lattice, &cells).expect("parts of cells");
                let spacings = lattice.spacings();
                let at = |cell: &IVec3| axes * (lattice.origin + spacings * cell.as_dvec3());
                let cell = spacings.element_product();
                let own = axes * DMat3::from_diagonal(OWN_MOMENT * spacings * spacings) * axes.transpose();
                for (what, shares, within) in [("volume", &shares.volumes, 0.2), ("stiffness", &shares.stiffness, 0.02)]
                {
                    let volume = cell * shares.iter().sum::<f64>();
                    assert!((volume / size.element_product() - 1.0).abs() < 0.02, "{degrees}, {size}: {what} {volume}");
                    for k in 0..2 {
                        let each =
                            cells.iter().zip(shares).map(|(cell, share)| share * (at(cell)[k].powi(2) + own.col(k)[k]));
                        let ratio = cell * each.sum::<f64>() / (size.element_product() * size.x * size.x / 12.0);
                        assert!((ratio - 1.0).abs() < within, "{degrees}, {size}, {what}, axis {k}: {ratio}");
                    }
                }
            }
        }
    }
}
