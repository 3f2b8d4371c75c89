//! Sheets of a body: from strokes or vertices to surfaces that ride on the material.

use super::drives::drive;
use super::falloff::curve;
use super::fibres::{CROWDED, MOST_CURLED};
use super::note::Note;
use super::sheet_shape::SheetShape;
use super::slide::GREATEST_SQUARE_SUM;
use crate::geometry::kernel::Kernel;
use crate::scene::{Body, GrainAlong, Sheet, SheetRestShape};
use crate::solver::body::SheetSurface;
use crate::solver::embedding::{Embedder, EmbeddingWeights};
use crate::solver::forces::sheet::{SheetDrive, SheetLaw, SheetRest};
use glam::{DVec2, DVec3};

/// A sheet as it lies in the material.
#[derive(Clone, Debug)]
pub(super) struct PlacedSheet {
    /// Index of the scene's sheet.
    pub(super) sheet: usize,
    /// What there is of it.
    shape: SheetShape,
    /// How its vertices ride on the particles.
    embedding: Vec<EmbeddingWeights>,
    /// How many of its triangles, the first ones, carry force; the others are drawn only.
    active: usize,
}

/// Least area of a triangle in units of D².
const LEAST_AREA: f64 = 0.1;

/// Points at which the share of a sheet is summed over the distance from it.
const SUMMED: u32 = 64;

/// Where the sheets of one body are put, and where it is said what happened.
pub(super) struct Placing<'a> {
    pub(super) body: &'a Body,
    pub(super) embedder: &'a Embedder<'a>,
    /// Diagonal H of the shape's bounding box [m].
    pub(super) diagonal: f64,
    /// Pointer to the body.
    pub(super) path: &'a str,
    pub(super) notes: &'a mut Vec<Note>,
}

