//! Combined rows of a chunk, along whose lines a shift is a load from the place beside.

use super::row_table::DISTANCES;
use crate::solver::wide::LANES;
use fearless_simd::{Simd, f64x4, prelude::*};

/// Sites in a chunk of bricks: bricks and the places beside their rows' ends, into which sums are shifted.
pub(super) const MAX_SITES: usize = 24;

/// Lines of a component: those of the first pass, of three kinds for each |dx|.
const LINES: usize = 3 * DISTANCES;
const _: () =
    assert!(2 * (DISTANCES - 1) < LINES, "the second pass needs a line for dx = 0 and two for each other |dx|");

/// Numbers along the sites of a chunk, four for each.
pub(super) type Line = [f64; LANES * MAX_SITES];

/// The lines of a chunk, of each component x, y, z.
#[derive(Default)]
pub(super) struct LineBuffer(pub(super) Vec<[Line; LINES]>);

impl LineBuffer {
    pub(super) fn new() -> Self {
        Self(vec![[[0.0; LANES * MAX_SITES]; LINES]; 3])
    }

    /// Zeroes all lines at a site.
    #[inline(always)]
    pub(super) fn clear<S: Simd>(&mut self, simd: S, site: usize) {
        let zero = f64x4::splat(simd, 0.0);
        for line in self.0.iter_mut().flatten() {
            put(line, site, zero);
        }
    }
}

/// Puts four numbers at a site.
#[inline(always)]
pub(super) fn put<S: Simd>(line: &mut Line, site: usize, value: f64x4<S>) {
    value.store_slice(&mut line[LANES * site..LANES * (site + 1)]);
}

/// Four numbers from a place on, which may lie between two sites.
#[inline(always)]
pub(super) fn read<S: Simd>(simd: S, line: &Line, place: usize) -> f64x4<S> {
    f64x4::from_slice(simd, &line[place..place + LANES])
}
