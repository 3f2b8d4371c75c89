//! Seams: open surfaces through a body, along which it may come apart.
//!
//! What lies on which side of one is asked at the points of a lattice, and a surface that is drawn on the lattice has
//! many of them, and edges of triangles, right in it. So it is moved to the side of its normals by a share of the
//! spacing that nobody sees, and a segment through an edge counts for both triangles beside it: no segment slips
//! through.

use super::bvh::{Bvh, Node};
use glam::DVec3;

/// By how much it is moved to the side of its normals, as a share of the spacing.
const MOVED: f64 = 2e-3;

/// An open surface, sorted so that it can be asked what crosses it.
#[derive(Clone, Debug)]
pub(crate) struct Seam {
    points: Vec<DVec3>,
    normals: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    bvh: Bvh,
}

impl Seam {
    /// The surface of these points [m] and triangles through a body of this spacing [m].
    pub(crate) fn new(points: &[DVec3], triangles: &[[u32; 3]], spacing: f64) -> Self {
        let mut normals = vec![DVec3::ZERO; points.len()];
        for triangle in triangles {
            let [a, b, c] = triangle.map(|k| points[k as usize]);
            for k in triangle {
                normals[*k as usize] += (b - a).cross(c - a);
            }
        }
        for normal in &mut normals {
            *normal = normal.normalize_or(DVec3::Y);
        }
        let points: Vec<DVec3> =
            points.iter().zip(&normals).map(|(&at, &normal)| at + MOVED * spacing * normal).collect();
        let bvh = Bvh::new(&points, triangles);
        Self { points, normals, triangles: triangles.to_vec(), bvh }
    }

    /// Its points [m].
    pub(crate) fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// A unit normal a point.
    pub(crate) fn normals(&self) -> &[DVec3] {
        &self.normals
    }

    /// Three points a triangle.
    pub(crate) fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Least and greatest corner [m].
    pub(crate) fn bounds(&self) -> [DVec3; 2] {
        let around = |[min, max]: [DVec3; 2], &x: &DVec3| [min.min(x), max.max(x)];
        self.points.iter().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], around)
    }

    /// The share of the way from `a` to `b` [m] after which the segment first passes through it; none where it does
    /// not.
    pub(crate) fn crossing(&self, [a, b]: [DVec3; 2]) -> Option<f64> {
        let (min, max) = (a.min(b), a.max(b));
        let mut first: Option<f64> = None;
        let enter = |node: &Node| node.min.cmple(max).all() && min.cmple(node.max).all();
        self.bvh.visit(enter, |face| {
            let corners = self.triangles[face as usize].map(|k| self.points[k as usize]);
            if let Some(share) = through([a, b], corners) {
                first = Some(first.map_or(share, |first| first.min(share)));
            }
        });
        first
    }
}

/// The share of the way after which a segment passes through a triangle or its rim. An end in its plane counts as on
/// the side of its normal.
fn through([p, q]: [DVec3; 2], [a, b, c]: [DVec3; 3]) -> Option<f64> {
    let normal = (b - a).cross(c - a);
    let [from, to] = [p, q].map(|end| normal.dot(end - a));
    if (from < 0.0) == (to < 0.0) {
        return None;
    }
    let way = q - p;
    // Rounding may take a segment through an edge to be on either side of it, but not on the outer side for both.
    let slack = 1e-9 * way.length() * normal.length();
    let side = |u: DVec3, v: DVec3| way.dot((u - p).cross(v - p));
    let sides = [side(a, b), side(b, c), side(c, a)];
    let inside = sides.iter().all(|side| *side >= -slack) || sides.iter().all(|side| *side <= slack);
    inside.then(|| from / (from - to))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::surface_grid::grid_triangles;

    /// A square of this many steps of one spacing a side at y = 0, wavy by so much.
    fn square(steps: i32, waves: f64) -> Seam {
        let at = |k: i32| {
            let (x, z) = (f64::from(k % (steps + 1)), f64::from(k / (steps + 1)));
            DVec3::new(x, waves * (0.9 * x).sin() * (0.7 * z).cos(), z)
        };
        let points: Vec<DVec3> = (0..(steps + 1) * (steps + 1)).map(at).collect();
        let side = (steps + 1) as usize;
        Seam::new(&points, &grid_triangles(side, side), 1.0)
    }

    #[test]
    fn no_segment_of_a_lattice_slips_through_a_seam_drawn_on_it() {
        for waves in [0.0, 0.3] {
            let seam = square(8, waves);
            // Points right in it, on its edges and corners, among them: each is on one side, and those are told apart.
            let lattice: Vec<DVec3> =
                (0..7 * 5 * 7)
                    .map(|k| {
                        DVec3::new(f64::from(k % 7), f64::from(k / 7 % 5) - 2.0, f64::from(k / 35))
                            + DVec3::new(0.5, 0.0, 0.5)
                    })
                    .chain((0..7 * 5 * 7).map(|k| {
                        DVec3::new(1.0 + f64::from(k % 7), f64::from(k / 7 % 5) - 2.0, 1.0 + f64::from(k / 35))
                    }))
                    .filter(|at| waves == 0.0 || at.y.abs() > 0.5)
                    .collect();
            // Its normals look down: what lies right in it is above.
            let below = |at: &DVec3| at.y < 0.0;
            for a in &lattice {
                for b in lattice.iter().filter(|b| a.distance(**b) < 2.6) {
                    assert_eq!(seam.crossing([*a, *b]).is_some(), below(a) != below(b), "{a} to {b}");
                }
            }
        }
    }

    #[test]
    fn what_passes_beside_a_seam_does_not_cross_it() {
        let seam = square(4, 0.0);
        let share = seam.crossing([DVec3::new(1.3, -1.0, 1.7), DVec3::new(1.3, 3.0, 1.7)]).expect("it is in the way");
        assert!((share - 0.25).abs() < 0.001, "{share}");
        assert_eq!(seam.crossing([DVec3::new(4.1, -1.0, 1.7), DVec3::new(4.1, 3.0, 1.7)]), None);
        assert_eq!(seam.crossing([DVec3::new(1.3, 0.1, 1.7), DVec3::new(1.3, 3.0, 1.7)]), None);
    }
}
