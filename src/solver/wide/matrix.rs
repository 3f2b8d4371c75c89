//! Matrices of several particles.

use super::lanes::Wide;
use super::quaternion::Quatx;
use super::vector::Vec3x;
use glam::DMat3;
use std::ops::{Add, Index, Mul, Sub};

/// A matrix of each particle, by columns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mat3x<V>(pub [Vec3x<V>; 3]);

impl<V: Wide> Mat3x<V> {
    /// The same matrix for all particles.
    #[inline(always)]
    pub(crate) fn splat(simd: V::Set, m: &DMat3) -> Self {
        let columns = m.to_cols_array_2d();
        let mut matrix = Self([Vec3x::splat(V::constant(simd, 0.0)); 3]);
        for c in 0..3 {
            for r in 0..3 {
                matrix.0[c][r] = V::constant(simd, columns[c][r]);
            }
        }
        matrix
    }

    /// The rotation matrices of unit quaternions.
    #[inline(always)]
    pub(crate) fn from_quat(q: Quatx<V>) -> Self {
        let mut rotation = Self::from_quat_beyond_identity(q);
        let one = V::constant(q.0[0].token(), 1.0);
        for k in 0..3 {
            rotation.0[k][k] = one + rotation.0[k][k];
        }
        rotation
    }

    /// The rotation matrices of unit quaternions less the identity: exact to the numbers' own size for small turns.
    #[inline(always)]
    pub(crate) fn from_quat_beyond_identity(Quatx([x, y, z, w]): Quatx<V>) -> Self {
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (xx, xy, xz) = (x * x2, x * y2, x * z2);
        let (yy, yz, zz) = (y * y2, y * z2, z * z2);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        Self([
            Vec3x([-(yy + zz), xy + wz, xz - wy]),
            Vec3x([xy - wz, -(xx + zz), yz + wx]),
            Vec3x([xz + wy, yz - wx, -(xx + yy)]),
        ])
    }

    /// The symmetric matrix of the entries 00, 01, 02, 11, 12, 22.
    #[inline(always)]
    pub(crate) fn symmetric([m00, m01, m02, m11, m12, m22]: [V; 6]) -> Self {
        Self([Vec3x([m00, m01, m02]), Vec3x([m01, m11, m12]), Vec3x([m02, m12, m22])])
    }

    /// `a (x) b`, the matrix with entries `a_r b_c`.
    #[inline(always)]
    pub(crate) fn outer(a: Vec3x<V>, b: Vec3x<V>) -> Self {
        Self([a * b[0], a * b[1], a * b[2]])
    }

    /// `aᵀ`.
    #[inline(always)]
    pub(crate) fn transpose(self) -> Self {
        let Self([a, b, c]) = self;
        Self([Vec3x([a[0], b[0], c[0]]), Vec3x([a[1], b[1], c[1]]), Vec3x([a[2], b[2], c[2]])])
    }

    /// `aᵀ b`.
    #[inline(always)]
    pub(crate) fn transpose_mul(self, b: Self) -> Self {
        let Self(a) = self;
        let mut out = b;
        for c in 0..3 {
            out.0[c] = Vec3x([a[0].dot(b.0[c]), a[1].dot(b.0[c]), a[2].dot(b.0[c])]);
        }
        out
    }

    /// `a : b`, the sum of all products of entries, which is tr(aᵀ b).
    #[inline(always)]
    pub(crate) fn double_dot(self, Self(b): Self) -> V {
        let Self(a) = self;
        a[0].dot(b[0]) + a[1].dot(b[1]) + a[2].dot(b[2])
    }

    /// `s a + b`, rounded once where the machine can.
    #[inline(always)]
    pub(crate) fn mul_add(mut self, s: V, b: Self) -> Self {
        for c in 0..3 {
            self.0[c] = self.0[c].mul_add(s, b.0[c]);
        }
        self
    }
}

impl<V> Index<usize> for Mat3x<V> {
    type Output = Vec3x<V>;

    #[inline(always)]
    fn index(&self, column: usize) -> &Vec3x<V> {
        &self.0[column]
    }
}

impl<V: Wide> Add for Mat3x<V> {
    type Output = Self;

    #[inline(always)]
    fn add(mut self, other: Self) -> Self {
        for c in 0..3 {
            self.0[c] += other.0[c];
        }
        self
    }
}

impl<V: Wide> Sub for Mat3x<V> {
    type Output = Self;

    #[inline(always)]
    fn sub(mut self, other: Self) -> Self {
        for c in 0..3 {
            self.0[c] = self.0[c] - other.0[c];
        }
        self
    }
}

/// `s m`.
impl<V: Wide> Mul<V> for Mat3x<V> {
    type Output = Self;

    #[inline(always)]
    fn mul(mut self, s: V) -> Self {
        for c in 0..3 {
            self.0[c] = self.0[c] * s;
        }
        self
    }
}

/// `m v`.
impl<V: Wide> Mul<Vec3x<V>> for Mat3x<V> {
    type Output = Vec3x<V>;

    #[inline(always)]
    fn mul(self, v: Vec3x<V>) -> Vec3x<V> {
        let Self(m) = self;
        let mut out = v;
        for r in 0..3 {
            out[r] = m[2][r].mul_add(v[2], m[1][r].mul_add(v[1], m[0][r] * v[0]));
        }
        out
    }
}

/// `a b`.
impl<V: Wide> Mul for Mat3x<V> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, Self(b): Self) -> Self {
        Self([self * b[0], self * b[1], self * b[2]])
    }
}
