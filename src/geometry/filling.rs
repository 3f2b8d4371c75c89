//! What comes of filling a solid: its particles, and what each of them stands for.

use super::lattice::LatticeSample;
use super::thinness::Thinness;
use glam::DVec3;
use std::array::from_fn;

/// A filled solid.
#[derive(Clone, Debug, PartialEq)]
pub struct Filling {
    /// The particles.
    pub sample: LatticeSample,
    /// Particles' volume over the solid's, minus one.
    pub volume_error: f64,
    /// Particles in parts of one layer, and of two.
    pub thinness: Thinness,
    /// Lattice points inside that were left out because too few others are around them to hold them.
    pub pruned: usize,
    /// Those [m].
    pub(crate) left_out: Vec<DVec3>,
    /// What each particle stands for; a whole cell where nothing is said.
    pub(crate) shares: Option<CellShares>,
}

/// What particles stand for, in cells.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CellShares {
    /// Volume of the shape that is nearest to each particle; all of them are the shape's.
    pub(crate) volumes: Vec<f64>,
    /// Volume that each counts as when it resists, by which the second moments of the whole are the shape's, too.
    pub(crate) stiffness: Vec<f64>,
}

impl CellShares {
    /// Those of the particles that are kept.
    pub(crate) fn chosen(&self, kept: &[u32]) -> Self {
        let of = |shares: &[f64]| kept.iter().map(|&i| shares[i as usize]).collect();
        Self { volumes: of(&self.volumes), stiffness: of(&self.stiffness) }
    }

    /// Least and greatest volume.
    pub(crate) fn range(&self) -> [f64; 2] {
        let volumes = || self.volumes.iter().copied();
        from_fn(|k| if k == 0 { volumes().fold(f64::INFINITY, f64::min) } else { volumes().fold(0.0, f64::max) })
    }
}

/// A filling that is asked for twice: first to see whether it does, then for good.
#[derive(Clone, Debug)]
pub(crate) struct KnownFilling {
    /// Particles that were asked for.
    pub(crate) particles: u32,
    /// Support radius over the spacing.
    pub(crate) reach: f64,
    /// Most particles that were allowed.
    pub(crate) limit: usize,
    /// What came of it.
    pub(crate) filling: Filling,
}