impl Placing<'_> {
    /// Places every sheet of the body; what is trimmed, moved or left out is said in the notes.
    pub(super) fn place(&mut self) -> Vec<PlacedSheet> {
        let body = self.body;
        let sheets = body.sheets.iter().enumerate();
        sheets.filter_map(|(k, sheet)| self.embed(k, sheet, &format!("{}/sheets/{k}", self.path))).collect()
    }

    fn note(&mut self, path: &str, warning: bool, text: String) {
        self.notes.push(Note { path: path.to_owned(), text, warning });
    }

    fn leave_out(&mut self, path: &str, why: &str) -> Option<PlacedSheet> {
        self.note(path, true, format!("the sheet is left out: {why}"));
        None
    }

    fn weights(&self, at: DVec3) -> Option<EmbeddingWeights> {
        self.embedder.vertex_weights(at).filter(|_| self.embedder.is_embedded(at))
    }

    fn holds(&self, at: DVec3) -> bool {
        self.weights(at).is_some_and(|weights| weights.square_sum() <= GREATEST_SQUARE_SUM)
    }

    fn embed(&mut self, index: usize, sheet: &Sheet, path: &str) -> Option<PlacedSheet> {
        let spacing = self.body.material.spacing();
        let mut shape = match SheetShape::of(sheet, self.diagonal, spacing) {
            Ok(shape) => shape,
            Err(error) => return self.leave_out(path, &error.to_string()),
        };
        self.warn_if_weak(sheet, path);
        let least = LEAST_AREA * spacing * spacing;
        let smallest = shape.areas().fold(f64::INFINITY, f64::min);
        // A seam carries nothing: however small its triangles are, it is drawn.
        if smallest < least && sheet.seam.is_none() {
            let why = format!(
                "a triangle of it has {smallest:.2e} m², less than the {least:.2e} m² that the particles tell apart; give it \
                 fewer or wider steps"
            );
            return self.leave_out(path, &why);
        }
        let is_seam = sheet.seam.is_some();
        let slid = if is_seam { 0 } else { self.slide(&mut shape) };
        let total = shape.triangles.len();
        let inside: Vec<bool> = shape.points.iter().map(|&at| self.weights(at).is_some()).collect();
        let holding: Vec<bool> = shape.points.iter().map(|&at| self.holds(at)).collect();
        let all = |of: &[bool], corners: [u32; 3]| corners.iter().all(|&k| of[k as usize]);
        let areas: Vec<f64> = shape.areas().collect();
        let active: Vec<bool> =
            (0..total).map(|k| all(&holding, shape.triangles[k]) && (areas[k] >= least || is_seam)).collect();
        let drawn: Vec<usize> = (0..total).filter(|&k| active[k] || all(&inside, shape.triangles[k])).collect();
        let (carrying, idle): (Vec<usize>, Vec<usize>) = drawn.into_iter().partition(|&k| active[k]);
        if carrying.is_empty() {
            let why = format!("none of its {total} triangles lies deep enough in the material to carry force");
            return self.leave_out(path, &why);
        }
        let count = carrying.len();
        if count < total && !is_seam {
            let text = format!(
                "{} of {total} triangles lie outside the material, or too near to it to carry force",
                total - count
            );
            self.note(path, false, text);
        }
        if slid > 0 {
            let text = format!(
                "{slid} of {} points lay too far outside the material and were moved into it",
                shape.points.len()
            );
            self.note(path, true, text);
        }
        let kept: Vec<usize> = carrying.into_iter().chain(idle).collect();
        let shape = shape.with_triangles(&kept);
        let closest = shape.shortest_edge(count);
        if closest < CROWDED * spacing {
            let text = format!(
                "its vertices lie as close as {closest:.2e} m, which shrinks the time step; keep them {spacing} m apart"
            );
            self.note(path, true, text);
        }
        if let Some(of) = &sheet.activation {
            let fastest = of.curl_degrees_per_metre.into_iter().fold(0.0, |most: f64, rate| most.max(rate.abs()));
            let most = fastest * drive(&of.drive, &self.body.drives).largest() * shape.longest_edge(count);
            if most >= MOST_CURLED {
                let why =
                    format!("it is to curl by {most:.0} degrees from vertex to vertex; keep that below {MOST_CURLED}");
                return self.leave_out(path, &why);
            }
        }
        let embedding = shape.points.iter().map(|&at| self.weights(at).unwrap_or_default()).collect();
        Some(PlacedSheet { sheet: index, shape, embedding, active: count })
    }

    /// Moves vertices of a grid that lie too far outside, and between others of their row or column that do not,
    /// towards the particles; gives their number. Where none holds, the sheet runs along the outside, and all are
    /// moved.
    fn slide(&self, shape: &mut SheetShape) -> usize {
        let holds: Vec<bool> = shape.points.iter().map(|&at| self.holds(at)).collect();
        let none = !holds.contains(&true);
        let mut slid = 0;
        let between = shape.between(&holds);
        for k in (0..holds.len()).filter(|&k| !holds[k] && (none || between[k])) {
            if let Some(inside) = self.slide_in(shape.points[k]) {
                shape.points[k] = inside;
                slid += 1;
            }
        }
        slid
    }

    /// The nearest point on the way to the centroid of the particles around a vertex at which it may carry force.
    fn slide_in(&self, vertex: DVec3) -> Option<DVec3> {
        self.weights(vertex)?;
        let inwards = self.embedder.centroid(vertex) - vertex;
        let (mut outside, mut inside) = (0.0, 1.0);
        while !self.holds(vertex + inside * inwards) {
            if inside > 4.0 {
                return None;
            }
            outside = inside;
            inside *= 2.0;
        }
        for _ in 0..30 {
            let middle = 0.5 * (outside + inside);
            if self.holds(vertex + middle * inwards) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        Some(vertex + inside * inwards)
    }

    /// A sheet softer than the material it displaces weakens the solid and reverses what it is meant to do.
    fn warn_if_weak(&mut self, sheet: &Sheet, path: &str) {
        let material = &self.body.material;
        let curve = curve(material, Kernel::new(material.support_radius));
        let step = material.support_radius / f64::from(SUMMED);
        let thickness: f64 = (0..SUMMED).map(|k| 2.0 * step * curve((f64::from(k) + 0.5) * step)).sum();
        let displaced = material.young_modulus * thickness;
        let et = sheet.stiffness.et;
        if et < displaced && fraction(sheet) > 0.0 {
            let text = format!(
                "Et = {et:.3e} N/m is less than the {displaced:.3e} N/m of the material that the sheet displaces, so it \
                 weakens the solid; raise Et or lower the material's Young's modulus"
            );
            self.note(&format!("{path}/stiffness"), true, text);
        }
    }
}

