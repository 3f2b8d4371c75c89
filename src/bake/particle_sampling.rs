//! From a shape to the particles that fill it and the surface that is drawn of it.

use super::error::BakeError;
use super::mesh_filling::Meshed;
use super::note::Note;
use super::section_notes::{Thinnest, radius_note, section_notes};
use super::stage::{BakeStage, Tell};
use super::voids::Hollowing;
use crate::geometry::askew_box::AskewBox;
use crate::geometry::cell_shares::cell_shares;
use crate::geometry::clip::DrawnSurface;
use crate::geometry::filling::CellShares;
use crate::geometry::hollows::Hollows;
use crate::geometry::kernel::Kernel;
use crate::geometry::lattice::{Cuboid, LatticeSample, fill_box_unless};
use crate::geometry::lattice_fit::FittedLattice;
use crate::geometry::mesh::box_surface;
use crate::geometry::model::{MeshData, Model};
use crate::geometry::progress::Progress;
use crate::geometry::seam::Seam;
use crate::geometry::solid::Solid;
use crate::scene::{Assets, Body, BoxShape, Rotation, Shape};
use crate::solver::skin::{Skin, SkinShape};
use glam::{DMat3, DVec3};
use std::borrow::Cow;
use std::ops::ControlFlow;
use std::sync::Arc;

/// A filled shape.
pub(super) struct ParticleSampling<'a> {
    /// The particles.
    pub(super) sample: LatticeSample,
    /// Particles before any were taken out.
    pub(super) whole: usize,
    /// What was taken out.
    pub(super) hollows: Hollows,
    /// Volume of the shape [m³].
    pub(super) volume: f64,
    /// Extents of the shape [m].
    pub(super) size: DVec3,
    /// Particles in parts of hardly more than one layer, where that is said.
    pub(super) thin: Vec<u32>,
    /// Places that have no particles, as they lie in parts too thin for any, where that is said [m].
    pub(super) left_out: Vec<DVec3>,
    /// What each particle stands for; a whole cell where nothing is said.
    pub(super) shares: Option<CellShares>,
    source: Source<'a>,
}

enum Source<'a> {
    Box(Cuboid),
    Mesh(Box<Cow<'a, Solid>>),
}

impl Source<'_> {
    fn contains(&self, at: DVec3) -> bool {
        match self {
            Self::Box(solid) => solid.contains(at),
            Self::Mesh(solid) => solid.contains(at),
        }
    }
}

/// A section that is so much wider than thick is no compact one.
const WIDE: f64 = 2.0;

/// Share of the matter that lies at edges and tips, which are thinner than what they are at the edge of.
const EDGES: f64 = 0.1;

/// Volume errors beyond this are said.
const VOLUME_ERROR: f64 = 0.02;

pub(super) fn sample_particles<'a>(
    body: &Body,
    assets: &'a Assets,
    path: &str,
    notes: &mut Vec<Note>,
    progress: &mut Tell<'_>,
) -> Result<ParticleSampling<'a>, BakeError> {
    let mut filled = |done, of| progress(body.title(), BakeStage::Sampling { done, of });
    filled(0, 1)?;
    let mut sampling = match &body.shape {
        Shape::Box(shape) => fill_box_shape(body, shape, path, notes, &mut || filled(0, 1).is_err())?,
        Shape::Mesh(shape) => {
            let file = format!("{path}/shape/mesh/path");
            let solid = assets.solid(shape).ok_or_else(|| BakeError::NotLoaded { path: file.clone() })?;
            let found = solid.report.findings().into_iter();
            notes.extend(found.map(|finding| Note {
                path: file.clone(),
                text: finding.text,
                warning: finding.warning,
            }));
            let mut told =
                |done, of| if filled(done, of).is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
            let meshed = Meshed { body, particles: shape.particles, solid, path, blamed: "shape/mesh/path" };
            let (mut filling, left_out) = meshed.filled(notes, &mut told)?;
            ParticleSampling {
                thin: Meshed::thin_places(&mut filling),
                left_out,
                whole: filling.sample.points.len(),
                hollows: Hollows::default(),
                shares: filling.shares,
                sample: filling.sample,
                volume: solid.volume,
                size: solid.size(),
                source: Source::Mesh(Box::new(Cow::Borrowed(solid))),
            }
        }
        round => {
            let mut told =
                |done, of| if filled(done, of).is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
            fill_round_shape(body, round, path, notes, &mut told)?
        }
    };
    filled(1, 1)?;
    sampling.note_sampling(path, notes, &mut || filled(1, 1).is_err())?;
    if !body.voids.is_empty() {
        sampling.take_out_voids(body, assets, path, notes)?;
    }
    Ok(sampling)
}

