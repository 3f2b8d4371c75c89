//! A surface of triangles that things are kept out of, or on one side of.

use super::bvh::{Bvh, Node};
use super::closest::closest_on_triangle;
use super::model::Model;
use super::model_report::Refusal;
use super::solid::Solid;
use super::weld::Welded;
use super::winding::Winding;
use glam::DVec3;

/// Where an obstacle is nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Foot {
    /// Distance of the point [m], negative inside.
    pub gap: f64,
    /// Unit vector out of the obstacle, or to the point's side of a shell.
    pub normal: DVec3,
}

/// Where a way first goes into an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Entry {
    /// Share of the way before it.
    pub share: f64,
    /// Unit vector out of the obstacle there, to the side that the way comes from.
    pub normal: DVec3,
}

/// Triangles with what they are found by.
#[derive(Clone, Debug)]
pub(crate) struct ObstacleMesh {
    points: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
    bvh: Bvh,
    /// How often a closed surface turns around a point.
    turns: Option<Winding>,
}

/// A way through two triangles at their common edge meets one of them at least, by this share of their size.
const SLACK: f64 = 1e-9;

impl ObstacleMesh {
    /// The surface of a model, upright and in metres: what a closed one encloses is solid, any other is a shell.
    ///
    /// # Errors
    /// [`Refusal::NoFaces`] for a model without a face that has an area.
    pub(crate) fn new(model: &Model) -> Result<Self, Refusal> {
        if let Ok(solid) = Solid::new(model)
            && solid.report.closed
            && solid.report.left_out.pieces == 0
        {
            return Ok(Self::of(solid.surface.points, solid.surface.faces, true));
        }
        let there = |face: &[u32; 3]| face.iter().all(|&i| (i as usize) < model.positions.len());
        let finite = |face: &[u32; 3]| face.iter().all(|&i| model.positions[i as usize].is_finite());
        let whole = Model {
            positions: model.positions.iter().map(|x| if x.is_finite() { *x } else { DVec3::ZERO }).collect(),
            triangles: model.triangles.iter().copied().filter(|face| there(face) && finite(face)).collect(),
            ..Model::default()
        };
        let lost_faces = model.triangles.len() - whole.triangles.len();
        let Welded { points, mut faces, .. } = Welded::new(&whole);
        faces.retain(|&face| area_vector(&points, face) != DVec3::ZERO);
        if faces.is_empty() { Err(Refusal::NoFaces { lost_faces }) } else { Ok(Self::of(points, faces, false)) }
    }

    fn of(points: Vec<DVec3>, faces: Vec<[u32; 3]>, closed: bool) -> Self {
        let bvh = Bvh::new(&points, &faces);
        let turns = closed.then(|| Winding::new(&points, &faces, &bvh));
        Self { points, faces, bvh, turns }
    }

    /// The same surface as a shell that is touched from both sides.
    pub(crate) fn hollow(&self) -> Self {
        Self { turns: None, ..self.clone() }
    }

    /// Whether it encloses something solid.
    pub(crate) fn is_solid(&self) -> bool {
        self.turns.is_some()
    }

    /// Different positions of its vertices [m].
    pub(crate) fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// Point indices of its faces.
    pub(crate) fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// Least and greatest corner [m].
    pub(crate) fn bounds(&self) -> [DVec3; 2] {
        self.bvh.nodes().first().map_or([DVec3::ZERO; 2], |node| [node.min, node.max])
    }

    fn corners(&self, face: u32) -> [DVec3; 3] {
        self.faces[face as usize].map(|i| self.points[i as usize])
    }

    /// Where it is nearest to a point that is not further than `reach` [m] away.
    pub(crate) fn foot(&self, x: DVec3, reach: f64) -> Option<Foot> {
        let (face, at, squared) = self.nearest(x, reach * reach)?;
        let shell_side = |n: DVec3| if n.dot(x - at) < 0.0 { -n } else { n };
        let inside = self.turns.as_ref().is_some_and(|turns| turns.at(x) > 0.5);
        let distance = squared.sqrt();
        let sign = if inside { -1.0 } else { 1.0 };
        let size = at.abs().max_element().max(1e-3);
        let normal = if distance > 1e-12 * size {
            (x - at) * (sign / distance)
        } else {
            let out = area_vector(&self.points, self.faces[face as usize]).normalize_or(DVec3::Y);
            if self.is_solid() { out } else { shell_side(out) }
        };
        Some(Foot { gap: sign * distance, normal })
    }

    /// The nearest face to a point, the place on it, and the square of its distance [m²], which is no more than `most`.
    fn nearest(&self, x: DVec3, most: f64) -> Option<(u32, DVec3, f64)> {
        let nodes = self.bvh.nodes();
        let squared = |node: &Node| x.distance_squared(x.clamp(node.min, node.max));
        let mut open: Vec<(usize, f64)> = nodes.first().map(|node| (0, squared(node))).into_iter().collect();
        let mut best: Option<(u32, DVec3, f64)> = None;
        while let Some((index, bound)) = open.pop() {
            let least = best.map_or(most, |(.., squared)| squared);
            if bound > least {
                continue;
            }
            if nodes[index].is_leaf() {
                for &face in self.bvh.triangles(index) {
                    let corners = self.corners(face);
                    let weights = closest_on_triangle(x, corners);
                    let at: DVec3 = corners.into_iter().zip(weights).map(|(corner, weight)| weight * corner).sum();
                    let squared = x.distance_squared(at);
                    let least = best.map_or(most, |(.., squared)| squared);
                    // Of equal ones the first in the file, whatever the order of the search.
                    let first = best.is_none_or(|(known, ..)| face < known);
                    if squared < least || (squared == least && first) {
                        best = Some((face, at, squared));
                    }
                }
            } else {
                let [a, b] = self.bvh.children(index).map(|child| (child, squared(&nodes[child])));
                let [near, far] = if a.1 <= b.1 { [a, b] } else { [b, a] };
                open.extend([far, near]);
            }
        }
        best
    }

    /// Where the way between two points first goes into it, or through a shell.
    pub(crate) fn entry(&self, from: DVec3, to: DVec3) -> Option<Entry> {
        let way = to - from;
        let (low, high) = (from.min(to), from.max(to));
        let mut first: Option<(f64, u32)> = None;
        let meets = |node: &Node| node.min.cmple(high).all() && node.max.cmpge(low).all();
        self.bvh.visit(meets, |face| {
            let [a, b, c] = self.corners(face);
            let (ab, ac) = (b - a, c - a);
            let across = way.cross(ac);
            let determinant = ab.dot(across);
            // Out of a solid is no way in.
            let enters = if self.is_solid() { determinant > 0.0 } else { determinant != 0.0 };
            if !enters {
                return;
            }
            let start = from - a;
            let u = start.dot(across) / determinant;
            let turned = start.cross(ab);
            let v = way.dot(turned) / determinant;
            let share = ac.dot(turned) / determinant;
            let within = u >= -SLACK && v >= -SLACK && u + v <= 1.0 + SLACK;
            let sooner = first.is_none_or(|known| (share, face) < known);
            if within && (0.0..=1.0).contains(&share) && sooner {
                first = Some((share, face));
            }
        });
        first.map(|(share, face)| {
            let out = area_vector(&self.points, self.faces[face as usize]).normalize_or(DVec3::Y);
            Entry { share, normal: if out.dot(way) > 0.0 { -out } else { out } }
        })
    }
}

fn area_vector(points: &[DVec3], face: [u32; 3]) -> DVec3 {
    let [a, b, c] = face.map(|i| points[i as usize]);
    (b - a).cross(c - a)
}
