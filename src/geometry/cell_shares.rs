//! How much of a shape each particle of a lattice in it stands for: one at a surface seldom stands for a whole cell.

use super::cell_map::CellMap;
use super::filling::CellShares;
use super::lattice_fit::{FittedLattice, OWN_MOMENT, Target};
use super::moments::Moments;
use super::scanlines::Scanlines;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use glam::{DMat3, DVec3, IVec3};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Rows through an eighth of a cell, the others being their images, and where there are so many particles that each
/// weighs little, or that more faces than this would have to be looked at.
const ROWS: usize = 5;
const FEW_ROWS: usize = 1;
const MANY: usize = 60_000;
const MOST_LOOKS: f64 = 16e6;

/// A share that is nearer to one is one.
const WHOLE: f64 = 1e-9;

/// Least and greatest share in the stiffness.
const BOUNDS: [f64; 2] = [0.15, 2.5];

/// Rounds in which shares are brought to the moments, since the bounds are in the way.
const ROUNDS: usize = 4;

/// How far off a volume without a particle may be taken over, in spacings.
const REACH: i32 = 2;

/// The shares of the particles in these cells of a lattice in a shape; none where each stands for a whole cell.
pub(crate) fn cell_shares(shape: &dyn Scanlines, lattice: &FittedLattice, cells: &[IVec3]) -> Option<CellShares> {
    let is_large = cells.len() > MANY;
    let Pieces { all, whole, lost } = Pieces::of(shape, lattice, cells, is_large);
    let cell = lattice.spacings().element_product();
    let mut volumes = vec![0.0; cells.len()];
    for (i, volume) in all {
        volumes[i] += volume / cell;
    }
    for volume in &mut volumes {
        if (*volume - 1.0).abs() < WHOLE {
            *volume = 1.0;
        }
    }
    if volumes.iter().all(|volume| *volume == 1.0) {
        return None;
    }
    scale_parts(&mut volumes, shape.volume() / cell, lost / cell);
    let stiffness = if is_large { within_bounds(&volumes) } else { fitted(lattice, cells, &volumes, &whole) };
    Some(CellShares { volumes, stiffness })
}

/// What rows may miss of the parts of cells, at most: more of it is no error of theirs.
const MISSED: f64 = 0.2;

/// Brings the parts of cells to where all volumes add up to the whole, but for what is too far from any particle.
fn scale_parts(volumes: &mut [f64], whole: f64, lost: f64) {
    let is_part = |volume: &f64| *volume != 1.0;
    let parts: f64 = volumes.iter().filter(|volume| is_part(volume)).sum();
    let full = volumes.iter().filter(|volume| !is_part(volume)).count() as f64;
    let scale = (whole - full) / (parts + lost);
    if (scale - 1.0).abs() < MISSED {
        volumes.iter_mut().filter(|volume| is_part(volume)).for_each(|volume| *volume *= scale);
    }
}

fn within_bounds(volumes: &[f64]) -> Vec<f64> {
    volumes.iter().map(|volume| volume.clamp(BOUNDS[0], BOUNDS[1])).collect()
}

/// What particles stand for, piece by piece: of their own cells and of those without a particle.
struct Pieces {
    /// Particles and volumes [m³].
    all: Vec<(usize, f64)>,
    /// All of these, about the lattice's origin.
    whole: Moments,
    /// Volume that is too far from any particle [m³].
    lost: f64,
}

impl Pieces {
    const NONE: Self = Self { all: Vec::new(), whole: Moments::NONE, lost: 0.0 };

