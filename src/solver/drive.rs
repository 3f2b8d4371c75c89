//! Numbers that change in time.

use super::hand::{Hand, Lead, OwnShare};
use crate::geometry::hermite::{Hermite, range_of};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A number that changes in time, exactly the same whenever it is asked for the same time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Drive {
    /// The same at all times.
    Constant(f64),
    /// From key to key.
    Keys {
        /// At ascending times, one at least.
        keys: Vec<Key>,
        /// How it goes from one to the next.
        between: Between,
        /// What it does from the last one on.
        after: After,
    },
    /// Up and down.
    Wave(Wave),
    /// Keys on top of another drive, which it is before them.
    Over {
        /// Its keys.
        keys: Box<Drive>,
        /// Times of the first two [s]: there it goes from the other drive to the second.
        begins: [f64; 2],
        /// When it goes back to the other drive from its last key, and when it is back [s]; none where it stays.
        ends: Option<[f64; 2]>,
        /// The other drive.
        own: Box<Drive>,
    },
    /// One that several things follow, and that a hand may lead.
    Shared {
        /// Its identifier among the body's.
        id: Arc<str>,
        /// What it is by itself.
        own: Box<Drive>,
        /// What leads it.
        hand: Option<Hand>,
    },
}

/// A value at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Key {
    /// [s]
    pub time: f64,
    pub value: f64,
    /// Rate with which a smooth course goes through it [1/s].
    pub slope: f64,
}

impl Key {
    /// A value at a time [s] at which it comes to rest.
    pub(crate) fn at_rest((time, value): (f64, f64)) -> Self {
        Self { time, value, slope: 0.0 }
    }
}

/// How a drive goes from one key to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Between {
    /// It keeps its value up to the next.
    Stepped,
    /// At a steady rate.
    Linear,
    /// By a cubic from slope to slope.
    Smooth,
}

/// What a drive does from its last key on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum After {
    /// It keeps the last value.
    Hold,
    /// It begins again with the first key.
    Repeat,
    /// It goes back and comes again.
    Mirror,
}

/// `mean - amplitude cos(2 pi (s / wavelength - (t - start) / period) + phase)` at the place s of a fibre, zero before
/// the start and rising from there within the first period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wave {
    pub mean: f64,
    pub amplitude: f64,
    /// [s]
    pub period: f64,
    /// [rad]
    pub phase: f64,
    /// [m]; none where all places swing at once.
    pub wavelength: Option<f64>,
    /// [s]
    pub start: f64,
}

impl Wave {
    /// Share of the swing that is reached at a time, and its rate [1/s].
    pub(super) fn rise(&self, time: f64) -> (f64, f64) {
        let s = (time - self.start) / self.period;
        match s {
            _ if s <= 0.0 => (0.0, 0.0),
            _ if s >= 1.0 => (1.0, 0.0),
            _ => (s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s) / self.period),
        }
    }

    /// Angle [rad] at the place zero.
    pub(super) fn angle(&self, time: f64) -> f64 {
        self.phase - TAU * ((time - self.start) / self.period).fract()
    }
}

impl Drive {
    /// Value and rate [1/s] at `time` [s], of a wave at the place zero. The rate of a jump is zero.
    pub(crate) fn at(&self, time: f64) -> (f64, f64) {
        match self {
            Self::Constant(value) => (*value, 0.0),
            Self::Keys { keys, between, after } => keyed(keys, *between, *after, time),
            Self::Wave(wave) => {
                let (rise, rate) = wave.rise(time);
                let (sin, cos) = wave.angle(time).sin_cos();
                let value = wave.mean - wave.amplitude * cos;
                (rise * value, rate * value - rise * wave.amplitude * sin * TAU / wave.period)
            }
            Self::Over { begins, own, .. } if time < begins[0] => own.at(time),
            Self::Over { keys, ends, own, .. } => match ends {
                Some(ends) if time >= ends[0] => Lead::back(*ends, keys.at(ends[0]).0).lead(time, own.at(time)),
                _ => keys.at(time),
            },
            Self::Shared { own, hand, .. } => {
                let own = own.at(time);
                hand.map_or(own, |hand| hand.lead(time, own))
            }
        }
    }

    /// Times [s] at which all that it does in one round is seen.
    pub(crate) fn moments(&self) -> Vec<f64> {
        match self {
            Self::Constant(_) => vec![0.0],
            Self::Keys { keys, between, .. } => {
                let middles = keys.windows(2).map(|pair| 0.5 * (pair[0].time + pair[1].time));
                let turns = spans(keys, *between).flat_map(|(start, span)| span.turns().map(move |way| start + way));
                let mut times: Vec<f64> = keys.iter().map(|key| key.time).chain(middles).chain(turns).collect();
                times.sort_by(f64::total_cmp);
                times
            }
            Self::Shared { own, .. } => own.moments(),
            Self::Over { keys, ends, own, .. } => {
                let mut times = own.moments();
                times.extend(keys.moments().into_iter().chain(ends.iter().flatten().copied()));
                times.sort_by(f64::total_cmp);
                times
            }
            Self::Wave(wave) => (0..=32).map(|k| wave.start + wave.period * f64::from(k) / 16.0).collect(),
        }
    }

