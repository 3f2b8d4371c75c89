//! The vertices of a fibre, one by one.

use super::edited::{Edited, Sampling, chosen, with_vertices};
use super::error::FibreEditError;
use crate::scene::{Fibre, FibreSource};
use crate::sketch::structure_particles;
use glam::DVec3;

/// Vertices of a fibre in the model frame [m]: those that it is simulated with before its ends are trimmed.
///
/// # Errors
/// Strokes that give no curve.
pub fn vertices(fibre: &Fibre, sampling: Sampling) -> Result<Vec<DVec3>, FibreEditError> {
    match &fibre.source {
        FibreSource::Vertices(vertices) => Ok(vertices.iter().copied().map(DVec3::from_array).collect()),
        FibreSource::Strokes(pair) => {
            Ok(structure_particles(&pair.lifted(sampling.model_diagonal)?.curve, sampling.spacing)?)
        }
    }
}

/// Points along a fibre as closely as they are known: the whole curve of a pair of strokes.
pub(super) fn curve(fibre: &Fibre, sampling: Sampling) -> Result<Vec<DVec3>, FibreEditError> {
    match &fibre.source {
        FibreSource::Vertices(_) => vertices(fibre, sampling),
        FibreSource::Strokes(pair) => Ok(pair.lifted(sampling.model_diagonal)?.curve),
    }
}

/// Gives up a fibre's strokes for its vertices; it stays where it is.
///
/// # Errors
/// Strokes that give no curve.
pub fn detach(fibre: &Fibre, sampling: Sampling) -> Result<Edited, FibreEditError> {
    with_vertices(fibre, &vertices(fibre, sampling)?)
}

/// Puts a vertex into an edge, `share` of the way from its start, from 0 to 1: the fibre runs as before.
///
/// # Errors
/// No such edge, a share outside it, or strokes that give no curve.
pub fn insert_vertex(fibre: &Fibre, edge: usize, share: f64, sampling: Sampling) -> Result<Edited, FibreEditError> {
    let mut vertices = vertices(fibre, sampling)?;
    let count = vertices.len().saturating_sub(1);
    if edge >= count {
        return Err(FibreEditError::NoEdge { index: edge, count });
    }
    if !(share > 0.0 && share < 1.0) {
        return Err(FibreEditError::Share(share));
    }
    vertices.insert(edge + 1, vertices[edge].lerp(vertices[edge + 1], share));
    with_vertices(fibre, &vertices)
}

/// Takes vertices away; their neighbours are joined by a straight edge.
///
/// # Errors
/// No such vertex, fewer than 3 would be left, neighbours that lie in one place, or strokes that give no curve.
pub fn delete_vertices(fibre: &Fibre, indices: &[usize], sampling: Sampling) -> Result<Edited, FibreEditError> {
    let vertices = vertices(fibre, sampling)?;
    let gone = chosen(indices, vertices.len())?;
    if !gone.contains(&true) {
        return Ok(Edited::whole(fibre.clone()));
    }
    let left: Vec<DVec3> = vertices.into_iter().zip(gone).filter(|(_, gone)| !gone).map(|(vertex, _)| vertex).collect();
    with_vertices(fibre, &left)
}
