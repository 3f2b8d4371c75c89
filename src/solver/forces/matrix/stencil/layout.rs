//! Where the bricks of a lattice lie in memory for the stencil: numbered from 1, and brick 0, which is empty and zero
//! and stands for every place without particles; and the chunks that they are worked on in.

use super::line_buffer::MAX_SITES;
use super::row_table::{ROWS, rows_within};
use crate::solver::forces::bricks::{Alignment, Bricks, NO_PARTICLE};
use crate::solver::neighbourhood::Lattice;
use glam::{DMat3, DVec3, IVec3};
use std::collections::HashMap;
use std::ops::Range;

/// Bricks of a body and which of them neighbour each other.
pub(super) struct Layout {
    pub(super) bricks: Bricks,
    /// Axes of the stencil in the model frame: those of the lattice, perhaps in another order.
    pub(super) axes: DMat3,
    /// By how much the lattice is stretched along them.
    pub(super) stretch: DVec3,
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

impl Layout {
    /// Lays out the particles of a lattice for stencils of |o|² up to `norm_squared`, in bricks of so many lanes.
    pub(super) fn new(lattice: &Lattice, norm_squared: usize, lanes: usize) -> Self {
        let alignment = Alignment::of_fewest_bricks(&lattice.cells, lanes);
        let bricks = Bricks::new(&lattice.cells, alignment);
        let count = lattice.cells.len().max(1) as f64;
        let mean = lattice.cells.iter().map(|&cell| alignment.cell(cell).as_dvec3()).sum::<DVec3>() / count;
        let corner = |brick: &IVec3| IVec3::new(alignment.length() * brick.x, brick.y, brick.z).as_dvec3() - mean;
        let mut layout = Self {
            axes: alignment.axes(&lattice.axes),
            stretch: alignment.along(lattice.stretch),
            corners: bricks.positions.iter().map(corner).collect(),
            chunks: Vec::new(),
            sites: Vec::new(),
            site_of: Vec::with_capacity(bricks.len()),
            neighbours: Vec::new(),
            bricks,
        };
        layout.add_chunks(norm_squared);
        layout
    }

    /// Bricks at [`ROWS`] around every site that has any.
    #[inline(always)]
    pub(super) fn neighbours<const N: usize>(&self) -> &[[u32; N]] {
        self.neighbours.as_chunks().0
    }

    fn add_chunks(&mut self, norm_squared: usize) {
        let numbers = (1..).zip(&self.bricks.positions).map(|(k, &brick)| (brick, k)).collect();
        let index = BrickIndex { numbers, norm_squared };
        let bricks = self.bricks.positions.clone();
        let mut first = 0;
        while first < bricks.len() {
            let last = end_of_row(&bricks, first);
            // The row's bricks and a site beside each end.
            let needed = last - first + 2;
            let full = self.chunks.last().is_none_or(|chunk| chunk.sites.len() + needed > MAX_SITES);
            if full {
                let (brick, site) = (self.site_of.len(), self.sites.len());
                self.chunks.push(Chunk { bricks: brick..brick, sites: site..site });
            }
            self.add_row(&bricks[first..last], &index);
            first = last;
        }
    }

    /// Adds a row of bricks to the last chunk.
    fn add_row(&mut self, row: &[IVec3], index: &BrickIndex) {
        let Some(start) = self.chunks.last().map(|chunk| chunk.sites.start) else { return };
        let before = self.site_beside(row[0], -1, index);
        // Two empty sites beside each other are as good as one.
        if before.is_some() || self.sites[start..].last() != Some(&None) {
            self.sites.push(before);
        }
        for &brick in row {
            let site = self.site(brick, index);
            self.site_of.push((self.sites.len() - start) as u32);
            self.sites.push(site);
        }
        let after = self.site_beside(row[row.len() - 1], 1, index);
        self.sites.push(after);
        if let Some(chunk) = self.chunks.last_mut() {
            chunk.bricks.end = self.site_of.len();
            chunk.sites.end = self.sites.len();
        }
    }

    /// The neighbours of the site beside the end of a row, on the side of negative or positive x, if a particle of the
    /// row's last brick has any there.
    #[allow(clippy::cast_possible_wrap, reason = "a register has a handful of lanes")]
    fn site_beside(&mut self, brick: IVec3, side: i32, index: &BrickIndex) -> Option<u32> {
        let beside = brick + side * IVec3::X;
        let (first, last) = self.ends(index.number(brick))?;
        let reached = ROWS[..rows_within(index.norm_squared)].iter().any(|&(y, z)| {
            let Some((begin, end)) = self.ends(index.number(beside + IVec3::new(0, y, z))) else { return false };
            let length = self.bricks.lanes() as i32;
            let step = if side < 0 { first + length - end } else { begin + length - last };
            (step * step + y * y + z * z) as usize <= index.norm_squared
        });
        if reached { self.site(beside, index) } else { None }
    }

    /// First and last lane of a brick that are taken; none of the empty brick.
    #[allow(clippy::cast_possible_wrap, reason = "a register has a handful of lanes")]
    fn ends(&self, number: u32) -> Option<(i32, i32)> {
        let particles = self.bricks.particles((number as usize).checked_sub(1)?);
        let taken = |&particle: &u32| particle != NO_PARTICLE;
        Some((particles.iter().position(taken)? as i32, particles.iter().rposition(taken)? as i32))
    }

    /// The neighbours of a site, if there are any.
    fn site(&mut self, at: IVec3, index: &BrickIndex) -> Option<u32> {
        let rows = rows_within(index.norm_squared);
        let around = ROWS[..rows].iter().map(|&(y, z)| index.number(at + IVec3::new(0, y, z)));
        let start = self.neighbours.len();
        self.neighbours.extend(around);
        if self.neighbours[start..].iter().all(|&brick| brick == 0) {
            self.neighbours.truncate(start);
            return None;
        }
        Some((start / rows) as u32)
    }
}

/// Numbers of the bricks by where they lie, and how far a stencil reaches among them.
struct BrickIndex {
    numbers: HashMap<IVec3, u32>,
    /// Greatest |o|² of the stencil.
    norm_squared: usize,
}

impl BrickIndex {
    /// Number of a brick; that of the empty one where none is.
    fn number(&self, brick: IVec3) -> u32 {
        self.numbers.get(&brick).copied().unwrap_or(0)
    }
}

/// Where the row of bricks ends that begins at `first`, or where a chunk would be full of it.
fn end_of_row(bricks: &[IVec3], first: usize) -> usize {
    let longest = MAX_SITES - 2;
    let goes_on = |&k: &usize| k < first + longest && bricks.get(k) == Some(&(bricks[k - 1] + IVec3::X));
    (first + 1..bricks.len()).take_while(goes_on).last().unwrap_or(first) + 1
}
