//! A drive along a fibre, where a wave may run.

use super::drive::Drive;
use super::hand::Hand;
use std::f64::consts::TAU;

/// A drive at many places of a fibre.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DriveAlong {
    drive: Drive,
    /// Cosine and sine of the way along each place in turns of the wave; none where all places are driven alike.
    turns: Vec<[f64; 2]>,
}

impl DriveAlong {
    /// A drive at places this far along a fibre [m].
    pub(crate) fn new(drive: &Drive, places: impl Iterator<Item = f64>) -> Self {
        let turn = |place: f64, wavelength: f64| {
            let (sin, cos) = (TAU * (place / wavelength).fract()).sin_cos();
            [cos, sin]
        };
        let turns = match drive.wave_along() {
            Some((_, wavelength)) => places.map(|place| turn(place, wavelength)).collect(),
            None => Vec::new(),
        };
        Self { drive: drive.clone(), turns }
    }

    /// Its values at a time [s], by the number of the place.
    pub(crate) fn at(&self, time: f64) -> impl Fn(usize) -> f64 + '_ {
        let (same, wave) = match self.drive.wave_along() {
            Some((wave, _)) if !self.turns.is_empty() => {
                let (sin, cos) = wave.angle(time).sin_cos();
                (0.0, Some((wave, wave.rise(time).0, [cos, sin])))
            }
            _ => (self.drive.at(time).0, None),
        };
        let share = self.drive.share_of_wave(time);
        move |place| {
            let Some((wave, rise, [cos, sin])) = wave else { return same };
            let [c, s] = self.turns[place];
            share.of(rise * (wave.mean - wave.amplitude * (c * cos - s * sin)))
        }
    }

    /// Has a hand lead a shared drive, or none.
    pub(crate) fn give(&mut self, to: &str, led: Option<Hand>) {
        self.drive.give(to, led);
    }

    /// The greatest value that it takes, or the least.
    pub(crate) fn extreme(&self, greatest: bool) -> f64 {
        if greatest { self.drive.greatest() } else { self.drive.least() }
    }

    /// The larger of what a number that is the first of two where it is 0 and the second where it is 1 comes to where
    /// it is at its greatest and at its least, or the smaller of both.
    pub(crate) fn thickest(&self, [at_zero, at_one]: [f64; 2], larger: bool) -> f64 {
        let [a, b] = [true, false].map(|greatest| at_zero + (at_one - at_zero) * self.extreme(greatest));
        if larger { a.max(b) } else { a.min(b) }
    }

    /// Where it stands still at that value.
    pub(crate) fn at_extreme(&self, greatest: bool) -> Self {
        Self { drive: Drive::Constant(self.extreme(greatest)), turns: Vec::new() }
    }

    /// Until when [s] it changes.
    pub(crate) fn until(&self) -> f64 {
        self.drive.until()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::drive::Wave;

    fn wave(wavelength: Option<f64>) -> Wave {
        Wave { mean: 0.5, amplitude: 0.5, period: 0.8, phase: 0.3, wavelength, start: 0.1 }
    }

    #[test]
    fn a_wave_runs_along_a_fibre_as_it_swings_in_time() {
        let (along, still) = (wave(Some(0.05)), wave(None));
        let places = [0.0, 0.01, 0.03];
        let driven = DriveAlong::new(&Drive::Wave(along), places.into_iter());
        for time in [0.0, 0.3, 5.0] {
            let values = driven.at(time);
            for (k, place) in places.iter().enumerate() {
                let late = Wave { phase: still.phase + TAU * place / 0.05, ..still };
                assert!((values(k) - Drive::Wave(late).at(time).0).abs() < 1e-14, "{place} m, {time} s");
            }
        }
    }
}
