//! What a fibre stands.

/// What a fibre stands before it breaks; infinite where it never does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BreakLimits {
    /// Turn away from the rest shape at a vertex [rad].
    pub angle: f64,
    /// Force that an edge carries, the volume fraction included [N].
    pub tension: f64,
}

impl Default for BreakLimits {
    fn default() -> Self {
        Self { angle: f64::INFINITY, tension: f64::INFINITY }
    }
}

impl BreakLimits {
    /// Whether it can break at all.
    pub fn is_finite(&self) -> bool {
        self.angle.is_finite() || self.tension.is_finite()
    }
}

/// The greatest ratio of a load to its limit and where it is; zero where there is none.
pub(super) fn furthest(ratios: impl Iterator<Item = (f64, usize)>) -> (f64, usize) {
    ratios.fold((0.0, 0), |most, ratio| if ratio.0 > most.0 { ratio } else { most })
}
