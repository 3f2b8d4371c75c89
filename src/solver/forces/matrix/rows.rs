//! Neighbour sums as stencils: rows along x are combined over y and z first, and shifted along x last.
//!
//! The weight of an offset `o` depends on `|o|²` alone. With `rows(dy, dz)` the row that lies (dy, dz) off, and the
//! offsets of equal |dx| = k taken together, a sum over all offsets is a sum over k of a *combined row*
//!
//! `C_k = sum over (dy, dz) of w(k² + dy² + dz²) row(dy, dz)`,
//!
//! read at x + k and at x - k: at D = 0.4 h three combinations of 21 rows in place of 80 offsets. Rows at (±a, ±b) share
//! their weights, so that they are added (or subtracted, where the sum is weighted with dy or dz) before they are
//! multiplied. Combined rows are kept in [`Lines`] along x, where a shift is a load from the place beside.

use super::lanes::{LANES, Lanes, load};
use fearless_simd::{Simd, f64x4, prelude::*};

/// Greatest |o|² a stencil may have: D / h from 0.3 on.
pub(super) const MOST: usize = 11;
/// Values of |dx|.
const STEPS: usize = 4;

/// Rows (dy, dz) in order of dy² + dz², so that a smaller stencil uses the first of them: 21 up to |o|² = 6.
pub(super) const ROWS: [(i32, i32); 37] = {
    let groups =
        [(0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (0, 2), (2, 1), (1, 2), (2, 2), (3, 0), (0, 3), (3, 1), (1, 3)];
    let mut rows = [(0, 0); 37];
    let (mut n, mut g) = (0, 0);
    while g < groups.len() {
        let (a, b) = groups[g];
        // (a, b), (-a, b), (a, -b), (-a, -b), as far as they differ.
        let mut k = 0;
        while k < 4 {
            let (y, z) = (k % 2 == 1, k / 2 == 1);
            if !(y && a == 0 || z && b == 0) {
                rows[n] = (if y { -a } else { a }, if z { -b } else { b });
                n += 1;
            }
            k += 1;
        }
        g += 1;
    }
    rows
};

/// Weights of the offsets by |o|².
#[derive(Clone)]
pub(super) struct Weights {
    /// `w` [1/m²].
    plain: [Lanes; MOST + 1],
    /// `a D w` [1/m], the weight of an offset with a component of a spacings along some axis.
    slope: [[Lanes; MOST + 1]; STEPS],
    /// Spacing D [m].
    spacing: f64,
}

impl Weights {
    /// Weights of |o|² = 0, 1, ... [1/m²] at a spacing D [m]; a particle is no neighbour of itself.
    pub(super) fn new(mut weights: [f64; MOST + 1], spacing: f64) -> Self {
        weights[0] = 0.0;
        let times = |factor: f64| weights.map(|weight| Lanes([factor * weight; LANES]));
        Self { plain: times(1.0), slope: [0.0, 1.0, 2.0, 3.0].map(|a| times(a * spacing)), spacing }
    }
}

/// Sites in a chunk of bricks: bricks and the places beside their rows' ends, into which sums are shifted.
pub(super) const MOST_SITES: usize = 24;
/// Combined rows of a component: those of the first pass for each |dx|.
const LINES: usize = 3 * STEPS;

/// Combined rows of a chunk: of each component, each line runs along the sites.
#[derive(Default)]
pub(super) struct Lines(Vec<[[f64; LANES * MOST_SITES]; LINES]>);

impl Lines {
    pub(super) fn new() -> Self {
        Self(vec![[[0.0; LANES * MOST_SITES]; LINES]; 3])
    }
}

/// A stencil of |o|² up to `M`, over the first `N` of [`ROWS`].
pub(super) struct Rows<'a, S: Simd, const M: usize, const N: usize> {
    pub(super) simd: S,
    pub(super) weights: &'a Weights,
}

/// One of the numbers of the bricks around a site.
#[derive(Clone, Copy)]
struct Column<'a, const F: usize, const N: usize> {
    rows: &'a [u32; N],
    bricks: &'a [[Lanes; F]],
    entry: usize,
}

impl<const F: usize, const N: usize> Column<'_, F, N> {
    #[inline(always)]
    fn row<S: Simd>(&self, simd: S, k: usize) -> f64x4<S> {
        load(simd, &self.bricks[self.rows[k] as usize][self.entry])
    }
}

/// Sum of up to four rows, and differences over y and over z.
type Parity<S> = (f64x4<S>, f64x4<S>, f64x4<S>);

