//! Which frames of a run are written, and how they are counted then.

use std::ops::RangeInclusive;

/// Every so many frames of a run, from the first to the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FrameChoice {
    /// The first that is written.
    pub(crate) first: u64,
    /// None after this one is written.
    pub(crate) last: u64,
    /// From one that is written to the next; one at least.
    pub(crate) step: u64,
}

impl FrameChoice {
    /// Whether a frame is written.
    pub(crate) fn takes(self, number: u64) -> bool {
        (self.first..=self.last).contains(&number) && (number - self.first).is_multiple_of(self.step)
    }

    /// How many are written of a run that reaches the last.
    pub(crate) fn count(self) -> u64 {
        self.last.checked_sub(self.first).map_or(0, |more| more / self.step + 1)
    }

    /// The numbers that they are written under: one after the other, as what comes of fewer frames lasts as long.
    pub(crate) fn numbers(self) -> RangeInclusive<u64> {
        let first = self.first / self.step;
        first..=(first + self.count()).saturating_sub(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_that_are_left_out_are_not_counted() {
        let choice = FrameChoice { first: 3, last: 10, step: 3 };
        let taken: Vec<u64> = (0..20).filter(|&number| choice.takes(number)).collect();
        assert_eq!((taken, choice.count(), choice.numbers()), (vec![3, 6, 9], 3, 1..=3));
        let one = FrameChoice { first: 5, last: 5, step: 7 };
        assert_eq!((one.takes(5), one.count(), one.numbers()), (true, 1, 0..=0));
        assert_eq!(FrameChoice { first: 2, last: 1, step: 1 }.count(), 0);
    }
}
