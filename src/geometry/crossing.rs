//! Where a surface passes through itself.

use super::bvh::Bvh;
use glam::DVec3;
use rayon::prelude::*;

/// Pairs of faces that pass through each other.
///
/// Neighbours that only touch do not count, nor do faces that lie in one plane: what matters is whether the surface
/// has an inside, and touching leaves it one.
pub(crate) fn crossing_pairs(points: &[DVec3], faces: &[[u32; 3]], bvh: &Bvh) -> Vec<[u32; 2]> {
    // Most faces of leaves that meet do not: their boxes tell.
    let boxes: Vec<[DVec3; 2]> = faces
        .par_iter()
        .map(|face| face.map(|i| points[i as usize]))
        .map(|[a, b, c]| [a.min(b).min(c), a.max(b).max(c)])
        .collect();
    let meet = |a: u32, b: u32| {
        let ([least, most], [from, to]) = (boxes[a as usize], boxes[b as usize]);
        least.cmple(to).all() && from.cmple(most).all()
    };
    let of_leaves = |&[m, n]: &[u32; 2]| {
        let (left, right) = (bvh.triangles(m as usize), bvh.triangles(n as usize));
        let from = move |k: usize| if m == n { k + 1 } else { 0 };
        let pairs = left.iter().enumerate().flat_map(move |(k, &a)| right[from(k)..].iter().map(move |&b| [a, b]));
        pairs.filter(|&[a, b]| meet(a, b) && crosses(points, faces[a as usize], faces[b as usize]))
    };
    bvh.overlapping_leaves().par_iter().flat_map_iter(of_leaves).collect()
}

/// Whether an edge of one passes through the inside of the other. Edges that share a point with the other cannot.
fn crosses(points: &[DVec3], a: [u32; 3], b: [u32; 3]) -> bool {
    let shared = a.iter().filter(|i| b.contains(i)).count();
    if shared > 1 {
        return false;
    }
    let pierces = |edges: [u32; 3], face: [u32; 3]| {
        let corners = face.map(|i| points[i as usize]);
        (0..3).any(|k| {
            let ends = [edges[k], edges[(k + 1) % 3]];
            !ends.iter().any(|end| face.contains(end)) && passes(ends.map(|i| points[i as usize]), corners)
        })
    };
    pierces(a, b) || pierces(b, a)
}

/// Volumes below this share of the product of their edges' lengths are round-off: the points lie in one plane.
const FLAT: f64 = 1e-12;

/// Whether a segment passes through the inside of a triangle.
pub(crate) fn passes([p, q]: [DVec3; 2], [a, b, c]: [DVec3; 3]) -> bool {
    let normal = (b - a).cross(c - a);
    let [above, below] = [p, q].map(|end| normal.dot(end - a));
    let scale = FLAT * normal.length();
    if above * below >= 0.0 || above.abs() <= scale * (p - a).length() || below.abs() <= scale * (q - a).length() {
        return false;
    }
    let direction = q - p;
    let side = |u: DVec3, v: DVec3| {
        let (u, v) = (u - p, v - p);
        let volume = direction.dot(u.cross(v));
        if volume.abs() <= FLAT * direction.length() * u.length() * v.length() { 0.0 } else { volume.signum() }
    };
    let first = side(a, b);
    first != 0.0 && side(b, c) == first && side(c, a) == first
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::{TriangleMesh, box_surface};

    fn pairs(mesh: &TriangleMesh) -> usize {
        let bvh = Bvh::new(&mesh.positions, &mesh.triangles);
        crossing_pairs(&mesh.positions, &mesh.triangles, &bvh).len()
    }

    #[test]
    fn a_box_does_not_cross_itself_but_two_do() {
        let unit = Cuboid { center: DVec3::ZERO, size: DVec3::ONE };
        let mut mesh = box_surface(&unit, 0.25);
        assert_eq!(pairs(&mesh), 0);
        let other = box_surface(&Cuboid { center: DVec3::new(0.43, 0.37, 0.31), size: DVec3::ONE }, 0.25);
        let base = mesh.positions.len() as u32;
        mesh.positions.extend(other.positions);
        mesh.triangles.extend(other.triangles.iter().map(|t| t.map(|i| i + base)));
        let bvh = Bvh::new(&mesh.positions, &mesh.triangles);
        let found = crossing_pairs(&mesh.positions, &mesh.triangles, &bvh).len();
        let faces = &mesh.triangles;
        let all = (0..faces.len())
            .flat_map(|a| (a + 1..faces.len()).map(move |b| (a, b)))
            .filter(|&(a, b)| crosses(&mesh.positions, faces[a], faces[b]))
            .count();
        assert!(found > 20);
        assert_eq!(found, all);
    }
}
