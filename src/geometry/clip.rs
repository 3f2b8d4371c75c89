//! A drawn surface with holes cut into it, and the walls that show through them.

mod parting;

use super::hollows::{Hollow, Hollows};
use super::mesh::TriangleMesh;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::collections::{HashMap, HashSet};

/// A surface as it is drawn: vertices split where normals or colours differ, on points that they share.
#[derive(Clone, Debug, Default)]
pub(crate) struct DrawnSurface {
    /// Different positions [m].
    pub(crate) points: Vec<DVec3>,
    /// Point of every vertex.
    pub(crate) point_of: Vec<u32>,
    /// A unit normal a vertex, or none at all.
    pub(crate) normals: Vec<Vec3>,
    /// A colour a vertex, or none at all.
    pub(crate) colours: Vec<[f32; 4]>,
    /// Vertex indices of the faces.
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// Halvings by which the place is found where an edge comes out of what is kept.
const HALVINGS: usize = 30;

/// Rounds in which long edges are halved, at most.
const ROUNDS: usize = 12;

impl DrawnSurface {
    /// A surface whose vertices are its points.
    pub(crate) fn of(mesh: TriangleMesh) -> Self {
        let point_of = (0..mesh.positions.len() as u32).collect();
        Self { points: mesh.positions, point_of, triangles: mesh.triangles, ..Self::default() }
    }

    /// The surface of a body with hollows: what lies in a hollow is cut out, and their walls are added, turned into
    /// them, as far as `is_solid` has them inside the body. Edges there are about `edge` [m] long.
    pub(crate) fn hollowed(mut self, hollows: &Hollows, edge: f64, is_solid: &(dyn Fn(DVec3) -> bool + Sync)) -> Self {
        let mut walls = Vec::new();
        for (k, shape) in hollows.shapes().enumerate() {
            let mut wall = Self::of(shape.wall(edge));
            wall.refine(edge, &|_, _| true);
            // Where two hollows share their wall, the first has it.
            let others = |at: DVec3| hollows.shapes().enumerate().any(|(other, of)| other != k && of.contains(at));
            wall.keep(&|at| is_solid(at) && !others(at));
            wall.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
            walls.push(wall);
        }
        let bounds: Vec<[DVec3; 2]> = hollows.shapes().map(Hollow::bounds).collect();
        self.refine(edge, &|low, high| bounds.iter().any(|[min, max]| min.cmple(high).all() && low.cmple(*max).all()));
        self.keep(&|at| !hollows.contain(at));
        let colour = mean(&self.colours);
        for wall in walls {
            self.add(wall, colour);
        }
        self.without_unused()
    }

    /// Halves edges longer than `edge` [m] of triangles that `near` has by the corners of their boxes, until none is
    /// left.
    fn refine(&mut self, edge: f64, near: &dyn Fn(DVec3, DVec3) -> bool) {
        for _ in 0..ROUNDS {
            let mut halved: HashSet<[u32; 2]> = HashSet::new();
            for triangle in &self.triangles {
                let corners = triangle.map(|v| self.at(v));
                let [low, high] =
                    [corners[0].min(corners[1]).min(corners[2]), corners[0].max(corners[1]).max(corners[2])];
                if !near(low, high) {
                    continue;
                }
                for k in 0..3 {
                    if corners[k].distance(corners[(k + 1) % 3]) > edge {
                        halved.insert(self.side(triangle[k], triangle[(k + 1) % 3]));
                    }
                }
            }
            if halved.is_empty() {
                return;
            }
            let mut between = Between::default();
            let triangles = std::mem::take(&mut self.triangles);
            for [a, b, c] in triangles {
                let mut middle = |one: u32, other: u32| {
                    halved.contains(&self.side(one, other)).then(|| between.vertex(self, [one, other], 0.5))
                };
                let middles = [middle(a, b), middle(b, c), middle(c, a)];
                self.triangles.extend(divided([a, b, c], middles));
            }
        }
    }

