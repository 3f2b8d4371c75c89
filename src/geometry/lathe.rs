//! Closed surfaces of revolution about the Y axis.

use super::mesh::TriangleMesh;
use std::f64::consts::TAU;

/// Fewest and most corners of a circle.
const AROUND: (f64, f64) = (32.0, 160.0);

/// Corners of a circle of this radius so that they lie about `edge` apart [m]: a multiple of four.
pub(crate) fn corners_around(radius: f64, edge: f64) -> usize {
    let wanted = (TAU * radius / edge).clamp(AROUND.0, AROUND.1);
    4 * (0.25 * wanted).round() as usize
}

/// The surface that a profile leaves as it goes round the axis: points [distance from the axis, height] [m] from the
/// lowest end, which lies on the axis, to the highest, which does too.
pub(crate) fn spindle(profile: &[[f64; 2]], around: usize) -> TriangleMesh {
    let Some((low, high)) = profile.first().zip(profile.last()) else { return TriangleMesh::default() };
    let mut mesh = TriangleMesh::default();
    let inner = &profile[1..profile.len().max(2) - 1];
    rings(inner, around, &mut mesh);
    bands(inner.len(), around, false, &mut mesh);
    let [bottom, top] = [low, high].map(|end| {
        mesh.positions.push(glam::DVec3::new(0.0, end[1], 0.0));
        mesh.positions.len() as u32 - 1
    });
    let last = (inner.len().saturating_sub(1) * around) as u32;
    for k in 0..around as u32 {
        let next = (k + 1) % around as u32;
        mesh.triangles.push([bottom, k, next]);
        mesh.triangles.push([top, last + next, last + k]);
    }
    mesh
}

/// The surface that a closed profile leaves as it goes round the axis without touching it: points [distance from the
/// axis, height] [m], rising where they are outermost.
pub(crate) fn hoop(profile: &[[f64; 2]], around: usize) -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    rings(profile, around, &mut mesh);
    bands(profile.len(), around, true, &mut mesh);
    mesh
}

fn rings(profile: &[[f64; 2]], around: usize, mesh: &mut TriangleMesh) {
    for &[radius, height] in profile {
        for k in 0..around {
            let (sine, cosine) = (TAU * k as f64 / around as f64).sin_cos();
            mesh.positions.push(glam::DVec3::new(radius * cosine, height, radius * sine));
        }
    }
}

/// Faces between rings that follow each other, and between the last and the first of a hoop.
fn bands(count: usize, around: usize, closed: bool, mesh: &mut TriangleMesh) {
    let at = |ring: usize, k: usize| ((ring % count) * around + k % around) as u32;
    for ring in 0..(if closed { count } else { count.saturating_sub(1) }) {
        for k in 0..around {
            let [p, q, r, s] = [at(ring, k), at(ring + 1, k), at(ring + 1, k + 1), at(ring, k + 1)];
            mesh.triangles.extend([[p, q, r], [p, r, s]]);
        }
    }
}
