//! What is measured of a world.

use crate::solver::body::Body;
use crate::solver::measure::{MeasureValue, Quantity};

/// A named measure of one body.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// Name in reports.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// What is read.
    pub(crate) quantity: Quantity,
    /// Whether the greatest value over time is kept, of every step, so that it does not depend on the frame rate.
    pub(crate) peak: bool,
}

impl Probe {
    /// Keeps the present value at a time [s] where it is greater than the greatest so far.
    pub(super) fn raise(&self, peak: &mut MeasureValue, body: &Body, time: f64) {
        let value = self.quantity.read(body, time);
        if value.magnitude() > peak.magnitude() {
            *peak = value;
        }
    }
}
