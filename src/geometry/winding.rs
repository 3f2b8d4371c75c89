//! The generalised winding number: how often a surface turns around a point, holes and all.
//!
//! One inside a closed surface and nothing outside it; beside a hole it passes smoothly from one to the other, so that
//! one half is a sound place to draw the line (Jacobson et al. 2013). Far triangles are taken together by the first two
//! terms of their expansion (Barill et al. 2018), so that a query costs the logarithm of the number of triangles.

use super::bvh::Bvh;
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use std::f64::consts::PI;

/// Triangles with their far fields.
#[derive(Clone, Debug, Default)]
pub(crate) struct Winding {
    nodes: Vec<Far>,
    /// Corners of the triangles in the tree's order [m].
    corners: Vec<[DVec3; 3]>,
}

/// What a group of triangles looks like from afar. Groups stand in the order of the tree's nodes, parents before
/// children.
#[derive(Clone, Copy, Debug)]
struct Far {
    center: DVec3,
    /// Sum of the triangles' area vectors [m²].
    area: DVec3,
    /// Sum of `(c - center) (x) area` over the triangles' centres c [m³].
    moment: DMat3,
    /// Distance from the centre beyond which none of them reaches [m].
    radius: f64,
    /// The first group behind this one that is no part of it.
    next: u32,
    /// Triangles of a leaf: the first, and how many; none of another group.
    first: u32,
    count: u32,
}

/// A group counts as far from this many radii on: the error falls with the cube.
const FAR: f64 = 3.0;
const ROUGHLY_FAR: f64 = 2.0;

impl Winding {
    /// Far fields of the nodes of a tree over triangles.
    pub(crate) fn new(points: &[DVec3], faces: &[[u32; 3]], bvh: &Bvh) -> Self {
        let corners_of =
            |node: usize| bvh.triangles(node).iter().map(|&face| faces[face as usize].map(|i| points[i as usize]));
        let nodes = (0..bvh.nodes().len()).into_par_iter().map(|node| Far::new(&corners_of(node), bvh, node));
        Self { nodes: nodes.collect(), corners: if faces.is_empty() { Vec::new() } else { corners_of(0).collect() } }
    }

    /// How often the surface turns around a point; positive when its faces turn outwards.
    pub(crate) fn at(&self, point: DVec3) -> f64 {
        let mut near = 0.0;
        let far = self.walk(point, FAR, |triangles| {
            near += triangles.iter().map(|corners| solid_angle(corners.map(|p| p - point))).sum::<f64>();
        });
        (far + near) / (4.0 * PI)
    }

    /// [`Self::at`], several times as fast and off by some hundredths.
    pub(crate) fn about(&self, point: DVec3) -> f64 {
        let mut angle = Angle { re: 1.0, im: 0.0, turns: 0.0 };
        let far = self.walk(point, ROUGHLY_FAR, |triangles| {
            for corners in triangles {
                let [volume, below] = half_angle(corners.map(|p| p - point));
                angle.add(below, volume);
            }
            angle.normalize();
        });
        (far + 2.0 * angle.sum()) / (4.0 * PI)
    }

    /// Sum of the solid angles of groups that are so many radii away; `near` gets the triangles of the others.
    #[inline]
    fn walk(&self, point: DVec3, radii: f64, mut near: impl FnMut(&[[DVec3; 3]])) -> f64 {
        let (mut sum, mut index) = (0.0, 0);
        while let Some(Far { center, area, moment, radius, next, first, count }) = self.nodes.get(index) {
            let offset = *center - point;
            let squared = offset.length_squared();
            if squared > (radii * radius).powi(2) {
                let trace = moment.x_axis.x + moment.y_axis.y + moment.z_axis.z;
                let over = squared.recip();
                sum += (area.dot(offset) + trace - 3.0 * over * offset.dot(*moment * offset)) * over * over.sqrt();
                index = *next as usize;
            } else {
                if *count > 0 {
                    near(&self.corners[*first as usize..(first + count) as usize]);
                }
                index += 1;
            }
        }
        sum
    }
}