    /// Cuts away what is not kept.
    fn keep(&mut self, keep: &(dyn Fn(DVec3) -> bool + Sync)) {
        let kept: Vec<bool> = self.points.par_iter().with_min_len(256).map(|&at| keep(at)).collect();
        let mut between = Between::default();
        for triangle in std::mem::take(&mut self.triangles) {
            let inside = triangle.map(|v| kept[self.point_of[v as usize] as usize]);
            // Turned so that the corner alone on its side comes first.
            let alone = match inside.iter().filter(|inside| **inside).count() {
                0 => continue,
                3 => {
                    self.triangles.push(triangle);
                    continue;
                }
                1 => inside.iter().position(|inside| *inside),
                _ => inside.iter().position(|inside| !inside),
            };
            let first = alone.unwrap_or(0);
            let [a, b, c] = [triangle[first], triangle[(first + 1) % 3], triangle[(first + 2) % 3]];
            let mut rim = |one: u32, other: u32| {
                let share = self.leaves(keep, [one, other], kept[self.point_of[one as usize] as usize]);
                between.vertex(self, [one, other], share)
            };
            let (ab, ac) = (rim(a, b), rim(a, c));
            if inside[first] {
                self.triangles.push([a, ab, ac]);
            } else {
                self.triangles.extend([[ab, b, c], [ab, c, ac]]);
            }
        }
    }

    /// The share of the way from one vertex to another at which an edge changes sides; `inside` tells on which it
    /// starts.
    fn leaves(&self, keep: &dyn Fn(DVec3) -> bool, [one, other]: [u32; 2], inside: bool) -> f64 {
        let (a, b) = (self.at(one), self.at(other));
        let (mut from, mut to) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            if keep(a.lerp(b, middle)) == inside {
                from = middle;
            } else {
                to = middle;
            }
        }
        0.5 * (from + to)
    }

    fn at(&self, vertex: u32) -> DVec3 {
        self.points[self.point_of[vertex as usize] as usize]
    }

    /// A new vertex on a point a share of the way from one vertex to another.
    fn vertex_between(&mut self, [one, other]: [u32; 2], share: f64, point: u32) -> u32 {
        let vertex = self.point_of.len() as u32;
        self.point_of.push(point);
        let (one_at, other_at) = (one as usize, other as usize);
        if !self.normals.is_empty() {
            let normal = self.normals[one_at].lerp(self.normals[other_at], share as f32);
            self.normals.push(normal.normalize_or(self.normals[one_at]));
        }
        if !self.colours.is_empty() {
            let (from, to) = (self.colours[one_at], self.colours[other_at]);
            self.colours.push(std::array::from_fn(|k| from[k] + share as f32 * (to[k] - from[k])));
        }
        vertex
    }

    /// An edge by its points.
    fn side(&self, one: u32, other: u32) -> [u32; 2] {
        let [a, b] = [one, other].map(|v| self.point_of[v as usize]);
        [a.min(b), a.max(b)]
    }

    /// Adds another surface on points of its own.
    fn add(&mut self, other: Self, colour: [f32; 4]) {
        let (points, vertices) = (self.points.len() as u32, self.point_of.len() as u32);
        if !self.normals.is_empty() {
            self.normals.extend(other.vertex_normals());
        }
        if !self.colours.is_empty() {
            self.colours.extend(std::iter::repeat_n(colour, other.point_of.len()));
        }
        self.points.extend(other.points);
        self.point_of.extend(other.point_of.iter().map(|point| points + point));
        self.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(|v| vertices + v)));
    }

    /// Means of the faces around every vertex, by area.
    fn vertex_normals(&self) -> Vec<Vec3> {
        let mut sums = vec![DVec3::ZERO; self.points.len()];
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| self.at(v));
            for v in triangle {
                sums[self.point_of[*v as usize] as usize] += (b - a).cross(c - a);
            }
        }
        self.point_of.iter().map(|&point| sums[point as usize].normalize_or(DVec3::Y).as_vec3()).collect()
    }

    /// The same without vertices and points of no face.
    fn without_unused(self) -> Self {
        let mut vertex_now = vec![u32::MAX; self.point_of.len()];
        let mut point_now = vec![u32::MAX; self.points.len()];
        let mut left = Self::default();
        for triangle in &self.triangles {
            left.triangles.push(triangle.map(|v| {
                let v = v as usize;
                if vertex_now[v] == u32::MAX {
                    vertex_now[v] = left.point_of.len() as u32;
                    let point = self.point_of[v] as usize;
                    if point_now[point] == u32::MAX {
                        point_now[point] = left.points.len() as u32;
                        left.points.push(self.points[point]);
                    }
                    left.point_of.push(point_now[point]);
                    left.normals.extend(self.normals.get(v));
                    left.colours.extend(self.colours.get(v));
                }
                vertex_now[v]
            }));
        }
        left
    }
}

