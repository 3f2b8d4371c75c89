//! How times lie along the timeline.

use crate::text::number::time_tick;
use egui::Rangef;

/// Lengths that a timeline may have [s]; beyond them it doubles.
const LENGTHS: [f64; 18] =
    [2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 60.0, 120.0, 180.0, 300.0];
/// Frames that the shortest timeline has room for: five seconds of sixty.
const ROOM: f64 = 300.0;
/// Steps between labelled times [s].
const STEPS: [f64; 21] = [
    2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0,
    600.0,
];
/// Labels stand at least so far apart [points].
const APART: f32 = 60.0;

/// A stretch of time along a stretch of the window. It is longer than what is kept, so that what is there stays where
/// it is while more comes.
#[derive(Clone, Copy, Debug)]
pub(super) struct TimeScale {
    first: f64,
    length: f64,
    places: Rangef,
}

impl TimeScale {
    /// The scale of what is kept from a first to a last time [s], with room up to `until` [s], in frames of this length
    /// [s], over places of the window [points].
    pub(super) fn new([first, last]: [f64; 2], until: f64, frame: f64, places: Rangef) -> Self {
        let kept = last.max(until) - first;
        let least = kept.max(ROOM * frame * (1.0 - 1e-6));
        let mut length =
            LENGTHS.into_iter().find(|length| *length >= least).unwrap_or(2.0 * LENGTHS[LENGTHS.len() - 1]);
        while length < kept {
            length *= 2.0;
        }
        Self { first, length, places }
    }

    /// Where a time is [points].
    pub(super) fn place(&self, time: f64) -> f32 {
        self.places.min + ((time - self.first) / self.length) as f32 * self.places.span()
    }

    /// The time at a place [s].
    pub(super) fn time(&self, place: f32) -> f64 {
        self.first + self.length * f64::from((place - self.places.min) / self.places.span())
    }

    /// Round times along it [s], with what is written there.
    pub(super) fn ticks(&self) -> Vec<(f64, String)> {
        let least = self.length * f64::from(APART / self.places.span().max(1.0));
        let step = STEPS.into_iter().find(|step| *step >= least).unwrap_or(least);
        let from = (self.first / step - 1e-9).ceil() as i64;
        let to = ((self.first + self.length) / step + 1e-9).floor() as i64;
        let tick = |k: i64| {
            let time = k as f64 * step;
            (time, time_tick(time, step))
        };
        (from..=to).map(tick).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_and_places_are_each_others_inverse() {
        let scale = TimeScale::new([3.0, 11.0], 0.0, 1.0 / 60.0, Rangef::new(100.0, 800.0));
        assert!((scale.place(3.0) - 100.0).abs() < 1e-3 && (scale.place(13.0) - 800.0).abs() < 1e-3, "{scale:?}");
        for time in [3.0, 4.25, 11.0] {
            assert!((scale.time(scale.place(time)) - time).abs() < 1e-4);
        }
    }

    #[test]
    fn labels_are_round_and_stand_apart() {
        let slow = [(0.0, 700.0), (8.0, 700.0), (8.0, 150.0), (100.0, 300.0), (1000.0, 2000.0), (1e5, 90.0)];
        let fast = [(0.0, 700.0), (0.004, 700.0), (0.05, 150.0), (0.05, 2000.0)];
        let cases = slow.map(|case| (1.0 / 60.0, case)).into_iter().chain(fast.map(|case| (5e-5, case)));
        for (frame, (length, width)) in cases {
            let scale = TimeScale::new([7.3, 7.3 + length], 7.3, frame, Rangef::new(0.0, width));
            let ticks = scale.ticks();
            for pair in ticks.windows(2) {
                assert!(scale.place(pair[1].0) - scale.place(pair[0].0) >= APART - 0.1, "{length} s: {ticks:?}");
                assert_ne!(pair[0].1, pair[1].1);
            }
            assert!(width < 200.0 || ticks.len() >= 2, "{length} s: {ticks:?}");
        }
    }
}
