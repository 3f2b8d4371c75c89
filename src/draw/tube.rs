//! Fibres as round tubes.

use super::Vertex;
use glam::{Quat, Vec3};
use std::f32::consts::{FRAC_PI_2, TAU};

/// Vertices round a tube: enough for its outline to be round at the widths at which fibres are drawn.
const SIDES: u32 = 14;
/// Rings of each rounded end.
const CAP_RINGS: u32 = 4;
/// Points of the smooth curve between two vertices of the fibre.
const PIECES: u32 = 4;

/// A tube.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Tube {
    /// Its vertices.
    pub vertices: Vec<Vertex>,
    /// Three a triangle.
    pub indices: Vec<u32>,
    /// Where along the points each vertex is: 1.5 is half way from the second to the third.
    pub along: Vec<f32>,
}

/// A point of the curve and where along the points it is.
type CurvePoint = (Vec3, f32);

/// A tube of `radius` [m] with rounded ends along a smooth curve through the points. Nothing for fewer than two points
/// that differ.
pub(super) fn tube(points: &[Vec3], radius: f32) -> Tube {
    let (centres, places): (Vec<Vec3>, Vec<f32>) = without_ends(smooth(points), radius).into_iter().unzip();
    if centres.len() < 2 {
        return Tube::default();
    }
    let mut rings: Vec<(usize, Vec3, Vec3, Vec3, f32, f32)> = Vec::new();
    let last = centres.len() - 1;
    let tangent_at = |k: usize| (centres[(k + 1).min(last)] - centres[k.saturating_sub(1)]).normalize_or(Vec3::Y);
    // A frame carried along by the least turn does not twist.
    let mut side = tangent_at(0).any_orthonormal_vector();
    let mut before = tangent_at(0);
    for k in 0..=last {
        let tangent = tangent_at(k);
        side = Quat::from_rotation_arc(before, tangent) * side;
        side = side.reject_from(tangent).normalize_or(tangent.any_orthonormal_vector());
        before = tangent;
        let cap = |end: f32| {
            (0..CAP_RINGS).map(move |ring| end * FRAC_PI_2 * (1.0 - ring as f32 / CAP_RINGS as f32)).collect::<Vec<_>>()
        };
        let mut latitudes = vec![0.0];
        if k == 0 {
            latitudes = cap(-1.0).into_iter().chain(latitudes).collect();
        }
        if k == last {
            latitudes.extend(cap(1.0).into_iter().rev());
        }
        for latitude in latitudes {
            let (along, out) = (f32::sin(latitude), f32::cos(latitude));
            // The ends are round and yet no further out than the curve itself.
            let inset = tangent * radius * if k == 0 { 1.0 } else { -1.0 };
            let centre = if k == 0 || k == last { centres[k] + inset } else { centres[k] };
            rings.push((k, centre, tangent, side, along, out));
        }
    }
    let mut vertices = Vec::with_capacity(rings.len() * SIDES as usize);
    let mut where_along = Vec::with_capacity(vertices.capacity());
    for &(k, centre, tangent, side, along, out) in &rings {
        let other = tangent.cross(side);
        for side_of in 0..SIDES {
            let (sin, cos) = (TAU * side_of as f32 / SIDES as f32).sin_cos();
            let normal = (side * cos + other * sin) * out + tangent * along;
            vertices.push(Vertex { position: centre + normal * radius, normal });
            where_along.push(places[k]);
        }
    }
    Tube { vertices, indices: indices(rings.len() as u32), along: where_along }
}

/// The curve without what lies within `radius` of its ends, but for the ends themselves.
fn without_ends(curve: Vec<CurvePoint>, radius: f32) -> Vec<CurvePoint> {
    let (Some(&first), Some(&last)) = (curve.first(), curve.last()) else { return curve };
    let far = |point: Vec3| point.distance(first.0) > radius && point.distance(last.0) > radius;
    let inner = curve.into_iter().filter(|(point, _)| far(*point));
    std::iter::once(first).chain(inner).chain((first.0 != last.0).then_some(last)).collect()
}

