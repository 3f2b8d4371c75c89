//! Symmetric matrices of 3 by 3 blocks within an envelope, and vectors that go with them.
//!
//! A row of a block is a SIMD register whose fourth lane is zero. Rows hold the upper triangle, each from its diagonal
//! to the end of its envelope; ends never go back from one row to the next.

use crate::solver::wide::{Lanes4, Wide};
use fearless_simd::{Simd, f64x4, prelude::*};

/// Three rows of a block.
pub(super) type Block = [Lanes4; 3];

/// Where the rows of an upper triangle end and how they stand in memory.
#[derive(Clone, Debug, Default)]
pub(super) struct Envelope {
    /// End of each row, exclusive.
    pub(super) ends: Vec<usize>,
    /// Where each row begins in memory, and their end.
    starts: Vec<usize>,
}

impl Envelope {
    /// The least envelope around rows that end there, exclusive.
    pub(super) fn new(ends: impl IntoIterator<Item = usize>) -> Self {
        let mut this = Self { ends: Vec::new(), starts: vec![0] };
        let (mut furthest, mut begun) = (0, 0);
        for (row, end) in ends.into_iter().enumerate() {
            furthest = end.max(furthest).max(row + 1);
            begun += furthest - row;
            this.ends.push(furthest);
            this.starts.push(begun);
        }
        this
    }

    /// Number of rows.
    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    /// Entries of all rows.
    pub(super) fn entries(&self) -> usize {
        self.starts[self.len()]
    }

    /// Entries of a row in memory.
    #[inline(always)]
    pub(super) fn row(&self, row: usize) -> std::ops::Range<usize> {
        self.starts[row]..self.starts[row + 1]
    }

    /// How many products of two blocks it takes to factor a matrix in it.
    pub(super) fn products(&self) -> usize {
        let lengths = self.ends.iter().enumerate().map(|(row, end)| end - row);
        lengths.map(|length| length * (length + 1) / 2).sum()
    }
}

/// A positive definite matrix, then its Cholesky factor.
#[derive(Debug, Default)]
pub(super) struct BlockMatrix {
    rows: Vec<Block>,
    /// Diagonal blocks of the factor: r00, r01, r02, r11, r12, r22, the diagonal ones inverted.
    diagonals: Vec<[f64; 6]>,
}

impl BlockMatrix {
    /// Makes room for the entries of an envelope.
    pub(super) fn fit(&mut self, envelope: &Envelope) {
        self.rows.resize(envelope.entries(), Block::default());
        self.diagonals.resize(envelope.len(), [0.0; 6]);
    }

    /// The blocks of a row.
    #[inline(always)]
    pub(super) fn row_mut(&mut self, envelope: &Envelope, row: usize) -> &mut [Block] {
        &mut self.rows[envelope.row(row)]
    }

    /// Factors it in place, `A = U^T U`; false if it is not positive definite.
    #[inline(always)]
    pub(super) fn factor<S: Simd>(&mut self, simd: S, envelope: &Envelope) -> bool {
        for j in 0..envelope.len() {
            let (before, after) = self.rows.split_at_mut(envelope.row(j).end);
            let row = &mut before[envelope.row(j).start..];
            let Some(diagonal) = factored(&row[0]) else { return false };
            self.diagonals[j] = diagonal;
            let [r00, r01, r02, r11, r12, r22] = diagonal.map(|entry| f64x4::splat(simd, entry));
            for block in row.iter_mut().skip(1) {
                let first = f64x4::load(simd, &block[0]) * r00;
                let second = (f64x4::load(simd, &block[1]) - r01 * first) * r11;
                let third = (f64x4::load(simd, &block[2]) - r02 * first - r12 * second) * r22;
                *block = [first.store(), second.store(), third.store()];
            }
            let row = &row[1..];
            let offset = envelope.row(j).end;
            for k in 0..row.len() {
                let i = j + 1 + k;
                let target = &mut after[envelope.row(i).start - offset..][..row.len() - k];
                let by = &row[k];
                let mut factors = [[f64x4::splat(simd, 0.0); 3]; 3];
                for c in 0..3 {
                    for of in 0..3 {
                        factors[c][of] = f64x4::splat(simd, -by[of].0[c]);
                    }
                }
                for (target, source) in target.iter_mut().zip(&row[k..]) {
                    let first = f64x4::load(simd, &source[0]);
                    let second = f64x4::load(simd, &source[1]);
                    let third = f64x4::load(simd, &source[2]);
                    for c in 0..3 {
                        let mut sum = f64x4::load(simd, &target[c]);
                        sum = first.mul_add(factors[c][0], sum);
                        sum = second.mul_add(factors[c][1], sum);
                        target[c] = third.mul_add(factors[c][2], sum).store();
                    }
                }
            }
        }
        true
    }

