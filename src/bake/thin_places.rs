//! Where a body is thinner than its particles resolve: what is said of that is shown there.

use super::particle_sampling::ParticleSampling;
use crate::geometry::kernel::Kernel;
use crate::solver::skin::{Skin, SkinShape};
use glam::DVec3;
use std::sync::Arc;

/// Places in parts of a body that are too thin for its particles.
#[derive(Clone, Debug, Default)]
pub struct ThinPlaces {
    /// Particles in parts of hardly more than one layer, which bend too easily; none where there are so few that it is
    /// not said.
    pub particles: Vec<u32>,
    /// Places in parts of less than one, which have no particles: those around carry them.
    left_out: Option<Arc<Skin>>,
}

/// Places without particles that are kept, at most.
const KEPT: usize = 300;

impl ThinPlaces {
    /// Those of a body's particles.
    pub(super) fn of(sampling: &ParticleSampling<'_>, kernel: Kernel) -> Self {
        let apart = sampling.left_out.len().div_ceil(KEPT).max(1);
        let points: Vec<DVec3> =
            sampling.left_out.iter().step_by(apart).filter(|&&at| !sampling.hollows.contain(at)).copied().collect();
        let point_of: Vec<u32> = (0..points.len() as u32).collect();
        let shape = SkinShape { points: &points, point_of: &point_of, normals: &[], colours: &[], triangles: &[] };
        let carried = || Skin::embed(&shape, &sampling.sample.points, kernel, &mut |_, _| {});
        let left_out = if points.is_empty() { None } else { carried() };
        Self { particles: sampling.thin.clone(), left_out: left_out.map(Arc::new) }
    }

    /// Where they are with a body's particles at these places [m]: of those in single layers at most so many.
    pub fn places(&self, particles: &[DVec3], most: usize) -> Vec<DVec3> {
        let single = self.particles.iter().step_by(self.particles.len().div_ceil(most).max(1));
        let mut places: Vec<DVec3> = single.filter_map(|&k| particles.get(k as usize).copied()).collect();
        if let Some(skin) = &self.left_out {
            places.extend(skin.positions(particles));
        }
        places
    }
}