    /// The greatest value that it takes.
    pub(crate) fn greatest(&self) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Keys { keys, between, .. } => extremes(keys, *between)[1],
            Self::Wave(wave) => (wave.mean + wave.amplitude.abs()).max(0.0),
            Self::Shared { own, .. } => own.in_hand()[1],
            Self::Over { keys, own, .. } => keys.greatest().max(own.greatest()),
        }
    }

    /// The least value that it takes.
    pub(crate) fn least(&self) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Keys { keys, between, .. } => extremes(keys, *between)[0],
            Self::Wave(wave) => (wave.mean - wave.amplitude.abs()).min(0.0),
            Self::Shared { own, .. } => own.in_hand()[0],
            Self::Over { keys, own, .. } => keys.least().min(own.least()),
        }
    }

    /// The least and the greatest value to which a hand may bring it where it is shared: as far as it goes by itself,
    /// and to nothing.
    pub(crate) fn in_hand(&self) -> [f64; 2] {
        [self.least().min(0.0), self.greatest().max(0.0)]
    }

    /// The greatest size of its values.
    pub(crate) fn largest(&self) -> f64 {
        self.greatest().abs().max(self.least().abs())
    }

    /// Until when [s] it changes.
    pub(crate) fn until(&self) -> f64 {
        match self {
            Self::Keys { keys, after: After::Hold, .. } => keys.last().map_or(0.0, |key| key.time),
            Self::Constant(_) => 0.0,
            Self::Wave(Wave { amplitude: 0.0, start, period, .. }) => start + period,
            Self::Shared { own, hand, .. } => hand.map_or(own.until(), |hand| hand.until(own.until())),
            Self::Over { keys, ends, own, .. } => ends.map_or(keys.until(), |[_, back]| own.until().max(back)),
            Self::Keys { .. } | Self::Wave(_) => f64::INFINITY,
        }
    }

    /// What it is by itself, without hands and keys on top of it.
    fn innermost(&self) -> &Self {
        match self {
            Self::Shared { own, .. } | Self::Over { own, .. } => own.innermost(),
            itself => itself,
        }
    }

    /// The wave that runs along a fibre, with its length [m].
    pub(super) fn wave_along(&self) -> Option<(&Wave, f64)> {
        let Self::Wave(wave) = self.innermost() else { return None };
        wave.wavelength.map(|length| (wave, length))
    }

    /// What becomes of that wave's value at each place at a time [s].
    pub(super) fn share_of_wave(&self, time: f64) -> OwnShare {
        match self {
            Self::Shared { own, hand, .. } => {
                let own = own.share_of_wave(time);
                hand.map_or(own, |hand| hand.share(time).after(own))
            }
            Self::Over { keys, begins, ends, own } => {
                let own = own.share_of_wave(time);
                let [first, second] = *begins;
                match ends {
                    _ if time < first => own,
                    Some(ends) if time >= ends[0] => Lead::back(*ends, keys.at(ends[0]).0).share(time).after(own),
                    _ if time < second => {
                        Lead::away(*begins, keys.at(first).0, keys.at(second).0).share(time).after(own)
                    }
                    _ => OwnShare::none(keys.at(time).0),
                }
            }
            Self::Constant(_) | Self::Keys { .. } | Self::Wave(_) => OwnShare::WHOLE,
        }
    }

    /// What leads it.
    pub(crate) fn hand(&self) -> Option<Hand> {
        if let Self::Shared { hand, .. } = self { *hand } else { None }
    }

    /// Has a hand lead the shared drive of an identifier, or none.
    pub(crate) fn give(&mut self, to: &str, led: Option<Hand>) {
        if let Self::Shared { id, hand, .. } = self
            && **id == *to
        {
            *hand = led;
        }
    }

    /// The hand that leads it within two times [s] to a value, no further than [`Self::in_hand`] says, or lets go of
    /// it; none where there is nothing to let go of.
    pub(crate) fn led(&self, times: [f64; 2], aim: Option<f64>) -> Option<Hand> {
        let aim = aim.map(|aim| {
            let [least, greatest] = self.in_hand();
            aim.clamp(least, greatest)
        });
        let is_led = aim.is_some() || self.hand().is_some_and(|hand| hand.holds());
        is_led.then(|| Hand::new(times, self.at(times[0]).0, aim, self.hand()))
    }
}

/// The cubics of a smooth course with the times at which they start [s]; none of another.
fn spans(keys: &[Key], between: Between) -> impl Iterator<Item = (f64, Hermite)> + '_ {
    let pairs = keys.windows(2).filter(move |_| between == Between::Smooth);
    pairs.map(|pair| (pair[0].time, span(pair[0], pair[1])))
}

fn span(from: Key, to: Key) -> Hermite {
    Hermite { span: to.time - from.time, values: [from.value, to.value], slopes: [from.slope, to.slope] }
}