impl Far {
    /// The far field of a node's triangles. All are summed, at every level: a logarithm of additions a triangle, and no
    /// error that grows from level to level.
    fn new(triangles: &(impl Iterator<Item = [DVec3; 3]> + Clone), bvh: &Bvh, node: usize) -> Self {
        let triangles = triangles.clone().map(|[a, b, c]| (0.5 * (b - a).cross(c - a), (a + b + c) / 3.0));
        let (mut area, mut center, mut weight) = (DVec3::ZERO, DVec3::ZERO, 0.0);
        for (vector, middle) in triangles.clone() {
            let size = vector.length();
            area += vector;
            center += size * middle;
            weight += size;
        }
        let bounds = &bvh.nodes()[node];
        let center = if weight > 0.0 { center / weight } else { 0.5 * (bounds.min + bounds.max) };
        let mut moment = DMat3::ZERO;
        for (vector, middle) in triangles {
            let arm = middle - center;
            moment += DMat3::from_cols(arm * vector.x, arm * vector.y, arm * vector.z);
        }
        let radius = (center - bounds.min).max(bounds.max - center).length();
        let range = if bounds.is_leaf() { bounds.range() } else { 0..0 };
        let (first, count) = (range.start, range.end - range.start);
        Self { center, area, moment, radius, next: bounds.next() as u32, first, count }
    }
}

/// The sum of many angles by the product of as many complex numbers: one arc tangent for all of them.
struct Angle {
    re: f64,
    im: f64,
    turns: f64,
}

impl Angle {
    fn add(&mut self, re: f64, im: f64) {
        if re == 0.0 && im == 0.0 {
            return;
        }
        let (was_left, is_left) = (self.im > 0.0, im > 0.0);
        let (product, turned) = (self.re * re - self.im * im, self.re * im + self.im * re);
        // Two angles to the same side come out on the other one where their sum is more than half a turn.
        if was_left == is_left && (turned > 0.0) != is_left {
            self.turns += if is_left { 1.0 } else { -1.0 };
        }
        (self.re, self.im) = (product, turned);
    }

    /// Keeps the product of many from becoming too large or too small: to be called every few.
    fn normalize(&mut self) {
        let size = self.re.abs() + self.im.abs();
        (self.re, self.im) = if size > 0.0 { (self.re / size, self.im / size) } else { (1.0, 0.0) };
    }

    fn sum(&self) -> f64 {
        self.im.atan2(self.re) + 2.0 * PI * self.turns
    }
}

/// Signed solid angle of a triangle seen from the origin (Van Oosterom and Strackee 1983).
pub(crate) fn solid_angle(corners: [DVec3; 3]) -> f64 {
    let [volume, below] = half_angle(corners);
    2.0 * volume.atan2(below)
}

/// Opposite and adjacent side of half that angle.
fn half_angle([a, b, c]: [DVec3; 3]) -> [f64; 2] {
    let [la, lb, lc] = [a, b, c].map(DVec3::length);
    let volume = a.dot(b.cross(c));
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    [volume, below]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;

    #[test]
    fn angles_add_up_over_whole_turns() {
        let mut angle = Angle { re: 1.0, im: 0.0, turns: 0.0 };
        let mut expected = 0.0;
        for k in 0..500 {
            let part = 3.1 * (0.7 * f64::from(k)).sin() + if k < 250 { 0.03 } else { -0.02 };
            angle.add(part.cos(), part.sin());
            expected += part;
            assert!((angle.sum() - expected).abs() < 1e-9, "{k}: {} not {expected}", angle.sum());
        }
    }

    #[test]
    fn the_far_field_agrees_with_the_sum_of_all_angles() {
        let shape = Cuboid { center: DVec3::splat(0.2), size: DVec3::new(1.0, 2.0, 0.5) };
        let mut mesh = box_surface(&shape, 0.05);
        // Open on one side.
        mesh.triangles.retain(|t| t.iter().any(|&i| mesh.positions[i as usize].y < 1.19));
        let bvh = Bvh::new(&mesh.positions, &mesh.triangles);
        let winding = Winding::new(&mesh.positions, &mesh.triangles, &bvh);
        for k in 0..200 {
            let t = f64::from(k);
            let point = DVec3::new((t * 0.37).sin(), 1.5 * (t * 0.73).cos(), (t * 1.1).sin()) + 0.2;
            let exact: f64 =
                mesh.triangles.iter().map(|t| solid_angle(t.map(|i| mesh.positions[i as usize] - point))).sum::<f64>()
                    / (4.0 * PI);
            assert!((winding.at(point) - exact).abs() < 1e-2, "{point}: {} not {exact}", winding.at(point));
            assert!((winding.about(point) - exact).abs() < 5e-2, "{point}: {} not {exact}", winding.about(point));
        }
    }
}
