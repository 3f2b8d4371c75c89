//! Moves and turns of the world.

use glam::{DQuat, DVec3};

/// A move and a turn of the world.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rigid {
    pub turn: DQuat,
    pub offset: DVec3,
}

impl Rigid {
    pub(super) fn apply(&self, point: [f64; 3]) -> [f64; 3] {
        (self.turn * DVec3::from_array(point) + self.offset).to_array()
    }

    pub(super) fn direction(&self, direction: [f64; 3]) -> [f64; 3] {
        if self.turn == DQuat::IDENTITY { direction } else { (self.turn * DVec3::from_array(direction)).to_array() }
    }
}