/// New vertices on edges: both faces beside one share it.
#[derive(Default)]
struct Between {
    vertices: HashMap<[u32; 2], u32>,
    points: HashMap<[u32; 2], u32>,
}

impl Between {
    /// The vertex at a share of the way from one vertex to another.
    fn vertex(&mut self, surface: &mut DrawnSurface, [one, other]: [u32; 2], share: f64) -> u32 {
        if let Some(&known) = self.vertices.get(&[one.min(other), one.max(other)]) {
            return known;
        }
        let (a, b) = (surface.at(one), surface.at(other));
        let point = *self.points.entry(surface.side(one, other)).or_insert_with(|| {
            surface.points.push(a.lerp(b, share));
            surface.points.len() as u32 - 1
        });
        let vertex = surface.vertex_between([one, other], share, point);
        self.vertices.insert([one.min(other), one.max(other)], vertex);
        vertex
    }
}

/// A triangle with new vertices in the middles of some of its sides ab, bc, ca.
fn divided([a, b, c]: [u32; 3], middles: [Option<u32>; 3]) -> Vec<[u32; 3]> {
    match middles {
        [None, None, None] => vec![[a, b, c]],
        [Some(m), None, None] => vec![[a, m, c], [m, b, c]],
        [None, Some(m), None] => vec![[b, m, a], [m, c, a]],
        [None, None, Some(m)] => vec![[c, m, b], [m, a, b]],
        [Some(m), Some(n), None] => vec![[m, b, n], [a, m, n], [a, n, c]],
        [None, Some(m), Some(n)] => vec![[m, c, n], [b, m, n], [b, n, a]],
        [Some(n), None, Some(m)] => vec![[m, a, n], [c, m, n], [c, n, b]],
        [Some(ab), Some(bc), Some(ca)] => vec![[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]],
    }
}

fn mean(colours: &[[f32; 4]]) -> [f32; 4] {
    let count = colours.len().max(1) as f32;
    std::array::from_fn(|k| colours.iter().map(|colour| colour[k]).sum::<f32>() / count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;
    use std::f64::consts::PI;

    /// Volume that the faces enclose [m³], those of walls turned into the hollow.
    fn hollowed(cut: Hollow, edge: f64) -> (DrawnSurface, f64) {
        let cube = Cuboid { center: DVec3::ZERO, size: DVec3::splat(2.0) };
        let hollows = Hollows::new(vec![cut], edge);
        // A coarse surface: a hole may lie within one of its faces.
        let surface = DrawnSurface::of(box_surface(&cube, 2.0)).hollowed(&hollows, edge, &|at| cube.contains(at));
        let mesh = TriangleMesh {
            positions: surface.point_of.iter().map(|&point| surface.points[point as usize]).collect(),
            triangles: surface.triangles.clone(),
        };
        (surface, mesh.volume())
    }

    #[test]
    fn a_surface_with_hollows_encloses_what_is_left() {
        let ball = Hollow::Ball { center: DVec3::ZERO, radius: 0.5 };
        let (_, volume) = hollowed(ball, 0.05);
        assert!((8.0 - volume - 4.0 / 3.0 * PI * 0.125).abs() < 5e-3, "{volume}");
        // Half a ball that opens one side, and a tube right through.
        let half = Hollow::Ball { center: DVec3::X, radius: 0.5 };
        let (surface, volume) = hollowed(half, 0.05);
        assert!((8.0 - volume - 2.0 / 3.0 * PI * 0.125).abs() < 5e-3, "{volume}");
        assert!(surface.points.iter().all(|at| at.distance(DVec3::X) > 0.497), "nothing is left in the hole");
        let line = vec![DVec3::new(-2.0, 0.1, 0.0), DVec3::new(2.0, 0.1, 0.0)];
        let (_, volume) = hollowed(Hollow::Tube { line, radius: 0.4 }, 0.05);
        assert!((8.0 - volume - 2.0 * PI * 0.16).abs() < 1e-2, "{volume}");
    }
}
