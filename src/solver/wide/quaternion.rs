//! Quaternions of several particles.

use super::lanes::{Wide, load_all, store_all};
use super::vector::Vec3x;

/// A quaternion of each particle: x, y, z, w.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quatx<V>(pub [V; 4]);

impl<V: Wide> Quatx<V> {
    /// The quaternions that stand in memory.
    #[inline(always)]
    pub(crate) fn load(simd: V::Set, lanes: &[V::Memory; 4]) -> Self {
        Self(load_all(simd, lanes))
    }

    /// The quaternions, to be kept in memory.
    #[inline(always)]
    pub(crate) fn store(self) -> [V::Memory; 4] {
        store_all(self.0)
    }

    /// `q (h, 1)`: turned further by about twice a small h, and longer by a factor `sqrt(1 + h²)`.
    #[inline(always)]
    pub(crate) fn turned_by(self, h: Vec3x<V>) -> Self {
        let Self([x, y, z, w]) = self;
        Self([
            z.mul_add(-h[1], y.mul_add(h[2], w.mul_add(h[0], x))),
            x.mul_add(-h[2], z.mul_add(h[0], w.mul_add(h[1], y))),
            y.mul_add(-h[0], x.mul_add(h[1], w.mul_add(h[2], z))),
            w - Vec3x([x, y, z]).dot(h),
        ])
    }

    /// The unit quaternions along these.
    #[inline(always)]
    pub(crate) fn normalize(self) -> Self {
        let Self([x, y, z, w]) = self;
        let vector = Vec3x([x, y, z]);
        let inverse = V::constant(x.token(), 1.0) / w.mul_add(w, vector.dot(vector)).sqrt();
        Self([x * inverse, y * inverse, z * inverse, w * inverse])
    }
}
