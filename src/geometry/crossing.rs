//! Where a surface passes through itself.

use super::bvh::{Bvh, Node};
use super::progress::GoOn;
use glam::DVec3;
use rayon::prelude::*;
use std::ops::ControlFlow;

/// Pairs of faces that pass through each other.
///
/// Neighbours that only touch do not count, nor do faces that lie in one plane: what matters is whether the surface
/// has an inside, and touching leaves it one.
pub(crate) fn crossing_pairs(points: &[DVec3], faces: &[[u32; 3]], bvh: &Bvh) -> Vec<[u32; 2]> {
    match crossing_pairs_unless(points, faces, bvh, &mut || ControlFlow::Continue(())) {
        ControlFlow::Continue(pairs) => pairs,
        ControlFlow::Break(()) => unreachable!("nothing stops it"),
    }
}

/// [`crossing_pairs`]; `go_on` is asked from time to time.
pub(crate) fn crossing_pairs_unless(
    points: &[DVec3],
    faces: &[[u32; 3]],
    bvh: &Bvh,
    go_on: &mut GoOn<'_>,
) -> ControlFlow<(), Vec<[u32; 2]>> {
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
    let mut pairs = Vec::new();
    for leaves in near_leaves(points, faces, bvh).chunks(AT_ONCE) {
        go_on()?;
        pairs.par_extend(leaves.par_iter().flat_map_iter(of_leaves));
    }
    ControlFlow::Continue(pairs)
}

/// Pairs of leaves after which it is asked whether to go on.
const AT_ONCE: usize = 100_000;

/// Pairs of leaves whose faces may cross.
fn near_leaves(points: &[DVec3], faces: &[[u32; 3]], bvh: &Bvh) -> Vec<[u32; 2]> {
    let fans = fans(points, faces, bvh);
    let nodes = bvh.nodes();
    bvh.meeting_leaves(|m, n| {
        let overlap = |[min, max]: [DVec3; 2], of: &Node| min.cmple(of.max).all() && of.min.cmple(max).all();
        match (&fans[m], &fans[n]) {
            (Some(a), Some(b)) if a.apex == b.apex => overlap(a.rim, &nodes[n]) || overlap(b.rim, &nodes[m]),
            _ => nodes[m].overlaps(&nodes[n]),
        }
    })
}

/// Faces that all have a point in common. Two of them cross only where the edge of one that lies opposite of it passes
/// through the other: at the point itself all their boxes overlap, thousands of them in the cap of a cylinder.
#[derive(Clone, Copy, Debug)]
struct Fan {
    apex: u32,
    /// Box of the edges opposite of it [m].
    rim: [DVec3; 2],
}

/// Of every node whose faces are a fan, that.
fn fans(points: &[DVec3], faces: &[[u32; 3]], bvh: &Bvh) -> Vec<Option<Fan>> {
    // Of several points that faces have in common, that of most faces is the same for their neighbours.
    let mut faces_at = vec![0_u32; points.len()];
    faces.iter().flatten().for_each(|&corner| faces_at[corner as usize] += 1);
    let of_leaf = |triangles: &[u32]| {
        let corners = || triangles.iter().map(|&face| faces[face as usize]);
        let shared = corners().next()?.into_iter().filter(|corner| corners().all(|face| face.contains(corner)));
        let apex = shared.max_by_key(|&corner| (faces_at[corner as usize], corner))?;
        let others = corners().flatten().filter(|&corner| corner != apex).map(|corner| points[corner as usize]);
        let rim = others.map(|point| [point; 2]).reduce(joined)?;
        Some(Fan { apex, rim })
    };
    let mut fans = vec![None; bvh.nodes().len()];
    // Children stand behind their parents.
    for (index, node) in bvh.nodes().iter().enumerate().rev() {
        fans[index] = if node.is_leaf() {
            of_leaf(bvh.triangles(index))
        } else {
            match bvh.children(index).map(|child| fans[child]) {
                [Some(a), Some(b)] if a.apex == b.apex => Some(Fan { apex: a.apex, rim: joined(a.rim, b.rim) }),
                _ => None,
            }
        };
    }
    fans
}

fn joined(a: [DVec3; 2], b: [DVec3; 2]) -> [DVec3; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
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

    /// All pairs that cross, by looking at all.
    fn all_pairs(points: &[DVec3], faces: &[[u32; 3]]) -> usize {
        let pairs = (0..faces.len()).flat_map(|a| (a + 1..faces.len()).map(move |b| (a, b)));
        pairs.filter(|&(a, b)| crosses(points, faces[a], faces[b])).count()
    }

    /// Slivers around a point, flat or up to a ring above it, of which the others are `spread` as high.
    fn fan(count: u32, height: f64, spread: f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let at = |k: u32| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(count)).sin_cos();
            DVec3::new(cos, sin, if k.is_multiple_of(2) { height } else { height * spread })
        };
        let points = (0..count).map(at).chain([DVec3::ZERO]).collect();
        (points, (0..count).map(|k| [k, (k + 1) % count, count]).collect())
    }

    #[test]
    fn faces_around_a_point_are_not_looked_at_two_by_two() {
        for (height, spread) in [(0.0, 1.0), (0.5, 1.0), (0.5, -1.0)] {
            let (points, faces) = fan(4000, height, spread);
            let bvh = Bvh::new(&points, &faces);
            let pairs = near_leaves(&points, &faces, &bvh).len();
            assert!(pairs < 20 * faces.len(), "{pairs} pairs of leaves");
            assert_eq!(crossing_pairs(&points, &faces, &bvh).len(), 0);
        }
    }

    #[test]
    fn faces_around_a_point_that_cross_are_found() {
        // Every seventh face of a cone reaches across the others to a point inside of it, and a plate cuts through.
        let (mut points, mut faces) = fan(60, 1.0, 1.0);
        for k in (0..60).step_by(7) {
            points.push(DVec3::new(0.1, -0.2, 1.3) - 0.8 * points[k as usize]);
            faces.push([k, points.len() as u32 - 1, 60]);
        }
        let base = points.len() as u32;
        points.extend([DVec3::new(-1.0, -1.0, 0.41), DVec3::new(1.0, -0.9, 0.52), DVec3::new(0.1, 1.0, 0.63)]);
        faces.push([base, base + 1, base + 2]);
        let bvh = Bvh::new(&points, &faces);
        let found = crossing_pairs(&points, &faces, &bvh).len();
        assert_eq!(found, all_pairs(&points, &faces));
        assert!(found > 40, "{found}");
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
        assert!(found > 20);
        assert_eq!(found, all_pairs(&mesh.positions, &mesh.triangles));
    }
}
