//! How the fibres of a body ride on its particles.

use super::band::{BandBuilder, BandMatrix};
use super::rest::{CurvedRest, FibreRest};
use super::strip::Strip;
use glam::DVec3;

/// The weights by which the fibres of a body ride on its particles.
pub(super) struct FibreEmbedding {
    pub(super) strip: Strip,
    /// Of every vertex, fibre after fibre.
    pub(super) vertices: BandMatrix<1>,
    /// Of every curved bend, by the components of `om_k Z_k`.
    pub(super) turns: BandMatrix<3>,
    pub(super) curved: Vec<EmbeddedBend>,
}

/// A bend whose rest shape is curved.
pub(super) struct EmbeddedBend {
    /// Its number among all bends.
    pub(super) bend: usize,
    /// Number of its corner among the packed rods'.
    pub(super) corner: usize,
    /// As [`super::rest::Bend::stiffness`] [N m].
    pub(super) stiffness: f64,
    /// Curvature binormal kb0 at rest, model frame.
    pub(super) binormal: DVec3,
}

impl FibreEmbedding {
    /// The weights of these fibres.
    pub(super) fn new(fibres: &[FibreRest]) -> Self {
        let (mut strip, mut vertices, mut turns) = (Strip::default(), BandBuilder::default(), BandBuilder::default());
        let mut curved = Vec::new();
        let (mut first_bend, mut first) = (0, 0);
        for fibre in fibres {
            let index = strip.add(fibre.particles());
            for vertex in &fibre.vertices {
                vertices.add(&index, vertex.weights.iter().map(|&(particle, phi)| (particle, [phi])));
            }
            for (k, bend) in fibre.bends.iter().enumerate() {
                if let Some(CurvedRest { binormal, turn }) = &bend.curved {
                    let (bend, stiffness) = (first_bend + k, bend.stiffness);
                    curved.push(EmbeddedBend { bend, corner: first + k, stiffness, binormal: *binormal });
                    turns.add(&index, turn.weights.iter().map(|&(particle, z)| (particle, z.to_array())));
                }
            }
            first_bend += fibre.bends.len();
            first += fibre.vertices.len();
        }
        Self { vertices: vertices.band(strip.len()), turns: turns.band(strip.len()), strip, curved }
    }
}
