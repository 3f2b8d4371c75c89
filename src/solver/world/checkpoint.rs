//! What a world goes on from: kept frame by frame, it lets a motion be looked at again and taken up anywhere.

use super::eased::Eased;
use super::grips::Grips;
use super::watched::Watch;
use super::work::DoneWork;
use crate::solver::body::checkpoint::BodyCheckpoint;
use crate::solver::measure::MeasureValue;

/// Everything of a world that moving changes: about 120 bytes a particle. A world that goes back to it moves on as
/// if nothing had happened since, bit for bit.
#[derive(Clone)]
pub struct Checkpoint {
    pub(super) bodies: Vec<BodyCheckpoint>,
    /// Height [m] and velocity [m/s] of every panel.
    pub(super) panels: Vec<[f64; 2]>,
    pub(super) peaks: Vec<MeasureValue>,
    pub(super) contact_current: bool,
    pub(super) panel_pushes: Vec<f64>,
    pub(super) work: DoneWork,
    pub(super) watch: Watch,
    pub(super) eased: Eased,
    pub(super) grips: Grips,
    pub(super) since: f64,
    pub(super) frame: u64,
}

impl Checkpoint {
    /// Memory that it takes [bytes].
    pub fn bytes(&self) -> usize {
        let bodies: usize = self.bodies.iter().map(BodyCheckpoint::bytes).sum();
        let rest = size_of_val(&*self.panels)
            + size_of_val(&*self.peaks)
            + size_of_val(&*self.panel_pushes)
            + size_of_val(&*self.work.on_bodies)
            + self.watch.bytes();
        size_of_val(self) + bodies + rest + self.eased.bytes() + self.grips.bytes()
    }
}
