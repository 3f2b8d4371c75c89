//! What lies in the cells of a lattice, found fast: a table that is asked millions of times.

use glam::IVec3;
use std::collections::{HashMap, HashSet};
use std::hash::{BuildHasherDefault, Hasher};

/// Values by cells. No input is to be feared here: the indices of cells are mixed by a multiplication each.
pub(crate) type CellMap<V> = HashMap<IVec3, V, BuildHasherDefault<CellHasher>>;

/// Cells, found as fast.
pub(crate) type CellSet = HashSet<IVec3, BuildHasherDefault<CellHasher>>;

/// Mixes the indices of a cell.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CellHasher(u64);

/// An odd number whose bits are spread evenly: 2^64 over the golden ratio.
const MIXER: u64 = 0x9e37_79b9_7f4a_7c15;

impl Hasher for CellHasher {
    fn finish(&self) -> u64 {
        // The product's high bits hang on all of the input, the low ones on little of it.
        self.0 ^ (self.0 >> 32)
    }

    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.write_i32(byte.into());
        }
    }

    fn write_i32(&mut self, index: i32) {
        self.0 = (self.0.rotate_left(23) ^ u64::from(index.cast_unsigned())).wrapping_mul(MIXER);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hash::BuildHasher;

    #[test]
    fn neighbours_come_to_different_places() {
        let map: CellMap<usize> = CellMap::default();
        let cells = (0..32_768).map(|k: i32| IVec3::new(k % 32, k / 32 % 32, k / 1024) - 16);
        let hashes: Vec<u64> = cells.map(|cell| map.hasher().hash_one(cell)).collect();
        // As many of the places of a table, and of the tags in it, are met as by chance.
        for (shift, count) in [(0, 65_536_u64), (57, 128)] {
            let mut met = vec![0_u32; count as usize];
            for hash in &hashes {
                met[(hash >> shift) as usize % count as usize] += 1;
            }
            let used = met.iter().filter(|&&met| met > 0).count() as f64;
            let by_chance = count as f64 * (1.0 - (-32_768.0 / count as f64).exp());
            assert!(used > 0.9 * by_chance, "{used} of {count}, by chance {by_chance}");
            assert!(met.iter().all(|&met| f64::from(met) < 8.0 + 2.0 * 32_768.0 / count as f64), "{shift}");
        }
    }
}
