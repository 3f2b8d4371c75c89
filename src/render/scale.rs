//! Metric steps: how far apart the lines of a grid are, and how long the bar is that tells its scale.

use crate::text::number::round_length;

/// Minor lines are at least this far apart [pixels at scale 1].
const CLOSEST: f64 = 9.0;

/// Steps of a grid at some zoom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Steps {
    /// Distance of minor lines [m], a power of ten.
    pub(super) minor: f64,
    /// Opacity of minor lines from 0 to 1: they appear as they get room.
    pub(super) strength: f64,
    /// Distance of major lines [m]: ten minor ones.
    pub(super) major: f64,
}

/// Steps where a pixel at scale 1 covers so many metres.
pub(super) fn steps(metres_per_pixel: f64) -> Steps {
    let exponent = (CLOSEST * metres_per_pixel).log10();
    let minor = 10_f64.powi(exponent.ceil() as i32);
    Steps { minor, strength: 1.0 - (exponent - exponent.floor()).powi(3), major: 10.0 * minor }
}

/// A bar's length [m]: 1, 2 or 5 times a power of ten, the longest not above `most` [m]; and in words.
pub(super) fn bar(most: f64) -> (f64, String) {
    let decade = 10_f64.powi(most.log10().floor() as i32);
    let factor = [5.0, 2.0].into_iter().find(|factor| factor * decade <= most).unwrap_or(1.0);
    let length = factor * decade;
    (length, round_length(length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_decades_with_room_for_their_lines() {
        for k in 0..200 {
            let pixel = 1e-7 * 1.13_f64.powi(k);
            let steps = steps(pixel);
            assert!(steps.minor / pixel >= 0.999 * CLOSEST && steps.minor / pixel < 10.001 * CLOSEST);
            assert!((0.0..=1.0).contains(&steps.strength));
        }
    }

    #[test]
    fn bars_are_one_two_or_five_of_a_unit() {
        let words: Vec<String> = [0.0034, 0.012, 0.2, 0.6, 3.0, 1500.0, 2.5e-5].map(|most| bar(most).1).to_vec();
        assert_eq!(words, ["2 mm", "1 cm", "20 cm", "50 cm", "2 m", "1 km", "20 µm"]);
        assert!(bar(0.0099).0 <= 0.0099);
    }
}
