//! What a drive does to a force, and the work that this does.

use super::drive::Drive;
use super::hand::Hand;

/// What a force and its energy are multiplied by, and the work that this does on the body by changing: half of a step's
/// at each of its ends.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Driven {
    /// By 1 where there is none.
    drive: Option<Drive>,
    /// Work done up to the last booking [J].
    done: f64,
    /// The drive's value there, and the energy that is not multiplied [J].
    booked: Option<[f64; 2]>,
}

impl Driven {
    /// By a drive, if there is one.
    pub(crate) fn by(drive: Option<Drive>) -> Self {
        Self { drive, ..Self::default() }
    }

    /// The factor at a time [s].
    pub(crate) fn at(&self, time: f64) -> f64 {
        self.drive.as_ref().map_or(1.0, |drive| drive.at(time).0)
    }

    /// Work done so far [J].
    pub(crate) fn work(&self) -> f64 {
        self.done
    }

    /// Takes note of where the booking begins, unless it has begun; `energy` [J] is what is multiplied.
    pub(crate) fn begin(&mut self, time: f64, energy: impl FnOnce() -> f64) {
        if self.booked.is_none() {
            self.book(time, energy);
        }
    }

    /// Books the step that ended at a time [s] with this energy [J]. One that is no number, such as that of gas without
    /// a volume, has no work: the body is about to be stopped.
    pub(crate) fn book(&mut self, time: f64, energy: impl FnOnce() -> f64) {
        let Some(drive) = &self.drive else { return };
        let now = [drive.at(time).0, energy()];
        if !now[1].is_finite() {
            return;
        }
        if let Some(before) = self.booked {
            self.done += 0.5 * (now[0] - before[0]) * (before[1] + now[1]);
        }
        self.booked = Some(now);
    }

    /// Begins to book anew, from wherever the body is next, and goes on with the work of what stood here before.
    pub(crate) fn adopt(&mut self, before: Option<&Self>) {
        self.booked = None;
        self.done = before.map_or(0.0, |before| before.done);
    }

    /// Has a hand lead a shared drive, or none.
    pub(crate) fn give(&mut self, to: &str, led: Option<Hand>) {
        if let Some(drive) = &mut self.drive {
            drive.give(to, led);
        }
    }

    /// Until when [s] it changes.
    pub(crate) fn until(&self) -> f64 {
        self.drive.as_ref().map_or(0.0, Drive::until)
    }

    /// Where it stands still at its greatest value, or at its least.
    pub(crate) fn at_extreme(&self, greatest: bool) -> Self {
        let of = |drive: &Drive| Drive::Constant(if greatest { drive.greatest() } else { drive.least() });
        Self::by(self.drive.as_ref().map(of))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::drive::{After, Between, Key};

    #[test]
    fn energies_that_are_no_number_are_no_work() {
        let mut driven = Driven::by(Some(Drive::Keys {
            keys: [(0.5, 1.0), (1.5, 3.0), (2.5, -1.0)].map(Key::at_rest).to_vec(),
            between: Between::Linear,
            after: After::Hold,
        }));
        driven.begin(0.5, || 2.0);
        for energy in [f64::NAN, f64::INFINITY] {
            driven.book(1.0, || energy);
        }
        driven.book(1.5, || 4.0);
        assert_eq!(driven.work(), 0.5 * (3.0 - 1.0) * (2.0 + 4.0));
    }
}
