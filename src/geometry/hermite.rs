//! Cubic curves of one number, by values and slopes at both ends (Hermite's).

/// A cubic from one value and slope to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hermite {
    /// How far it goes, above zero.
    pub(crate) span: f64,
    /// Values at both ends.
    pub(crate) values: [f64; 2],
    /// Slopes there.
    pub(crate) slopes: [f64; 2],
}

impl Hermite {
    /// Value at a way from its start, and its slope there.
    pub(crate) fn at(&self, way: f64) -> (f64, f64) {
        let Self { span, values: [a, b], slopes: [p, q] } = *self;
        let s = way / span;
        let between = a + (b - a) * s * s * (3.0 - 2.0 * s);
        let value = between + span * (p * s * (1.0 - s) * (1.0 - s) - q * s * s * (1.0 - s));
        let rise = (b - a) * 6.0 * s * (1.0 - s);
        (value, (rise + span * (p * (1.0 - s) * (1.0 - 3.0 * s) + q * s * (3.0 * s - 2.0))) / span)
    }

    /// Ways between its ends at which it turns.
    pub(crate) fn turns(&self) -> impl Iterator<Item = f64> + use<> {
        let Self { span, values: [a, b], slopes } = *self;
        let [p, q] = slopes.map(|slope| slope * span);
        // The derivative by the share of the way, c2 s² + c1 s + c0.
        let [c2, c1, c0] = [3.0 * (p + q) - 6.0 * (b - a), 6.0 * (b - a) - 4.0 * p - 2.0 * q, p];
        let root = (c1 * c1 - 4.0 * c2 * c0).max(0.0).sqrt();
        // No digits are lost where one coefficient is small.
        let half = -0.5 * (c1 + root.copysign(c1));
        [half / c2, c0 / half].into_iter().filter(|s| *s > 0.0 && *s < 1.0).map(move |s| s * span)
    }

    /// The least and the greatest value from end to end.
    pub(crate) fn range(&self) -> [f64; 2] {
        let [a, b] = self.values;
        let turned = self.turns().map(|way| self.at(way).0);
        turned.fold([a.min(b), a.max(b)], |[least, most], value| [least.min(value), most.max(value)])
    }
}

/// The least and the greatest value of a course that is these cubics one after the other, or straight between these
/// values.
pub(crate) fn range_of(values: impl Iterator<Item = f64>, cubics: impl Iterator<Item = Hermite>) -> [f64; 2] {
    let ranges = values.map(|value| [value; 2]).chain(cubics.map(|cubic| cubic.range()));
    ranges.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], [a, b]| [least.min(a), most.max(b)])
}

#[cfg(test)]
mod tests {
    use super::*;

    const CURVES: [Hermite; 6] = [
        Hermite { span: 0.5, values: [1.0, 3.0], slopes: [0.0, 0.0] },
        Hermite { span: 2.0, values: [1.0, 1.0], slopes: [3.0, -3.0] },
        Hermite { span: 2.0, values: [0.0, 1.0], slopes: [-4.0, 5.0] },
        Hermite { span: 1.0, values: [0.0, 1.0], slopes: [1.0, 1.0] },
        Hermite { span: 1.0, values: [0.0, 1.0], slopes: [6.0, 0.0] },
        Hermite { span: 0.3, values: [2.0, 2.0], slopes: [0.0, 0.0] },
    ];

    #[test]
    fn ends_and_slopes_are_met_and_slopes_are_those_of_the_values() {
        for curve in CURVES {
            for (end, way) in [0.0, curve.span].into_iter().enumerate() {
                let (value, slope) = curve.at(way);
                assert!((value - curve.values[end]).abs() < 1e-14, "{curve:?}");
                assert!((slope - curve.slopes[end]).abs() < 1e-13, "{curve:?}");
            }
            for share in [0.1, 0.35, 0.6, 0.9] {
                let way = share * curve.span;
                let difference = (curve.at(way + 1e-6).0 - curve.at(way - 1e-6).0) / 2e-6;
                assert!((difference - curve.at(way).1).abs() < 1e-7, "{curve:?} {share}");
            }
        }
    }

    #[test]
    fn ranges_are_those_of_many_values() {
        for curve in CURVES {
            let values = (0..=4000).map(|k| curve.at(curve.span * f64::from(k) / 4000.0).0);
            let [least, most] = values
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| [least.min(value), most.max(value)]);
            let found = curve.range();
            assert!((found[0] - least).abs() < 1e-6 && (found[1] - most).abs() < 1e-6, "{curve:?}: {found:?}");
        }
    }
}
