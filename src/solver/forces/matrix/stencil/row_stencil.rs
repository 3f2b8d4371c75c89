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

use super::brick_data::{BrickStress, BrickVectors};
use super::line_buffer::{LineBuffer, put, read};
use super::row_table::{DISTANCES, Group, MAX_NORM_SQUARED, for_every_group, rows_within};
use crate::solver::wide::{LANES, Lanes4, Mat3x, Vec3x, Wide};
use fearless_simd::{Simd, f64x4, prelude::*};

/// Weights of the offsets by |o|².
pub(super) struct StencilWeights {
    /// `w` [1/m²].
    plain: [Lanes4; MAX_NORM_SQUARED + 1],
    /// `a D w` [1/m], the weight of an offset with a component of a spacings along some axis.
    slope: [[Lanes4; MAX_NORM_SQUARED + 1]; DISTANCES],
    /// Spacing D [m].
    spacing: f64,
}

impl StencilWeights {
    /// Weights of |o|² = 0, 1, ... [1/m²] at a spacing D [m]; a particle is no neighbour of itself.
    pub(super) fn new(mut weights: [f64; MAX_NORM_SQUARED + 1], spacing: f64) -> Self {
        weights[0] = 0.0;
        let times = |factor: f64| weights.map(|weight| Lanes4::splat(factor * weight));
        Self { plain: times(1.0), slope: [0.0, 1.0, 2.0, 3.0].map(|a| times(a * spacing)), spacing }
    }
}

/// A stencil of |o|² up to `M`, over the first `N` of [`ROWS`].
pub(super) struct RowStencil<'a, S: Simd, const M: usize, const N: usize> {
    pub(super) simd: S,
    pub(super) weights: &'a StencilWeights,
}

/// One of the F numbers of the bricks around a site.
#[derive(Clone, Copy)]
struct SiteComponent<'a, const F: usize, const N: usize> {
    around: &'a [u32; N],
    bricks: &'a [[Lanes4; F]],
    component: usize,
}

impl<const F: usize, const N: usize> SiteComponent<'_, F, N> {
    #[inline(always)]
    fn row<S: Simd>(&self, simd: S, k: usize) -> f64x4<S> {
        f64x4::load(simd, &self.bricks[self.around[k] as usize][self.component])
    }
}

/// The rows (±a, ±b) of a group, taken together.
struct GroupSums<S: Simd> {
    /// Their sum.
    even: f64x4<S>,
    /// Those of positive dy less those of negative dy, and the same over dz; meaningless where that is zero.
    odd_y: f64x4<S>,
    odd_z: f64x4<S>,
}

/// Sums over the neighbours of a brick's particles, without the particles themselves.
pub(super) struct DeviationSums<S: Simd> {
    /// `sum w u_j (x) X_ji` [1].
    pub(super) moment: Mat3x<f64x4<S>>,
    /// `sum w u_j` [1/m].
    pub(super) plain: Vec3x<f64x4<S>>,
}

