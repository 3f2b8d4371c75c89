//! Seams of a body: from the scene's sheets to the bonds that may tear.

use super::error::BakeError;
use super::note::Note;
use super::particle_sampling::ParticleSampling;
use super::sheet_shape::SheetShape;
use crate::geometry::hollows::Hollows;
use crate::geometry::kernel::Kernel;
use crate::geometry::seam::Seam;
use crate::scene::Body;
use crate::solver::forces::SeamBonds;
use crate::solver::neighbourhood::Neighbourhood;
use std::sync::Arc;

/// The seams of a body that lie in it.
#[derive(Default)]
pub(super) struct Seams {
    /// Index of each among the body's sheets, and how far it is stretched before it tears.
    of: Vec<(usize, f64)>,
    /// Where they lie.
    pub(super) surfaces: Vec<Arc<Seam>>,
}

impl Seams {
    /// Those of a body; what cannot be one is said in the notes.
    pub(super) fn of(body: &Body, sampling: &ParticleSampling<'_>, path: &str, notes: &mut Vec<Note>) -> Self {
        let (diagonal, spacing) = (sampling.size.length(), body.material.spacing());
        let mut seams = Self::default();
        for (k, sheet) in body.sheets.iter().enumerate() {
            let Some(seam) = &sheet.seam else { continue };
            match SheetShape::of(sheet, diagonal, spacing) {
                Ok(shape) => {
                    seams.of.push((k, seam.stretch));
                    seams.surfaces.push(Arc::new(Seam::new(&shape.points, &shape.triangles, spacing)));
                }
                Err(error) => notes.push(Note {
                    path: format!("{path}/sheets/{k}"),
                    text: format!("the seam is left out: {error}"),
                    warning: true,
                }),
            }
        }
        seams
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.surfaces.is_empty()
    }

    /// What separates particles once all is torn.
    pub(super) fn hollows(&self, sampling: &ParticleSampling<'_>) -> Hollows {
        sampling.hollows.with_seams(&self.surfaces)
    }

    /// The neighbourhoods that are left once all is torn; none where `stop` says that they are no longer wanted.
    ///
    /// # Errors
    /// Layers beside a seam that nothing could hold in place.
    pub(super) fn apart(
        &self,
        sampling: &ParticleSampling<'_>,
        (kernel, volume): (Kernel, f64),
        path: &str,
        stop: &mut dyn FnMut() -> bool,
    ) -> Option<Result<Neighbourhood, BakeError>> {
        let hollows = self.hollows(sampling);
        let apart = Neighbourhood::around(&sampling.sample, kernel, volume, &hollows, stop).transpose()?;
        Some(apart.map_err(|source| BakeError::ThinBesideSeam {
            path: format!("{path}/sheets/{}/seam", self.of[0].0),
            count: source.count,
            at: source.at,
            least: 2.0 * sampling.sample.spacing,
        }))
    }

    /// The bonds of `whole` neighbourhoods that lie across each seam; one that crosses none of the body is said in the
    /// notes.
    pub(super) fn bonds(
        &self,
        sampling: &ParticleSampling<'_>,
        whole: &Neighbourhood,
        path: &str,
        notes: &mut Vec<Note>,
    ) -> Vec<SeamBonds> {
        let points = &sampling.sample.points;
        let mut bonds: Vec<SeamBonds> =
            self.of.iter().map(|&(_, stretch)| SeamBonds { stretch, pairs: Vec::new() }).collect();
        let alone =
            |seam: &Arc<Seam>| Hollows::new(Vec::new(), sampling.sample.spacing).with_seams(&[Arc::clone(seam)]);
        let seams: Vec<Hollows> = self.surfaces.iter().map(alone).collect();
        for i in 0..whole.len() {
            for (j, _) in whole.bonds(i).filter(|(j, _)| *j > i) {
                // Where seams cross, a bond through both is of the first.
                if let Some(k) = seams.iter().position(|seam| seam.separate(points[i], points[j])) {
                    bonds[k].pairs.push([i as u32, j as u32]);
                }
            }
        }
        for ((sheet, _), seam) in self.of.iter().zip(&bonds) {
            let (warning, text) = match seam.pairs.len() {
                0 => (true, "the seam lies outside the body and parts nothing".to_owned()),
                count => (false, format!("{count} pairs of neighbours lie across the seam")),
            };
            notes.push(Note { path: format!("{path}/sheets/{sheet}"), text, warning });
        }
        bonds
    }
}
