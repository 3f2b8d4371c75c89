//! Triangles that are swollen by a ball at every point, whose radius goes linearly from corner to corner: what balls of
//! different sizes around the corners sweep out.
//!
//! The surface of one is where `|x - p| - r(p)`, least over the points p of the triangle, is zero. Both terms are
//! convex in p: where the least one of the whole plane lies outside, it lies on an edge. In the plane, with the foot f
//! of x at a distance h and g the slope of r, it is at `f + g h / sqrt(1 - g²)`: x is seen under the slope's angle.

use super::closest::{closest_on_segment, closest_on_triangle, on_nearest_edge};
use glam::DVec3;

/// Slopes of the radius count as no steeper than this: one ball would hold the next.
const STEEPEST: f64 = 0.95;

/// Weights of the corners in the point p of a triangle at which `|x - p|` less the radius there is least.
pub(crate) fn nearest_on_swollen(x: DVec3, corners: [DVec3; 3], radii: [f64; 3]) -> [f64; 3] {
    let ([a, b, c], [ra, rb, rc]) = (corners, radii);
    if ra.to_bits() == rb.to_bits() && ra.to_bits() == rc.to_bits() {
        return closest_on_triangle(x, corners);
    }
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(ac);
    let square = normal.length_squared();
    if square > 0.0 {
        let slope = ((rb - ra) * ac.cross(normal) + (rc - ra) * normal.cross(ab)) / square;
        let height = (x - a).dot(normal).abs() / square.sqrt();
        let to = x - a + offset(slope, height);
        let v = to.cross(ac).dot(normal) / square;
        let w = ab.cross(to).dot(normal) / square;
        if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
            return [1.0 - v - w, v, w];
        }
    }
    let at = |[p, q]: [DVec3; 2], [rp, rq]: [f64; 2]| {
        let along = q - p;
        let square = along.length_squared();
        let [_, t] = if square > 0.0 {
            let height = (x - p).reject_from(along).length();
            closest_on_segment(x + offset((rq - rp) / square * along, height), [p, q])
        } else if rq > rp {
            [0.0, 1.0]
        } else {
            [1.0, 0.0]
        };
        let s = 1.0 - t;
        (x.distance(s * p + t * q) - (s * rp + t * rq), s, t)
    };
    on_nearest_edge([at([a, b], [ra, rb]), at([b, c], [rb, rc]), at([c, a], [rc, ra])])
}

/// How far beside the foot of what is `height` above it the least one lies, where the radius has this slope.
fn offset(slope: DVec3, height: f64) -> DVec3 {
    let slope = slope.clamp_length_max(STEEPEST);
    slope * (height / (1.0 - slope.length_squared()).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_point_of_the_triangle_is_nearer_to_its_ball() {
        let corners = [DVec3::new(0.1, 0.0, 0.3), DVec3::new(1.2, 0.4, -0.2), DVec3::new(-0.3, 1.1, 0.5)];
        for radii in [[0.3, 0.5, 0.2], [0.5, 0.5, 0.1], [0.2, 0.2, 0.2]] {
            let gap = |x: DVec3, w: [f64; 3]| {
                let p = w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
                x.distance(p) - (w[0] * radii[0] + w[1] * radii[1] + w[2] * radii[2])
            };
            for k in 0..200 {
                let k = f64::from(k);
                let x = 2.0 * DVec3::new((1.3 * k).sin(), (2.1 * k).cos(), (0.7 * k).sin());
                let weights = nearest_on_swollen(x, corners, radii);
                assert!(weights.iter().all(|w| (-1e-12..=1.0 + 1e-12).contains(w)));
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
                let least = gap(x, weights);
                for i in 0..=20 {
                    for j in 0..=20 - i {
                        let (v, w) = (f64::from(i) / 20.0, f64::from(j) / 20.0);
                        assert!(gap(x, [1.0 - v - w, v, w]) >= least - 1e-12, "{radii:?} at {x}");
                    }
                }
            }
        }
    }
}
