//! Neighbour sums as stencils: rows along x are combined over y and z first, and shifted along x last.
//!
//! The weight of an offset `o` depends on `|o|²` alone. With `rows(dy, dz)` the row that lies (dy, dz) off, and the
//! offsets of equal |dx| = k taken together, a sum over all offsets is a sum over k of a *combined row*
//!
//! `C_k = sum over (dy, dz) of w(k² + dy² + dz²) row(dy, dz)`,
//!
//! read at x + k and at x - k: at D = 0.4 h three combinations of 21 rows in place of 80 offsets. Rows at (±a, ±b)
//! share their weights, so that they are added (or subtracted, where the sum is weighted with dy or dz) before they are
//! multiplied. Combined rows are kept in the lines of a [`LineBuffer`], where a shift is a load from the place beside.

use super::line_buffer::{LINES, Line, LineBuffer, read};
use super::row_table::{DISTANCES, Group, MAX_NORM_SQUARED, for_every_group, rows_within};
use crate::solver::wide::{Lanes, Mat3x, Vec3x, Wide};
use fearless_simd::{Simd, prelude::*};
use glam::DVec3;

/// Weights of the offsets by |o|².
pub(super) struct StencilWeights<L> {
    /// `w` [1/m²].
    plain: [L; MAX_NORM_SQUARED + 1],
    /// `a D w` [1/m], the weight of an offset with a component of a spacings along x, y or z.
    slope: [[[L; MAX_NORM_SQUARED + 1]; DISTANCES]; 3],
    /// Spacing D along x [m].
    spacing: f64,
}

impl<L: Lanes> StencilWeights<L> {
    /// Weights of |o|² = 0, 1, ... [1/m²] at spacings D along the axes [m]; a particle is no neighbour of itself.
    pub(super) fn new(mut weights: [f64; MAX_NORM_SQUARED + 1], spacings: DVec3) -> Self {
        weights[0] = 0.0;
        let times = |factor: f64| weights.map(|weight| L::splat(factor * weight));
        let sloped = |spacing: f64| [0.0, 1.0, 2.0, 3.0].map(|a| times(a * spacing));
        Self { plain: times(1.0), slope: spacings.to_array().map(sloped), spacing: spacings.x }
    }
}

/// Where the columns of Q and z stand in a [`BrickStress`].
const Q_X: usize = 0;
const Q_Y: usize = 1;
const Q_Z: usize = 2;
const Z: usize = 3;

/// A stencil of |o|² up to `M`, over the first `N` of [`ROWS`].
pub(super) struct RowStencil<'a, S: Simd, L: Lanes, const M: usize, const N: usize> {
    pub(super) simd: S,
    pub(super) weights: &'a StencilWeights<L>,
}

/// The bricks around a site, of F numbers each, out of a power of two of them: a mask then keeps every number within,
/// which costs less than to check it.
#[derive(Clone, Copy)]
pub(super) struct Around<'a, L, const F: usize, const N: usize> {
    pub(super) numbers: &'a [u32; N],
    pub(super) bricks: &'a [[L; F]],
}

/// The bricks in the rows of a group, the first of them once more where there are fewer than four.
type GroupBricks<'a, L, const F: usize> = [&'a [L; F]; 4];

impl<'a, L: Lanes, const F: usize, const N: usize> Around<'a, L, F, N> {
    #[inline(always)]
    fn group<const G: usize>(self) -> GroupBricks<'a, L, F> {
        let first = Group::<G>::FIRST;
        let mask = self.bricks.len() - 1;
        let brick = |k: usize| &self.bricks[self.numbers[k] as usize & mask];
        match (Group::<G>::A, Group::<G>::B) {
            (0, 0) => [brick(first); 4],
            (_, 0) | (0, _) => {
                let [first, second] = [brick(first), brick(first + 1)];
                [first, second, first, first]
            }
            _ => [brick(first), brick(first + 1), brick(first + 2), brick(first + 3)],
        }
    }
}

/// The rows (±a, ±b) of a group, taken together.
struct GroupSums<V> {
    /// Their sum.
    even: V,
    /// Those of positive dy less those of negative dy, and the same over dz; meaningless where that is zero.
    odd_y: V,
    odd_z: V,
}

/// Combined rows of the first pass at a site, by |dx|: plain, times dy and times dz.
pub(super) type DeviationRows<V> = [[V; DISTANCES]; 3];

/// Combined rows of the second pass at a site, by |dx|: of what is even in dx, and odd.
pub(super) type StressRows<V> = [[V; DISTANCES]; 2];

/// Sums over the neighbours of a brick's particles, without the particles themselves.
pub(super) struct DeviationSums<V> {
    /// `sum w u_j (x) X_ji` [1].
    pub(super) moment: Mat3x<V>,
    /// `sum w u_j` [1/m].
    pub(super) plain: Vec3x<V>,
}

