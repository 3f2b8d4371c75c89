//! Where a body can be taken hold of, and where it is.

use super::Body;
use crate::solver::embedding::EmbeddingWeights;
use crate::solver::forces::Grab;
use glam::DVec3;

impl Body {
    /// Grabs a point of the body and pulls it towards `target` [m]: by the paper's spring of a two-layer body, or
    /// one that is scaled to the body for others.
    pub fn grab(&mut self, point: EmbeddingWeights, target: DVec3) {
        let grab = match &self.parts.layers {
            Some(layers) => {
                let [stiffness, damping] = layers.grab;
                Grab { point, target, stiffness, damping, until: f64::INFINITY }
            }
            None => Grab::scaled(point, target, &self.parts.state, self.parts.resolved_dt()),
        };
        self.grabs_mut().push(grab);
    }

    /// Grabs of the body, to be added, moved and taken away.
    pub(crate) fn grabs_mut(&mut self) -> &mut Vec<Grab> {
        self.note_grabs();
        self.current = false;
        &mut self.grabs
    }

    /// Grabs of the body.
    pub fn grabs(&self) -> &[Grab] {
        &self.grabs
    }

    /// The point of the skin's vertex, or of the particle where there is no skin; none if there is no such vertex. Of a
    /// vertex too far outside for particles to carry it there, the point that they do carry.
    pub fn point(&self, vertex: usize) -> Option<EmbeddingWeights> {
        match self.skin() {
            Some(skin) => skin.weights(vertex),
            None => (vertex < self.parts.state.len()).then(|| EmbeddingWeights::of_particle(vertex as u32)),
        }
    }

    /// From [`Body::point`] to the skin's vertex itself [m]; zero where that is carried there, as nearly all are.
    pub(crate) fn arm(&self, vertex: usize) -> DVec3 {
        self.skin().map_or(DVec3::ZERO, |skin| skin.arm(vertex, &self.parts.state.positions))
    }
}
