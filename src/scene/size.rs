//! How many particles bodies are made of, as far as the document and the models tell.

use super::{Body, Shape, TwoLayer, TwoLayerShape};
use crate::geometry::lattice::points_looked_at;
use glam::{DMat3, DVec3};

/// Memory that a material particle takes with its neighbours [bytes].
pub(crate) const BYTES_PER_PARTICLE: f64 = 2500.0;

impl Body {
    /// About how many particles fill it, a mesh of this volume [m³]; none where that is asked for and not known.
    pub(crate) fn about_particles(&self, volume: Option<f64>) -> Option<f64> {
        let spacing = self.material.spacing();
        match &self.shape {
            Shape::Box(shape) => {
                let turn = &shape.lattice_rotation;
                let axes = if turn.degrees == 0.0 {
                    DMat3::IDENTITY
                } else {
                    let axis = DVec3::from_array(turn.axis).normalize_or(DVec3::Y);
                    DMat3::from_axis_angle(axis, turn.degrees.to_radians())
                };
                Some(points_looked_at(DVec3::from_array(shape.size), spacing, axes))
            }
            Shape::Mesh(shape) if shape.particles.is_some() => shape.particles.map(f64::from),
            Shape::Mesh(_) => volume.map(|volume| volume / spacing.powi(3)),
            round => round.volume().map(|volume| volume / spacing.powi(3)),
        }
    }
}

impl TwoLayer {
    /// How many particles it has, with a mesh of so many points; none where that is asked for and not known.
    pub(crate) fn about_particles(&self, points: Option<usize>) -> Option<f64> {
        let (points, single) = match &self.shape {
            TwoLayerShape::Segment(_) => return Some(2.0),
            TwoLayerShape::Ring(ring) => (f64::from(ring.sides), ring.single_layer),
            // An octahedron cut in four again and again.
            TwoLayerShape::Ball(ball) => {
                (2_f64.powf(2.0 * f64::from(ball.subdivisions) + 2.0) + 2.0, ball.single_layer)
            }
            TwoLayerShape::Mesh(mesh) => (points? as f64, mesh.single_layer),
        };
        Some(if single { points } else { 2.0 * points })
    }
}
