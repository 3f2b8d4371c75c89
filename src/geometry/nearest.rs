//! The point of a surface that is nearest to a point, and which way is out there.

use super::bvh::{Bvh, Node};
use super::closest::closest_on_triangle;
use super::slabs::Slabs;
use glam::DVec3;
use std::collections::HashMap;

/// Triangles that can be asked for their nearest point. Faces must share the points at which they meet, and turn
/// counter-clockwise seen from outside.
#[derive(Clone, Debug)]
pub struct SurfaceIndex {
    points: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
    bvh: Bvh,
    edge_normals: HashMap<[u32; 2], DVec3>,
    point_normals: Vec<DVec3>,
}

/// The nearest point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// The point [m].
    pub point: DVec3,
    /// Unit vector outwards there: that of the face, or at an edge or corner the mean of the faces that meet in it, by
    /// their angles (Baerentzen and Aanaes: *Signed distance computation using the angle weighted pseudonormal*, 2005).
    pub normal: DVec3,
    /// Index of the face.
    pub face: u32,
}

impl SurfaceIndex {
    /// Sorts the faces for asking.
    pub fn new(points: Vec<DVec3>, faces: Vec<[u32; 3]>) -> Self {
        let bvh = Bvh::new(&points, &faces);
        let mut edge_normals: HashMap<[u32; 2], DVec3> = HashMap::new();
        let mut point_normals = vec![DVec3::ZERO; points.len()];
        for face in &faces {
            let corners = face.map(|i| points[i as usize]);
            let normal = face_normal(corners);
            for k in 0..3 {
                let (a, b) = (face[k], face[(k + 1) % 3]);
                *edge_normals.entry([a.min(b), a.max(b)]).or_default() += normal;
                let to = |other: usize| (corners[other % 3] - corners[k]).normalize_or_zero();
                point_normals[a as usize] += to(k + 1).angle_between(to(k + 2)).max(0.0) * normal;
            }
        }
        Self { points, faces, bvh, edge_normals, point_normals }
    }

    /// The nearest point; none of a surface without faces. Of faces equally near the first counts.
    pub fn nearest(&self, x: DVec3) -> Option<Nearest> {
        let (face, weights, point) = nearest_face(&self.points, &self.faces, &self.bvh, x)?;
        Some(Nearest { point, normal: self.normal(face, weights), face })
    }

    fn corners(&self, face: u32) -> [DVec3; 3] {
        self.faces[face as usize].map(|i| self.points[i as usize])
    }

    fn normal(&self, face: u32, weights: [f64; 3]) -> DVec3 {
        let own = face_normal(self.corners(face));
        let carrying: Vec<u32> =
            self.faces[face as usize].into_iter().zip(weights).filter(|(_, w)| *w != 0.0).map(|(i, _)| i).collect();
        let mean = match carrying[..] {
            [a] => self.point_normals[a as usize],
            [a, b] => self.edge_normals.get(&[a.min(b), a.max(b)]).copied().unwrap_or(own),
            _ => own,
        };
        mean.normalize_or(own)
    }
}

/// The face nearest to a point, the weights of its corners in its nearest point, and that; `bvh` holds the faces. Of
/// those equally near the first counts.
pub(crate) fn nearest_face(
    points: &[DVec3],
    faces: &[[u32; 3]],
    bvh: &Bvh,
    x: DVec3,
) -> Option<(u32, [f64; 3], DVec3)> {
    nearest_face_by(points, faces, (bvh, None), x, f64::INFINITY)
}

