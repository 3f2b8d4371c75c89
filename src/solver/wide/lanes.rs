//! Registers and what they are loaded from.

use fearless_simd::{Simd, f64x4, f64x8, prelude::*};
use glam::{DQuat, DVec3};

/// Particles side by side in all but the sums of fibres.
pub(crate) const LANES: usize = 4;

/// A number of each of four particles, in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(32))]
pub(crate) struct Lanes4(pub [f64; LANES]);

/// A number of each of eight particles, in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub(crate) struct Lanes8(pub [f64; 8]);

impl Lanes4 {
    /// The same number for all four.
    pub(crate) fn splat(value: f64) -> Self {
        Self([value; LANES])
    }
}

/// A number of each of several particles, in a register.
pub(crate) trait Wide: SimdFloat<<Self as Wide>::Set, Element = f64> {
    /// The instruction set that the register belongs to.
    type Set: Simd;
    /// The same numbers in memory.
    type Memory: Copy + Default;

    fn load(simd: Self::Set, lanes: &Self::Memory) -> Self;

    fn store(self) -> Self::Memory;
}

impl<S: Simd> Wide for f64x4<S> {
    type Set = S;
    type Memory = Lanes4;

    #[inline(always)]
    fn load(simd: S, lanes: &Lanes4) -> Self {
        Self::simd_from(simd, lanes.0)
    }

    #[inline(always)]
    fn store(self) -> Lanes4 {
        Lanes4(self.into())
    }
}

impl<S: Simd> Wide for f64x8<S> {
    type Set = S;
    type Memory = Lanes8;

    #[inline(always)]
    fn load(simd: S, lanes: &Lanes8) -> Self {
        Self::simd_from(simd, lanes.0)
    }

    #[inline(always)]
    fn store(self) -> Lanes8 {
        Lanes8(self.into())
    }
}

/// Several numbers of the same particles.
#[inline(always)]
pub(crate) fn load_all<V: Wide, const N: usize>(simd: V::Set, lanes: &[V::Memory; N]) -> [V; N] {
    let mut values = [V::simd_from(simd, 0.0); N];
    for k in 0..N {
        values[k] = V::load(simd, &lanes[k]);
    }
    values
}

/// Several numbers of the same particles, back in memory.
#[inline(always)]
pub(super) fn store_all<V: Wide, const N: usize>(values: [V; N]) -> [V::Memory; N] {
    let mut lanes = [V::Memory::default(); N];
    for k in 0..N {
        lanes[k] = values[k].store();
    }
    lanes
}

/// The vector of one of four particles.
#[inline(always)]
pub(crate) fn vector_of(lanes: &[Lanes4; 3], lane: usize) -> DVec3 {
    DVec3::new(lanes[0].0[lane], lanes[1].0[lane], lanes[2].0[lane])
}

/// The quaternion of one of four particles.
#[inline(always)]
pub(crate) fn quaternion_of(lanes: &[Lanes4; 4], lane: usize) -> DQuat {
    DQuat::from_xyzw(lanes[0].0[lane], lanes[1].0[lane], lanes[2].0[lane], lanes[3].0[lane])
}
