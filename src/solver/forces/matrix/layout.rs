//! Where the particles of a lattice lie in memory for the stencil: bricks of four along a row, numbered from 1, and brick
//! 0, which is empty and zero and stands for every place without particles. A place of a brick without a particle holds
//! zeros too, so that no sum has to ask what is there.

use super::lanes::LANES;
use super::rows::{MOST_SITES, ROWS};
use crate::solver::neighbourhood::Lattice;
use glam::{DMat3, DVec3, IVec3};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// Cells of a brick, one for each lane.
const BRICK: i32 = 4;
const _: () = assert!(BRICK as usize == LANES, "a brick fills its lanes");

/// A place of a brick without a particle.
pub(super) const NONE: u32 = u32::MAX;

/// Bricks of a body and which of them neighbour each other.
pub(super) struct Layout {
    /// Axes of the stencil in the model frame: those of the lattice, perhaps in another order.
    pub(super) axes: DMat3,
    /// Particles of every brick.
    pub(super) particles: Vec<[u32; LANES]>,
    /// Place of every particle: its brick's number (without the empty one) times four, plus its place there.
    pub(super) places: Vec<u32>,
    /// Lattice index of every brick's first place, from the mean of all particles, along the stencil's axes.
    pub(super) corners: Vec<DVec3>,
    /// Consecutive bricks that are worked on together.
    pub(super) chunks: Vec<Chunk>,
    /// Sites of all chunks, bricks and places beside the ends of rows: their number in `neighbours`; none where nothing
    /// lies around.
    pub(super) sites: Vec<Option<u32>>,
    /// Site of every brick, from the first of its chunk.
    pub(super) site_of: Vec<u32>,
    /// Bricks at [`ROWS`] around every site that has any.
    neighbours: Vec<u32>,
}

/// Bricks of whole rows as a rule, with all sites that their sums need.
pub(super) struct Chunk {
    pub(super) bricks: Range<usize>,
    pub(super) sites: Range<usize>,
}

/// How the lattice is cut into bricks: which of its axes the rows run along, and where bricks begin.
#[derive(Clone, Copy)]
struct Cut {
    turn: usize,
    phase: i32,
}

impl Cut {
    /// Every cut, the plain one first.
    fn all() -> impl Iterator<Item = Self> {
        (0..3).flat_map(|turn| (0..BRICK).map(move |phase| Self { turn, phase }))
    }

    /// The index with the axes in turn, so that they stay right-handed, and rows begun at the phase.
    fn cell(self, cell: IVec3) -> IVec3 {
        let [x, y, z] = cell.to_array();
        let cell = [IVec3::new(x, y, z), IVec3::new(y, z, x), IVec3::new(z, x, y)][self.turn];
        cell + self.phase * IVec3::X
    }

    fn axes(self, axes: &DMat3) -> DMat3 {
        let [x, y, z] = [axes.x_axis, axes.y_axis, axes.z_axis];
        match self.turn {
            0 => *axes,
            1 => DMat3::from_cols(y, z, x),
            _ => DMat3::from_cols(z, x, y),
        }
    }

    /// The cut of fewest bricks; another than the plain one only where that saves some.
    fn best(cells: &[IVec3]) -> Self {
        let bricks = |cut: Self| cells.iter().map(|&cell| brick(cut.cell(cell))).collect::<HashSet<_>>().len();
        let mut best: Option<(usize, Self)> = None;
        for cut in Self::all() {
            let count = bricks(cut);
            if best.is_none_or(|(least, _)| 20 * count < 19 * least) {
                best = Some((count, cut));
            }
        }
        best.map_or(Self { turn: 0, phase: 0 }, |(_, cut)| cut)
    }
}

/// Brick of a cell: its x in units of bricks.
fn brick(cell: IVec3) -> IVec3 {
    IVec3::new(cell.x.div_euclid(BRICK), cell.y, cell.z)
}