    /// By rows through each cell.
    fn of(shape: &dyn Scanlines, lattice: &FittedLattice, cells: &[IVec3], is_large: bool) -> Self {
        let numbers: CellMap<usize> = cells.iter().enumerate().map(|(i, &cell)| (cell, i)).collect();
        let (spacings, origin) = (lattice.spacings(), lattice.origin);
        let rows = rows_near(shape, lattice, cells);
        let is_dear = (rows.len() * 8 * ROWS) as f64 * shape.looks_a_row() > MOST_LOOKS;
        let within = places_within(if is_large || is_dear { FEW_ROWS } else { ROWS });
        let section = spacings.y * spacings.z / within.len() as f64;
        let steps = steps_within_reach(spacings);
        let of_row = |&[y, z]: &[i32; 2]| {
            let along = |x: f64| (x - origin.x) / spacings.x;
            let crossed: Vec<([f64; 2], Vec<[f64; 2]>)> = within
                .iter()
                .map(|place| [spacings.y * (f64::from(y) + place[0]), spacings.z * (f64::from(z) + place[1])])
                .map(|across| (across, shape.row(origin.y + across[0], origin.z + across[1])))
                .map(|(across, row)| (across, row.into_iter().map(|ends| ends.map(along)).collect()))
                .collect();
            let mut row = Row::of(crossed.iter().flat_map(|(_, row)| row));
            for (across, stretches) in crossed {
                for [from, to] in stretches {
                    for x in (from + 0.5).floor() as i32..(to + 0.5).ceil() as i32 {
                        let ends = [from.max(f64::from(x) - 0.5), to.min(f64::from(x) + 0.5)];
                        row.cell(x).add_stretch(ends.map(|end| spacings.x * end), across, section);
                    }
                }
            }
            let mut found = Self::NONE;
            for (x, moments) in row.cells().filter(|(_, moments)| moments.volume > 0.0) {
                let cell = IVec3::new(x, y, z);
                let nearest = numbers.get(&cell).map_or_else(|| nearest(cell, &numbers, &steps), |&i| vec![i]);
                if nearest.is_empty() {
                    found.lost += moments.volume;
                } else {
                    found.whole.add(&moments);
                    let each = moments.volume / nearest.len() as f64;
                    found.all.extend(nearest.into_iter().map(|i| (i, each)));
                }
            }
            found
        };
        let rows: Vec<Self> = rows.par_iter().map(of_row).collect();
        rows.into_iter().fold(Self::NONE, |mut sum, of| {
            sum.all.extend(of.all);
            sum.whole.add(&of.whole);
            sum.lost += of.lost;
            sum
        })
    }
}

/// What lies in the cells of a row: side by side, or one by one where most of them are empty.
enum Row {
    Table(i32, Vec<Moments>),
    Sorted(BTreeMap<i32, Moments>),
}

/// Cells for each stretch of a row that have room in a table, and some more.
const ROOM: [i64; 2] = [16, 256];

impl Row {
    /// Room for stretches, in cells from the origin.
    fn of<'a>(stretches: impl Iterator<Item = &'a [f64; 2]>) -> Self {
        let (mut count, mut first, mut last) = (0, i32::MAX, i32::MIN);
        for [from, to] in stretches {
            count += 1;
            first = first.min((from + 0.5).floor() as i32);
            last = last.max((to + 0.5).ceil() as i32);
        }
        let length = i64::from(last) - i64::from(first);
        if length <= ROOM[0] * count + ROOM[1] {
            Self::Table(first, vec![Moments::NONE; length.max(0) as usize])
        } else {
            Self::Sorted(BTreeMap::new())
        }
    }

    fn cell(&mut self, x: i32) -> &mut Moments {
        match self {
            Self::Table(first, cells) => &mut cells[(x - *first) as usize],
            Self::Sorted(cells) => cells.entry(x).or_insert(Moments::NONE),
        }
    }

    /// All of them, in order.
    fn cells(self) -> Box<dyn Iterator<Item = (i32, Moments)>> {
        match self {
            Self::Table(first, cells) => {
                Box::new((0_i32..).zip(cells).map(move |(k, cell)| (first.wrapping_add(k), cell)))
            }
            Self::Sorted(cells) => Box::new(cells.into_iter()),
        }
    }
}

/// Places in the section of a cell, from -1/2 to 1/2, as many to the left as to the right, below and above, and
/// alike along both, so that what a shape is alike on all sides its parts are; evenly along each of the two, and none
/// on the diagonals, along which faces may lie.
fn places_within(eighth: usize) -> Vec<[f64; 2]> {
    let place = |k: usize| [k as f64 + 0.25, ((2 * k + 1) % eighth) as f64 + 0.75].map(|of| 0.5 * of / eighth as f64);
    let folded = (0..eighth).map(place).flat_map(|[a, b]| [[a, b], [b, a]]);
    folded.flat_map(|[a, b]| [[a, b], [-a, b], [a, -b], [-a, -b]]).collect()
}

