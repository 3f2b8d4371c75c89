//! How many layers of a lattice a part is thick.

use super::cell_map::CellMap;
use glam::{DMat3, DVec3, IVec3};
use rayon::prelude::*;
use std::f64::consts::PI;

/// Particles in thin parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Thinness {
    /// Particles in parts of hardly more than one layer.
    pub single: usize,
    /// Particles in parts of about two layers.
    pub double: usize,
    /// Indices of the particles in parts of hardly more than one layer.
    pub places: Vec<u32>,
}

/// Least variance of the particles in reach, in squared spacings: 0 for one layer, 1/4 for two, about 1/2 for three.
pub(crate) const SINGLE: f64 = 0.15;
const DOUBLE: f64 = 0.3;

/// Variance and number of neighbours below which a particle is held by next to nothing.
pub(crate) const STRAY: (f64, usize) = (0.02, 6);

/// Looks around every particle, out to `reach` spacings. Also tells which particles are strays: those whose neighbours
/// lie on a plane or a line, or are too few.
pub(crate) fn thinness(cells: &[IVec3], reach: f64) -> (Thinness, Vec<bool>) {
    let occupied = Occupied::new(cells);
    let rows = rows_within(reach);
    let found: Vec<(f64, usize)> = cells
        .par_iter()
        .map(|&cell| {
            let around = Around::new(&occupied, &rows, cell);
            let count = f64::from(around.count);
            let mean = around.sum.as_dvec3() / count;
            let spread =
                around.squares() * count.recip() - DMat3::from_cols(mean * mean.x, mean * mean.y, mean * mean.z);
            (least_eigenvalue(spread), around.count as usize - 1)
        })
        .collect();
    let single = |&(variance, _): &(f64, usize)| variance < SINGLE;
    let thinness = Thinness {
        single: found.iter().filter(|one| single(one)).count(),
        double: found.iter().filter(|&&(variance, _)| (SINGLE..DOUBLE).contains(&variance)).count(),
        places: (0..found.len() as u32).filter(|&k| single(&found[k as usize])).collect(),
    };
    let stray = found.iter().map(|&(variance, count)| variance < STRAY.0 || count < STRAY.1).collect();
    (thinness, stray)
}

/// Lattice steps along x that are shorter than `reach` together with a step across.
struct Row {
    /// The step across; the first one of the row along x.
    first: IVec3,
    /// Which of them are short enough, from the first on; not the one to nowhere.
    steps: u64,
    /// How many they are from the first to the last.
    width: i32,
}

/// Lattice steps shorter than `reach`, none left out. They are looked at row by row, as bits: there are dozens of them
/// to a particle.
fn rows_within(reach: f64) -> Vec<Row> {
    // As far as there are bits.
    let n = (reach.ceil() as i32).min(31);
    let across = (-n..=n).flat_map(|z| (-n..=n).map(move |y| IVec3::new(-n, y, z)));
    let row = |first: IVec3| {
        let width = 2 * n + 1;
        let is_short = |k: &i32| {
            let step = first + IVec3::X * *k;
            step != IVec3::ZERO && step.as_dvec3().length() < reach
        };
        Row { first, steps: (0..width).filter(is_short).map(|k| 1 << k).sum(), width }
    };
    across.map(row).filter(|row| row.steps != 0).collect()
}

/// The particles within reach of one, itself included: sums over the steps to them, which are whole numbers.
#[derive(Default)]
struct Around {
    count: i32,
    sum: IVec3,
    /// Sums of xx, yy, zz and of xy, yz, zx.
    own: IVec3,
    mixed: IVec3,
}

impl Around {
    fn new(occupied: &Occupied, rows: &[Row], cell: IVec3) -> Self {
        let mut this = Self { count: 1, ..Self::default() };
        for row in rows {
            let mut there = occupied.row(cell + row.first, row.width) & row.steps;
            let (mut count, mut sum, mut squares) = (0, 0, 0);
            while there != 0 {
                let x = row.first.x + there.trailing_zeros().cast_signed();
                (count, sum, squares) = (count + 1, sum + x, squares + x * x);
                there &= there - 1;
            }
            let IVec3 { y, z, .. } = row.first;
            this.count += count;
            this.sum += IVec3::new(sum, count * y, count * z);
            this.own += IVec3::new(squares, count * y * y, count * z * z);
            this.mixed += IVec3::new(sum * y, count * y * z, sum * z);
        }
        this
    }

    fn squares(&self) -> DMat3 {
        let ([xx, yy, zz], [xy, yz, zx]) = (self.own.as_dvec3().to_array(), self.mixed.as_dvec3().to_array());
        DMat3::from_cols(DVec3::new(xx, xy, zx), DVec3::new(xy, yy, yz), DVec3::new(zx, yz, zz))
    }
}

