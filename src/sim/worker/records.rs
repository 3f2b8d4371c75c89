//! What is recorded of every frame. It does not go with the pictures, of which a busy window misses some.

use super::Loop;
use crate::sim::{Runner, TimeSeries};
use std::sync::PoisonError;

/// Rows that are kept: ten minutes at sixty frames a second.
const KEPT: usize = 36_000;

/// Readings of every frame since the start of the scene, or since it has other bodies or measures.
#[derive(Clone, Debug, Default)]
pub struct RecordedSeries {
    /// Of the world.
    pub world: TimeSeries,
    /// Of the scene that runs in step, since it does; none where there is none.
    pub ghost: Option<TimeSeries>,
}

impl Loop {
    /// Reads the present frame: again, where nothing has moved since the last time.
    pub(super) fn take_readings(&self) {
        let mut records = self.out.records.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(world) = self.runner.as_ref().map(Runner::world) {
            records.world.continue_with(world, KEPT);
            records.world.push(world);
        }
        match self.sights.world() {
            Some(world) => records.ghost.get_or_insert_with(|| TimeSeries::new(world, KEPT)).push(world),
            None => records.ghost = None,
        }
    }

    /// Ends what was recorded of a document that another one follows.
    pub(super) fn forget_readings(&self) {
        *self.out.records.lock().unwrap_or_else(PoisonError::into_inner) = RecordedSeries::default();
    }

    /// Ends what was recorded of a ghost that another one follows.
    pub(super) fn forget_ghost(&self) {
        self.out.records.lock().unwrap_or_else(PoisonError::into_inner).ghost = None;
    }
}
