//! Scanlines, straight rows along x through a closed surface: where they run inside it.
//!
//! A row along x crosses the surface where, seen along x, it falls into a triangle. Whether it does is decided edge by
//! edge by a test that gives both faces of an edge the same answer and never calls a tie: the row is thought to lie
//! beside the edge by an infinitely small distance. So every row crosses a closed surface as often inwards as outwards,
//! even along its edges and through its corners.

use super::bvh::Bvh;
use super::winding::Winding;
use glam::DVec3;

/// Places where the row through (y, z) along x passes through faces, in order, each with +1 where it enters and -1
/// where it leaves. Points are those of an oriented surface, sorted as [`super::weld::Welded`] sorts them.
fn crossings(points: &[DVec3], faces: &[[u32; 3]], bvh: &Bvh, y: f64, z: f64) -> Vec<(f64, i32)> {
    let mut found = Vec::new();
    bvh.visit(
        |node| node.min.y <= y && y <= node.max.y && node.min.z <= z && z <= node.max.z,
        |face| found.extend(crossing(points, faces[face as usize], y, z)),
    );
    // Entries before exits at the same place, so that faces which touch leave no gap.
    found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    found
}

/// The stretches of the row through (y, z) along x that lie inside a closed surface, in order: where it turns around
/// the row at least once.
pub(crate) fn inside_stretches(points: &[DVec3], faces: &[[u32; 3]], bvh: &Bvh, y: f64, z: f64) -> Vec<[f64; 2]> {
    let mut stretches: Vec<[f64; 2]> = Vec::new();
    let mut depth = 0;
    for (x, step) in crossings(points, faces, bvh, y, z) {
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

/// A scanline through a surface with holes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct OpenScanline {
    /// Stretches where the winding number is above one half, in order [m].
    pub inside: Vec<[f64; 2]>,
    /// Length where it is within a quarter of one half [m]: there the surface does not say clearly.
    pub doubtful: f64,
}

impl OpenScanline {
    /// Adds a stretch behind the others, or to the last where they touch: no place is inside twice.
    fn fill(&mut self, [from, to]: [f64; 2]) {
        match self.inside.last_mut() {
            Some(last) if last[1] >= from => last[1] = to,
            _ => self.inside.push([from, to]),
        }
    }
}

/// Halvings that find where a winding number passes one half.
const HALVINGS: usize = 24;

/// Winding numbers this close to one half are doubtful.
const DOUBT: f64 = 0.25;

/// The row through (y, z) along x, from `from` to `to` [m], through a surface with holes.
///
/// Between two faces the winding number changes smoothly. It is looked at thrice there and, where the way is long,
/// every `step` [m]; where it passes one half the place is found by halving.
pub(crate) fn open_scanline(
    (points, faces, bvh): (&[DVec3], &[[u32; 3]], &Bvh),
    winding: &Winding<'_>,
    [from, to]: [f64; 2],
    step: f64,
    [y, z]: [f64; 2],
) -> OpenScanline {
    let mut places = vec![from];
    places.extend(crossings(points, faces, bvh, y, z).into_iter().map(|(x, _)| x.clamp(from, to)));
    places.push(to);
    let at = |x: f64| winding.at(DVec3::new(x, y, z));
    let mut row = OpenScanline::default();
    for ends in places.windows(2) {
        let length = ends[1] - ends[0];
        if length <= 0.0 {
            continue;
        }
        let count = 3.0_f64.max((length / step).ceil());
        let samples: Vec<(f64, f64)> =
            (0..count as usize).map(|k| ends[0] + length * (k as f64 + 0.5) / count).map(|x| (x, at(x))).collect();
        row.doubtful += samples.iter().filter(|(_, w)| (w - 0.5).abs() < DOUBT).count() as f64 * length / count;
        let mut begin = (samples[0].1 > 0.5).then_some(ends[0]);
        for pair in samples.windows(2) {
            let [(mut low, before), (mut high, after)] = [pair[0], pair[1]];
            if (before > 0.5) == (after > 0.5) {
                continue;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if (at(middle) > 0.5) == (before > 0.5) { low = middle } else { high = middle }
            }
            match begin.take() {
                Some(start) => row.fill([start, low]),
                None => begin = Some(high),
            }
        }
        if let Some(start) = begin {
            row.fill([start, ends[1]]);
        }
    }
    row
}

/// Where a row enters (+1) or leaves (-1) through a face.
fn crossing(points: &[DVec3], face: [u32; 3], y: f64, z: f64) -> Option<(f64, i32)> {
    let sides = [0, 1, 2].map(|k| left_of(points, face[k], face[(k + 1) % 3], y, z));
    if sides[0] != sides[1] || sides[1] != sides[2] {
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
    Some((x, if sides[0] { -1 } else { 1 }))
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
        let bvh = Bvh::new(&mesh.positions, &mesh.triangles);
        let mut inside = 0;
        for k in 0..=8 {
            for l in 0..=8 {
                let (y, z) = (f64::from(k) / 8.0, f64::from(l) / 8.0);
                let found = inside_stretches(&mesh.positions, &mesh.triangles, &bvh, y, z);
                assert!(found.is_empty() || found == [[0.0, 1.0]], "{y} {z}: {found:?}");
                inside += found.len();
            }
        }
        // Rows on the hull are in on one side of the box and out on the other.
        assert_eq!(inside, 64);
    }
}
