//! From a shape to the particles that fill it and the surface that is drawn of it.

use super::error::BakeError;
use super::note::Note;
use crate::geometry::fill::{FEW, FillError, FillResolution, Filling, fill, two_layer_spacing};
use crate::geometry::kernel::Kernel;
use crate::geometry::lattice::{Cuboid, LatticeSample, fill_box};
use crate::geometry::mesh::box_surface;
use crate::geometry::solid::Solid;
use crate::scene::{Assets, Body, BoxShape, MAX_PARTICLES, MeshShape, Rotation, Shape};
use crate::solver::skin::{Skin, SkinShape};
use glam::{DMat3, DVec3};
use std::borrow::Cow;

/// A filled shape.
pub(super) struct ParticleSampling<'a> {
    /// The particles.
    pub(super) sample: LatticeSample,
    /// Volume of the shape [m³].
    pub(super) volume: f64,
    /// Extents of the shape [m].
    pub(super) size: DVec3,
    source: Source<'a>,
}

enum Source<'a> {
    Box(Cuboid),
    Mesh(&'a Solid),
}

/// Volume errors beyond this are said.
const VOLUME_ERROR: f64 = 0.02;

pub(super) fn sample_particles<'a>(
    body: &Body,
    assets: &'a Assets,
    path: &str,
    notes: &mut Vec<Note>,
) -> Result<ParticleSampling<'a>, BakeError> {
    let sampling = match &body.shape {
        Shape::Box(shape) => fill_box_shape(body, shape, path)?,
        Shape::Mesh(shape) => fill_mesh_shape(body, shape, assets, path, notes)?,
    };
    sampling.note_sampling(path, notes);
    Ok(sampling)
}

fn fill_box_shape<'a>(body: &Body, shape: &BoxShape, path: &str) -> Result<ParticleSampling<'a>, BakeError> {
    let spacing = body.material.spacing();
    let solid = Cuboid { center: DVec3::from_array(shape.center), size: DVec3::from_array(shape.size) };
    let sample = fill_box(&solid, spacing, lattice_axes(&shape.lattice_rotation));
    if sample.points.is_empty() {
        return Err(BakeError::Empty { path: format!("{path}/shape"), body: path.to_owned(), spacing });
    }
    Ok(ParticleSampling { sample, volume: solid.volume(), size: solid.size, source: Source::Box(solid) })
}

fn lattice_axes(rotation: &Rotation) -> DMat3 {
    // Exactly along the axes when not turned: that decides how the box is filled.
    if rotation.degrees == 0.0 { DMat3::IDENTITY } else { DMat3::from_quat(rotation.quaternion()) }
}

fn fill_mesh_shape<'a>(
    body: &Body,
    shape: &MeshShape,
    assets: &'a Assets,
    path: &str,
    notes: &mut Vec<Note>,
) -> Result<ParticleSampling<'a>, BakeError> {
    let at = format!("{path}/shape/mesh");
    let solid = assets.solid(shape).ok_or_else(|| BakeError::NotLoaded { path: format!("{at}/path") })?;
    let found = solid.report.findings();
    notes.extend(found.into_iter().map(|finding| Note {
        path: format!("{at}/path"),
        text: finding.text,
        warning: finding.warning,
    }));
    let ratio = body.material.spacing_ratio;
    let fineness = shape.particles.map_or(FillResolution::Spacing(body.material.spacing()), FillResolution::Particles);
    let filling = fill(solid, fineness, ratio.recip(), MAX_PARTICLES).map_err(|error| match error {
        FillError::TooMany { wanted, limit } => {
            let spacing = body.material.spacing() * 1.01 * (wanted / limit).cbrt();
            BakeError::TooMany {
                path: format!("{path}/material/support_radius"),
                what: "lattice points would be needed",
                wanted,
                limit,
                suggested: spacing / ratio,
            }
        }
        FillError::TooFarApart { .. } => BakeError::MeshTooWide { path: format!("{at}/path"), source: error },
        FillError::TooThin { flat, total, suggested, .. } => BakeError::MeshTooThin {
            path: format!("{path}/material/support_radius"),
            flat,
            total,
            suggested: suggested.map(|spacing| spacing / ratio),
        },
    })?;
    note_filling(&filling, solid, body, shape, path, notes);
    Ok(ParticleSampling {
        sample: filling.sample,
        volume: solid.volume,
        size: solid.size(),
        source: Source::Mesh(solid),
    })
}

