//! Hollows of a body: what lies inside them, which segments pass through them, and their walls.

use super::bvh::{Bvh, Node};
use super::closest::{closest_on_segment, closest_segments};
use super::crossing::passes;
use super::isosurface::isosurface;
use super::lattice::Cuboid;
use super::mesh::{TriangleMesh, box_surface};
use super::octahedron::sphere;
use super::seam::Seam;
use super::solid::Solid;
use glam::DVec3;
use std::sync::Arc;

/// One hollow.
#[derive(Clone, Debug)]
pub(crate) enum Hollow {
    /// A ball: its centre and radius [m].
    Ball { center: DVec3, radius: f64 },
    /// A box along the axes.
    Box(Cuboid),
    /// All that lies within a radius [m] of a line, round at its ends.
    Tube { line: Vec<DVec3>, radius: f64 },
    /// What a mesh encloses.
    Solid(HollowSolid),
    /// Nothing, between the two sides of a seam.
    Seam(Arc<Seam>),
}

/// A mesh that encloses a hollow, sorted so that it can be asked what crosses it.
#[derive(Clone, Debug)]
pub(crate) struct HollowSolid {
    solid: Arc<Solid>,
    bvh: Bvh,
}

impl HollowSolid {
    /// The inside of a solid.
    pub(crate) fn new(solid: Arc<Solid>) -> Self {
        let bvh = Bvh::new(&solid.surface.points, &solid.surface.faces);
        Self { solid, bvh }
    }

    fn crosses(&self, [a, b]: [DVec3; 2]) -> bool {
        let (min, max) = (a.min(b), a.max(b));
        let surface = &self.solid.surface;
        let mut crosses = false;
        let enter = |node: &Node| node.min.cmple(max).all() && min.cmple(node.max).all();
        self.bvh.visit(enter, |face| {
            crosses |= passes([a, b], surface.faces[face as usize].map(|i| surface.points[i as usize]));
        });
        crosses
    }
}

impl Hollow {
    /// Whether a point [m] lies inside.
    pub(crate) fn contains(&self, at: DVec3) -> bool {
        match self {
            Self::Solid(of) => of.solid.contains(at),
            _ => self.distance(at) < 0.0,
        }
    }

    /// Distance [m] from the wall of all but a mesh's, negative inside.
    fn distance(&self, at: DVec3) -> f64 {
        match self {
            Self::Ball { center, radius } => at.distance(*center) - radius,
            Self::Box(shape) => {
                let out = (at - shape.center).abs() - 0.5 * shape.size;
                out.max(DVec3::ZERO).length() + out.max_element().min(0.0)
            }
            Self::Tube { line, radius } => {
                let near = |ends: &[DVec3]| {
                    let [a, b] = closest_on_segment(at, [ends[0], ends[1]]);
                    at.distance(a * ends[0] + b * ends[1])
                };
                line.windows(2).map(near).fold(f64::INFINITY, f64::min) - radius
            }
            Self::Solid(_) | Self::Seam(_) => f64::INFINITY,
        }
    }

    /// Whether a segment passes through it, or ends in it. What only grazes the wall, by less than `slack` [m], does
    /// not.
    pub(crate) fn crosses(&self, [a, b]: [DVec3; 2], slack: f64) -> bool {
        match self {
            Self::Ball { center, radius } => {
                let [s, t] = closest_on_segment(*center, [a, b]);
                center.distance(s * a + t * b) < radius - slack
            }
            Self::Box(shape) => {
                let half = 0.5 * shape.size - slack.min(0.25 * shape.size.min_element());
                within_slabs([a - shape.center, b - shape.center], half)
            }
            Self::Tube { line, radius } => {
                line.windows(2).any(|ends| closest_segments([a, b], [ends[0], ends[1]]) < radius - slack)
            }
            Self::Solid(of) => {
                // A point on the wall starts beside it.
                let way = (b - a).normalize_or_zero() * slack.min(0.25 * a.distance(b));
                of.crosses([a + way, b - way])
            }
            Self::Seam(seam) => seam.crossing([a, b]).is_some(),
        }
    }

    /// Least and greatest corner [m].
    pub(crate) fn bounds(&self) -> [DVec3; 2] {
        match self {
            Self::Ball { center, radius } => [*center - *radius, *center + *radius],
            Self::Box(shape) => [shape.center - 0.5 * shape.size, shape.center + 0.5 * shape.size],
            Self::Tube { line, radius } => {
                let around = |[min, max]: [DVec3; 2], &x: &DVec3| [min.min(x - *radius), max.max(x + *radius)];
                line.iter().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], around)
            }
            Self::Solid(of) => [of.solid.min, of.solid.max],
            Self::Seam(seam) => seam.bounds(),
        }
    }

    /// Its wall, turned outwards, in triangles with edges of about `edge` [m]; a mesh's as it is, and none of a seam.
    pub(crate) fn wall(&self, edge: f64) -> TriangleMesh {
        match self {
            Self::Ball { center, radius } => {
                // An octahedron's edge is the root of two of its radius, and halves with every cut.
                let cuts = (2.0_f64.sqrt() * radius / edge).log2().ceil().clamp(2.0, 7.0);
                let mut wall = sphere(cuts as u32);
                wall.positions.iter_mut().for_each(|x| *x = *center + *radius * *x);
                wall
            }
            Self::Box(shape) => box_surface(shape, edge),
            Self::Tube { radius, .. } => {
                let cell = edge.min(0.4 * radius);
                let [min, max] = self.bounds();
                let wall = isosurface(&|at| self.distance(at), min - 2.0 * cell, max + 2.0 * cell, cell);
                TriangleMesh { positions: wall.positions, triangles: wall.triangles }
            }
            Self::Solid(of) => {
                TriangleMesh { positions: of.solid.surface.points.clone(), triangles: of.solid.surface.faces.clone() }
            }
            Self::Seam(_) => TriangleMesh::default(),
        }
    }
}

