//! Vectors of several particles.

use super::lanes::{Wide, load_all, store_all};
use std::ops::{Add, AddAssign, Index, IndexMut, Mul, Sub};

/// A vector of each particle: x, y, z.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vec3x<V>(pub [V; 3]);

impl<V: Wide> Vec3x<V> {
    /// The same register for all three components.
    #[inline(always)]
    pub(crate) fn splat(component: V) -> Self {
        Self([component; 3])
    }

    /// The vectors that stand in memory.
    #[inline(always)]
    pub(crate) fn load(simd: V::Set, lanes: &[V::Memory; 3]) -> Self {
        Self(load_all(simd, lanes))
    }

    /// The vectors, to be kept in memory.
    #[inline(always)]
    pub(crate) fn store(self) -> [V::Memory; 3] {
        store_all(self.0)
    }

    /// `a . b`.
    #[inline(always)]
    pub(crate) fn dot(self, Self(b): Self) -> V {
        let Self(a) = self;
        a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
    }

    /// `a x b`.
    #[inline(always)]
    pub(crate) fn cross(self, Self(b): Self) -> Self {
        let Self(a) = self;
        Self([a[1].mul_sub(b[2], a[2] * b[1]), a[2].mul_sub(b[0], a[0] * b[2]), a[0].mul_sub(b[1], a[1] * b[0])])
    }

    /// `s v + w`, rounded once where the machine can.
    #[inline(always)]
    pub(crate) fn mul_add(mut self, s: V, w: Self) -> Self {
        for k in 0..3 {
            self.0[k] = self.0[k].mul_add(s, w.0[k]);
        }
        self
    }
}

impl<V> Index<usize> for Vec3x<V> {
    type Output = V;

    #[inline(always)]
    fn index(&self, k: usize) -> &V {
        &self.0[k]
    }
}

impl<V> IndexMut<usize> for Vec3x<V> {
    #[inline(always)]
    fn index_mut(&mut self, k: usize) -> &mut V {
        &mut self.0[k]
    }
}

impl<V: Wide> Add for Vec3x<V> {
    type Output = Self;

    #[inline(always)]
    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl<V: Wide> AddAssign for Vec3x<V> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        for k in 0..3 {
            self.0[k] += other.0[k];
        }
    }
}

impl<V: Wide> Sub for Vec3x<V> {
    type Output = Self;

    #[inline(always)]
    fn sub(mut self, other: Self) -> Self {
        for k in 0..3 {
            self.0[k] -= other.0[k];
        }
        self
    }
}

/// `s v`.
impl<V: Wide> Mul<V> for Vec3x<V> {
    type Output = Self;

    #[inline(always)]
    fn mul(mut self, s: V) -> Self {
        for k in 0..3 {
            self.0[k] *= s;
        }
        self
    }
}
