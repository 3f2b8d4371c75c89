//! Faces of more than three corners.

use glam::{DVec2, DVec3};

/// Cuts a polygon into triangles of its corners, by ears; convex or not, but flat more or less. Corners are given by
/// index, so are triangles. A polygon that crosses itself still comes out in one less triangle less than it has
/// corners.
pub(in crate::io) fn triangulate(corners: &[u32], positions: &[DVec3], triangles: &mut Vec<[u32; 3]>) {
    match *corners {
        [a, b, c] => triangles.push([a, b, c]),
        [_, _, _, _, ..] => match flatten(corners, positions) {
            Some(flat) => cut_ears(corners, &flat, triangles),
            // Indices without a position are left for the model to sort out.
            None => triangles.extend(corners[1..].windows(2).map(|pair| [corners[0], pair[0], pair[1]])),
        },
        _ => {}
    }
}

/// Corners in the plane that the polygon lies in most (Newell), counter-clockwise.
fn flatten(corners: &[u32], positions: &[DVec3]) -> Option<Vec<DVec2>> {
    let points: Vec<DVec3> = corners.iter().map(|&i| positions.get(i as usize).copied()).collect::<Option<_>>()?;
    let mut normal = DVec3::ZERO;
    for (k, p) in points.iter().enumerate() {
        normal += (*p - points[0]).cross(points[(k + 1) % points.len()] - points[0]);
    }
    let normal = normal.try_normalize()?;
    let (u, v) = normal.any_orthonormal_pair();
    Some(points.iter().map(|&p| DVec2::new((p - points[0]).dot(u), (p - points[0]).dot(v))).collect())
}

fn cut_ears(corners: &[u32], flat: &[DVec2], triangles: &mut Vec<[u32; 3]>) {
    let mut left: Vec<usize> = (0..corners.len()).collect();
    let mut at = 0;
    let mut tried = 0;
    while left.len() > 3 {
        let n = left.len();
        let [before, here, after] = [(at + n - 1) % n, at % n, (at + 1) % n].map(|k| left[k]);
        // With nothing but bad corners left any will do: the outline is kept, whatever lies inside.
        if tried > n || is_ear(flat, &left, [before, here, after]) {
            triangles.push([before, here, after].map(|k| corners[k]));
            left.remove(at % n);
            tried = 0;
        } else {
            tried += 1;
            at += 1;
        }
        at %= left.len();
    }
    triangles.push([left[0], left[1], left[2]].map(|k| corners[k]));
}

fn is_ear(flat: &[DVec2], left: &[usize], ear: [usize; 3]) -> bool {
    let [a, b, c] = ear.map(|k| flat[k]);
    let turn = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let inside = |p: DVec2| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
    turn(a, b, c) > 0.0 && !left.iter().any(|k| !ear.contains(k) && inside(flat[*k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(outline: &[[f64; 2]]) -> f64 {
        let positions: Vec<DVec3> = outline.iter().map(|p| DVec3::new(p[0], p[1], 0.5 * p[0])).collect();
        let corners: Vec<u32> = (0..outline.len() as u32).collect();
        let mut triangles = Vec::new();
        triangulate(&corners, &positions, &mut triangles);
        assert_eq!(triangles.len(), outline.len() - 2);
        let twice = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| DVec2::from_array(outline[i as usize]));
            (b - a).perp_dot(c - a)
        };
        assert!(triangles.iter().all(|t| twice(t) >= 0.0), "{triangles:?}");
        triangles.iter().map(|t| 0.5 * twice(t)).sum()
    }

    #[test]
    fn hollow_corners_stay_hollow() {
        assert_eq!(area(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]), 1.0);
        let arrow = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]];
        assert_eq!(area(&arrow), 1.5);
        let comb = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [3.0, 2.0], [3.0, 1.0], [2.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
        assert_eq!(area(&comb), 7.0);
    }
}