/// The least and the greatest value.
fn extremes(keys: &[Key], between: Between) -> [f64; 2] {
    range_of(keys.iter().map(|key| key.value), spans(keys, between).map(|(_, span)| span))
}

fn keyed(keys: &[Key], between: Between, after: After, time: f64) -> (f64, f64) {
    let (Some(&first), Some(&last)) = (keys.first(), keys.last()) else { return (0.0, 0.0) };
    let whole = last.time - first.time;
    let since = time - first.time;
    let (mut time, mut way) = (time, 1.0);
    if since >= whole && whole > 0.0 {
        match after {
            After::Hold => {}
            After::Repeat => time = first.time + since % whole,
            After::Mirror => {
                let turned = since % (2.0 * whole);
                way = if turned < whole { 1.0 } else { -1.0 };
                time = first.time + if turned < whole { turned } else { 2.0 * whole - turned };
            }
        }
    }
    let next = keys.partition_point(|key| key.time <= time);
    match (next.checked_sub(1).map(|k| keys[k]), keys.get(next)) {
        (Some(from), Some(&to)) => match between {
            Between::Stepped => (from.value, 0.0),
            Between::Linear => {
                let (long, higher) = (to.time - from.time, to.value - from.value);
                (from.value + higher * ((time - from.time) / long), way * higher / long)
            }
            Between::Smooth => {
                let (value, slope) = span(from, to).at(time - from.time);
                (value, way * slope)
            }
        },
        (Some(last), None) => (last.value, 0.0),
        (None, _) => (first.value, 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys(between: Between, after: After) -> Drive {
        let keys = [(0.5, 1.0), (1.5, 3.0), (2.5, -1.0)].map(Key::at_rest).to_vec();
        Drive::Keys { keys, between, after }
    }

    fn wave(wavelength: Option<f64>) -> Wave {
        Wave { mean: 0.5, amplitude: 0.5, period: 0.8, phase: 0.3, wavelength, start: 0.1 }
    }

    #[test]
    fn keys_are_met_and_then_held_repeated_or_mirrored() {
        let value = |between, after, time| keys(between, after).at(time).0;
        for between in [Between::Stepped, Between::Linear, Between::Smooth] {
            for (time, expected) in [(0.0, 1.0), (0.5, 1.0), (1.5, 3.0), (2.5, -1.0), (9.0, -1.0)] {
                assert_eq!(value(between, After::Hold, time), expected, "{between:?} {time}");
            }
        }
        let quarter = |between| value(between, After::Hold, 0.75);
        assert_eq!([Between::Stepped, Between::Linear, Between::Smooth].map(quarter), [1.0, 1.5, 1.3125]);
        // Two seconds from key to key: 2.75 is 0.75 again, or 2.25 on the way back.
        assert_eq!(value(Between::Linear, After::Repeat, 2.75), 1.5);
        assert_eq!(value(Between::Linear, After::Mirror, 2.75), value(Between::Linear, After::Hold, 2.25));
        assert_eq!(value(Between::Linear, After::Mirror, 4.75), 1.5);
    }

    #[test]
    fn later_rounds_are_the_first_one_forth_or_back() {
        for between in [Between::Stepped, Between::Linear, Between::Smooth] {
            let value = |after, time| keys(between, after).at(time).0;
            // A round takes two seconds, from 0.5 on.
            for time in [0.5, 0.75, 1.25, 1.5, 1.75, 2.25] {
                let first = value(After::Hold, time);
                for round in [1.0, 2.0, 7.0] {
                    assert_eq!(value(After::Repeat, time + 2.0 * round), first, "{between:?} {time}");
                    assert_eq!(value(After::Mirror, time + 4.0 * round), first, "{between:?} {time}");
                    assert_eq!(value(After::Mirror, 1.0 + 4.0 * round - time), first, "{between:?} {time}, back");
                }
            }
        }
        assert_eq!(keys(Between::Stepped, After::Repeat).at(2.75), (1.0, 0.0));
        assert_eq!(keys(Between::Stepped, After::Mirror).at(2.75), (3.0, 0.0));
        assert_eq!(keys(Between::Smooth, After::Repeat).at(2.75), (1.3125, 2.25));
        assert_eq!(keys(Between::Smooth, After::Mirror).at(2.75), (-0.375, 4.5));
    }

    #[test]
    fn rates_are_those_of_the_values() {
        for after in [After::Hold, After::Repeat, After::Mirror] {
            for drive in [keys(Between::Linear, after), keys(Between::Smooth, after), Drive::Wave(wave(None))] {
                for time in [0.2, 0.7, 1.1, 1.7, 2.3, 2.9, 3.6, 4.4] {
                    let difference = (drive.at(time + 1e-6).0 - drive.at(time - 1e-6).0) / 2e-6;
                    assert!((difference - drive.at(time).1).abs() < 1e-5, "{drive:?} {time}");
                }
            }
        }
    }
}