impl<S: Simd, const M: usize, const N: usize> Rows<'_, S, M, N> {
    /// Greatest |dx|.
    const REACH: usize = {
        let mut reach = 1;
        while (reach + 1) * (reach + 1) <= M {
            reach += 1;
        }
        reach
    };

    /// The rows (±A, ±B), which stand from `FIRST` on.
    #[inline(always)]
    fn parity<const A: usize, const B: usize, const FIRST: usize, const F: usize>(
        &self,
        column: Column<'_, F, N>,
    ) -> Parity<S> {
        let simd = self.simd;
        let first = column.row(simd, FIRST);
        match (A, B) {
            (0, 0) => (first, first, first),
            (_, 0) | (0, _) => {
                let second = column.row(simd, FIRST + 1);
                let difference = first - second;
                (first + second, difference, difference)
            }
            _ => {
                let (mp, pm) = (column.row(simd, FIRST + 1), column.row(simd, FIRST + 2));
                let mm = column.row(simd, FIRST + 3);
                let (front, back) = (first + mp, pm + mm);
                (front + back, (first - mp) + (pm - mm), front - back)
            }
        }
    }

    /// `sum + w row`, or `a D w row`, at |dx| = K and dy² + dz² = C.
    #[inline(always)]
    fn plain<const K: usize>(&self, c: usize, row: f64x4<S>, sum: &mut [f64x4<S>; STEPS]) {
        if K * K + c <= M && K * K + c > 0 {
            sum[K] = row.mul_add(load(self.simd, &self.weights.plain[K * K + c]), sum[K]);
        }
    }

    #[inline(always)]
    fn sloped<const K: usize>(&self, a: usize, c: usize, row: f64x4<S>, sum: &mut [f64x4<S>; STEPS]) {
        if K * K + c <= M && K * K + c > 0 {
            sum[K] = row.mul_add(load(self.simd, &self.weights.slope[a][K * K + c]), sum[K]);
        }
    }

    #[inline(always)]
    fn all_plain(&self, c: usize, row: f64x4<S>, sum: &mut [f64x4<S>; STEPS]) {
        self.plain::<0>(c, row, sum);
        self.plain::<1>(c, row, sum);
        self.plain::<2>(c, row, sum);
        self.plain::<3>(c, row, sum);
    }

    #[inline(always)]
    fn all_sloped(&self, a: usize, c: usize, row: f64x4<S>, sum: &mut [f64x4<S>; STEPS]) {
        self.sloped::<0>(a, c, row, sum);
        self.sloped::<1>(a, c, row, sum);
        self.sloped::<2>(a, c, row, sum);
        self.sloped::<3>(a, c, row, sum);
    }

    #[inline(always)]
    fn first_group<const A: usize, const B: usize, const FIRST: usize>(
        &self,
        column: Column<'_, 3, N>,
        [plain, over_y, over_z]: &mut [[f64x4<S>; STEPS]; 3],
    ) {
        let c = A * A + B * B;
        if c <= M {
            let (sum, y, z) = self.parity::<A, B, FIRST, 3>(column);
            self.all_plain(c, sum, plain);
            if A > 0 {
                self.all_sloped(A, c, y, over_y);
            }
            if B > 0 {
                self.all_sloped(B, c, z, over_z);
            }
        }
    }

    /// Combined rows of the first pass at a site, plain, times dy and times dz, from the deviations of the bricks in
    /// `rows`.
    #[inline(always)]
    pub(super) fn combine_deviations(&self, rows: &[u32; N], bricks: &[[Lanes; 3]], site: usize, lines: &mut Lines) {
        for (component, lines) in lines.0.iter_mut().enumerate() {
            let column = Column { rows, bricks, entry: component };
            let mut sums = [[f64x4::splat(self.simd, 0.0); STEPS]; 3];
            self.first_group::<0, 0, 0>(column, &mut sums);
            self.first_group::<1, 0, 1>(column, &mut sums);
            self.first_group::<0, 1, 3>(column, &mut sums);
            self.first_group::<1, 1, 5>(column, &mut sums);
            self.first_group::<2, 0, 9>(column, &mut sums);
            self.first_group::<0, 2, 11>(column, &mut sums);
            self.first_group::<2, 1, 13>(column, &mut sums);
            self.first_group::<1, 2, 17>(column, &mut sums);
            self.first_group::<2, 2, 21>(column, &mut sums);
            self.first_group::<3, 0, 25>(column, &mut sums);
            self.first_group::<0, 3, 27>(column, &mut sums);
            self.first_group::<3, 1, 29>(column, &mut sums);
            self.first_group::<1, 3, 33>(column, &mut sums);
            for (kind, sums) in sums.iter().enumerate() {
                for (k, sum) in sums.iter().enumerate().take(Self::REACH + 1) {
                    put(&mut lines[STEPS * kind + k], site, *sum);
                }
            }
        }
    }

    /// Combined rows of either pass at a site beside which nothing lies: zero.
    #[inline(always)]
    pub(super) fn clear(&self, site: usize, lines: &mut Lines) {
        let zero = f64x4::splat(self.simd, 0.0);
        for line in lines.0.iter_mut().flatten() {
            put(line, site, zero);
        }
    }

    /// Sums of the first pass for the brick at `site`: `sum w u_j (x) X_ji`, by columns, and `sum w u_j`.
    #[inline(always)]
    pub(super) fn shift_deviations(&self, site: usize, lines: &Lines) -> [[f64x4<S>; 3]; 4] {
        let zero = f64x4::splat(self.simd, 0.0);
        let mut sums = [[zero; 3]; 4];
        let [over_x, over_y, over_z, plain] = &mut sums;
        for (component, lines) in lines.0.iter().enumerate() {
            let at = LANES * site;
            plain[component] = self.read(&lines[0], at);
            over_y[component] = self.read(&lines[STEPS], at);
            over_z[component] = self.read(&lines[2 * STEPS], at);
            for k in 1..=Self::REACH {
                let (front, back) = (self.read(&lines[k], at + k), self.read(&lines[k], at - k));
                plain[component] += front + back;
                let distance = f64x4::splat(self.simd, k as f64 * self.weights.spacing);
                over_x[component] = (front - back).mul_add(distance, over_x[component]);
                let (y, z) = (&lines[STEPS + k], &lines[2 * STEPS + k]);
                over_y[component] += self.read(y, at + k) + self.read(y, at - k);
                over_z[component] += self.read(z, at + k) + self.read(z, at - k);
            }
        }
        sums
    }

    #[inline(always)]
    fn read(&self, line: &[f64; LANES * MOST_SITES], at: usize) -> f64x4<S> {
        f64x4::from_slice(self.simd, &line[at..at + LANES])
    }

    #[inline(always)]
    fn second_group<const A: usize, const B: usize, const FIRST: usize>(
        &self,
        [over_x, over_y, over_z, plain]: [Column<'_, 12, N>; 4],
        [even, odd]: &mut [[f64x4<S>; STEPS]; 2],
    ) {
        let c = A * A + B * B;
        if c <= M {
            self.all_plain(c, self.parity::<A, B, FIRST, 12>(plain).0, even);
            if c < M {
                self.x_terms(c, self.parity::<A, B, FIRST, 12>(over_x).0, odd);
            }
            if A > 0 {
                self.all_sloped(A, c, self.parity::<A, B, FIRST, 12>(over_y).1, even);
            }
            if B > 0 {
                self.all_sloped(B, c, self.parity::<A, B, FIRST, 12>(over_z).2, even);
            }
        }
    }

    #[inline(always)]
    fn x_terms(&self, c: usize, row: f64x4<S>, odd: &mut [f64x4<S>; STEPS]) {
        self.sloped::<1>(1, c, row, odd);
        self.sloped::<2>(2, c, row, odd);
        self.sloped::<3>(3, c, row, odd);
    }

    /// Combined rows of the second pass at a site, to be read ahead and behind, from the fields of the bricks in `rows`:
    /// the columns of Q, weighted with X_ji, and a fourth vector.
    #[inline(always)]
    pub(super) fn combine_fields(&self, rows: &[u32; N], bricks: &[[Lanes; 12]], site: usize, lines: &mut Lines) {
        for (component, lines) in lines.0.iter_mut().enumerate() {
            let column = |field: usize| Column { rows, bricks, entry: 3 * field + component };
            let fields = [column(0), column(1), column(2), column(3)];
            let mut sums = [[f64x4::splat(self.simd, 0.0); STEPS]; 2];
            self.second_group::<0, 0, 0>(fields, &mut sums);
            self.second_group::<1, 0, 1>(fields, &mut sums);
            self.second_group::<0, 1, 3>(fields, &mut sums);
            self.second_group::<1, 1, 5>(fields, &mut sums);
            self.second_group::<2, 0, 9>(fields, &mut sums);
            self.second_group::<0, 2, 11>(fields, &mut sums);
            self.second_group::<2, 1, 13>(fields, &mut sums);
            self.second_group::<1, 2, 17>(fields, &mut sums);
            self.second_group::<2, 2, 21>(fields, &mut sums);
            self.second_group::<3, 0, 25>(fields, &mut sums);
            self.second_group::<0, 3, 27>(fields, &mut sums);
            self.second_group::<3, 1, 29>(fields, &mut sums);
            self.second_group::<1, 3, 33>(fields, &mut sums);
            let [even, odd] = sums;
            put(&mut lines[0], site, even[0]);
            for k in 1..=Self::REACH {
                put(&mut lines[2 * k - 1], site, even[k] + odd[k]);
                put(&mut lines[2 * k], site, even[k] - odd[k]);
            }
        }
    }

    /// Sums of the second pass for the brick at `site`: `sum w (Q_j X_ji + Z_j)`.
    #[inline(always)]
    pub(super) fn shift_fields(&self, site: usize, lines: &Lines) -> [f64x4<S>; 3] {
        let mut sums = [f64x4::splat(self.simd, 0.0); 3];
        for (component, lines) in lines.0.iter().enumerate() {
            let at = LANES * site;
            sums[component] = self.read(&lines[0], at);
            for k in 1..=Self::REACH {
                sums[component] += self.read(&lines[2 * k - 1], at + k) + self.read(&lines[2 * k], at - k);
            }
        }
        sums
    }
}

#[inline(always)]
fn put<S: Simd>(line: &mut [f64; LANES * MOST_SITES], site: usize, value: f64x4<S>) {
    value.store_slice(&mut line[LANES * site..LANES * (site + 1)]);
}