/// Indices along y and z of the rows of cells with particles and those within reach of them, as far as the shape goes.
fn rows_near(shape: &dyn Scanlines, lattice: &FittedLattice, cells: &[IVec3]) -> Vec<[i32; 2]> {
    let [first, last] =
        shape.bounds().map(|corner| ((corner - lattice.origin) / lattice.spacings()).round().as_ivec3());
    let mut rows: Vec<[i32; 2]> = cells.iter().map(|cell| [cell.z, cell.y]).collect();
    rows.dedup();
    let mut near = BTreeSet::new();
    for [z, y] in rows {
        for z in (z - REACH).max(first.z)..=(z + REACH).min(last.z) {
            near.extend(((y - REACH).max(first.y)..=(y + REACH).min(last.y)).map(|y| [z, y]));
        }
    }
    near.into_iter().map(|[z, y]| [y, z]).collect()
}

/// Steps to the cells within reach of one, the nearest first, with their lengths [m].
fn steps_within_reach(spacings: DVec3) -> Vec<(f64, IVec3)> {
    let along = || -REACH..=REACH;
    let steps = along().flat_map(|z| along().flat_map(move |y| along().map(move |x| IVec3::new(x, y, z))));
    let mut steps: Vec<(f64, IVec3)> = steps.map(|step| ((spacings * step.as_dvec3()).length(), step)).collect();
    steps.sort_by(|a, b| a.0.total_cmp(&b.0));
    steps
}

/// The particles that lie nearest to a cell without one.
fn nearest(cell: IVec3, numbers: &CellMap<usize>, steps: &[(f64, IVec3)]) -> Vec<usize> {
    let mut least = f64::INFINITY;
    let mut found = Vec::new();
    for &(distance, step) in steps {
        if distance >= least * (1.0 + 1e-9) {
            break;
        }
        if let Some(&i) = numbers.get(&(cell + step)) {
            least = least.min(distance);
            found.push(i);
        }
    }
    found
}

/// Numbers by which a share may differ from the volume: 1, x, y, z, xx, yy, zz, xy, yz, zx.
const TERMS: usize = 10;

/// Shares near the volumes by which volume, centre and second moments are those of `whole`, which are taken about the
/// lattice's origin.
fn fitted(lattice: &FittedLattice, cells: &[IVec3], volumes: &[f64], whole: &Moments) -> Vec<f64> {
    let spacings = lattice.spacings();
    let Target { to_unit, gravity, .. } = Target::from_moments(whole);
    let own = to_unit * DMat3::from_diagonal(OWN_MOMENT * spacings * spacings) * to_unit.transpose();
    let terms: Vec<[f64; TERMS]> = cells
        .iter()
        .map(|cell| {
            let DVec3 { x, y, z } = to_unit * (spacings * cell.as_dvec3() - gravity);
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
    let mut shares = volumes.to_vec();
    for _ in 0..ROUNDS {
        let mut gram = Mat::<f64>::zeros(TERMS, TERMS);
        let mut missing = Mat::from_fn(TERMS, 1, |row, _| target[row]);
        for (share, terms) in shares.iter().zip(&terms) {
            for (row, a) in terms.iter().enumerate() {
                for (column, b) in terms[..=row].iter().enumerate() {
                    gram[(row, column)] += share * a * b;
                }
                missing[(row, 0)] -= share * a;
            }
        }
        for k in 0..TERMS {
            gram[(k, k)] *= 1.0 + RIDGE;
        }
        let Ok(factor) = gram.llt(Side::Lower) else { break };
        factor.solve_in_place(&mut missing);
        for (share, terms) in shares.iter_mut().zip(&terms) {
            let change: f64 = terms.iter().enumerate().map(|(row, term)| missing[(row, 0)] * term).sum();
            *share = (*share * (1.0 + change)).clamp(BOUNDS[0], BOUNDS[1]);
        }
    }
    if shares.iter().all(|share| share.is_finite()) { shares } else { within_bounds(volumes) }
}

/// Keeps what the particles cannot tell apart, as two layers cannot a square from a constant, from having a part.
const RIDGE: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::askew_box::AskewBox;
    use crate::geometry::lattice::Cuboid;
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
                // At 3.25 layers and 45 degrees 0.951, else within 2 %: shares within their bounds do no more.
                for (what, shares, within) in [("volume", &shares.volumes, 0.2), ("stiffness", &shares.stiffness, 0.05)]
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