/// Whether a segment passes through a box of this half extent about the origin.
fn within_slabs([a, b]: [DVec3; 2], half: DVec3) -> bool {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for axis in 0..3 {
        let (start, way) = (a[axis], b[axis] - a[axis]);
        if way == 0.0 {
            if start.abs() >= half[axis] {
                return false;
            }
            continue;
        }
        let (one, other) = ((-half[axis] - start) / way, (half[axis] - start) / way);
        from = from.max(one.min(other));
        to = to.min(one.max(other));
    }
    from < to
}

/// The hollows of a body.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hollows {
    shapes: Vec<(Hollow, [DVec3; 2])>,
    /// By how much of a wall that segments only graze counts as nothing [m].
    slack: f64,
}

/// The same as a share of the spacing.
const GRAZE: f64 = 0.02;

impl Hollows {
    /// These hollows in a body of this spacing [m].
    pub(crate) fn new(shapes: Vec<Hollow>, spacing: f64) -> Self {
        let shapes = shapes.into_iter().map(|shape| (shape.bounds(), shape)).map(|(bounds, shape)| (shape, bounds));
        Self { shapes: shapes.collect(), slack: GRAZE * spacing }
    }

    /// These and seams.
    pub(crate) fn with_seams(&self, seams: &[Arc<Seam>]) -> Self {
        let seams = seams.iter().map(|seam| (Hollow::Seam(Arc::clone(seam)), seam.bounds()));
        Self { shapes: self.shapes.iter().cloned().chain(seams).collect(), slack: self.slack }
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.shapes.is_empty()
    }

    /// Each of them.
    pub(crate) fn shapes(&self) -> impl Iterator<Item = &Hollow> {
        self.shapes.iter().map(|(shape, _)| shape)
    }

    /// Whether a point [m] lies in any.
    pub(crate) fn contain(&self, at: DVec3) -> bool {
        self.shapes.iter().any(|(shape, [min, max])| min.cmple(at).all() && at.cmple(*max).all() && shape.contains(at))
    }

    /// Whether any lies between two points [m].
    pub(crate) fn separate(&self, a: DVec3, b: DVec3) -> bool {
        let (low, high) = (a.min(b), a.max(b));
        self.shapes.iter().any(|(shape, [min, max])| {
            min.cmple(high).all() && low.cmple(*max).all() && shape.crosses([a, b], self.slack)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::model::{MeshData, Model};

    fn shapes() -> [Hollow; 4] {
        let cube = Cuboid { center: DVec3::ZERO, size: DVec3::splat(2.0) };
        let mesh = box_surface(&cube, 0.5);
        let mut model = Model::default();
        model.add(MeshData { positions: mesh.positions, triangles: mesh.triangles, ..MeshData::default() });
        let solid = Arc::new(Solid::new(&model).expect("a cube"));
        [
            Hollow::Ball { center: DVec3::ZERO, radius: 1.0 },
            Hollow::Box(cube),
            Hollow::Tube { line: vec![DVec3::NEG_X, DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)], radius: 0.4 },
            Hollow::Solid(HollowSolid::new(solid)),
        ]
    }

    #[test]
    fn a_segment_crosses_where_its_points_lie_inside() {
        let mut state = 7_u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            3.2 * (f64::from(state >> 8) / f64::from(1 << 24) - 0.5)
        };
        for shape in shapes() {
            let (mut crossing, mut free) = (0, 0);
            for _ in 0..400 {
                let [a, b] = [0, 1].map(|_| DVec3::new(random(), random(), random()));
                if shape.contains(a) || shape.contains(b) {
                    continue;
                }
                let inside = (1..400).filter(|&k| shape.contains(a.lerp(b, f64::from(k) / 400.0))).count();
                let crosses = shape.crosses([a, b], 0.0);
                // What one sample or two would show is grazing.
                assert!(crosses == (inside > 0) || inside <= 2, "{shape:?}: {a} to {b}, {inside} samples inside");
                if crosses { crossing += 1 } else { free += 1 }
            }
            assert!(crossing > 10 && free > 10, "{crossing}, {free}");
        }
    }

    #[test]
    fn walls_enclose_what_is_inside() {
        for shape in shapes() {
            let wall = shape.wall(0.05);
            let [min, max] = shape.bounds();
            let count = 40;
            let at = |k: i32, axis: usize| min[axis] + (max - min)[axis] * (f64::from(k) + 0.5) / f64::from(count);
            let mut inside = 0;
            for k in 0..count * count * count {
                let at = DVec3::new(at(k % count, 0), at(k / count % count, 1), at(k / (count * count), 2));
                inside += i32::from(shape.contains(at));
            }
            let volume = f64::from(inside) / f64::from(count.pow(3)) * (max - min).element_product();
            assert!((wall.volume() / volume - 1.0).abs() < 0.02, "{} and {volume}", wall.volume());
        }
    }
}
