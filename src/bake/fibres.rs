//! Fibres of a body: from vertices or strokes to structure particles that ride on the material.

use super::Note;
use crate::geometry::kernel::Kernel;
use crate::scene::{Body, Falloff, Fibre, FibreSource, RestShape};
use crate::solver::body::FibreLine;
use crate::solver::embedding::{Embedder, Stencil};
use crate::solver::forces::fibre::FibreRest;
use crate::solver::volume_fraction::volume_fractions;
use glam::DVec3;
use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;

/// One run of a fibre inside the material.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedFibre {
    /// Index of the scene's fibre.
    pub fibre: usize,
    /// Identifier of the scene's fibre.
    pub id: String,
    /// Structure particles at rest, model frame [m].
    pub vertices: Vec<DVec3>,
    /// Their embedding.
    pub stencils: Vec<Stencil>,
    /// Those that carry force; the others are drawn only.
    pub active: Range<usize>,
}

impl PlacedFibre {
    pub(super) fn line(&self) -> FibreLine {
        FibreLine { id: self.id.clone(), vertices: self.stencils.clone() }
    }
}

/// Greatest `sum phi²` of a structure particle that carries force: beyond it the particle shrinks the stable step.
const GREATEST_SQUARE_SUM: f64 = 1.0;

/// Places every fibre of a body; what is trimmed, split or discarded is said in `notes`.
pub(super) fn place(
    body: &Body,
    embedder: &Embedder<'_>,
    diagonal: f64,
    path: &str,
    notes: &mut Vec<Note>,
) -> Vec<PlacedFibre> {
    let _ = diagonal;
    let mut placed = Vec::new();
    for (k, fibre) in body.fibres.iter().enumerate() {
        let path = format!("{path}/fibres/{k}");
        warn_if_weak(body, fibre, &path, notes);
        let FibreSource::Vertices(vertices) = &fibre.source else { continue };
        let vertices: Vec<DVec3> = vertices.iter().map(|&x| DVec3::from_array(x)).collect();
        let stencils: Vec<Stencil> = vertices.iter().filter_map(|&x| embedder.stencil(x)).collect();
        placed.push(PlacedFibre { fibre: k, id: fibre.id.clone(), active: 0..vertices.len(), vertices, stencils });
    }
    placed
}

/// A fibre softer than the material it displaces weakens the solid and reverses what it is meant to do.
fn warn_if_weak(body: &Body, fibre: &Fibre, path: &str, notes: &mut Vec<Note>) {
    let material = &body.material;
    let (ea, _) = fibre.stiffness.rigidity(material.spacing().powi(3));
    let displaced = material.young_modulus * 0.2 * PI * material.support_radius.powi(2);
    if ea < displaced && fibre.volume_fraction > 0.0 {
        notes.push(Note {
            path: format!("{path}/stiffness"),
            text: format!(
                "EA = {ea:.3e} N is less than the {displaced:.3e} N of the material that the fibre displaces, so it \
                 weakens the solid; raise EA or lower the material's Young's modulus"
            ),
            warning: true,
        });
    }
}

/// Share of matrix, `1 - l_i`, at every particle.
pub(super) fn matrix_share(body: &Body, particles: &[DVec3], kernel: Kernel, placed: &[PlacedFibre]) -> Arc<[f64]> {
    let h = kernel.support_radius;
    let falloff = body.material.volume_fraction_falloff;
    let curve = move |distance: f64| match falloff {
        Falloff::Kernel => kernel.relative(distance),
        Falloff::Linear => (1.0 - distance / h).max(0.0),
        Falloff::Constant => f64::from(u8::from(distance < h)),
    };
    let runs: Vec<(f64, &[DVec3])> =
        placed.iter().map(|run| (body.fibres[run.fibre].volume_fraction, &run.vertices[run.active.clone()])).collect();
    volume_fractions(particles, &runs, &curve).into_iter().map(|fraction| 1.0 - fraction).collect()
}

/// Rods of the placed fibres; a fibre of no volume fraction carries nothing and is left out, to the bit.
pub(super) fn rods(
    body: &Body,
    embedder: &Embedder<'_>,
    particle_volume: f64,
    placed: &[PlacedFibre],
) -> Vec<FibreRest> {
    let carries = |run: &&PlacedFibre| body.fibres[run.fibre].volume_fraction > 0.0;
    placed
        .iter()
        .filter(carries)
        .map(|run| {
            let fibre = &body.fibres[run.fibre];
            let (ea, ei) = fibre.stiffness.rigidity(particle_volume);
            let vertices = &run.vertices[run.active.clone()];
            let inner = vertices.get(1..vertices.len().saturating_sub(1)).unwrap_or_default();
            let turns = inner
                .iter()
                .map(|&at| match fibre.rest_shape {
                    RestShape::Straight => None,
                    RestShape::AsDrawn => embedder.turn_stencil(at),
                })
                .collect();
            FibreRest::new(run.stencils[run.active.clone()].to_vec(), vertices, ea, ei, fibre.volume_fraction, turns)
        })
        .collect()
}