    /// Solves `U^T U x = b` by the factor, in place.
    #[inline(always)]
    pub(super) fn solve<S: Simd>(&self, simd: S, envelope: &Envelope, b: &mut [Lanes4]) {
        for j in 0..envelope.len() {
            let [r00, r01, r02, r11, r12, r22] = self.diagonals[j];
            let [x, y, z, _] = b[j].0;
            let first = x * r00;
            let second = (y - r01 * first) * r11;
            let third = (z - r02 * first - r12 * second) * r22;
            b[j] = Lanes4([first, second, third, 0.0]);
            let [first, second, third] = [first, second, third].map(|value| f64x4::splat(simd, -value));
            let row = &self.rows[envelope.row(j)];
            for (b, block) in b[j + 1..].iter_mut().zip(&row[1..]) {
                let mut sum = f64x4::load(simd, b);
                sum = f64x4::load(simd, &block[0]).mul_add(first, sum);
                sum = f64x4::load(simd, &block[1]).mul_add(second, sum);
                *b = f64x4::load(simd, &block[2]).mul_add(third, sum).store();
            }
        }
        for j in (0..envelope.len()).rev() {
            let row = &self.rows[envelope.row(j)];
            let mut sums = [f64x4::splat(simd, 0.0); 3];
            for (b, block) in b[j + 1..].iter().zip(&row[1..]) {
                let x = f64x4::load(simd, b);
                for c in 0..3 {
                    sums[c] = f64x4::load(simd, &block[c]).mul_add(x, sums[c]);
                }
            }
            let [r00, r01, r02, r11, r12, r22] = self.diagonals[j];
            let [x, y, z, _] = b[j].0;
            let third = (z - total(sums[2])) * r22;
            let second = (y - total(sums[1]) - r12 * third) * r11;
            let first = (x - total(sums[0]) - r01 * second - r02 * third) * r00;
            b[j] = Lanes4([first, second, third, 0.0]);
        }
    }
}

/// Sum of all lanes.
#[inline(always)]
fn total<S: Simd>(lanes: f64x4<S>) -> f64 {
    let [a, b, c, d]: [f64; 4] = lanes.into();
    (a + c) + (b + d)
}

/// Upper factor of a block, its diagonal inverted; none if the block is not positive definite.
#[inline(always)]
fn factored([first, second, third]: &Block) -> Option<[f64; 6]> {
    let positive = |pivot: f64| (pivot > 0.0).then(|| 1.0 / pivot.sqrt());
    let r00 = positive(first.0[0])?;
    let (r01, r02) = (first.0[1] * r00, first.0[2] * r00);
    let r11 = positive(second.0[1] - r01 * r01)?;
    let r12 = (second.0[2] - r01 * r02) * r11;
    let r22 = positive(third.0[2] - r02 * r02 - r12 * r12)?;
    Some([r00, r01, r02, r11, r12, r22])
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};

    /// A matrix of this many rows of blocks, dense, positive definite within its envelope.
    fn example(ends: &[usize]) -> (Envelope, BlockMatrix, Vec<Vec<f64>>) {
        let envelope = Envelope::new(ends.iter().copied());
        let n = 3 * ends.len();
        let mut dense = vec![vec![0.0; n]; n];
        let mut matrix = BlockMatrix::default();
        matrix.fit(&envelope);
        for i in 0..ends.len() {
            for j in i..envelope.ends[i] {
                for c in 0..3 {
                    for d in 0..3 {
                        let (r, s) = (3 * i + c, 3 * j + d);
                        let entry = ((r.min(s) * 7 + r.max(s) * 3) as f64).sin() + if r == s { 40.0 } else { 0.0 };
                        (dense[r][s], dense[s][r]) = (entry, entry);
                        matrix.row_mut(&envelope, i)[j - i][c].0[d] = entry;
                    }
                }
            }
        }
        (envelope, matrix, dense)
    }

    #[test]
    fn solutions_solve() {
        for ends in [vec![1], vec![2, 2], vec![3, 3, 4, 7, 6, 7, 9, 8, 9], vec![12; 12]] {
            let (envelope, mut matrix, dense) = example(&ends);
            let exact: Vec<f64> = (0..dense.len()).map(|k| (k as f64).cos()).collect();
            let product = |row: &Vec<f64>| row.iter().zip(&exact).map(|(a, x)| a * x).sum::<f64>();
            let b: Vec<f64> = dense.iter().map(product).collect();
            let mut b: Vec<Lanes4> = b.chunks(3).map(|b| Lanes4([b[0], b[1], b[2], 0.0])).collect();
            dispatch!(Level::new(), simd => {
                assert!(BlockMatrix::factor(&mut matrix, simd, &envelope));
                BlockMatrix::solve(&matrix, simd, &envelope, &mut b);
            });
            for (k, exact) in exact.iter().enumerate() {
                assert!((b[k / 3].0[k % 3] - exact).abs() < 1e-12, "{k} of {ends:?}");
            }
        }
    }

    #[test]
    fn what_is_not_positive_definite_is_told() {
        let (envelope, mut matrix, _) = example(&[2, 2]);
        matrix.row_mut(&envelope, 1)[0][2].0[2] = -1.0;
        assert!(!dispatch!(Level::new(), simd => BlockMatrix::factor(&mut matrix, simd, &envelope)));
    }
}
