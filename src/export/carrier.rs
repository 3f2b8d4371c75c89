//! How the vertices of a file ride on the particles of a body.
//!
//! Each of them is embedded by itself, where the file has it, as the points of a skin are. So those at the same place
//! move alike, the surface of the picture and this one are the same wherever nothing was repaired, and vertices that no
//! face uses, or of pieces that enclose nothing, go along.

use crate::geometry::file_mesh::FileMesh;
use crate::geometry::kernel::Kernel;
use crate::solver::body::Body;
use crate::solver::skin::{Skin, SkinShape};
use glam::DVec3;
use std::collections::HashMap;
use std::sync::Arc;

/// Coordinates beyond this are damage [m]; such vertices are put where the first sound one is.
const LARGEST: f64 = 1e9;

/// Time [s] over which velocities are taken: short beside any step, long beside rounding.
const INSTANT: f64 = 1e-6;

/// What carries the vertices of a mesh.
pub(super) enum Carrier {
    /// Vertices are the body's particles.
    Particles,
    /// Vertices are those of the body's skin.
    Skin(Arc<Skin>),
    /// Vertices hang on the particles; some are particles of a layer themselves (vertex, particle).
    Embedded { skin: Box<Skin>, particles: Vec<(u32, u32)> },
}

impl Carrier {
    /// Of a mesh over a body at rest, both in the body's model frame; the mesh comes back sound.
    pub(super) fn of_mesh(mut mesh: FileMesh, body: &Body) -> (FileMesh, Self) {
        let is_sound = |point: &DVec3| point.is_finite() && point.abs().max_element() <= LARGEST;
        let somewhere = mesh.points.iter().copied().find(is_sound).unwrap_or_default();
        mesh.move_points(|point| if is_sound(&point) { point } else { somewhere });
        let parts = body.parts();
        let layer = parts.layers.as_ref().map(|layers| &parts.model[..layers.outer]);
        let carrying = layer.unwrap_or(&parts.model);
        let kernel = Kernel::new(if layer.is_some() { width_of_layer(carrying) } else { parts.reach });
        let point_of: Vec<u32> = (0..mesh.points.len() as u32).collect();
        let shape = SkinShape { points: &mesh.points, point_of: &point_of, normals: &[], colours: &[], triangles: &[] };
        let Some(skin) = Skin::embed(&shape, carrying, kernel, &mut |_, _| {}) else {
            // There is nothing that could carry any.
            return (FileMesh::default(), Self::Particles);
        };
        let particles = layer.map_or_else(Vec::new, |layer| same_places(&mesh.points, layer));
        (mesh, Self::Embedded { skin: Box::new(skin), particles })
    }

    /// The vertices over particles at `positions` [m].
    pub(super) fn places(&self, positions: &[DVec3], outer: usize) -> Vec<DVec3> {
        match self {
            Self::Particles => positions.to_vec(),
            Self::Skin(skin) => skin.positions(positions),
            Self::Embedded { skin, particles } => {
                let mut places = skin.positions(&positions[..outer]);
                for &(vertex, particle) in particles {
                    places[vertex as usize] = positions[particle as usize];
                }
                places
            }
        }
    }

    /// Their velocities [m/s]: what hangs on arms turns with the particles, which is no sum over their velocities.
    pub(super) fn velocities(&self, positions: &[DVec3], velocities: &[DVec3], outer: usize) -> Vec<DVec3> {
        let after = |time: f64| {
            let moved: Vec<DVec3> = positions.iter().zip(velocities).map(|(&x, &v)| x + time * v).collect();
            self.places(&moved, outer)
        };
        let (before, after) = (after(-INSTANT), after(INSTANT));
        before.into_iter().zip(after).map(|(before, after)| (after - before) / (2.0 * INSTANT)).collect()
    }
}

/// About how far the particles of a layer lie apart, twice [m].
fn width_of_layer(layer: &[DVec3]) -> f64 {
    let (min, max) =
        layer.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(min, max), &p| (min.min(p), max.max(p)));
    (2.0 * (max - min).length() / (layer.len() as f64).sqrt()).max(f64::MIN_POSITIVE)
}

/// Points that lie where a particle does.
fn same_places(points: &[DVec3], particles: &[DVec3]) -> Vec<(u32, u32)> {
    // Minus zero is the same place as zero.
    let key = |point: DVec3| (point + 0.0).to_array().map(f64::to_bits);
    let at: HashMap<[u64; 3], u32> = particles.iter().zip(0..).map(|(&point, index)| (key(point), index)).collect();
    points.iter().zip(0..).filter_map(|(&point, vertex)| Some((vertex, *at.get(&key(point))?))).collect()
}