impl<S: Simd, const M: usize, const N: usize> RowStencil<'_, S, M, N> {
    /// Greatest |dx|.
    const REACH: usize = {
        assert!(N == rows_within(M), "the stencil looks at all rows within its reach");
        let mut reach = 1;
        while (reach + 1) * (reach + 1) <= M {
            reach += 1;
        }
        reach
    };

    /// Sums of the rows of group G.
    #[inline(always)]
    fn group_sums<const G: usize, const F: usize>(&self, of: SiteComponent<'_, F, N>) -> GroupSums<S> {
        let simd = self.simd;
        let first = of.row(simd, Group::<G>::FIRST);
        match (Group::<G>::A, Group::<G>::B) {
            (0, 0) => GroupSums { even: first, odd_y: first, odd_z: first },
            (_, 0) | (0, _) => {
                let second = of.row(simd, Group::<G>::FIRST + 1);
                let difference = first - second;
                GroupSums { even: first + second, odd_y: difference, odd_z: difference }
            }
            _ => {
                let (mp, pm) = (of.row(simd, Group::<G>::FIRST + 1), of.row(simd, Group::<G>::FIRST + 2));
                let mm = of.row(simd, Group::<G>::FIRST + 3);
                let (front, back) = (first + mp, pm + mm);
                GroupSums { even: front + back, odd_y: (first - mp) + (pm - mm), odd_z: front - back }
            }
        }
    }

    /// `sum + w row`, or `a D w row`, at |dx| = K and dy² + dz² = C.
    #[inline(always)]
    fn plain<const K: usize>(&self, c: usize, row: f64x4<S>, sum: &mut [f64x4<S>; DISTANCES]) {
        if K * K + c <= M && K * K + c > 0 {
            sum[K] = row.mul_add(f64x4::load(self.simd, &self.weights.plain[K * K + c]), sum[K]);
        }
    }

    #[inline(always)]
    fn sloped<const K: usize>(&self, a: usize, c: usize, row: f64x4<S>, sum: &mut [f64x4<S>; DISTANCES]) {
        if K * K + c <= M && K * K + c > 0 {
            sum[K] = row.mul_add(f64x4::load(self.simd, &self.weights.slope[a][K * K + c]), sum[K]);
        }
    }

    #[inline(always)]
    fn all_plain(&self, c: usize, row: f64x4<S>, sum: &mut [f64x4<S>; DISTANCES]) {
        self.plain::<0>(c, row, sum);
        self.plain::<1>(c, row, sum);
        self.plain::<2>(c, row, sum);
        self.plain::<3>(c, row, sum);
    }

    #[inline(always)]
    fn all_sloped(&self, a: usize, c: usize, row: f64x4<S>, sum: &mut [f64x4<S>; DISTANCES]) {
        self.sloped::<0>(a, c, row, sum);
        self.sloped::<1>(a, c, row, sum);
        self.sloped::<2>(a, c, row, sum);
        self.sloped::<3>(a, c, row, sum);
    }

    #[inline(always)]
    fn add_deviations<const G: usize>(
        &self,
        deviation: SiteComponent<'_, 3, N>,
        [plain, over_y, over_z]: &mut [[f64x4<S>; DISTANCES]; 3],
    ) {
        let c = Group::<G>::NORM_SQUARED;
        if c <= M {
            let GroupSums { even, odd_y, odd_z } = self.group_sums::<G, 3>(deviation);
            self.all_plain(c, even, plain);
            if Group::<G>::A > 0 {
                self.all_sloped(Group::<G>::A, c, odd_y, over_y);
            }
            if Group::<G>::B > 0 {
                self.all_sloped(Group::<G>::B, c, odd_z, over_z);
            }
        }
    }

    /// Combined rows of the first pass at a site, plain, times dy and times dz, from the deviations of the bricks
    /// `around`.
    #[inline(always)]
    pub(super) fn combine_deviations(
        &self,
        around: &[u32; N],
        bricks: &[BrickVectors],
        site: usize,
        lines: &mut LineBuffer,
    ) {
        for (component, lines) in lines.0.iter_mut().enumerate() {
            let deviation = SiteComponent { around, bricks, component };
            let mut sums = [[f64x4::splat(self.simd, 0.0); DISTANCES]; 3];
            for_every_group!(self.add_deviations(deviation, &mut sums));
            for (kind, sums) in sums.iter().enumerate() {
                for (k, sum) in sums.iter().enumerate().take(Self::REACH + 1) {
                    put(&mut lines[DISTANCES * kind + k], site, *sum);
                }
            }
        }
    }

    /// Sums of the first pass for the brick at `site`.
    #[inline(always)]
    pub(super) fn shift_deviations(&self, site: usize, lines: &LineBuffer) -> DeviationSums<S> {
        let simd = self.simd;
        let zero = Vec3x::splat(f64x4::splat(simd, 0.0));
        let (mut over_x, mut over_y, mut over_z, mut plain) = (zero, zero, zero, zero);
        for (component, lines) in lines.0.iter().enumerate() {
            let at = LANES * site;
            plain[component] = read(simd, &lines[0], at);
            over_y[component] = read(simd, &lines[DISTANCES], at);
            over_z[component] = read(simd, &lines[2 * DISTANCES], at);
            for k in 1..=Self::REACH {
                let (ahead, behind) = (read(simd, &lines[k], at + k), read(simd, &lines[k], at - k));
                plain[component] += ahead + behind;
                let distance = f64x4::splat(simd, k as f64 * self.weights.spacing);
                over_x[component] = (ahead - behind).mul_add(distance, over_x[component]);
                let (y, z) = (&lines[DISTANCES + k], &lines[2 * DISTANCES + k]);
                over_y[component] += read(simd, y, at + k) + read(simd, y, at - k);
                over_z[component] += read(simd, z, at + k) + read(simd, z, at - k);
            }
        }
        DeviationSums { moment: Mat3x([over_x, over_y, over_z]), plain }
    }

    #[inline(always)]
    fn add_stresses<const G: usize>(
        &self,
        [over_x, over_y, over_z, plain]: [SiteComponent<'_, 12, N>; 4],
        [even, odd]: &mut [[f64x4<S>; DISTANCES]; 2],
    ) {
        let c = Group::<G>::NORM_SQUARED;
        if c <= M {
            self.all_plain(c, self.group_sums::<G, 12>(plain).even, even);
            if c < M {
                self.x_terms(c, self.group_sums::<G, 12>(over_x).even, odd);
            }
            if Group::<G>::A > 0 {
                self.all_sloped(Group::<G>::A, c, self.group_sums::<G, 12>(over_y).odd_y, even);
            }
            if Group::<G>::B > 0 {
                self.all_sloped(Group::<G>::B, c, self.group_sums::<G, 12>(over_z).odd_z, even);
            }
        }
    }

    #[inline(always)]
    fn x_terms(&self, c: usize, row: f64x4<S>, odd: &mut [f64x4<S>; DISTANCES]) {
        self.sloped::<1>(1, c, row, odd);
        self.sloped::<2>(2, c, row, odd);
        self.sloped::<3>(3, c, row, odd);
    }

    /// Combined rows of the second pass at a site, to be read ahead and behind, from the stresses of the bricks
    /// `around`: the columns of Q, weighted with X_ji, and z.
    #[inline(always)]
    pub(super) fn combine_stresses(
        &self,
        around: &[u32; N],
        bricks: &[BrickStress],
        site: usize,
        lines: &mut LineBuffer,
    ) {
        for (component, lines) in lines.0.iter_mut().enumerate() {
            let column = |column: usize| SiteComponent { around, bricks, component: 3 * column + component };
            let columns = [column(0), column(1), column(2), column(3)];
            let mut sums = [[f64x4::splat(self.simd, 0.0); DISTANCES]; 2];
            for_every_group!(self.add_stresses(columns, &mut sums));
            let [even, odd] = sums;
            put(&mut lines[0], site, even[0]);
            for k in 1..=Self::REACH {
                put(&mut lines[2 * k - 1], site, even[k] + odd[k]);
                put(&mut lines[2 * k], site, even[k] - odd[k]);
            }
        }
    }

    /// Sums of the second pass for the brick at `site`: `sum w (Q_j X_ji + z_j)` [N].
    #[inline(always)]
    pub(super) fn shift_stresses(&self, site: usize, lines: &LineBuffer) -> Vec3x<f64x4<S>> {
        let simd = self.simd;
        let mut sums = Vec3x::splat(f64x4::splat(simd, 0.0));
        for (component, lines) in lines.0.iter().enumerate() {
            let at = LANES * site;
            sums[component] = read(simd, &lines[0], at);
            for k in 1..=Self::REACH {
                sums[component] += read(simd, &lines[2 * k - 1], at + k) + read(simd, &lines[2 * k], at - k);
            }
        }
        sums
    }
}
