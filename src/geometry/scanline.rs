//! Scanlines, straight rows along x through a closed surface: where they run inside it.
//!
//! A row along x crosses the surface where, seen along x, it falls into a triangle. Whether it does is decided edge by
//! edge by a test that gives both faces of an edge the same answer and never calls a tie: the row is thought to lie
//! beside the edge by an infinitely small distance. So every row crosses a closed surface as often inwards as outwards,
//! even along its edges and through its corners.

use super::row_index::RowIndex;
use glam::DVec3;

/// Calls `found` with every face that the row through (y, z) along x passes through, where, and +1 where it enters
/// there or -1 where it leaves; in no order.
pub(crate) fn visit_crossings(
    points: &[DVec3],
    faces: &[[u32; 3]],
    index: &RowIndex,
    [y, z]: [f64; 2],
    mut found: impl FnMut(u32, f64, i32),
) {
    index.visit([y, z], |face| {
        if let Some((x, step)) = crossing(points, faces[face as usize], y, z) {
            found(face, x, step);
        }
    });
}

/// Places where the row through (y, z) along x passes through faces, in order, each with +1 where it enters and -1
/// where it leaves. Points are those of an oriented surface, sorted as [`super::weld::Welded`] sorts them.
pub(crate) fn crossings(points: &[DVec3], faces: &[[u32; 3]], index: &RowIndex, row: [f64; 2]) -> Vec<(f64, i32)> {
    let mut found = Vec::new();
    visit_crossings(points, faces, index, row, |_, x, step| found.push((x, step)));
    in_order(found)
}

/// [`crossings`] of those faces whose spans in the index meet a part of the row along x [m].
pub(crate) fn crossings_within(
    points: &[DVec3],
    faces: &[[u32; 3]],
    index: &RowIndex,
    [y, z]: [f64; 2],
    part: [f64; 2],
) -> Vec<(f64, i32)> {
    let mut found = Vec::new();
    index.visit_within([y, z], part, |face| found.extend(crossing(points, faces[face as usize], y, z)));
    in_order(found)
}

/// Entries before exits at the same place, so that faces which touch leave no gap.
fn in_order(mut crossings: Vec<(f64, i32)>) -> Vec<(f64, i32)> {
    crossings.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    crossings
}

/// The stretches of a row with these crossings that lie inside a closed surface, in order: where it turns around the
/// row at least once.
pub(crate) fn inside_stretches(crossings: &[(f64, i32)]) -> Vec<[f64; 2]> {
    let mut stretches: Vec<[f64; 2]> = Vec::new();
    let mut depth = 0;
    for &(x, step) in crossings {
        if depth <= 0 && depth + step > 0 {
            stretches.push([x, x]);
        }
        if depth > 0
            && depth + step <= 0
            && let Some(last) = stretches.last_mut()
        {
            last[1] = x;
        }
        depth += step;
    }
    // Nothing is filled where the surface turns out not to be closed.
    stretches.retain(|[from, to]| from < to);
    stretches
}

/// What lies in either of two rows of stretches, in order.
pub(crate) fn joined(a: Vec<[f64; 2]>, b: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    if a.is_empty() || b.is_empty() {
        return if a.is_empty() { b } else { a };
    }
    let mut all = [a, b].concat();
    all.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut stretches: Vec<[f64; 2]> = Vec::with_capacity(all.len());
    for [from, to] in all {
        match stretches.last_mut() {
            Some(last) if last[1] >= from => last[1] = last[1].max(to),
            _ => stretches.push([from, to]),
        }
    }
    stretches
}

/// Where a row enters (+1) or leaves (-1) through a face.
fn crossing(points: &[DVec3], face: [u32; 3], y: f64, z: f64) -> Option<(f64, i32)> {
    let is_left = left_of(points, face[0], face[1], y, z);
    if left_of(points, face[1], face[2], y, z) != is_left || left_of(points, face[2], face[0], y, z) != is_left {
        return None;
    }
    let [a, b, c] = face.map(|i| points[i as usize]);
    // Areas seen along x, as weights of the corners.
    let cross = |p: DVec3, q: DVec3| (p.y - y) * (q.z - z) - (p.z - z) * (q.y - y);
    let weights = [cross(b, c), cross(c, a), cross(a, b)];
    let total: f64 = weights.iter().sum();
    let x = (weights[0] * a.x + weights[1] * b.x + weights[2] * c.x) / total;
    let x = if x.is_finite() { x.clamp(a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x)) } else { a.x };
    // Counter-clockwise seen from +x: the face looks that way, and the row leaves.
    Some((x, if is_left { -1 } else { 1 }))
}

/// Whether the row lies to the left of an edge, both seen from +x. Never undecided.
fn left_of(points: &[DVec3], from: u32, to: u32, y: f64, z: f64) -> bool {
    // Always computed from the lesser point to the greater, so that both faces of an edge see the same bits.
    let [p, q] = [from.min(to), from.max(to)].map(|i| points[i as usize]);
    let area = (q.y - p.y) * (z - p.z) - (q.z - p.z) * (y - p.y);
    // A tie is broken as if the row lay at (y + e, z + e²) with e infinitely small.
    let left = if area != 0.0 {
        area > 0.0
    } else if q.z != p.z {
        q.z < p.z
    } else {
        q.y > p.y
    };
    left == (from < to)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;

    #[test]
    fn rows_through_edges_and_corners_cross_a_box_twice_or_not_at_all() {
        let mesh = box_surface(&Cuboid { center: DVec3::splat(0.5), size: DVec3::ONE }, 0.25);
        let index = RowIndex::new(&mesh.positions, &mesh.triangles);
        let mut inside = 0;
        for k in 0..=8 {
            for l in 0..=8 {
                let (y, z) = (f64::from(k) / 8.0, f64::from(l) / 8.0);
                let found = inside_stretches(&crossings(&mesh.positions, &mesh.triangles, &index, [y, z]));
                assert!(found.is_empty() || found == [[0.0, 1.0]], "{y} {z}: {found:?}");
                inside += found.len();
            }
        }
        // Rows on the hull are in on one side of the box and out on the other.
        assert_eq!(inside, 64);
    }

    #[test]
    fn rows_of_stretches_are_joined() {
        assert_eq!(joined(vec![[0.0, 1.0], [4.0, 5.0]], vec![[0.5, 2.0], [5.0, 6.0]]), [[0.0, 2.0], [4.0, 6.0]]);
        assert_eq!(joined(Vec::new(), vec![[0.0, 1.0]]), [[0.0, 1.0]]);
    }
}
