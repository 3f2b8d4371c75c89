//! Fields of one vector a particle as vectors of one large space.

use glam::DVec3;

/// `a . b`.
pub(crate) fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

/// Euclidean length.
pub(crate) fn norm(a: &[DVec3]) -> f64 {
    dot(a, a).sqrt()
}

/// `y += a x`.
pub(crate) fn axpy(a: f64, x: &[DVec3], y: &mut [DVec3]) {
    for (y, &x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}

/// `y /= a`.
pub(crate) fn divide(y: &mut [DVec3], a: f64) {
    for y in y {
        *y /= a;
    }
}

/// Scales a field to the length one.
pub(crate) fn normalise(y: &mut [DVec3]) {
    let length = norm(y);
    divide(y, length);
}
