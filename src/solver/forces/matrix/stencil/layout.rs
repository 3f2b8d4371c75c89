//! Where the bricks of a lattice lie in memory for the stencil: numbered from 1, and brick 0, which is empty and zero
//! and stands for every place without particles; and the chunks that they are worked on in.

use super::line_buffer::MAX_SITES;
use super::row_table::ROWS;
use crate::solver::forces::bricks::{Alignment, Bricks, CELLS};
use crate::solver::neighbourhood::Lattice;
use glam::{DMat3, DVec3, IVec3};
use std::collections::HashMap;
use std::ops::Range;

/// Bricks of a body and which of them neighbour each other.
pub(super) struct Layout {
    pub(super) bricks: Bricks,
    /// Axes of the stencil in the model frame: those of the lattice, perhaps in another order.
    pub(super) axes: DMat3,
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
    /// Lays out the particles of a lattice for stencils over the first `rows` of [`ROWS`].
    pub(super) fn new(lattice: &Lattice, rows: usize) -> Self {
        let alignment = Alignment::of_fewest_bricks(&lattice.cells);
        let bricks = Bricks::new(&lattice.cells, alignment);
        let count = lattice.cells.len().max(1) as f64;
        let mean = lattice.cells.iter().map(|&cell| alignment.cell(cell).as_dvec3()).sum::<DVec3>() / count;
        let corner = |brick: &IVec3| IVec3::new(CELLS * brick.x, brick.y, brick.z).as_dvec3() - mean;
        let mut layout = Self {
            axes: alignment.axes(&lattice.axes),
            corners: bricks.positions.iter().map(corner).collect(),
            chunks: Vec::new(),
            sites: Vec::new(),
            site_of: Vec::with_capacity(bricks.len()),
            neighbours: Vec::new(),
            bricks,
        };
        layout.add_chunks(rows);
        layout
    }

    /// Bricks at [`ROWS`] around a site.
    #[inline(always)]
    pub(super) fn neighbours<const N: usize>(&self, site: u32) -> &[u32; N] {
        &self.neighbours.as_chunks().0[site as usize]
    }

    fn add_chunks(&mut self, rows: usize) {
        let index: HashMap<IVec3, u32> = (1..).zip(&self.bricks.positions).map(|(k, &brick)| (brick, k)).collect();
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
            self.add_row(&bricks[first..last], &index, rows);
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
    let longest = MAX_SITES - 2;
    let goes_on = |&k: &usize| k < first + longest && bricks.get(k) == Some(&(bricks[k - 1] + IVec3::X));
    (first + 1..bricks.len()).take_while(goes_on).last().unwrap_or(first) + 1
}
