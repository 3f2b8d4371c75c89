//! Registers and what they are loaded from.

use bytemuck::{Pod, Zeroable};
use fearless_simd::{Simd, f32x8, f64x4, f64x8, prelude::*};
use glam::{DQuat, DVec3};

/// Particles side by side where forces are exact, in all but the sums of fibres.
pub(crate) const LANES: usize = 4;

/// A number of each of several particles, side by side in memory.
pub(crate) trait Lanes: Pod + Default + Send + Sync {
    /// How many particles there are.
    const COUNT: usize;
    /// Whether numbers are too short for positions: they hold deviations along the axes of the body then.
    const SHORT: bool;
    /// The same numbers in a register.
    type Register<S: Simd>: Wide<Set = S, Memory = Self>;

    /// The same number for all.
    fn splat(value: f64) -> Self;

    /// The number of one particle.
    fn get(&self, lane: usize) -> f64;

    /// Changes the number of one particle.
    fn set(&mut self, lane: usize, value: f64);
}

/// A number of each of several particles, in a register.
pub(crate) trait Wide: SimdFloat<<Self as Wide>::Set> {
    /// The instruction set that the register belongs to.
    type Set: Simd;
    /// The same numbers in memory.
    type Memory: Lanes;

    /// The same number for all.
    fn constant(simd: Self::Set, value: f64) -> Self;

    fn load(simd: Self::Set, lanes: &Self::Memory) -> Self;

    fn store(self) -> Self::Memory;

    /// Consecutive numbers of a line from a place on.
    fn read(simd: Self::Set, line: &[Self::Memory], place: usize) -> Self;
}

/// Numbers in memory, and the register that they fit.
macro_rules! lanes {
    ($(#[$about:meta])* $name:ident([$number:ident; $count:literal]), $register:ident, $align:literal, $short:literal) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
        #[repr(C, align($align))]
        pub(crate) struct $name(pub [$number; $count]);

        #[allow(clippy::unnecessary_cast, clippy::cast_lossless, reason = "the numbers may be f64")]
        impl Lanes for $name {
            const COUNT: usize = $count;
            const SHORT: bool = $short;
            type Register<S: Simd> = $register<S>;

            fn splat(value: f64) -> Self {
                Self([value as $number; $count])
            }

            #[inline(always)]
            fn get(&self, lane: usize) -> f64 {
                self.0[lane] as f64
            }

            #[inline(always)]
            fn set(&mut self, lane: usize, value: f64) {
                self.0[lane] = value as $number;
            }
        }

        #[allow(clippy::unnecessary_cast, reason = "the numbers may be f64")]
        impl<S: Simd> Wide for $register<S> {
            type Set = S;
            type Memory = $name;

            #[inline(always)]
            fn constant(simd: S, value: f64) -> Self {
                Self::simd_from(simd, value as $number)
            }

            #[inline(always)]
            fn load(simd: S, lanes: &$name) -> Self {
                Self::simd_from(simd, lanes.0)
            }

            #[inline(always)]
            fn store(self) -> $name {
                $name(self.into())
            }

            #[inline(always)]
            fn read(simd: S, line: &[$name], place: usize) -> Self {
                let line: &[$number] = bytemuck::cast_slice(line);
                Self::from_slice(simd, &line[place..place + $count])
            }
        }
    };
}

lanes! {
    /// Four particles, exact.
    Lanes4([f64; 4]), f64x4, 32, false
}
lanes! {
    /// Eight particles, exact.
    Lanes8([f64; 8]), f64x8, 64, false
}
impl Lanes8 {
    /// Four of them: the first ones, or the others.
    #[inline(always)]
    pub(crate) fn half<S: Simd>(&self, simd: S, half: usize) -> f64x4<S> {
        f64x4::from_slice(simd, &self.0[LANES * half..LANES * (half + 1)])
    }
}
lanes! {
    /// Eight particles, fast.
    Short8([f32; 8]), f32x8, 32, true
}

/// Several numbers of the same particles.
#[inline(always)]
pub(crate) fn load_all<V: Wide, const N: usize>(simd: V::Set, lanes: &[V::Memory; N]) -> [V; N] {
    let mut values = [V::constant(simd, 0.0); N];
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

/// The vector of one of several particles.
#[inline(always)]
pub(crate) fn vector_of<L: Lanes>(lanes: &[L; 3], lane: usize) -> DVec3 {
    DVec3::new(lanes[0].get(lane), lanes[1].get(lane), lanes[2].get(lane))
}

/// The quaternion of one of several particles.
#[inline(always)]
pub(crate) fn quaternion_of<L: Lanes>(lanes: &[L; 4], lane: usize) -> DQuat {
    DQuat::from_xyzw(lanes[0].get(lane), lanes[1].get(lane), lanes[2].get(lane), lanes[3].get(lane))
}
