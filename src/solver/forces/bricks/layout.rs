//! Which particle lies where.

use super::alignment::{Alignment, brick_of, lane_of};
use crate::solver::wide::LANES;
use glam::IVec3;
use std::collections::{HashMap, HashSet};

/// A place of a brick without a particle.
pub(crate) const NO_PARTICLE: u32 = u32::MAX;

/// The bricks of a body, row after row.
pub(crate) struct Bricks {
    /// Where every brick lies: its cells' index along the rows with x in units of bricks, in order of z, y, x.
    pub positions: Vec<IVec3>,
    /// Particles of every brick, [`NO_PARTICLE`] where there is none.
    pub particles: Vec<[u32; LANES]>,
    /// Place of every particle: its brick's number times four, plus its lane.
    pub places: Vec<u32>,
}

impl Bricks {
    /// The bricks of particles in these lattice cells.
    pub(crate) fn new(cells: &[IVec3], alignment: Alignment) -> Self {
        let cells: Vec<IVec3> = cells.iter().map(|&cell| alignment.cell(cell)).collect();
        let mut positions: Vec<IVec3> =
            cells.iter().map(|&cell| brick_of(cell)).collect::<HashSet<_>>().into_iter().collect();
        positions.sort_unstable_by_key(|brick| (brick.z, brick.y, brick.x));
        let numbers: HashMap<IVec3, u32> = (0..).zip(&positions).map(|(k, &brick)| (brick, k)).collect();
        let mut particles = vec![[NO_PARTICLE; LANES]; positions.len()];
        let mut places = Vec::with_capacity(cells.len());
        for (i, &cell) in cells.iter().enumerate() {
            let (brick, lane) = (numbers[&brick_of(cell)], lane_of(cell));
            particles[brick as usize][lane] = i as u32;
            places.push(LANES as u32 * brick + lane as u32);
        }
        Self { positions, particles, places }
    }

    /// Number of bricks.
    pub(crate) fn len(&self) -> usize {
        self.positions.len()
    }
}

/// Brick and lane of a place.
#[inline(always)]
pub(crate) fn brick_and_lane(place: u32) -> (usize, usize) {
    (place as usize / LANES, place as usize % LANES)
}
