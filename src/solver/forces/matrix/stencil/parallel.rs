//! Work on slices and chunks, on one thread or on all.

use super::line_buffer::LineBuffer;
use crate::solver::wide::Lanes;
use rayon::prelude::*;

/// Bricks or particles that a thread copies at a time.
pub(super) const COPIED: usize = 256;

/// Calls `work` with consecutive parts of a slice, of [`COPIED`] each, and their numbers.
pub(super) fn over_slices<T: Send>(parallel: bool, slice: &mut [T], work: impl Fn((usize, &mut [T])) + Send + Sync) {
    if parallel {
        slice.par_chunks_mut(COPIED).enumerate().for_each(work);
    } else {
        slice.chunks_mut(COPIED).enumerate().for_each(work);
    }
}

/// Calls `work` with every task and a buffer.
pub(super) fn over_tasks<T: Send, L: Lanes>(
    parallel: bool,
    tasks: impl Iterator<Item = T>,
    lines: &mut LineBuffer<L>,
    work: impl Fn(T, &mut LineBuffer<L>) + Send + Sync,
) {
    if parallel {
        let tasks: Vec<T> = tasks.collect();
        tasks.into_par_iter().for_each_init(LineBuffer::new, |lines, task| work(task, lines));
    } else {
        tasks.for_each(|task| work(task, lines));
    }
}

/// A slice from which parts are taken, from the front on.
pub(super) struct Remainder<'a, T>(pub(super) &'a mut [T]);

impl<'a, T> Remainder<'a, T> {
    /// The next so many; none if there are fewer.
    pub(super) fn take(&mut self, count: usize) -> &'a mut [T] {
        self.0.split_off_mut(..count).unwrap_or_default()
    }
}
