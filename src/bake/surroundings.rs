//! Who feels whom in a body, and how what is put into it hangs on its particles.

use super::error::BakeError;
use super::note::Note;
use super::particle_sampling::ParticleSampling;
use super::seams::Seams;
use super::stage::{BakeStage, Tell, unless_stopped};
use crate::geometry::kernel::Kernel;
use crate::scene::{Body, FibreEmbedding};
use crate::solver::embedding::Embedder;
use crate::solver::forces::SeamBonds;
use crate::solver::neighbourhood::Neighbourhood;
use std::sync::Arc;

/// The surroundings of a body's particles.
pub(super) struct Surroundings<'a> {
    /// Neighbours of the particles.
    pub(super) neighbourhood: Arc<Neighbourhood>,
    /// Those that they have once all seams are torn; the same without any.
    pub(super) apart: Arc<Neighbourhood>,
    /// The seams, and the bonds across each.
    pub(super) seams: (Seams, Vec<SeamBonds>),
    /// How fibres, sheets and elements hang on the particles: on those of their own side of a seam.
    pub(super) embedder: Embedder<'a>,
}

impl<'a> Surroundings<'a> {
    /// Those of a body at `path`.
    ///
    /// # Errors
    /// Layers that nothing holds in place, and what `progress` breaks off.
    pub(super) fn find(
        body: &Body,
        (sampling, kernel): (&'a ParticleSampling<'_>, Kernel),
        path: &str,
        notes: &mut Vec<Note>,
        progress: &mut Tell<'_>,
    ) -> Result<Self, BakeError> {
        let (name, sample, mut hollows) = (body.title(), &sampling.sample, sampling.hollows.clone());
        let volume = body.material.spacing().powi(3);
        let neighbourhood = unless_stopped(progress, (name, BakeStage::Neighbours), |stop| {
            Neighbourhood::around(sample, kernel, volume, &hollows, stop).transpose()
        })?
        .map_err(|source| BakeError::TooThin { path: format!("{path}/material/support_radius"), source })?;
        let neighbourhood = Arc::new(neighbourhood);
        let (mut apart, mut bonds) = (Arc::clone(&neighbourhood), Vec::new());
        let drawn = Seams::of(body, sampling, path, notes);
        if !drawn.is_empty() {
            hollows = drawn.hollows(sampling);
            apart = Arc::new(unless_stopped(progress, (name, BakeStage::Neighbours), |stop| {
                drawn.apart(sampling, (kernel, volume), path, stop)
            })??);
            bonds = drawn.bonds(sampling, &neighbourhood, path, notes);
        }
        let around = unless_stopped(progress, (name, BakeStage::Embedding), |stop| {
            Embedder::around(&sample.points, kernel, hollows, stop)
        })?;
        let embedder = match body.material.fibre_embedding {
            FibreEmbedding::Compact => around,
            FibreEmbedding::All => around.with_all_in_reach(),
        };
        Ok(Self { neighbourhood, apart, seams: (drawn, bonds), embedder })
    }
}
