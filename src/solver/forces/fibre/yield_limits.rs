//! What a fibre stands before it yields.

/// What a fibre stands before it yields; infinite where it never does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct YieldLimits {
    /// Force that an edge carries, the volume fraction included [N].
    pub(crate) tension: f64,
    /// Curvature away from the rest shape [rad/m].
    pub(crate) curvature: f64,
}

impl Default for YieldLimits {
    fn default() -> Self {
        Self { tension: f64::INFINITY, curvature: f64::INFINITY }
    }
}

impl YieldLimits {
    /// Whether it can yield at all.
    pub(crate) fn is_finite(&self) -> bool {
        self.tension.is_finite() || self.curvature.is_finite()
    }
}
