//! The measures of a world.

use super::World;
use super::probe::Probe;
use crate::solver::measure::MeasureValue;

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
