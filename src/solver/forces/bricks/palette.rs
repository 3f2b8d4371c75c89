//! What many bricks have in common.

use crate::solver::wide::Lanes4;
use std::collections::HashMap;

/// Constants of bricks, each set of them kept once: inside a body all bricks have the same.
pub(crate) struct Palette<T> {
    entries: Vec<T>,
    of_brick: Vec<u32>,
}

impl<T> Palette<T> {
    /// The palette of bricks with these numbers; sets of the same bits become one entry.
    pub(crate) fn new<const N: usize>(bricks: impl Iterator<Item = [Lanes4; N]>) -> Self
    where
        T: From<[Lanes4; N]>,
    {
        let mut known: HashMap<Vec<u64>, u32> = HashMap::new();
        let (mut entries, mut of_brick) = (Vec::new(), Vec::new());
        for numbers in bricks {
            let key = numbers.iter().flat_map(|lanes| lanes.0).map(f64::to_bits).collect();
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
