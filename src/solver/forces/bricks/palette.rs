//! What many bricks have in common.

use crate::solver::wide::Lanes;
use std::collections::HashMap;

/// Constants of bricks, each set of them kept once: inside a body all bricks have the same.
pub(crate) struct Palette<T> {
    entries: Vec<T>,
    of_brick: Vec<u32>,
}

impl<T> Palette<T> {
    /// The palette of bricks with these numbers; sets of the same bits become one entry.
    pub(crate) fn new<L: Lanes, const N: usize>(bricks: impl Iterator<Item = [L; N]>) -> Self
    where
        T: From<[L; N]>,
    {
        let mut known: HashMap<Vec<u8>, u32> = HashMap::new();
        let (mut entries, mut of_brick) = (Vec::new(), Vec::new());
        for numbers in bricks {
            let key = bytemuck::cast_slice::<L, u8>(&numbers).to_vec();
            of_brick.push(*known.entry(key).or_insert_with(|| {
                entries.push(T::from(numbers));
                entries.len() as u32 - 1
            }));
        }
        Self { entries, of_brick }
    }

    /// The entry of a brick.
    #[inline(always)]
    pub(crate) fn of(&self, brick: usize) -> &T {
        &self.entries[self.of_brick[brick] as usize]
    }
}
