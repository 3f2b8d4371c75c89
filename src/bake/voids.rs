//! What is taken out of a body: from the scene's voids to the hollows of its particles.

use super::error::BakeError;
use super::note::Note;
use crate::geometry::carve::{Carved, carve};
use crate::geometry::hollows::{Hollow, HollowSolid, Hollows};
use crate::geometry::lattice::{Cuboid, LatticeSample};
use crate::scene::{Assets, Body, FibreSource, Void, VoidShape};
use crate::sketch::structure_particles;
use glam::{DVec3, IVec3};
use std::sync::Arc;

/// A body whose voids are taken out.
#[derive(Clone, Copy)]
pub(super) struct Hollowing<'a> {
    pub(super) body: &'a Body,
    pub(super) assets: &'a Assets,
    /// Pointer to the body.
    pub(super) path: &'a str,
    /// Diagonal of the shape's bounding box [m].
    pub(super) diagonal: f64,
    /// What lies inside the shape.
    pub(super) is_solid: &'a (dyn Fn(DVec3) -> bool + Sync),
}

/// Places along each axis at which a void's volume is measured.
const MEASURED: i32 = 24;

impl Hollowing<'_> {
    /// The particles that are left of a filled shape, and the hollows between them.
    pub(super) fn of(self, whole: &LatticeSample, notes: &mut Vec<Note>) -> Result<(Carved, Hollows), BakeError> {
        let Self { body, path, is_solid, .. } = self;
        let mut shapes = Vec::new();
        for (k, void) in body.voids.iter().enumerate() {
            let hollow = self.hollow(void, &format!("{path}/voids/{k}/shape"), whole.spacing)?;
            shapes.push(hollow);
        }
        let hollows = Hollows::new(shapes.clone(), whole.spacing);
        let radius = whole.spacing / body.material.spacing_ratio;
        let carved = carve(whole, &hollows, radius, is_solid).map_err(|wall| {
            let is_beside = |hollow: &Hollow| {
                let [min, max] = hollow.bounds();
                (min - radius).cmple(wall.at).all() && wall.at.cmple(max + radius).all()
            };
            let which = shapes.iter().position(is_beside).unwrap_or(0);
            BakeError::ThinWall {
                path: format!("{path}/voids/{which}/shape"),
                count: wall.count,
                at: wall.at.to_array(),
                least: 2.0 * whole.spacing,
                support_radius: 0.5 * radius,
            }
        })?;
        if carved.sample.points.is_empty() {
            return Err(BakeError::Empty {
                path: format!("{path}/voids"),
                body: path.to_owned(),
                spacing: whole.spacing,
            });
        }
        self.note(whole, &carved, &shapes, notes);
        Ok((carved, hollows))
    }

    fn hollow(self, void: &Void, path: &str, spacing: f64) -> Result<Hollow, BakeError> {
        Ok(match &void.shape {
            VoidShape::Sphere { center, radius, .. } => {
                Hollow::Ball { center: DVec3::from_array(*center), radius: *radius }
            }
            VoidShape::Box { min, max, .. } => {
                let [min, max] = [*min, *max].map(DVec3::from_array);
                Hollow::Box(Cuboid { center: 0.5 * (min + max), size: max - min })
            }
            VoidShape::Tube { source, radius, .. } => {
                let undrawn = |source| BakeError::VoidUndrawn { path: format!("{path}/tube/source"), source };
                let line = match source {
                    FibreSource::Vertices(vertices) => vertices.iter().map(|&x| DVec3::from_array(x)).collect(),
                    FibreSource::Strokes(pair) => {
                        let lifted = pair.lifted(self.diagonal).map_err(undrawn)?;
                        structure_particles(&lifted.curve, spacing).map_err(undrawn)?
                    }
                };
                Hollow::Tube { line, radius: *radius }
            }
            VoidShape::Mesh(mesh) => {
                let file = format!("{path}/mesh/path");
                let solid = self.assets.solid(mesh).ok_or(BakeError::NotLoaded { path: file })?;
                Hollow::Solid(HollowSolid::new(Arc::clone(solid)))
            }
        })
    }

    /// Says what came of the voids.
    fn note(self, whole: &LatticeSample, carved: &Carved, shapes: &[Hollow], notes: &mut Vec<Note>) {
        let mut note = |path: String, warning: bool, text: String| notes.push(Note { path, text, warning });
        let voids = format!("{}/voids", self.path);
        let drawn: Vec<f64> = shapes.iter().map(|shape| self.volume_inside(shape)).collect();
        for (k, _) in drawn.iter().enumerate().filter(|(_, volume)| **volume == 0.0) {
            note(format!("{voids}/{k}"), true, "it lies outside the body and takes nothing out of it".to_owned());
        }
        let removed = carved.inside as f64 * whole.cell_volume();
        let text = if carved.inside == 0 {
            "no particle lies in them: they cut the material without taking any of it out".to_owned()
        } else {
            let off = 100.0 * (removed / drawn.iter().sum::<f64>() - 1.0);
            format!(
                "{} of {} particles are taken out, {removed:.3e} m³ or {off:+.0} % against what is drawn",
                carved.inside,
                whole.points.len()
            )
        };
        note(voids.clone(), false, text);
        if carved.fine > 0 {
            let text = format!("{} particles at rims too fine to hold them were left out", carved.fine);
            note(voids.clone(), false, text);
        }
        if carved.loose > 0 {
            let text = format!(
                "they cut {} particles off the rest, which are left out; only the largest piece stays",
                carved.loose
            );
            note(voids, true, text);
        }
    }

    /// Volume of a hollow as far as it lies in the shape [m³].
    fn volume_inside(self, shape: &Hollow) -> f64 {
        let [min, max] = shape.bounds();
        let cell = (max - min) / f64::from(MEASURED);
        let at = |k: i32| {
            let place = IVec3::new(k % MEASURED, k / MEASURED % MEASURED, k / (MEASURED * MEASURED));
            min + cell * (place.as_dvec3() + 0.5)
        };
        let inside = (0..MEASURED.pow(3)).filter(|&k| shape.contains(at(k)) && (self.is_solid)(at(k))).count();
        inside as f64 * cell.element_product()
    }
}
