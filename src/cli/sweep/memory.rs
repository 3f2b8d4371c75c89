//! How many rows run side by side, with the memory in view that they take.

use super::super::Console;
use crate::io::free_memory;
use crate::text::number::four_figures;

const MIB: u64 = 1 << 20;

/// Share of what is free that rows may take.
const SHARE: f64 = 0.8;

/// What putting a row together takes at the most, over what its world takes.
const TOGETHER: f64 = 2.5;

/// What a row takes besides its world [bytes].
const BESIDES: f64 = 4e6;

/// The memory that rows may take.
#[derive(Clone, Copy, Debug)]
pub(super) struct Memory {
    /// What was asked for [MiB].
    asked: Option<u32>,
}

impl Memory {
    /// As much as was asked for [MiB], or as is free.
    pub(super) fn new(asked: Option<u32>) -> Self {
        Self { asked }
    }

    /// How many rows of `threads` can run side by side, where the world of the largest takes so many bytes; says so
    /// where that is fewer.
    pub(super) fn abreast(self, threads: usize, largest: usize, console: Option<&mut Console>) -> usize {
        let free =
            self.asked.map(|asked| u64::from(asked) * MIB).or_else(|| Some((SHARE * free_memory()? as f64) as u64));
        let Some(free) = free else { return threads };
        let each = of_a_row(largest);
        let abreast = fitting(free, each, threads);
        if let Some(console) = console.filter(|_| abreast < threads) {
            let [each, free] = [each, free].map(|bytes| four_figures(bytes as f64 / MIB as f64));
            let rows = if abreast == 1 {
                "one row at a time runs".to_owned()
            } else {
                format!("{abreast} rows at a time run")
            };
            console.say("note", &format!("{rows}, since each takes up to {each} MiB and {free} MiB may be taken"));
        }
        abreast
    }
}

/// Memory that a row takes at the most [bytes], whose world takes so many.
fn of_a_row(world: usize) -> u64 {
    (TOGETHER * world as f64 + BESIDES) as u64
}

/// How many of so many bytes each fit, of those that are wanted; one at least.
fn fitting(free: u64, each: u64, wanted: usize) -> usize {
    usize::try_from(free / each.max(1)).unwrap_or(usize::MAX).clamp(1, wanted.max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_run_as_fit() {
        for (free, each, wanted, fit) in
            [(10, 3, 8, 3), (10, 3, 2, 2), (10, 11, 8, 1), (0, 1, 8, 1), (u64::MAX, 0, 8, 8), (9, 3, 0, 1)]
        {
            assert_eq!(fitting(free, each, wanted), fit, "{free}, {each}, {wanted}");
        }
        assert!(of_a_row(100 << 20) > 250 << 20 && of_a_row(0) < 5 << 20);
    }
}
