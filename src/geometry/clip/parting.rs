//! A drawn surface that comes apart along seams.

use super::DrawnSurface;
use crate::geometry::mesh::TriangleMesh;
use crate::geometry::seam::Seam;
use glam::DVec3;
use std::collections::HashMap;
use std::sync::Arc;

/// How far from a seam the surface begins on either side, as a share of the edges' length: nobody sees it, and it says
/// which side that is.
const SLIT: f64 = 2e-3;

impl DrawnSurface {
    /// The surface with points of their own on either side of seams, and both walls of each as far as `is_solid` has
    /// them inside the body; and how many of its faces, the first ones, are not of walls. Edges there are about `edge`
    /// [m] long.
    pub(crate) fn parted(
        mut self,
        seams: &[Arc<Seam>],
        edge: f64,
        is_solid: &(dyn Fn(DVec3) -> bool + Sync),
    ) -> (Self, usize) {
        for seam in seams {
            let [min, max] = seam.bounds();
            self.refine(edge, &|low, high| min.cmple(high).all() && low.cmple(max).all());
            self.split(seam, SLIT * edge);
        }
        let outer = self.triangles.len();
        let colour = super::mean(&self.colours);
        for seam in seams {
            for side in [1.0, -1.0] {
                let shifted = seam.points().iter().zip(seam.normals());
                let positions = shifted.map(|(&at, &normal)| at + side * SLIT * edge * normal).collect();
                let mut wall = Self::of(TriangleMesh { positions, triangles: seam.triangles().to_vec() });
                wall.refine(edge, &|_, _| true);
                wall.keep(is_solid);
                if side > 0.0 {
                    wall.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
                }
                self.add(wall, colour);
            }
        }
        (self.without_unused(), outer)
    }

    /// Cuts triangles where a seam passes through their edges; what lies on either side has points of its own there,
    /// `slit` [m] from the seam at most.
    fn split(&mut self, seam: &Seam, slit: f64) {
        let mut ends = Ends { seam, slit, crossings: HashMap::new(), points: HashMap::new(), vertices: HashMap::new() };
        for triangle in std::mem::take(&mut self.triangles) {
            let [a, b, c] = triangle;
            let crossed = [[a, b], [b, c], [c, a]].map(|[one, other]| ends.crossing(self, one, other).is_some());
            // The corner at which two cut sides meet, or the side that alone is cut: there the seam ends within.
            let first = match crossed {
                [true, _, true] => 0,
                [true, true, false] => 1,
                [false, true, true] => 2,
                [true, false, false] => {
                    let [to_a, to_b] = [ends.vertex(self, a, b), ends.vertex(self, b, a)];
                    self.triangles.extend([[a, to_a, c], [to_b, b, c]]);
                    continue;
                }
                [false, true, false] => {
                    let [to_b, to_c] = [ends.vertex(self, b, c), ends.vertex(self, c, b)];
                    self.triangles.extend([[b, to_b, a], [to_c, c, a]]);
                    continue;
                }
                [false, false, true] => {
                    let [to_c, to_a] = [ends.vertex(self, c, a), ends.vertex(self, a, c)];
                    self.triangles.extend([[c, to_c, b], [to_a, a, b]]);
                    continue;
                }
                [false, false, false] => {
                    self.triangles.push(triangle);
                    continue;
                }
            };
            let [a, b, c] = [0, 1, 2].map(|k| triangle[(first + k) % 3]);
            let near = [ends.vertex(self, a, b), ends.vertex(self, a, c)];
            let far = [ends.vertex(self, b, a), ends.vertex(self, c, a)];
            self.triangles.extend([[a, near[0], near[1]], [far[0], b, c], [far[0], c, far[1]]]);
        }
    }
}

/// Where edges end at a seam.
struct Ends<'a> {
    seam: &'a Seam,
    slit: f64,
    /// Share of the way at which an edge crosses it, by its points in ascending order.
    crossings: HashMap<[u32; 2], Option<f64>>,
    /// Points of the end on the side of the first, by the points of the edge.
    points: HashMap<[u32; 2], u32>,
    /// Vertices likewise.
    vertices: HashMap<[u32; 2], u32>,
}

impl Ends<'_> {
    /// The share of the way from one vertex to another at which the edge between them crosses the seam.
    fn crossing(&mut self, surface: &DrawnSurface, one: u32, other: u32) -> Option<f64> {
        let side = surface.side(one, other);
        let ends = side.map(|point| surface.points[point as usize]);
        let share = *self.crossings.entry(side).or_insert_with(|| self.seam.crossing(ends));
        share.map(|share| if surface.point_of[one as usize] == side[0] { share } else { 1.0 - share })
    }

    /// The vertex where what is left of an edge on the side of `one` ends.
    fn vertex(&mut self, surface: &mut DrawnSurface, one: u32, other: u32) -> u32 {
        if let Some(&known) = self.vertices.get(&[one, other]) {
            return known;
        }
        let (a, b) = (surface.at(one), surface.at(other));
        let share = self.crossing(surface, one, other).unwrap_or(0.5);
        let share = share - (self.slit / a.distance(b).max(f64::MIN_POSITIVE)).min(0.5 * share);
        let points = [one, other].map(|v| surface.point_of[v as usize]);
        let point = *self.points.entry(points).or_insert_with(|| {
            surface.points.push(a.lerp(b, share));
            surface.points.len() as u32 - 1
        });
        let vertex = surface.vertex_between([one, other], share, point);
        self.vertices.insert([one, other], vertex);
        vertex
    }
}
