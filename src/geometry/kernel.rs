//! The smoothing kernel of eq. 13, normalised.
//!
//! Eq. 13 as printed integrates to `16 pi h³ / 105` over its ball; dividing by that makes the kernel a density [1/m³],
//! so that `V W` is dimensionless and sums to about one inside a body.

use std::f64::consts::PI;

/// Normalised quartic kernel `W(r) = 105 / (16 pi h³) (1 - 6 q² + 8 q³ - 3 q⁴)`, `q = r / h`, zero beyond `h`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kernel {
    /// Support radius h [m].
    pub support_radius: f64,
    scale: f64,
}

impl Kernel {
    /// A kernel of support radius `h` [m].
    pub fn new(support_radius: f64) -> Self {
        Self { support_radius, scale: 105.0 / (16.0 * PI * support_radius.powi(3)) }
    }

    /// W at distance `r` [m], in 1/m³.
    pub fn value(&self, r: f64) -> f64 {
        let q = r / self.support_radius;
        if q >= 1.0 {
            return 0.0;
        }
        // 1 - 6 q² + 8 q³ - 3 q⁴ = (1 - q)³ (1 + 3 q): the factored form stays exact as q approaches 1.
        self.scale * (1.0 - q).powi(3) * (1.0 + 3.0 * q)
    }

    /// W at distance `r` over W at 0: 1 at the centre, 0 from `h` on.
    pub fn relative(&self, r: f64) -> f64 {
        self.value(r) / self.scale
    }

    /// `-W'(r) / r` [1/m⁵]; finite and positive for every `r` inside the support, the centre included.
    pub(crate) fn minus_slope_over_r(&self, r: f64) -> f64 {
        let h = self.support_radius;
        let q = r / h;
        if q >= 1.0 {
            return 0.0;
        }
        12.0 * self.scale * (1.0 - q).powi(2) / (h * h)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrates_to_one_over_its_ball() {
        let kernel = Kernel::new(0.015);
        let n = 20_000;
        let dr = kernel.support_radius / f64::from(n);
        let integral: f64 = (0..n)
            .map(|k| {
                let r = (f64::from(k) + 0.5) * dr;
                4.0 * PI * r * r * kernel.value(r) * dr
            })
            .sum();
        assert!((integral - 1.0).abs() < 1e-7, "{integral}");
    }

    #[test]
    fn slope_matches_the_value() {
        let kernel = Kernel::new(0.015);
        for r in [0.001, 0.004, 0.009, 0.0149] {
            let d = 1e-8;
            let slope = (kernel.value(r + d) - kernel.value(r - d)) / (2.0 * d);
            let expected = -slope / r;
            assert!((kernel.minus_slope_over_r(r) - expected).abs() <= 1e-6 * expected, "{r}");
        }
        assert_eq!(kernel.value(0.015), 0.0);
        assert_eq!(kernel.relative(0.0), 1.0);
    }
}
