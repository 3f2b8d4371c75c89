//! The body that is drawn into.

use crate::draw::Bounds;
use crate::sim::Published;
use crate::solver::snapshot::Snapshot;
use glam::DVec3;
use std::sync::Arc;

/// The active body, in the order of the snapshot.
#[derive(Debug, Default)]
pub(crate) struct ActiveBody {
    /// Which it is.
    pub index: usize,
    /// The body alone, at rest in its model frame.
    pub model: Arc<Snapshot>,
}

impl ActiveBody {
    /// Takes over how the body looks at rest.
    pub(crate) fn take_model(&mut self, published: &Published) {
        let bodies = published.at_rest.bodies.get(self.index).cloned().into_iter().collect();
        self.model = Arc::new(Snapshot { bodies, ..Snapshot::default() });
    }

    /// The box around the body at rest [m], by its skin where it has one; none before it is there.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        let body = self.model.bodies.first();
        let points = body.into_iter().flat_map(|body| if body.skin.is_empty() { &body.particles } else { &body.skin });
        Bounds::of(points.copied())
    }

    /// Diagonal of that box [m]; a hand's size before the body is there.
    pub(crate) fn diagonal(&self) -> f64 {
        self.bounds().map_or(0.1, |bounds| 2.0 * bounds.radius())
    }

    /// Least and greatest corner of that box [m].
    pub(crate) fn corners(&self) -> Option<[DVec3; 2]> {
        self.bounds().map(|bounds| [bounds.min, bounds.max])
    }
}
