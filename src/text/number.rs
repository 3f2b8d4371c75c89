//! Numbers for people: how many figures and places behind the point each kind gets, and when a power of ten is better.

use std::ops::Range;

/// A value to four figures, for a table.
pub(crate) fn four_figures(value: f64) -> String {
    figures(value, 4, 1e-3..1e5)
}

/// A value to three figures, beside a picture or a curve.
pub(crate) fn three_figures(value: f64) -> String {
    figures(value, 3, 1e-3..1e4)
}

/// A value in as few characters as it needs, for a field: up to four places behind the point, no zeros at its end.
pub(crate) fn compact(value: f64) -> String {
    if value == 0.0 || (1e-2..1e5).contains(&value.abs()) {
        let text = format!("{value:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.3e}")
    }
}

/// A value at an axis of marks `step` apart, of which the one farthest from zero has the size `largest`: with as many
/// places as its neighbours need to differ.
pub(crate) fn tick(value: f64, step: f64, largest: f64) -> String {
    /// Most places behind the point.
    const MOST: usize = 6;
    if value == 0.0 || value.abs() < 1e-6 * step {
        "0".to_owned()
    } else if (1e-2..1e5).contains(&largest) {
        format!("{value:.*}", places(step).min(MOST))
    } else {
        format!("{value:.1e}")
    }
}

/// A ratio with two figures at least.
pub(crate) fn ratio(value: f64) -> String {
    let fine = if value > 0.0 { places(value) + 1 } else { 0 };
    format!("{value:.*}", fine.max(2))
}

/// A share as a whole percentage: "40 %".
pub(crate) fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

/// A time [s] at an axis of times `step` [s] apart: from a step of one second on in minutes and seconds.
pub(crate) fn time_tick(time: f64, step: f64) -> String {
    if step < 1.0 { format!("{time:.*} s", places(step)) } else { whole_seconds(time) }
}

/// A point in time [s] as fine as frames of this length [s] need it.
pub(crate) fn moment(time: f64, frame: f64) -> String {
    format!("{time:.*} s", places(frame).max(2))
}

/// How long something lasts [s].
pub(crate) fn duration(seconds: f64) -> String {
    let fine = if seconds > 0.0 { places(seconds) } else { 0 };
    if seconds < 9.95 { format!("{seconds:.*} s", fine.max(1)) } else { whole_seconds(seconds) }
}

/// A length of 1, 2 or 5 times a power of ten [m], in the unit in which it is said.
pub(crate) fn round_length(metres: f64) -> String {
    let units = [(1e3, "km"), (1.0, "m"), (1e-2, "cm"), (1e-3, "mm"), (1e-6, "µm")];
    let (size, unit) = units.into_iter().find(|(size, _)| metres >= 0.999_999 * size).unwrap_or((1e-6, "µm"));
    let figure = metres / size;
    if figure >= 0.999_999 { format!("{figure:.0} {unit}") } else { format!("{figure} {unit}") }
}

/// Memory taken of what may be taken [bytes].
pub(crate) fn memory(taken: usize, most: usize) -> String {
    const MIB: f64 = (1 << 20) as f64;
    let [taken, most] = [taken, most].map(|bytes| bytes as f64 / MIB);
    if most < 1024.0 {
        format!("{taken:.0} of {most:.0} MiB")
    } else {
        format!("{:.1} of {:.0} GiB", taken / 1024.0, most / 1024.0)
    }
}

/// A value to so many figures; with a power of ten where its size lies outside `plain`.
fn figures(value: f64, count: i32, plain: Range<f64>) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if plain.contains(&size) {
        let places = (count - 1 - size.log10().floor() as i32).max(0);
        format!("{value:.*}", places.cast_unsigned() as usize)
    } else {
        format!("{value:.*e}", (count - 1).cast_unsigned() as usize)
    }
}

/// Places behind the point that tell multiples of a step apart.
fn places(step: f64) -> usize {
    (-step.log10() - 1e-9).ceil().clamp(0.0, 9.0) as usize
}

/// A time of whole seconds [s]: seconds, or minutes and seconds.
fn whole_seconds(time: f64) -> String {
    let seconds = time.round() as u64;
    if seconds < 60 { format!("{seconds} s") } else { format!("{}:{:02}", seconds / 60, seconds % 60) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_figures() {
        let cases = [(0.0, "0"), (1949.64, "1950"), (-0.012_345, "-0.01235"), (12.0, "12.00"), (3.2e-5, "3.200e-5")];
        for (value, expected) in cases {
            assert_eq!(four_figures(value), expected);
        }
        assert_eq!(four_figures(f64::NAN), "NaN");
    }

    #[test]
    fn three_digits_count() {
        let shown = [0.0, 0.012_345, 0.5, 12.345, 1234.5, 123_456.0, 1.2e-6].map(three_figures);
        assert_eq!(shown, ["0", "0.0123", "0.500", "12.3", "1234", "1.23e5", "1.20e-6"]);
    }

    #[test]
    fn numbers_take_few_characters() {
        for (value, text) in [(0.0, "0"), (0.33, "0.33"), (1e5, "1.000e5"), (1250.0, "1250"), (-9.81, "-9.81")] {
            assert_eq!(compact(value), text);
        }
    }

    #[test]
    fn ticks_have_the_digits_that_they_need() {
        assert_eq!(tick(0.1 + 0.2, 0.1, 0.9), "0.3");
        assert_eq!(tick(250.0, 50.0, 400.0), "250");
        assert_eq!(tick(2e-5, 1e-5, 5e-5), "2.0e-5");
        assert_eq!(tick(1e-20, 0.1, 0.9), "0");
        assert_eq!(tick(0.02, 1e-8, 0.02), "0.020000", "six places are enough");
    }

    #[test]
    fn times_ratios_and_memory_are_written_as_people_do() {
        assert_eq!(
            [0.0, 0.0083, 0.5, 9.2, 12.4, 112.0].map(duration),
            ["0.0 s", "0.008 s", "0.5 s", "9.2 s", "12 s", "1:52"]
        );
        assert_eq!([1.0 / 60.0, 0.002, 5e-5].map(|frame| moment(0.01234, frame)), ["0.01 s", "0.012 s", "0.01234 s"]);
        assert_eq!(
            [(0.3, 0.1), (0.012, 2e-3), (30.0, 15.0), (90.0, 15.0)].map(|(time, step)| time_tick(time, step)),
            ["0.3 s", "0.012 s", "30 s", "1:30"]
        );
        assert_eq!([0.0, 0.004_12, 0.03, 0.995, 1.5].map(ratio), ["0.00", "0.0041", "0.030", "0.99", "1.50"]);
        assert_eq!(percent(0.4), "40 %");
        assert_eq!(memory(214 << 20, 512 << 20), "214 of 512 MiB");
        assert_eq!(memory(214 << 20, 8 << 30), "0.2 of 8 GiB");
    }

    #[test]
    fn lengths_have_a_unit_that_suits_them() {
        let lengths = [2e-3, 0.01, 0.2, 0.5, 2.0, 1e3, 2e-5].map(round_length);
        assert_eq!(lengths, ["2 mm", "1 cm", "20 cm", "50 cm", "2 m", "1 km", "20 µm"]);
    }
}
