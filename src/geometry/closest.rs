//! The nearest point of a segment and of a triangle, and the distance of two segments.

use glam::DVec3;

/// Weights of both ends in the point of a segment that is nearest to `x`.
pub(crate) fn closest_on_segment(x: DVec3, [a, b]: [DVec3; 2]) -> [f64; 2] {
    let ab = b - a;
    let square = ab.length_squared();
    let t = if square > 0.0 { ((x - a).dot(ab) / square).clamp(0.0, 1.0) } else { 0.0 };
    [1.0 - t, t]
}

/// Distance between two segments.
pub(crate) fn closest_segments([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> f64 {
    let (u, v, w) = (b - a, d - c, a - c);
    let (uu, uv, vv) = (u.length_squared(), u.dot(v), v.length_squared());
    let determinant = uu * vv - uv * uv;
    // Where both lines are nearest, as far as that lies on the first; then the nearest on the second, and back.
    let s = if determinant > 1e-12 * uu * vv {
        ((uv * v.dot(w) - vv * u.dot(w)) / determinant).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let on = |x: DVec3, ends: [DVec3; 2]| {
        let [s, t] = closest_on_segment(x, ends);
        s * ends[0] + t * ends[1]
    };
    let mut from = a + s * u;
    let mut to = on(from, [c, d]);
    for _ in 0..2 {
        from = on(to, [a, b]);
        to = on(from, [c, d]);
    }
    from.distance(to)
}

/// Weights of the corners in the point of a triangle that is nearest to `x`.
pub(crate) fn closest_on_triangle(x: DVec3, [a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(ac);
    let square = normal.length_squared();
    if square > 0.0 {
        // Inside its prism the foot of the perpendicular is nearest.
        let to = x - a;
        let v = to.cross(ac).dot(normal) / square;
        let w = ab.cross(to).dot(normal) / square;
        if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
            return [1.0 - v - w, v, w];
        }
    }
    let at = |[p, q]: [DVec3; 2]| {
        let [s, t] = closest_on_segment(x, [p, q]);
        (x.distance_squared(s * p + t * q), s, t)
    };
    on_nearest_edge([at([a, b]), at([b, c]), at([c, a])])
}

/// Weights of a triangle's corners a, b, c on the nearest of the edges ab, bc, ca, each given by how far it is and by
/// the weights of its ends; the first of equal ones.
pub(crate) fn on_nearest_edge([ab, bc, ca]: [(f64, f64, f64); 3]) -> [f64; 3] {
    if ab.0 <= bc.0 && ab.0 <= ca.0 {
        [ab.1, ab.2, 0.0]
    } else if bc.0 <= ca.0 {
        [0.0, bc.1, bc.2]
    } else {
        [ca.2, 0.0, ca.1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_point_of_a_triangle_is_nearer() {
        let corners = [DVec3::new(0.1, 0.0, 0.3), DVec3::new(1.2, 0.4, -0.2), DVec3::new(-0.3, 1.1, 0.5)];
        let at = |w: [f64; 3]| w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
        for k in 0..200 {
            let k = f64::from(k);
            let x = 2.0 * DVec3::new((1.3 * k).sin(), (2.1 * k).cos(), (0.7 * k).sin());
            let weights = closest_on_triangle(x, corners);
            assert!(weights.iter().all(|w| (-1e-12..=1.0 + 1e-12).contains(w)));
            assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            let least = x.distance(at(weights));
            for i in 0..=20 {
                for j in 0..=20 - i {
                    let (v, w) = (f64::from(i) / 20.0, f64::from(j) / 20.0);
                    assert!(x.distance(at([1.0 - v - w, v, w])) >= least - 1e-12);
                }
            }
        }
    }
}
