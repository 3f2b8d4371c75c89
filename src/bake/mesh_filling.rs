//! From a mesh to the particles that fill it, and what is said of them.

use super::error::BakeError;
use super::note::Note;
use crate::geometry::fill::{FillError, FillResolution, fill_with_progress};
use crate::geometry::filling::Filling;
use crate::geometry::missed::{MissedPlace, missed_places};
use crate::geometry::progress::Progress;
use crate::geometry::solid::Solid;
use crate::geometry::two_layers::{FEW, two_layer_spacing};
use crate::scene::{Body, MAX_PARTICLES};
use glam::DVec3;
use std::ops::ControlFlow;

/// A body with the surface of a mesh, and where in the scene it stands.
#[derive(Clone, Copy)]
pub(super) struct Meshed<'a> {
    pub(super) body: &'a Body,
    /// Number of particles that is wanted; as many as the material's spacing gives unless one is.
    pub(super) particles: Option<u32>,
    pub(super) solid: &'a Solid,
    /// Pointer to the body.
    pub(super) path: &'a str,
    /// Pointer from the body to what is wrong where it cannot be filled.
    pub(super) blamed: &'a str,
}

/// Places without particles at which it is measured how thick the parts are, at most.
const MEASURED: usize = 200;

impl Meshed<'_> {
    /// Whether so much of it is thin that it has to be said.
    fn is_thin(filling: &Filling) -> bool {
        filling.thinness.single as f64 > FEW * filling.sample.points.len() as f64
    }

    /// Particles in parts of hardly more than one layer; none where there are so few that nothing is said.
    pub(super) fn thin_places(filling: &mut Filling) -> Vec<u32> {
        if Self::is_thin(filling) { std::mem::take(&mut filling.thinness.places) } else { Vec::new() }
    }

    /// Whether so much of it has no particles that it has to be said.
    fn is_lost(filling: &Filling) -> bool {
        filling.pruned as f64 > FEW * (filling.pruned + filling.sample.points.len()) as f64
    }

    /// Places of the lattice that have no particles [m]; none where there are so few that nothing is said.
    fn lost_places(filling: &mut Filling) -> Vec<DVec3> {
        if Self::is_lost(filling) { std::mem::take(&mut filling.left_out) } else { Vec::new() }
    }

    /// Fills it, and gives the places that are said to have no particles [m]; `progress` hears how far that has come.
    pub(super) fn filled(
        self,
        notes: &mut Vec<Note>,
        progress: &mut Progress<'_>,
    ) -> Result<(Filling, Vec<DVec3>), BakeError> {
        let Self { body, particles, solid, path, blamed } = self;
        let spacing = body.material.spacing();
        let reach = body.material.spacing_ratio.recip();
        let fineness = particles.map_or(FillResolution::Spacing(spacing), FillResolution::Particles);
        let mut filling =
            fill_with_progress(solid, fineness, reach, MAX_PARTICLES, progress).map_err(|error| match error {
                FillError::Cancelled => BakeError::Cancelled,
                FillError::TooMany { wanted, limit } => {
                    let share = wanted / limit;
                    BakeError::TooMany {
                        path: self.fineness_path(),
                        what: "lattice points would be needed",
                        wanted,
                        limit,
                        suggested: match particles {
                            Some(count) => format!("{:.0} particles or fewer", f64::from(count) / (1.03 * share)),
                            None => format!("{:.2e} m or more", reach * 1.01 * spacing * share.cbrt()),
                        },
                    }
                }
                FillError::TooFarApart { .. } => {
                    BakeError::MeshTooWide { path: format!("{path}/{blamed}"), source: error }
                }
                FillError::TooThin { flat, total, suggested, .. } => {
                    let remedy = suggested.map_or_else(
                        || "two layers would take more particles than are allowed; give it more thickness".to_owned(),
                        |spacing| self.two_layers(spacing),
                    );
                    BakeError::MeshTooThin { path: self.fineness_path(), flat, total, remedy }
                }
            })?;
        self.note(&filling, notes, progress)?;
        let mut places = Self::lost_places(&mut filling);
        let (share, missed) = missed_places(solid, &filling.sample, &places);
        if share > FEW {
            self.note_missed(share, &missed, notes);
            places.extend(missed.iter().map(|place| place.at));
        }
        Ok((filling, places))
    }

    /// Says which parts no particle is in, thinner than a layer that runs beside them.
    fn note_missed(self, share: f64, missed: &[MissedPlace], notes: &mut Vec<Note>) {
        let apart = missed.len().div_ceil(MEASURED).max(1);
        let chosen: Vec<MissedPlace> = missed.iter().step_by(apart).copied().collect();
        let mut thicknesses = self.solid.thickness_below(&chosen);
        thicknesses.sort_by(f64::total_cmp);
        // Rims and tips are thinner than what they are the rims of.
        let thickness = thicknesses.get(thicknesses.len() / 4).copied().filter(|thickness| *thickness > 0.0);
        let remedy = match thickness.map(|thickness| 0.5 * thickness) {
            Some(spacing) if f64::from(self.solid.particles_at(spacing)) <= MAX_PARTICLES as f64 => {
                self.two_layers(spacing)
            }
            Some(_) => "two layers would take more particles than are allowed; give them more thickness".to_owned(),
            None => "give them more thickness".to_owned(),
        };
        let at = missed.first().map(|place| place.at.to_array()).unwrap_or_default();
        let text = format!(
            "{:.0} % of the surface lies in parts so thin that no particle is in them (the first at {at:.4?} m), so that \
             there is nothing to move those by themselves: {remedy}",
            (100.0 * share).max(1.0),
        );
        notes.push(Note { path: self.shape_path(), text, warning: true });
    }

    /// Pointer to the shape.
    fn shape_path(self) -> String {
        format!("{}/{}", self.path, self.blamed.trim_end_matches("/path"))
    }

    /// Pointer to what decides how finely it is filled.
    fn fineness_path(self) -> String {
        let field = if self.particles.is_some() { "shape/mesh/particles" } else { "material/support_radius" };
        format!("{}/{field}", self.path)
    }

    /// What that has to be for a spacing [m].
    fn fineness_at(self, spacing: f64) -> String {
        match self.particles {
            Some(_) => format!("about {} particles", self.solid.particles_at(spacing)),
            None => format!("a support radius of {:.3e} m", spacing / self.body.material.spacing_ratio),
        }
    }

    fn two_layers(self, spacing: f64) -> String {
        let give = if self.particles.is_some() { "give" } else { "gives" };
        format!("{} {give} two layers", self.fineness_at(spacing))
    }

    fn note(self, filling: &Filling, notes: &mut Vec<Note>, progress: &mut Progress<'_>) -> Result<(), BakeError> {
        let Self { body, particles, solid, .. } = self;
        let mut note = |path: String, warning: bool, text: String| notes.push(Note { path, text, warning });
        let reach = body.material.spacing_ratio.recip();
        let spacing = filling.sample.spacing;
        let radius = spacing * reach;
        let change = radius / body.material.support_radius - 1.0;
        let total = filling.sample.points.len();
        if particles.is_some() {
            note(self.fineness_path(), false, format!("{total} particles at a support radius of {radius:.6} m"));
        } else if change != 0.0 {
            let percent = 100.0 * change;
            let text = format!("made {radius:.6} m ({percent:+.1} %) so that the particles fit the mesh");
            note(self.fineness_path(), false, text);
        }
        let [is_lost, is_thin] = [Self::is_lost(filling), Self::is_thin(filling)];
        let mut remedy = String::new();
        if is_lost || is_thin {
            // All lattices were tried; whether to go on is still asked.
            let mut asked = || progress(1, 1);
            remedy = match two_layer_spacing(solid, spacing, reach, MAX_PARTICLES as f64, &mut asked) {
                ControlFlow::Continue(Some(spacing)) => self.two_layers(spacing),
                ControlFlow::Continue(None) => "two layers would take more particles than are allowed".to_owned(),
                ControlFlow::Break(()) => return Err(BakeError::Cancelled),
            };
        }
        let lost = filling.pruned;
        let shape = self.shape_path();
        if is_lost {
            let at = filling.left_out.first().copied().unwrap_or_default().to_array();
            let text = format!(
                "{lost} of {} lattice points in parts less than one layer thick were left out (the first at {at:.4?} m), \
                 so that there is nothing to move those by themselves: {remedy}",
                total + lost,
            );
            note(shape, true, text);
        } else if lost > 0 {
            note(shape, false, format!("{lost} lattice points at tips too fine to hold them were left out"));
        }
        let thin = &filling.thinness;
        if is_thin {
            let at = thin.places.first().map_or(DVec3::ZERO, |&index| filling.sample.points[index as usize]);
            let text = format!(
                "{} of {total} particles lie in parts hardly more than one layer thick (the first at {:.4?} m), which \
                 bend too easily: {remedy}",
                thin.single,
                at.to_array(),
            );
            note(self.fineness_path(), true, text);
        }
        if thin.double > 0 {
            let text = format!(
                "{} of {total} particles lie in parts two layers thick, which twist a quarter too easily; {} would give \
                 three layers",
                thin.double,
                self.fineness_at(spacing / 1.5)
            );
            note(self.fineness_path(), false, text);
        }
        Ok(())
    }
}
