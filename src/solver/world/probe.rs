//! What is measured of a world.

use super::World;
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

impl World {
    /// What each measure is to report: its present value, or the greatest one over time with its sign.
    pub fn reported_measures(&self) -> Vec<MeasureValue> {
        let chosen =
            |((probe, now), &peak): ((&Probe, MeasureValue), &MeasureValue)| if probe.peak { peak } else { now };
        self.probes.iter().zip(self.measures()).zip(&self.peaks).map(chosen).collect()
    }

    /// Present values of the measures.
    pub fn measures(&self) -> Vec<MeasureValue> {
        self.probes.iter().map(|probe| probe.quantity.read(&self.bodies[probe.body], self.time())).collect()
    }
}