/// Which cells hold a particle: blocks of the bounding box, of which only those that hold any are kept.
struct Occupied {
    first: IVec3,
    /// Blocks along each axis.
    size: IVec3,
    /// For every block the number of those before it that hold a particle, plus one; zero for one that holds none.
    number: Numbers,
    blocks: Vec<[u64; 8]>,
}

/// Numbers of blocks: in a table, or sorted where that would be too large, as with pieces far apart.
enum Numbers {
    Table(Vec<u32>),
    Sorted(CellMap<u32>),
}

/// Cells along the edge of a block, as a power of two.
const BLOCK: i32 = 3;

/// Blocks of the bounding box up to which they have a table.
const TABLE: f64 = 4e6;

/// Place of a block in the table of a box of so many.
fn table_index(size: IVec3, block: IVec3) -> usize {
    ((block.z * size.y + block.y) * size.x + block.x) as usize
}

impl Occupied {
    fn new(cells: &[IVec3]) -> Self {
        let first = cells.iter().copied().reduce(IVec3::min).unwrap_or_default();
        let last = cells.iter().copied().reduce(IVec3::max).unwrap_or_default();
        let size = ((last - first) >> BLOCK) + 1;
        let number = if size.as_dvec3().element_product() <= TABLE {
            Numbers::Table(vec![0; size.x as usize * size.y as usize * size.z as usize])
        } else {
            Numbers::Sorted(CellMap::default())
        };
        let mut this = Self { first, size, number, blocks: Vec::new() };
        for &cell in cells {
            let at = cell - first;
            let block = at >> BLOCK;
            let number = match &mut this.number {
                Numbers::Table(table) => &mut table[table_index(this.size, block)],
                Numbers::Sorted(map) => map.entry(block).or_default(),
            };
            if *number == 0 {
                this.blocks.push([0; 8]);
                *number = this.blocks.len() as u32;
            }
            let [layer, bit] = within(at);
            this.blocks[*number as usize - 1][layer] |= 1 << bit;
        }
        this
    }

    /// Which of so many cells along x, from one on, hold a particle, as bits.
    fn row(&self, cell: IVec3, width: i32) -> u64 {
        let at = cell - self.first;
        let mut block = at >> BLOCK;
        let last = (at.x + width - 1) >> BLOCK;
        let [layer, bit] = within(at.with_x(0));
        let mut row = 0;
        while block.x <= last {
            let number = match &self.number {
                Numbers::Table(table) => {
                    let within = block.cmpge(IVec3::ZERO).all() && block.cmplt(self.size).all();
                    if within { table[table_index(self.size, block)] } else { 0 }
                }
                Numbers::Sorted(map) => map.get(&block).copied().unwrap_or(0),
            };
            if number > 0 {
                let cells = self.blocks[number as usize - 1][layer] >> bit & 0xff;
                let shift = (block.x << BLOCK) - at.x;
                row |= if shift < 0 { cells >> -shift } else { cells << shift };
            }
            block.x += 1;
        }
        row
    }
}

/// Layer of a block and place in it of a cell.
fn within(at: IVec3) -> [usize; 2] {
    let at = at & ((1 << BLOCK) - 1);
    [at.z as usize, (at.y << BLOCK | at.x) as usize]
}

/// Least eigenvalue of a symmetric matrix (Smith 1961).
pub(crate) fn least_eigenvalue(a: DMat3) -> f64 {
    let mean = (a.x_axis.x + a.y_axis.y + a.z_axis.z) / 3.0;
    let b = a - DMat3::from_diagonal(DVec3::splat(mean));
    let p = ((b.x_axis.length_squared() + b.y_axis.length_squared() + b.z_axis.length_squared()) / 6.0).sqrt();
    if p == 0.0 {
        return mean;
    }
    let r = (b * p.recip()).determinant() / 2.0;
    let phi = r.clamp(-1.0, 1.0).acos() / 3.0;
    mean + 2.0 * p * (phi + 2.0 * PI / 3.0).cos()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slab(layers: i32) -> Vec<IVec3> {
        let cells = (0..layers).flat_map(|z| (0..100).map(move |k| IVec3::new(k % 10, k / 10, z)));
        cells.collect()
    }

    #[test]
    fn eigenvalues_of_a_known_matrix() {
        let a = DMat3::from_cols_array(&[2.0, -1.0, 0.0, -1.0, 2.0, -1.0, 0.0, -1.0, 2.0]);
        assert!((least_eigenvalue(a) - (2.0 - 2.0_f64.sqrt())).abs() < 1e-12);
        assert_eq!(least_eigenvalue(DMat3::from_diagonal(DVec3::splat(3.0))), 3.0);
    }

    #[test]
    fn layers_are_told_apart() {
        let counts = |layers| {
            let (found, stray) = thinness(&slab(layers), 2.5);
            (found.single, found.double, stray.iter().filter(|&&stray| stray).count())
        };
        assert_eq!(counts(1), (100, 0, 100));
        assert_eq!(counts(2), (0, 200, 0));
        assert_eq!(counts(3), (0, 0, 0));
    }
}