fn indices(rings: u32) -> Vec<u32> {
    let mut indices = Vec::with_capacity(6 * ((rings - 1) * SIDES) as usize);
    for ring in 0..rings - 1 {
        for k in 0..SIDES {
            let (a, b) = (ring * SIDES + k, ring * SIDES + (k + 1) % SIDES);
            let (c, d) = (a + SIDES, b + SIDES);
            indices.extend([a, b, d, a, d, c]);
        }
    }
    indices
}

/// A Catmull-Rom curve through the points that differ from the one before.
fn smooth(points: &[Vec3]) -> Vec<CurvePoint> {
    let numbered = points.iter().enumerate().map(|(k, &point)| (point, k as f32));
    let mut points: Vec<CurvePoint> = numbered.filter(|(point, _)| point.is_finite()).collect();
    points.dedup_by(|a, b| a.0.distance_squared(b.0) == 0.0);
    if points.len() < 2 {
        return points;
    }
    let last = points.len() - 1;
    let mut curve = vec![points[0]];
    for k in 0..last {
        let [(p, from), (q, to)] = [points[k], points[k + 1]];
        let before = if k > 0 { points[k - 1].0 } else { 2.0 * p - q };
        let after = if k + 2 <= last { points[k + 2].0 } else { 2.0 * q - p };
        let (m, n) = (0.5 * (q - before), 0.5 * (after - p));
        for piece in 1..=PIECES {
            let t = piece as f32 / PIECES as f32;
            let (t2, t3) = (t * t, t * t * t);
            let at =
                p * (2.0 * t3 - 3.0 * t2 + 1.0) + m * (t3 - 2.0 * t2 + t) + q * (3.0 * t2 - 2.0 * t3) + n * (t3 - t2);
            curve.push((at, from + t * (to - from)));
        }
    }
    curve
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tube_is_closed_turned_outwards_and_has_the_volume_of_a_capsule() {
        let points = [0.0, 0.3, 0.7, 1.0].map(|y| Vec3::new(0.0, y, 0.0));
        let Tube { vertices, indices, along } = tube(&points, 0.05);
        let volume: f32 = indices
            .chunks(3)
            .map(|t| {
                let [a, b, c] = [t[0], t[1], t[2]].map(|k| vertices[k as usize].position);
                a.dot(b.cross(c)) / 6.0
            })
            .sum();
        let capsule = std::f32::consts::PI * 0.05_f32.powi(2) * (1.0 - 2.0 * 0.05 + 4.0 / 3.0 * 0.05);
        assert!((volume / capsule - 1.0).abs() < 0.06, "{volume} {capsule}");
        assert!(vertices.iter().all(|v| (v.normal.length() - 1.0).abs() < 1e-4));
        // Where a vertex is along the points goes with its height, but for the rounded ends.
        for (vertex, along) in vertices.iter().zip(&along) {
            let edge = (*along as usize).min(2);
            let height = points[edge].y + (along - edge as f32) * (points[edge + 1].y - points[edge].y);
            assert!((vertex.position.y - height).abs() < 0.051, "{} {along}", vertex.position);
        }
    }

    #[test]
    fn a_bent_tube_keeps_its_thickness_and_a_point_has_none() {
        let points: Vec<Vec3> =
            (0..12).map(|k| Vec3::new((k as f32 * 0.5).sin(), k as f32 * 0.2, (k as f32 * 0.5).cos())).collect();
        let centres: Vec<Vec3> = smooth(&points).into_iter().map(|(point, _)| point).collect();
        let Tube { vertices, .. } = tube(&points, 0.03);
        for vertex in &vertices {
            let from = |ends: &[Vec3]| {
                let step = ends[1] - ends[0];
                let share = (vertex.position - ends[0]).dot(step) / step.length_squared();
                vertex.position.distance(ends[0] + step * share.clamp(0.0, 1.0))
            };
            let distance = centres.windows(2).map(from).fold(f32::INFINITY, f32::min);
            // The rounded ends leave the curve a little, along its tangent.
            assert!(distance < 0.034, "{distance}");
        }
        assert!(tube(&[Vec3::ONE; 5], 0.1).indices.is_empty());
    }
}
