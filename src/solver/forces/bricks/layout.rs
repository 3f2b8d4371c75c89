//! Which particle lies where.

use super::alignment::Alignment;
use crate::solver::wide::Lanes;
use glam::IVec3;
use std::collections::{HashMap, HashSet};

/// A place of a brick without a particle.
pub(crate) const NO_PARTICLE: u32 = u32::MAX;

/// The bricks of a body, row after row.
pub(crate) struct Bricks {
    /// Where every brick lies: its cells' index along the rows with x in units of bricks, in order of z, y, x.
    pub positions: Vec<IVec3>,
    /// Particle at every place, [`NO_PARTICLE`] where there is none.
    particles: Vec<u32>,
    /// Place of every particle: its brick's number times the lanes of a brick, plus its lane.
    pub places: Vec<u32>,
    /// Lanes of a brick.
    lanes: usize,
}

impl Bricks {
    /// The bricks of particles in these lattice cells.
    pub(crate) fn new(cells: &[IVec3], alignment: Alignment) -> Self {
        let cells: Vec<IVec3> = cells.iter().map(|&cell| alignment.cell(cell)).collect();
        let mut positions: Vec<IVec3> =
            cells.iter().map(|&cell| alignment.brick_of(cell)).collect::<HashSet<_>>().into_iter().collect();
        positions.sort_unstable_by_key(|brick| (brick.z, brick.y, brick.x));
        let numbers: HashMap<IVec3, u32> = (0..).zip(&positions).map(|(k, &brick)| (brick, k)).collect();
        let lanes = alignment.length() as usize;
        let mut particles = vec![NO_PARTICLE; lanes * positions.len()];
        let mut places = Vec::with_capacity(cells.len());
        for (i, &cell) in cells.iter().enumerate() {
            let place = lanes * numbers[&alignment.brick_of(cell)] as usize + alignment.lane_of(cell);
            particles[place] = i as u32;
            places.push(place as u32);
        }
        Self { positions, particles, places, lanes }
    }

    /// Number of bricks.
    pub(crate) fn len(&self) -> usize {
        self.positions.len()
    }

    /// Lanes of a brick.
    pub(crate) fn lanes(&self) -> usize {
        self.lanes
    }

    /// Particles of a brick, [`NO_PARTICLE`] where there is none.
    #[inline(always)]
    pub(crate) fn particles(&self, brick: usize) -> &[u32] {
        &self.particles[self.lanes * brick..self.lanes * (brick + 1)]
    }

    /// Particles of every brick.
    pub(crate) fn all_particles(&self) -> std::slice::ChunksExact<'_, u32> {
        self.particles.chunks_exact(self.lanes)
    }
}

/// Brick and lane of a place.
#[inline(always)]
pub(crate) fn brick_and_lane<L: Lanes>(place: u32) -> (usize, usize) {
    (place as usize / L::COUNT, place as usize % L::COUNT)
}
