//! Vectors by components: a structure of arrays.

use glam::DVec3;

/// Many vectors, as their x, y and z.
pub(super) type SoaVectors = [Vec<f64>; 3];

/// So many zero vectors.
pub(super) fn zeros(count: usize) -> SoaVectors {
    [0, 1, 2].map(|_| vec![0.0; count])
}

/// Puts a vector into a place.
#[inline(always)]
pub(super) fn put([x, y, z]: &mut SoaVectors, place: usize, vector: DVec3) {
    (x[place], y[place], z[place]) = (vector.x, vector.y, vector.z);
}