impl PlacedSheet {
    /// What of it can be seen.
    pub(super) fn surface(&self, body: &Body) -> SheetSurface {
        let sheet = &body.sheets[self.sheet];
        let along = sheet.stiffness.grain.as_ref().map(|grain| &grain.along);
        SheetSurface {
            id: sheet.id.clone(),
            vertices: self.embedding.clone(),
            triangles: self.shape.triangles.as_slice().into(),
            threads: along.map_or_else(Vec::new, |along| self.shape.threads(along)).into(),
            rim: self.shape.rim().into(),
        }
    }

    /// Volume fraction in its surface and the triangles that carry force, at rest [m].
    pub(super) fn share(&self, body: &Body) -> (f64, Vec<[DVec3; 3]>) {
        let corners = |of: &[u32; 3]| of.map(|k| self.shape.points[k as usize]);
        (fraction(&body.sheets[self.sheet]), self.shape.triangles[..self.active].iter().map(corners).collect())
    }

    fn rest(&self, body: &Body) -> SheetRest {
        let sheet = &body.sheets[self.sheet];
        let of = &sheet.stiffness;
        let law = SheetLaw {
            et: of.et,
            poisson_ratio: of.poisson_ratio,
            bending: of.bending,
            grain: of.grain.as_ref().map_or(0.0, |grain| grain.et),
            volume_fraction: sheet.volume_fraction,
        };
        let grain = of.grain.as_ref().map_or(&GrainAlong::First, |grain| &grain.along);
        let triangles: Vec<_> =
            (0..self.active).map(|k| (self.shape.triangles[k], self.shape.ways(k, grain))).collect();
        let diagonal = |a: u32, b: u32| self.shape.is_diagonal(a, b);
        let rest = SheetRest::new(self.embedding.clone(), &self.shape.points, &triangles, law, diagonal);
        let rest = if sheet.rest_shape == SheetRestShape::Flat { rest.flattened() } else { rest };
        rest.acting(sheet.activation.as_ref().map(|of| SheetDrive {
            drive: drive(&of.drive, &body.drives),
            contract: DVec2::from_array(of.contract),
            curl: DVec2::from_array(of.curl_degrees_per_metre.map(f64::to_radians)),
        }))
    }
}

/// The placed sheets that carry anything, at rest.
pub(super) fn rests(body: &Body, placed: &[PlacedSheet]) -> Vec<SheetRest> {
    placed.iter().filter(|of| fraction(&body.sheets[of.sheet]) > 0.0).map(|of| of.rest(body)).collect()
}

/// Share of the material that is sheet in its surface; a seam is none.
fn fraction(sheet: &Sheet) -> f64 {
    if sheet.seam.is_some() { 0.0 } else { sheet.volume_fraction }
}

/// Index in the scene of the sheet that resists a move of a vertex most; none without one.
pub(super) fn strongest(body: &Body, placed: &[PlacedSheet]) -> Option<usize> {
    let area = body.material.spacing().powi(2);
    let stiff = |index: usize| {
        let (sheet, of) = (&body.sheets[index], &body.sheets[index].stiffness);
        let grain = of.grain.as_ref().map_or(0.0, |grain| grain.et);
        fraction(sheet) * (of.et + grain + of.bending / area)
    };
    placed.iter().map(|of| of.sheet).max_by(|&a, &b| stiff(a).total_cmp(&stiff(b)))
}