/// [`nearest_face`], if it is nearer than a distance [m], sooner with the slabs of the tree's leaves. What is about as
/// far from everywhere, as the middle of a ball is, is found soon to be so.
pub(crate) fn nearest_face_by(
    points: &[DVec3],
    faces: &[[u32; 3]],
    (bvh, slabs): (&Bvh, Option<&Slabs>),
    x: DVec3,
    distance: f64,
) -> Option<(u32, [f64; 3], DVec3)> {
    let mut least = distance * distance;
    let mut best: Option<(u32, [f64; 3], DVec3)> = None;
    let mut open = Vec::with_capacity(64);
    open.extend(bvh.nodes().first().map(|root| (distance_squared(root, x), 0)));
    while let Some((square, index)) = open.pop() {
        if square > least {
            continue;
        }
        if !bvh.nodes()[index].is_leaf() {
            let mut children = bvh.children(index).map(|child| (distance_squared(&bvh.nodes()[child], x), child));
            // The nearer child is looked at first: it mostly rules the other one out.
            children.sort_by(|a, b| b.0.total_cmp(&a.0));
            open.extend(children);
            continue;
        }
        if slabs.is_some_and(|slabs| slabs.distance(index, x).max(0.0).powi(2) > least) {
            continue;
        }
        for &face in bvh.triangles(index) {
            let corners = faces[face as usize].map(|i| points[i as usize]);
            let weights = closest_on_triangle(x, corners);
            let point = mix(weights, corners);
            let square = x.distance_squared(point);
            let is_first = best.is_none() && distance == f64::INFINITY;
            if square < least || is_first || (square == least && best.is_some_and(|(first, ..)| face < first)) {
                least = square;
                best = Some((face, weights, point));
            }
        }
    }
    best
}

fn face_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
}

fn mix(weights: [f64; 3], corners: [DVec3; 3]) -> DVec3 {
    weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2]
}

/// From a point to a box; zero inside.
fn distance_squared(node: &Node, x: DVec3) -> f64 {
    x.distance_squared(x.clamp(node.min, node.max))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;

    fn cube(edge: f64) -> SurfaceIndex {
        let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::splat(2.0) }, edge);
        SurfaceIndex::new(mesh.positions, mesh.triangles)
    }

    #[test]
    fn no_face_is_nearer() {
        let surface = cube(0.3);
        for k in 0..300 {
            let k = f64::from(k);
            let x = 2.0 * DVec3::new((1.3 * k).sin(), (2.1 * k).cos(), (0.7 * k).sin());
            let found = surface.nearest(x).expect("a surface");
            let least = (0..surface.faces.len() as u32)
                .map(|face| {
                    let corners = surface.corners(face);
                    x.distance(mix(closest_on_triangle(x, corners), corners))
                })
                .fold(f64::INFINITY, f64::min);
            assert!((x.distance(found.point) - least).abs() < 1e-12);
        }
    }

    #[test]
    fn what_is_no_nearer_than_a_distance_is_not_found() {
        let surface = cube(0.3);
        let (points, faces, bvh) = (&surface.points, &surface.faces, &surface.bvh);
        for k in 0..100 {
            let k = f64::from(k);
            let x = 2.0 * DVec3::new((1.3 * k).sin(), (2.1 * k).cos(), (0.7 * k).sin());
            let found = nearest_face(points, faces, bvh, x).expect("a surface");
            let distance = x.distance(found.2);
            assert_eq!(nearest_face_by(points, faces, (bvh, None), x, 1.01 * distance), Some(found));
            assert_eq!(nearest_face_by(points, faces, (bvh, None), x, 0.99 * distance), None);
            let slabs = Slabs::new(points, faces, bvh);
            for within in [f64::INFINITY, 1.01 * distance] {
                assert_eq!(nearest_face_by(points, faces, (bvh, Some(&slabs)), x, within), Some(found));
            }
        }
    }

    #[test]
    fn normals_point_out_of_faces_edges_and_corners() {
        // However finely the cube is divided, and whichever face of an edge is met first.
        for edge in [2.0, 0.3] {
            let surface = cube(edge);
            for (x, outwards) in [
                (DVec3::new(0.21, 0.57, 0.4), DVec3::Y),
                (DVec3::new(0.2, -3.0, 0.1), DVec3::NEG_Y),
                (DVec3::new(2.0, 2.0, 0.1), DVec3::new(1.0, 1.0, 0.0)),
                (DVec3::new(-2.0, 2.0, -2.0), DVec3::new(-1.0, 1.0, -1.0)),
            ] {
                let found = surface.nearest(x).expect("a surface");
                assert!(found.normal.distance(outwards.normalize_or_zero()) < 1e-12, "{x}: {}", found.normal);
                assert!((found.point.abs().max_element() - 1.0).abs() < 1e-12);
            }
        }
        assert!(SurfaceIndex::new(Vec::new(), Vec::new()).nearest(DVec3::ZERO).is_none());
    }
}
