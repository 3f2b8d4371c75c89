//! The numbers of every frame. They do not go with the pictures, of which a busy window misses some.

use crate::sim::series::TimeSeries;
use crate::solver::world::World;

/// Rows that are kept: ten minutes at sixty frames a second.
const MOST_ROWS: usize = 36_000;

/// Energies, momenta and measures of every frame since the start of the scene, or since it has other bodies or
/// measures.
#[derive(Clone, Debug, Default)]
pub struct TimeSeriesSet {
    /// Of the world.
    pub world: TimeSeries,
    /// Of the scene that runs in step, since it does; none where there is none.
    pub ghost: Option<TimeSeries>,
}

impl TimeSeriesSet {
    /// Adds the present frame of the world and of the ghost: again, where nothing has moved since the last time.
    pub(super) fn record(&mut self, world: Option<&World>, ghost: Option<&World>) {
        if let Some(world) = world {
            self.world.continue_with(world, MOST_ROWS);
            self.world.push(world);
        }
        match ghost {
            Some(world) => {
                let ghost = self.ghost.get_or_insert_with(|| TimeSeries::new(world, MOST_ROWS));
                ghost.continue_with(world, MOST_ROWS);
                ghost.push(world);
            }
            None => self.ghost = None,
        }
    }
}