fn note_filling(filling: &Filling, solid: &Solid, body: &Body, shape: &MeshShape, path: &str, notes: &mut Vec<Note>) {
    let mut note = |field: &str, warning: bool, text: String| {
        notes.push(Note { path: format!("{path}/{field}"), text, warning });
    };
    let radius = filling.sample.spacing / body.material.spacing_ratio;
    let change = radius / body.material.support_radius - 1.0;
    if shape.particles.is_some() {
        let count = filling.sample.points.len();
        note("shape/mesh/particles", false, format!("{count} particles at a support radius of {radius:.6} m"));
    } else if change != 0.0 {
        let percent = 100.0 * change;
        let text = format!("made {radius:.6} m ({percent:+.1} %) so that the particles' volume is that of the mesh");
        note("material/support_radius", false, text);
    }
    let total = filling.sample.points.len();
    if filling.pruned > 0 {
        let text = format!("{} lattice points at tips too fine to hold them were left out", filling.pruned);
        note("shape/mesh", false, text);
    }
    let thin = &filling.thinness;
    if thin.single as f64 > FEW * total as f64 {
        let at = thin.first.and_then(|index| filling.sample.points.get(index)).copied().unwrap_or_default();
        let ratio = body.material.spacing_ratio;
        let remedy = match two_layer_spacing(solid, filling.sample.spacing, ratio.recip(), MAX_PARTICLES as f64) {
            Some(spacing) => format!("a support radius of {:.3e} m gives two layers", spacing / ratio),
            None => "two layers would take more particles than are allowed".to_owned(),
        };
        let text = format!(
            "{} of {total} particles lie in parts hardly more than one layer thick (the first at {:.4?} m), which \
             bend too easily: {remedy}",
            thin.single,
            at.to_array(),
        );
        note("material/support_radius", true, text);
    }
    if thin.double > 0 {
        let text = format!(
            "{} of {total} particles lie in parts two layers thick, which twist a quarter too easily; {:.3e} m would \
             give three layers",
            thin.double,
            radius / 1.5
        );
        note("material/support_radius", false, text);
    }
}

impl ParticleSampling<'_> {
    /// The body with the support radius that its particles were given in the end.
    pub(super) fn effective<'b>(&self, body: &'b Body) -> Cow<'b, Body> {
        if matches!(self.source, Source::Box(_)) || self.sample.spacing == body.material.spacing() {
            return Cow::Borrowed(body);
        }
        let mut body = body.clone();
        body.material.support_radius = self.sample.spacing / body.material.spacing_ratio;
        Cow::Owned(body)
    }

    /// The surface that is drawn; `progress` hears how many of its points are embedded.
    pub(super) fn skin(&self, kernel: Kernel, progress: &mut dyn FnMut(usize, usize)) -> Option<Skin> {
        let particles = &self.sample.points;
        match &self.source {
            Source::Box(solid) => {
                let surface = box_surface(solid, self.sample.spacing);
                let point_of: Vec<u32> = (0..surface.positions.len() as u32).collect();
                let shape = SkinShape {
                    points: &surface.positions,
                    point_of: &point_of,
                    normals: &[],
                    colours: &[],
                    triangles: &surface.triangles,
                };
                Skin::embed(&shape, particles, kernel, progress)
            }
            Source::Mesh(solid) => {
                let shape = SkinShape {
                    points: &solid.surface.points,
                    point_of: &solid.surface.point_of,
                    normals: &solid.model.normals,
                    colours: &solid.model.colours,
                    triangles: &solid.model.triangles,
                };
                Skin::embed(&shape, particles, kernel, progress)
            }
        }
    }

    fn note_sampling(&self, path: &str, notes: &mut Vec<Note>) {
        let (_, pieces) = self.sample.pieces();
        if pieces > 1 {
            notes.push(Note {
                path: format!("{path}/shape"),
                text: format!("falls into {pieces} pieces that are not connected; each moves on its own"),
                warning: true,
            });
        }
        let error = self.sample.points.len() as f64 * self.sample.spacing.powi(3) / self.volume - 1.0;
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
    }
}