fn fill_box_shape<'a>(
    body: &Body,
    shape: &BoxShape,
    path: &str,
    notes: &mut Vec<Note>,
    stop: &mut dyn FnMut() -> bool,
) -> Result<ParticleSampling<'a>, BakeError> {
    let spacing = body.material.spacing();
    let solid = Cuboid { center: DVec3::from_array(shape.center), size: DVec3::from_array(shape.size) };
    let axes = lattice_axes(&shape.lattice_rotation);
    let (sample, shares) = filled_box(&solid, spacing, axes, stop).ok_or(BakeError::Cancelled)?;
    if sample.points.is_empty() {
        return Err(BakeError::Empty { path: format!("{path}/shape"), body: path.to_owned(), spacing });
    }
    notes.extend(radius_note(body, &sample, path));
    let (volume, size) = (solid.volume(), solid.size);
    let whole = sample.points.len();
    let (thin, left_out, hollows, source) = (Vec::new(), Vec::new(), Hollows::default(), Source::Box(solid));
    Ok(ParticleSampling { sample, whole, hollows, volume, size, thin, left_out, shares, source })
}

/// A box filled, askew to the lattice by the lattice that fits it best.
fn filled_box(
    solid: &Cuboid,
    spacing: f64,
    axes: DMat3,
    stop: &mut dyn FnMut() -> bool,
) -> Option<(LatticeSample, Option<CellShares>)> {
    if axes == DMat3::IDENTITY {
        return Some((fill_box_unless(solid, spacing, axes, stop)?, None));
    }
    let shape = AskewBox::new(solid, axes);
    let mut go_on = || if stop() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    let ControlFlow::Continue(fitted) = FittedLattice::to(&shape, spacing, &mut go_on) else { return None };
    let (lattice, sample) = if let Some(lattice) = fitted {
        let mut sample = lattice.collect(&shape);
        sample.axes = axes;
        sample.points.iter_mut().for_each(|point| *point = solid.center + axes * *point);
        (lattice, sample)
    } else {
        let sample = fill_box_unless(solid, spacing, axes, stop)?;
        let (Some(&point), Some(cell)) = (sample.points.first(), sample.cells.first()) else {
            return Some((sample, None));
        };
        let origin = axes.transpose() * (point - solid.center) - spacing * cell.as_dvec3();
        (FittedLattice { spacing, stretch: DVec3::ONE, origin }, sample)
    };
    let shares = cell_shares(&shape, &lattice, &sample.cells);
    Some((sample, shares))
}

fn fill_round_shape<'a>(
    body: &Body,
    shape: &Shape,
    path: &str,
    notes: &mut Vec<Note>,
    told: &mut Progress<'_>,
) -> Result<ParticleSampling<'a>, BakeError> {
    let spacing = body.material.spacing();
    let empty = || BakeError::Empty { path: format!("{path}/shape"), body: path.to_owned(), spacing };
    let surface = shape.round_surface(spacing).ok_or_else(empty)?;
    let mut model = Model::default();
    model.add(MeshData { positions: surface.positions, triangles: surface.triangles, ..MeshData::default() });
    let solid = Solid::new(&model).map_err(|_| empty())?;
    let meshed = Meshed { body, particles: None, solid: &solid, path, blamed: "shape" };
    let (mut filling, left_out) = meshed.filled(notes, told)?;
    Ok(ParticleSampling {
        thin: Meshed::thin_places(&mut filling),
        left_out,
        whole: filling.sample.points.len(),
        hollows: Hollows::default(),
        shares: filling.shares,
        sample: filling.sample,
        volume: shape.volume().unwrap_or(solid.volume),
        size: solid.size(),
        source: Source::Mesh(Box::new(Cow::Owned(solid))),
    })
}

fn lattice_axes(rotation: &Rotation) -> DMat3 {
    // Exactly along the axes when not turned: that decides how the box is filled.
    if rotation.degrees == 0.0 { DMat3::IDENTITY } else { DMat3::from_quat(rotation.quaternion()) }
}

