//! Snapping a fibre to the surface of its body.

use super::edited::{Edited, Sampling, chosen, with_vertices};
use super::error::FibreEditError;
use super::vertices::vertices;
use crate::geometry::lattice::Cuboid;
use crate::geometry::mesh::box_surface;
use crate::geometry::nearest::SurfaceIndex;
use crate::scene::{Assets, Body, Fibre, Shape};
use glam::DVec3;

/// Faces across the thickness of a round body.
const FACES: f64 = 24.0;

/// The surface of a body in its model frame; none of a mesh that was not loaded.
pub fn surface(body: &Body, assets: &Assets) -> Option<SurfaceIndex> {
    match &body.shape {
        Shape::Box(shape) => {
            let solid = Cuboid { center: DVec3::from_array(shape.center), size: DVec3::from_array(shape.size) };
            let mesh = box_surface(&solid, solid.size.max_element());
            Some(SurfaceIndex::new(mesh.positions, mesh.triangles))
        }
        Shape::Mesh(shape) => {
            let surface = &assets.solid(shape)?.surface;
            Some(SurfaceIndex::new(surface.points.clone(), surface.faces.clone()))
        }
        round => {
            let size = DVec3::from_array(round.size()?);
            let mesh = round.round_surface(size.min_element() / FACES)?;
            Some(SurfaceIndex::new(mesh.positions, mesh.triangles))
        }
    }
}

/// Puts vertices of a fibre, all of them unless some are named, at the nearest point of a surface and `offset` [m]
/// out of it along its normal there, inwards below zero. In a part thinner than twice the offset the opposite side
/// may be nearer than that.
///
/// # Errors
/// A surface without faces, no such vertex, neighbours that would lie in one place, an offset that is not finite, or
/// strokes that give no curve.
pub fn snap(
    fibre: &Fibre,
    only: Option<&[usize]>,
    surface: &SurfaceIndex,
    offset: f64,
    sampling: Sampling,
) -> Result<Edited, FibreEditError> {
    let mut vertices = vertices(fibre, sampling)?;
    let chosen = only.map_or_else(|| Ok(vec![true; vertices.len()]), |indices| chosen(indices, vertices.len()))?;
    if !chosen.contains(&true) {
        return Ok(Edited::whole(fibre.clone()));
    }
    for (vertex, chosen) in vertices.iter_mut().zip(chosen) {
        if chosen {
            let nearest = surface.nearest(*vertex).ok_or(FibreEditError::NoSurface)?;
            *vertex = nearest.point + offset * nearest.normal;
        }
    }
    with_vertices(fibre, &vertices)
}
