//! The rest shape of a two-layer body: its particles, and how they hang together.

use super::error::BakeError;
use super::note::Note;
use crate::geometry::mesh::TriangleMesh;
use crate::geometry::octahedron::{edges, sphere};
use crate::geometry::offset::moved_inwards;
use crate::geometry::solid::Solid;
use crate::scene::{Assets, ClosedMesh, InnerOffset, MAX_PARTICLES, TwoLayer, TwoLayerShape};
use crate::solver::forces::Springs;
use crate::solver::forces::pressure::Surface;
use crate::solver::forces::springs::{SpringGroup, SpringKind};
use crate::solver::skin::{Skin, SkinShape};
use glam::DVec3;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Points and how they hang together, in the model frame; the outer layer comes first.
pub(super) struct LayerModel {
    pub(super) points: Vec<DVec3>,
    pub(super) outer: usize,
    /// Edges of the outer layer; the inner layer has the same.
    edges: Vec<[u32; 2]>,
    /// Faces of the outer layer in 3D.
    faces: Vec<[u32; 3]>,
    pub(super) dimension: u32,
    /// Half the least extent [m]; of a segment half its length.
    pub(super) radius: f64,
    /// The surface that is drawn, in 3D.
    pub(super) skin: Option<Arc<Skin>>,
}

impl LayerModel {
    /// The particles of a shape; `path` is the body's pointer.
    pub(super) fn new(
        shape: &TwoLayerShape,
        assets: &Assets,
        path: &str,
        notes: &mut Vec<Note>,
    ) -> Result<Self, BakeError> {
        match shape {
            TwoLayerShape::Segment(segment) => {
                let end = 0.5 * segment.length * DVec3::X;
                Ok(Self::flat(vec![-end, end], 2, vec![[0, 1]], 1, 0.5 * segment.length))
            }
            TwoLayerShape::Ring(ring) => {
                let n = ring.sides;
                let at = |k: u32| {
                    // The first side lies flat below, so that the body stands on it.
                    let angle = TAU * ((f64::from(k) + 0.5) / f64::from(n) - 0.25);
                    DVec3::new(angle.cos(), angle.sin(), 0.0)
                };
                let edges = (0..n).map(|k| [k, (k + 1) % n]).collect();
                let unit: Vec<DVec3> = (0..n).map(at).collect();
                let points = scaled(&unit, ring.outer_radius, (!ring.single_layer).then_some(ring.inner_radius));
                Ok(Self::flat(points, n as usize, edges, 2, ring.outer_radius))
            }
            TwoLayerShape::Ball(ball) => {
                let mesh = sphere(ball.subdivisions);
                let inner = (!ball.single_layer).then_some(ball.inner_radius);
                let point_of: Vec<u32> = (0..mesh.positions.len() as u32).collect();
                let skin = SkinShape {
                    points: &mesh.positions,
                    point_of: &point_of,
                    normals: &[],
                    colours: &[],
                    triangles: &mesh.triangles,
                };
                Ok(Self {
                    points: scaled(&mesh.positions, ball.outer_radius, inner),
                    outer: mesh.positions.len(),
                    edges: edges(&mesh),
                    skin: Some(Arc::new(Skin::of_particles(&skin))),
                    faces: mesh.triangles,
                    dimension: 3,
                    radius: ball.outer_radius,
                })
            }
            TwoLayerShape::Mesh(mesh) => Self::of_mesh(mesh, assets, &format!("{path}/shape/mesh"), notes),
        }
    }

    fn flat(points: Vec<DVec3>, outer: usize, edges: Vec<[u32; 2]>, dimension: u32, radius: f64) -> Self {
        Self { points, outer, edges, faces: Vec::new(), dimension, radius, skin: None }
    }

    /// Mean distance between particles that an edge of the outer layer joins [m].
    pub(super) fn spacing(&self) -> f64 {
        self.mean_edge(0)
    }

    /// Mean distance between particles that an edge of the inner layer joins [m]; zero where there is none.
    pub(super) fn inner_spacing(&self) -> f64 {
        if self.has_inner_layer() { self.mean_edge(self.outer) } else { 0.0 }
    }

    /// The lesser of the two distances [m].
    pub(super) fn least_spacing(&self) -> f64 {
        let inner = self.inner_spacing();
        if inner > 0.0 { inner.min(self.spacing()) } else { self.spacing() }
    }

    /// Mean length [m] of the edges of the layer whose particles begin at `first`.
    fn mean_edge(&self, first: usize) -> f64 {
        let end = |end: u32| self.points[first + end as usize];
        let lengths = self.edges.iter().map(|edge| end(edge[0]).distance(end(edge[1])));
        lengths.sum::<f64>() / self.edges.len().max(1) as f64
    }

