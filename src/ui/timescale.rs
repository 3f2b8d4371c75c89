//! How times lie along the timeline, and how they and memory are written.

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

/// A stretch of time along a stretch of the window. It is longer than what is kept, so that what is there stays where it
/// is while more comes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    first: f64,
    length: f64,
    places: Rangef,
}

impl Scale {
    /// The scale of what is kept from a first to a last time [s] in frames of this length [s], over places of the window
    /// [points].
    pub(super) fn new([first, last]: [f64; 2], frame: f64, places: Rangef) -> Self {
        let kept = last - first;
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
            let text = if step < 1.0 { format!("{time:.*} s", decimals(step)) } else { whole(time) };
            (time, text)
        };
        (from..=to).map(tick).collect()
    }
}

/// A time of whole seconds [s]: seconds, or minutes and seconds.
fn whole(time: f64) -> String {
    let seconds = time.round() as u64;
    if seconds < 60 { format!("{seconds} s") } else { format!("{}:{:02}", seconds / 60, seconds % 60) }
}

/// Places behind the point that tell a step [s] of times from the next.
fn decimals(step: f64) -> usize {
    (-step.log10() - 1e-9).ceil().clamp(0.0, 9.0) as usize
}

/// A time [s] as fine as frames of this length [s] need it.
pub(super) fn moment(time: f64, frame: f64) -> String {
    format!("{time:.*} s", decimals(frame).max(2))
}

/// A ratio with two figures at least.
pub(super) fn ratio(value: f64) -> String {
    let fine = if value > 0.0 { decimals(value) + 1 } else { 0 };
    format!("{value:.*}", fine.max(2))
}

/// How long something lasts [s].
pub(super) fn clock(seconds: f64) -> String {
    let fine = if seconds > 0.0 { decimals(seconds) } else { 0 };
    if seconds < 9.95 { format!("{seconds:.*} s", fine.max(1)) } else { whole(seconds) }
}

/// Memory taken of what may be taken [bytes].
pub(super) fn memory(taken: usize, most: usize) -> String {
    const MIB: f64 = (1 << 20) as f64;
    let [taken, most] = [taken, most].map(|bytes| bytes as f64 / MIB);
    if most < 1024.0 {
        format!("{taken:.0} of {most:.0} MiB")
    } else {
        format!("{:.1} of {:.0} GiB", taken / 1024.0, most / 1024.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_and_places_are_each_others_inverse() {
        let scale = Scale::new([3.0, 11.0], 1.0 / 60.0, Rangef::new(100.0, 800.0));
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
            let scale = Scale::new([7.3, 7.3 + length], frame, Rangef::new(0.0, width));
            let ticks = scale.ticks();
            for pair in ticks.windows(2) {
                assert!(scale.place(pair[1].0) - scale.place(pair[0].0) >= APART - 0.1, "{length} s: {ticks:?}");
                assert_ne!(pair[0].1, pair[1].1);
            }
            assert!(width < 200.0 || ticks.len() >= 2, "{length} s: {ticks:?}");
        }
    }

    #[test]
    fn lengths_and_memory_are_written_as_people_do() {
        assert_eq!(
            [0.0, 0.0083, 0.5, 9.2, 12.4, 112.0].map(clock),
            ["0.0 s", "0.008 s", "0.5 s", "9.2 s", "12 s", "1:52"]
        );
        assert_eq!([1.0 / 60.0, 0.002, 5e-5].map(|frame| moment(0.01234, frame)), ["0.01 s", "0.012 s", "0.01234 s"]);
        assert_eq!([0.0, 0.004_12, 0.03, 0.995, 1.5].map(ratio), ["0.00", "0.0041", "0.030", "0.99", "1.50"]);
        assert_eq!(memory(214 << 20, 512 << 20), "214 of 512 MiB");
        assert_eq!(memory(214 << 20, 8 << 30), "0.2 of 8 GiB");
    }
}
