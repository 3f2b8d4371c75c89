//! How near the triangles of a leaf can be, by the slab that holds them: far tighter than its box where the surface
//! runs aslant, so that of thousands that are about as near to a point as the nearest hardly any is looked at.

use super::bvh::Bvh;
use glam::DVec3;

/// Slabs of the leaves of a tree of triangles.
#[derive(Clone, Debug)]
pub(crate) struct Slabs(Vec<Slab>);

/// What lies between two planes.
#[derive(Clone, Copy, Debug)]
struct Slab {
    normal: DVec3,
    /// Where the planes are along the normal [m].
    from: f64,
    to: f64,
}

/// Round-off, as a share of the numbers that are subtracted.
const ROUND_OFF: f64 = 1e-13;

impl Slabs {
    /// Those of a tree over these triangles.
    pub(crate) fn new(points: &[DVec3], faces: &[[u32; 3]], bvh: &Bvh) -> Self {
        let slab = |node: usize| {
            let corners = || bvh.triangles(node).iter().map(|&face| faces[face as usize].map(|i| points[i as usize]));
            let area: DVec3 = corners().map(|[a, b, c]| (b - a).cross(c - a)).sum();
            let normal = area.normalize_or_zero();
            let along = || corners().flatten().map(|corner| normal.dot(corner));
            let within = ROUND_OFF * corners().flatten().map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
            let [from, to] = [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)];
            Slab { normal, from: from - within, to: to + within }
        };
        let none = Slab { normal: DVec3::ZERO, from: 0.0, to: 0.0 };
        let slabs = bvh.nodes().iter().enumerate().map(|(k, node)| if node.is_leaf() { slab(k) } else { none });
        Self(slabs.collect())
    }

    /// Distance from a point to the slab of a leaf [m], no greater than that to its triangles; zero within.
    pub(crate) fn distance(&self, leaf: usize, x: DVec3) -> f64 {
        let Slab { normal, from, to } = self.0[leaf];
        let along = normal.dot(x);
        (from - along).max(along - to).max(0.0) - ROUND_OFF * x.abs().max_element()
    }
}