    /// The surface of a mesh; `at` is the shape's pointer.
    fn of_mesh(mesh: &ClosedMesh, assets: &Assets, at: &str, notes: &mut Vec<Note>) -> Result<Self, BakeError> {
        let file = format!("{at}/path");
        let solid = assets.solid(mesh).ok_or_else(|| BakeError::NotLoaded { path: file.clone() })?;
        if !solid.report.closed {
            return Err(BakeError::NotClosed { path: file, open_edges: solid.report.open_edges });
        }
        notes.extend(solid.report.findings().into_iter().map(|finding| Note {
            path: file.clone(),
            text: finding.text,
            warning: finding.warning,
        }));
        if solid.report.pieces > 1 {
            let text =
                format!("falls into {} pieces, which no spring joins; each moves on its own", solid.report.pieces);
            notes.push(Note { path: file.clone(), text, warning: true });
        }
        let (surface, skin) = surface(solid);
        let layers = if mesh.single_layer { 1 } else { 2 };
        let (outer, radius) = (surface.positions.len(), 0.5 * solid.size().min_element());
        if layers * outer > MAX_PARTICLES {
            return Err(BakeError::TooManyPoints { path: file, points: outer, limit: MAX_PARTICLES / layers });
        }
        let mut points = surface.positions.clone();
        if !mesh.single_layer {
            let (field, (unit, symbol), value) = match mesh.inner_offset {
                InnerOffset::Metres(metres) => ("metres", (1.0, " m"), metres),
                InnerOffset::Fraction(share) => ("fraction", (radius, ""), share),
            };
            let inner = moved_inwards(&surface.positions, &surface.triangles, value * unit);
            points.extend(inner.map_err(|fault| BakeError::InnerLayer {
                path: format!("{at}/inner_offset/{field}"),
                value,
                turned: fault.turned,
                crossings: fault.crossings,
                volume: fault.volume,
                // A little less, so that the digits of the message do.
                remedy: match fault.greatest {
                    Some(greatest) => {
                        format!("give {:.2e}{symbol} or less, or \"single_layer\": true", 0.99 * greatest / unit)
                    }
                    None => "this surface takes no inner layer: give \"single_layer\": true".to_owned(),
                },
            })?);
        }
        Ok(Self {
            points,
            outer,
            edges: edges(&surface),
            faces: surface.triangles,
            dimension: 3,
            radius,
            skin: Some(skin),
        })
    }

    pub(super) fn has_inner_layer(&self) -> bool {
        self.points.len() > self.outer
    }

    /// Every spring, kind by kind, with the constants of the body.
    pub(super) fn springs(&self, body: &TwoLayer) -> Springs {
        let n = self.outer as u32;
        let inner = self.has_inner_layer();
        let between = |pairs: Vec<[u32; 2]>| if inner { pairs } else { Vec::new() };
        let mut structural = self.edges.clone();
        structural.extend(between(self.edges.iter().map(|&[a, b]| [a + n, b + n]).collect()));
        let radius = between((0..n).map(|i| [i + n, i]).collect());
        let left = between(self.edges.iter().map(|&[a, b]| [a + n, b]).collect());
        let right = between(self.edges.iter().map(|&[a, b]| [b + n, a]).collect());
        let mut ends: Vec<[u32; 2]> = Vec::new();
        let mut groups = Vec::new();
        for (kind, springs) in [
            (SpringKind::Structural, structural),
            (SpringKind::Radius, radius),
            (SpringKind::ShearLeft, left),
            (SpringKind::ShearRight, right),
        ] {
            let (stiffness, damping) =
                if kind == SpringKind::Structural { (body.ks, body.kd) } else { (body.rks, body.rkd) };
            let first = ends.len();
            ends.extend(springs);
            groups.push(SpringGroup { kind, stiffness, damping, springs: first..ends.len() });
        }
        let at = |i: u32| self.points[i as usize];
        let rest_lengths = ends.iter().map(|&[a, b]| at(a).distance(at(b))).collect();
        Springs::new(ends.into(), rest_lengths, groups)
    }

    /// Surface of a layer whose first particle is `first`.
    pub(super) fn surface(&self, first: usize, normal: DVec3) -> Option<Surface> {
        let first = first as u32;
        match self.dimension {
            2 => Some(Surface::Polygon {
                edges: self.edges.iter().map(|edge| edge.map(|i| i + first)).collect(),
                normal,
            }),
            3 => Some(Surface::Faces(self.faces.iter().map(|face| face.map(|i| i + first)).collect())),
            _ => None,
        }
    }
}

/// Both layers of a shape given by unit vectors.
fn scaled(unit: &[DVec3], outer: f64, inner: Option<f64>) -> Vec<DVec3> {
    let radii = std::iter::once(outer).chain(inner);
    radii.flat_map(|radius| unit.iter().map(move |&x| radius * x)).collect()
}

/// The welded surface of a solid, without points that belong to no face of it, and what is drawn of it: the model,
/// whose vertices are split where normals or colours differ.
fn surface(solid: &Solid) -> (TriangleMesh, Arc<Skin>) {
    let welded = &solid.surface;
    let mut index = vec![None; welded.points.len()];
    for &point in welded.faces.iter().flatten() {
        index[point as usize] = Some(0);
    }
    let mut positions = Vec::new();
    for (index, &point) in index.iter_mut().zip(&welded.points) {
        if let Some(index) = index {
            *index = positions.len() as u32;
            positions.push(point);
        }
    }
    let of = |point: u32| index[point as usize].unwrap_or(0);
    let triangles = welded.faces.iter().map(|face| face.map(of)).collect();
    let point_of: Vec<u32> = welded.point_of.iter().map(|&point| of(point)).collect();
    let is_there = |vertex: &u32| index[welded.point_of[*vertex as usize] as usize].is_some();
    let drawn: Vec<[u32; 3]> = solid.model.triangles.iter().filter(|t| t.iter().all(is_there)).copied().collect();
    let skin = SkinShape {
        points: &positions,
        point_of: &point_of,
        normals: &solid.model.normals,
        colours: &solid.model.colours,
        triangles: &drawn,
    };
    let skin = Arc::new(Skin::of_particles(&skin));
    (TriangleMesh { positions, triangles }, skin)
}