impl Layout {
    /// Lays out the particles of a lattice for stencils over the first `rows` of [`ROWS`].
    pub(super) fn new(lattice: &Lattice, rows: usize) -> Self {
        let cut = Cut::best(&lattice.cells);
        let cells: Vec<IVec3> = lattice.cells.iter().map(|&cell| cut.cell(cell)).collect();
        let mut bricks: Vec<IVec3> =
            cells.iter().map(|&cell| brick(cell)).collect::<HashSet<_>>().into_iter().collect();
        bricks.sort_unstable_by_key(|brick| (brick.z, brick.y, brick.x));
        let index: HashMap<IVec3, u32> = (1..).zip(&bricks).map(|(k, &brick)| (brick, k)).collect();

        let mut particles = vec![[NONE; LANES]; bricks.len()];
        let mut places = Vec::with_capacity(cells.len());
        for (i, &cell) in cells.iter().enumerate() {
            let (brick, lane) = (index[&brick(cell)] - 1, cell.x.rem_euclid(BRICK));
            particles[brick as usize][lane as usize] = i as u32;
            places.push(LANES as u32 * brick + lane as u32);
        }
        let mean = cells.iter().map(|cell| cell.as_dvec3()).sum::<DVec3>() / cells.len().max(1) as f64;
        let corner = |brick: &IVec3| IVec3::new(BRICK * brick.x, brick.y, brick.z).as_dvec3() - mean;
        let mut layout = Self {
            axes: cut.axes(&lattice.axes),
            particles,
            places,
            corners: bricks.iter().map(corner).collect(),
            chunks: Vec::new(),
            sites: Vec::new(),
            site_of: Vec::with_capacity(bricks.len()),
            neighbours: Vec::new(),
        };
        layout.add_chunks(&bricks, &index, rows);
        layout
    }

    /// Bricks at [`ROWS`] around a site.
    #[inline(always)]
    pub(super) fn neighbours<const N: usize>(&self, site: u32) -> &[u32; N] {
        &self.neighbours.as_chunks().0[site as usize]
    }

    fn add_chunks(&mut self, bricks: &[IVec3], index: &HashMap<IVec3, u32>, rows: usize) {
        let mut first = 0;
        while first < bricks.len() {
            let last = end_of_row(bricks, first);
            // The row's bricks and a site beside each end.
            let needed = last - first + 2;
            let full = self.chunks.last().is_none_or(|chunk| chunk.sites.len() + needed > MOST_SITES);
            if full {
                let (brick, site) = (self.site_of.len(), self.sites.len());
                self.chunks.push(Chunk { bricks: brick..brick, sites: site..site });
            }
            self.add_row(&bricks[first..last], index, rows);
            first = last;
        }
    }

    /// Adds a row of bricks to the last chunk.
    fn add_row(&mut self, row: &[IVec3], index: &HashMap<IVec3, u32>, rows: usize) {
        let Some(start) = self.chunks.last().map(|chunk| chunk.sites.start) else { return };
        let before = self.site(row[0] - IVec3::X, index, rows);
        // Two empty sites beside each other are as good as one.
        if before.is_some() || self.sites[start..].last() != Some(&None) {
            self.sites.push(before);
        }
        for &brick in row {
            let site = self.site(brick, index, rows);
            self.site_of.push((self.sites.len() - start) as u32);
            self.sites.push(site);
        }
        let after = self.site(row[row.len() - 1] + IVec3::X, index, rows);
        self.sites.push(after);
        if let Some(chunk) = self.chunks.last_mut() {
            chunk.bricks.end = self.site_of.len();
            chunk.sites.end = self.sites.len();
        }
    }

    /// The neighbours of a site, if there are any.
    fn site(&mut self, at: IVec3, index: &HashMap<IVec3, u32>, rows: usize) -> Option<u32> {
        let around = ROWS[..rows].iter().map(|&(y, z)| index.get(&(at + IVec3::new(0, y, z))).copied().unwrap_or(0));
        let start = self.neighbours.len();
        self.neighbours.extend(around);
        if self.neighbours[start..].iter().all(|&brick| brick == 0) {
            self.neighbours.truncate(start);
            return None;
        }
        Some((start / rows) as u32)
    }
}

/// Where the row of bricks ends that begins at `first`, or where a chunk would be full of it.
fn end_of_row(bricks: &[IVec3], first: usize) -> usize {
    let longest = MOST_SITES - 2;
    let goes_on = |&k: &usize| k < first + longest && bricks.get(k) == Some(&(bricks[k - 1] + IVec3::X));
    (first + 1..bricks.len()).take_while(goes_on).last().unwrap_or(first) + 1
}
