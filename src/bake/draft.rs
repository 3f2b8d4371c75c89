//! A body on the way.

use super::thin_places::ThinPlaces;
use crate::solver::body::BodyParts;
use std::collections::HashMap;

/// A body put together but for its time step, which depends on the others.
pub(super) struct Draft {
    pub(super) parts: BodyParts,
    /// Particles of every region by its id.
    pub(super) regions: HashMap<String, Vec<u32>>,
    /// Greatest stable step [s] under every integrator, in the order of [`crate::scene::IntegratorKind::ALL`].
    pub(super) stable_steps: Vec<f64>,
    /// Volume fraction of fibre at every particle; none of a two-layer body.
    pub(super) fractions: Vec<f64>,
    /// Where it is thinner than its particles resolve, as far as that is said.
    pub(super) thin: ThinPlaces,
}
