//! Combined rows of a chunk, along whose lines a shift is a load from the place beside.

use super::row_table::DISTANCES;
use crate::solver::wide::{Lanes, Wide};
use fearless_simd::Simd;

/// Sites in a chunk of bricks: bricks and the places beside their rows' ends, into which sums are shifted.
pub(super) const MAX_SITES: usize = 24;

/// Lines of a component: those of the first pass, of three kinds for each |dx|.
pub(super) const LINES: usize = 3 * DISTANCES;
const _: () =
    assert!(2 * (DISTANCES - 1) < LINES, "the second pass needs a line for dx = 0 and two for each other |dx|");

/// Numbers along the sites of a chunk.
pub(super) type Line<L> = [L; MAX_SITES];

/// The lines of a chunk, of each component x, y, z.
#[derive(Default)]
pub(super) struct LineBuffer<L>(pub(super) Vec<[Line<L>; LINES]>);

impl<L: Lanes> LineBuffer<L> {
    pub(super) fn new() -> Self {
        Self(vec![[[L::default(); MAX_SITES]; LINES]; 3])
    }
}

/// The numbers so many places beside those of a site, not beyond the next one.
#[inline(always)]
pub(super) fn read<S: Simd, L: Lanes>(simd: S, line: &Line<L>, site: usize, step: isize) -> L::Register<S> {
    // One check of the site, none of the step.
    let window: &[L; 3] = line[site - 1..].first_chunk().expect("every row has a site beyond both its ends");
    L::Register::<S>::read(simd, window, L::COUNT.wrapping_add_signed(step))
}