impl<S: Simd, L: Lanes, const M: usize, const N: usize> RowStencil<'_, S, L, M, N> {
    /// Greatest |dx|.
    const REACH: usize = {
        assert!(N == rows_within(M), "the stencil looks at all rows within its reach");
        let mut reach = 1;
        while (reach + 1) * (reach + 1) <= M {
            reach += 1;
        }
        reach
    };

    /// Sums of a number over the rows of group G.
    #[inline(always)]
    fn group_sums<const G: usize, const F: usize>(
        &self,
        bricks: GroupBricks<'_, L, F>,
        number: usize,
    ) -> GroupSums<L::Register<S>> {
        let row = |k: usize| L::Register::load(self.simd, &bricks[k][number]);
        let first = row(0);
        match (Group::<G>::A, Group::<G>::B) {
            (0, 0) => GroupSums { even: first, odd_y: first, odd_z: first },
            (_, 0) | (0, _) => {
                let second = row(1);
                let difference = first - second;
                GroupSums { even: first + second, odd_y: difference, odd_z: difference }
            }
            _ => {
                let (mp, pm) = (row(1), row(2));
                let mm = row(3);
                let (front, back) = (first + mp, pm + mm);
                GroupSums { even: front + back, odd_y: (first - mp) + (pm - mm), odd_z: front - back }
            }
        }
    }

    /// `sum + w row`, or `a D w row`, at |dx| = K and dy² + dz² = C.
    #[inline(always)]
    fn plain<const K: usize>(&self, c: usize, row: L::Register<S>, sum: &mut [L::Register<S>; DISTANCES]) {
        if K * K + c <= M && K * K + c > 0 {
            sum[K] = row.mul_add(L::Register::load(self.simd, &self.weights.plain[K * K + c]), sum[K]);
        }
    }

    #[inline(always)]
    fn sloped<const K: usize, const AXIS: usize>(
        &self,
        a: usize,
        c: usize,
        row: L::Register<S>,
        sum: &mut [L::Register<S>; DISTANCES],
    ) {
        if K * K + c <= M && K * K + c > 0 {
            sum[K] = row.mul_add(L::Register::load(self.simd, &self.weights.slope[AXIS][a][K * K + c]), sum[K]);
        }
    }

    #[inline(always)]
    fn all_plain(&self, c: usize, row: L::Register<S>, sum: &mut [L::Register<S>; DISTANCES]) {
        self.plain::<0>(c, row, sum);
        self.plain::<1>(c, row, sum);
        self.plain::<2>(c, row, sum);
        self.plain::<3>(c, row, sum);
    }

    #[inline(always)]
    fn all_sloped<const AXIS: usize>(
        &self,
        a: usize,
        c: usize,
        row: L::Register<S>,
        sum: &mut [L::Register<S>; DISTANCES],
    ) {
        self.sloped::<0, AXIS>(a, c, row, sum);
        self.sloped::<1, AXIS>(a, c, row, sum);
        self.sloped::<2, AXIS>(a, c, row, sum);
        self.sloped::<3, AXIS>(a, c, row, sum);
    }

    #[inline(always)]
    fn add_deviations<const G: usize>(
        &self,
        around: Around<'_, L, 3, N>,
        component: usize,
        [plain, over_y, over_z]: &mut [[L::Register<S>; DISTANCES]; 3],
    ) {
        let c = Group::<G>::NORM_SQUARED;
        if c <= M {
            let GroupSums { even, odd_y, odd_z } = self.group_sums::<G, 3>(around.group::<G>(), component);
            self.all_plain(c, even, plain);
            if Group::<G>::A > 0 {
                self.all_sloped::<1>(Group::<G>::A, c, odd_y, over_y);
            }
            if Group::<G>::B > 0 {
                self.all_sloped::<2>(Group::<G>::B, c, odd_z, over_z);
            }
        }
    }

    /// Combined rows of the first pass at a site, plain, times dy and times dz, from a component of the deviations of
    /// the bricks `around`.
    #[inline(always)]
    pub(super) fn combine_deviations(
        &self,
        around: Around<'_, L, 3, N>,
        component: usize,
    ) -> DeviationRows<L::Register<S>> {
        let mut sums = [[L::Register::constant(self.simd, 0.0); DISTANCES]; 3];
        for_every_group!(self.add_deviations(around, component, &mut sums));
        sums
    }

    /// Puts them where they are read from.
    #[inline(always)]
    #[allow(clippy::unused_self, reason = "its type knows the reach")]
    pub(super) fn put_deviations(
        &self,
        sums: &DeviationRows<L::Register<S>>,
        site: usize,
        lines: &mut [Line<L>; LINES],
    ) {
        for (kind, sums) in sums.iter().enumerate() {
            for (k, sum) in sums.iter().enumerate().take(Self::REACH + 1) {
                lines[DISTANCES * kind + k][site] = sum.store();
            }
        }
    }

    /// Sums of the first pass for the brick at `site`.
    #[inline(always)]
    #[allow(clippy::cast_possible_wrap, reason = "a few places")]
    pub(super) fn shift_deviations(&self, site: usize, lines: &LineBuffer<L>) -> DeviationSums<L::Register<S>> {
        let simd = self.simd;
        let zero = Vec3x::splat(L::Register::constant(simd, 0.0));
        let (mut over_x, mut over_y, mut over_z, mut plain) = (zero, zero, zero, zero);
        for (component, lines) in lines.0.iter().enumerate() {
            let at = |line: usize, step: isize| read(simd, &lines[line], site, step);
            plain[component] = at(0, 0);
            over_y[component] = at(DISTANCES, 0);
            over_z[component] = at(2 * DISTANCES, 0);
            for k in 1..=Self::REACH {
                let step = k as isize;
                let (ahead, behind) = (at(k, step), at(k, -step));
                plain[component] += ahead + behind;
                let distance = L::Register::constant(simd, k as f64 * self.weights.spacing);
                over_x[component] = (ahead - behind).mul_add(distance, over_x[component]);
                let (y, z) = (DISTANCES + k, 2 * DISTANCES + k);
                over_y[component] += at(y, step) + at(y, -step);
                over_z[component] += at(z, step) + at(z, -step);
            }
        }
        DeviationSums { moment: Mat3x([over_x, over_y, over_z]), plain }
    }

    #[inline(always)]
    fn add_stresses<const G: usize>(
        &self,
        around: Around<'_, L, 4, N>,
        [even, odd]: &mut [[L::Register<S>; DISTANCES]; 2],
    ) {
        let c = Group::<G>::NORM_SQUARED;
        if c <= M {
            let bricks = around.group::<G>();
            self.all_plain(c, self.group_sums::<G, 4>(bricks, Z).even, even);
            if c < M {
                self.x_terms(c, self.group_sums::<G, 4>(bricks, Q_X).even, odd);
            }
            if Group::<G>::A > 0 {
                self.all_sloped::<1>(Group::<G>::A, c, self.group_sums::<G, 4>(bricks, Q_Y).odd_y, even);
            }
            if Group::<G>::B > 0 {
                self.all_sloped::<2>(Group::<G>::B, c, self.group_sums::<G, 4>(bricks, Q_Z).odd_z, even);
            }
        }
    }

    #[inline(always)]
    fn x_terms(&self, c: usize, row: L::Register<S>, odd: &mut [L::Register<S>; DISTANCES]) {
        self.sloped::<1, 0>(1, c, row, odd);
        self.sloped::<2, 0>(2, c, row, odd);
        self.sloped::<3, 0>(3, c, row, odd);
    }

    /// Combined rows of the second pass at a site, even and odd in dx, from a component of the stresses of the bricks
    /// `around`: the columns of Q, weighted with X_ji, and z.
    #[inline(always)]
    pub(super) fn combine_stresses(&self, around: Around<'_, L, 4, N>) -> StressRows<L::Register<S>> {
        let mut sums = [[L::Register::constant(self.simd, 0.0); DISTANCES]; 2];
        for_every_group!(self.add_stresses(around, &mut sums));
        sums
    }

    /// Puts them where they are read ahead and behind.
    #[inline(always)]
    #[allow(clippy::unused_self, reason = "its type knows the reach")]
    pub(super) fn put_stresses(
        &self,
        [even, odd]: &StressRows<L::Register<S>>,
        site: usize,
        lines: &mut [Line<L>; LINES],
    ) {
        lines[0][site] = even[0].store();
        for k in 1..=Self::REACH {
            lines[2 * k - 1][site] = (even[k] + odd[k]).store();
            lines[2 * k][site] = (even[k] - odd[k]).store();
        }
    }

    /// Sums of the second pass for the brick at `site`: `sum w (Q_j X_ji + z_j)` [N].
    #[inline(always)]
    #[allow(clippy::cast_possible_wrap, reason = "a few places")]
    pub(super) fn shift_stresses(&self, site: usize, lines: &LineBuffer<L>) -> Vec3x<L::Register<S>> {
        let simd = self.simd;
        let mut sums = Vec3x::splat(L::Register::constant(simd, 0.0));
        for (component, lines) in lines.0.iter().enumerate() {
            let at = |line: usize, step: isize| read(simd, &lines[line], site, step);
            sums[component] = at(0, 0);
            for k in 1..=Self::REACH {
                sums[component] += at(2 * k - 1, k as isize) + at(2 * k, -(k as isize));
            }
        }
        sums
    }
}
