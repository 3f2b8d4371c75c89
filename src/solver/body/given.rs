//! What a body was given from outside.

use glam::DVec3;

/// What was given to a body so far, beside what moved pins, colliders and forces from outside do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::solver) struct Given {
    /// Work of kicks by other bodies and panels [J].
    pub(in crate::solver) by_others: f64,
    /// Work done by hand: of blows, and of grabs that were set, moved and taken away [J].
    pub(in crate::solver) by_hand: f64,
    /// Linear momentum [kg m/s], and angular about the centre of mass [kg m²/s].
    pub(in crate::solver) momenta: [DVec3; 2],
    /// Energy of the grabs before they were changed, where that has not been counted yet [J].
    pub(super) grabs_before: Option<f64>,
}