impl ParticleSampling<'_> {
    /// Takes the body's voids out of its particles.
    fn take_out_voids(
        &mut self,
        body: &Body,
        assets: &Assets,
        path: &str,
        notes: &mut Vec<Note>,
    ) -> Result<(), BakeError> {
        let source = &self.source;
        let is_solid = |at: DVec3| source.contains(at);
        let hollowing = Hollowing { body, assets, path, diagonal: self.size.length(), is_solid: &is_solid };
        let (carved, hollows) = hollowing.of(&self.sample, notes)?;
        // Thin places by their new numbers.
        let now = carved.kept.iter().zip(0_u32..).filter(|(before, _)| self.thin.binary_search(before).is_ok());
        self.thin = now.map(|(_, now)| now).collect();
        self.shares = self.shares.take().map(|shares| shares.chosen(&carved.kept));
        (self.sample, self.hollows) = (carved.sample, hollows);
        Ok(())
    }

    /// Volume of all cells that the particles stand for [m³].
    pub(super) fn filled_volume(&self) -> f64 {
        let cells = self.shares.as_ref().map_or(self.sample.points.len() as f64, |of| of.volumes.iter().sum());
        cells * self.sample.cell_volume()
    }

    /// The body with the support radius that its particles were given in the end.
    pub(super) fn effective<'b>(&self, body: &'b Body) -> Cow<'b, Body> {
        if self.sample.spacing == body.material.spacing() {
            return Cow::Borrowed(body);
        }
        let mut body = body.clone();
        body.material.support_radius = self.sample.spacing / body.material.spacing_ratio;
        Cow::Owned(body)
    }

    /// The surface that is drawn; `progress` hears how many of its points are embedded.
    ///
    /// # Errors
    /// That of `progress`.
    pub(super) fn skin(
        &self,
        kernel: Kernel,
        progress: &mut dyn FnMut(usize, usize) -> Result<(), BakeError>,
    ) -> Result<Option<Skin>, BakeError> {
        let particles = &self.sample.points;
        if let (Source::Mesh(solid), true) = (&self.source, self.hollows.is_empty()) {
            return Skin::try_embed(&SkinShape::of(solid), particles, kernel, &self.hollows, progress);
        }
        let surface = self.drawn_surface();
        Skin::try_embed(&SkinShape::of_drawn(&surface), particles, kernel, &self.hollows, progress)
    }

    /// The surface of the shape, with openings where voids come out of it, and their walls.
    fn drawn_surface(&self) -> DrawnSurface {
        let surface = match &self.source {
            Source::Box(solid) => DrawnSurface::of(box_surface(solid, self.sample.spacing)),
            Source::Mesh(solid) => DrawnSurface {
                points: solid.surface.points.clone(),
                point_of: solid.surface.point_of.clone(),
                normals: solid.model.normals.clone(),
                colours: solid.model.colours.clone(),
                triangles: solid.model.triangles.clone(),
            },
        };
        if self.hollows.is_empty() {
            return surface;
        }
        surface.hollowed(&self.hollows, self.sample.spacing, &|at| self.source.contains(at))
    }

    /// The same split along seams, and how many of its faces, the first ones, are not of their walls.
    pub(super) fn parted_surface(&self, seams: &[Arc<Seam>]) -> (DrawnSurface, usize) {
        let is_solid = |at: DVec3| self.source.contains(at) && !self.hollows.contain(at);
        self.drawn_surface().parted(seams, self.sample.spacing, &is_solid)
    }

    /// The thinnest part, but for edges and tips.
    fn thinnest(&self) -> Thinnest {
        match &self.source {
            Source::Box(solid) => {
                let mut sides = solid.size.to_array();
                sides.sort_by(f64::total_cmp);
                Thinnest { thickness: sides[0], is_compact: sides[1] < WIDE * sides[0] }
            }
            Source::Mesh(solid) => {
                let thickness = solid.thickness().of_all_but(EDGES);
                let thickness = thickness.unwrap_or_else(|| solid.size().min_element());
                Thinnest { thickness, is_compact: false }
            }
        }
    }

    /// Notes what came of filling it.
    ///
    /// # Errors
    /// [`BakeError::Cancelled`] where `stop` says that it is no longer wanted.
    fn note_sampling(
        &self,
        path: &str,
        notes: &mut Vec<Note>,
        stop: &mut dyn FnMut() -> bool,
    ) -> Result<(), BakeError> {
        let (_, pieces) = self.sample.pieces_unless(stop).ok_or(BakeError::Cancelled)?;
        if pieces > 1 {
            notes.push(Note {
                path: format!("{path}/shape"),
                text: format!("falls into {pieces} pieces that are not connected; each moves on its own"),
                warning: true,
            });
        }
        let cells = self.shares.as_ref().map_or(self.whole as f64, |of| of.volumes.iter().sum());
        let error = cells * self.sample.cell_volume() / self.volume - 1.0;
        if error.abs() > VOLUME_ERROR {
            let cause = match self.source {
                Source::Box(_) => "its extents are not whole multiples of the spacing",
                Source::Mesh(_) => "parts of it are thin beside the spacing",
            };
            notes.push(Note {
                path: format!("{path}/shape"),
                text: format!(
                    "the particles fill {:.1} % of the shape's volume: {cause} {} m",
                    100.0 * (1.0 + error),
                    self.sample.spacing
                ),
                warning: true,
            });
        }
        notes.extend(section_notes(&self.sample, self.shares.as_ref(), self.thinnest(), path));
        Ok(())
    }
}
