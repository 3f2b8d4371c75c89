//! The sparse Cholesky factor, single precision: what it leaves is found by the residual, in double.

use super::stiffness::StiffnessMatrix;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side, Spec};
use glam::{BVec3, DMat3, DVec3};
use std::sync::Arc;

/// Where the matrix of a body has entries, and how it is eliminated: the same for every step.
pub(super) struct Elimination {
    symbolic: SymbolicCholesky<u32>,
    /// Lower triangle, column by column.
    starts: Vec<u32>,
    rows: Vec<u32>,
}

/// A factored matrix.
pub(super) struct Factor {
    elimination: Arc<Elimination>,
    values: Vec<f32>,
}

/// The matrix `diagonal + K + D / h` with all but the diagonal gone along held axes.
pub(super) struct Matrix<'a> {
    pub(super) stiffness: &'a StiffnessMatrix,
    /// The stage's step h [s].
    pub(super) h: f64,
    /// What is added to every particle's own block [N/m].
    pub(super) diagonal: &'a [DMat3],
    /// Axes along which each particle is held.
    pub(super) held: &'a [BVec3],
}

impl Matrix<'_> {
    fn block(&self, place: usize) -> DMat3 {
        let damping = self.stiffness.velocities.get(place).map_or(DMat3::ZERO, |&d| d * (1.0 / self.h));
        self.stiffness.positions[place] + damping
    }

    /// Values of the lower triangle, column by column, with `shift` [N/m] more on the diagonal.
    fn lower(&self, shift: f64) -> Vec<f32> {
        let sparsity = &self.stiffness.sparsity;
        let mut values = Vec::new();
        for j in 0..sparsity.len() {
            for column in 0..3 {
                // Symmetric: column j below the diagonal is row j behind it.
                for (place, &i) in sparsity.range(j).zip(sparsity.row(j)) {
                    let i = i as usize;
                    if i < j {
                        continue;
                    }
                    let own =
                        if i == j { self.diagonal[j] + DMat3::from_diagonal(DVec3::splat(shift)) } else { DMat3::ZERO };
                    let block = self.block(place) + own;
                    let first = if i == j { column } else { 0 };
                    for row in first..3 {
                        let is_held = self.held[i].test(row) || self.held[j].test(column);
                        let off = i != j || row != column;
                        values.push(if is_held && off { 0.0 } else { block.row(column)[row] as f32 });
                    }
                }
            }
        }
        values
    }

    /// The greatest entry of the diagonal.
    fn greatest(&self) -> f64 {
        let sparsity = &self.stiffness.sparsity;
        let own = (0..sparsity.len()).map(|i| self.block(sparsity.place(i, i)) + self.diagonal[i]);
        own.map(|b| b.x_axis.x.max(b.y_axis.y).max(b.z_axis.z)).fold(0.0, f64::max)
    }
}

impl Elimination {
    /// Of matrices of this stiffness; none where it is too large to be worked on.
    pub(super) fn new(stiffness: &StiffnessMatrix) -> Option<Self> {
        let sparsity = &stiffness.sparsity;
        let (mut starts, mut rows) = (vec![0], Vec::new());
        for j in 0..sparsity.len() {
            let below = || sparsity.row(j).iter().copied().filter(|&i| i as usize >= j);
            for column in 0..3 {
                let entries = below().flat_map(|i| (0..3).map(move |row| 3 * i + row));
                rows.extend(entries.filter(|&row| row >= 3 * j as u32 + column));
                starts.push(u32::try_from(rows.len()).ok()?);
            }
        }
        let n = 3 * sparsity.len();
        let pattern = SymbolicSparseColMatRef::new_checked(n, n, &starts, None, &rows);
        let symbolic = factorize_symbolic_cholesky(
            pattern,
            Side::Lower,
            SymmetricOrdering::Amd,
            CholeskySymbolicParams::default(),
        )
        .ok()?;
        Some(Self { symbolic, starts, rows })
    }

    /// Numbers that a factor holds.
    pub(super) fn len(&self) -> usize {
        self.symbolic.len_val()
    }
}

impl Factor {
    /// Of a matrix; of one that is not positive by the least shift that makes it so. None if none does.
    pub(super) fn new(elimination: &Arc<Elimination>, matrix: &Matrix<'_>) -> Option<Self> {
        /// Shares of the greatest entry that are tried.
        const SHIFTS: [f64; 6] = [0.0, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1];
        let greatest = matrix.greatest();
        SHIFTS.iter().find_map(|share| Self::of(elimination, &matrix.lower(share * greatest)))
    }

    fn of(elimination: &Arc<Elimination>, lower: &[f32]) -> Option<Self> {
        let Elimination { symbolic, starts, rows } = &**elimination;
        let n = symbolic.nrows();
        let pattern = SymbolicSparseColMatRef::new_checked(n, n, starts, None, rows);
        let mut values = vec![0.0; elimination.len()];
        let mut memory = MemBuffer::new(symbolic.factorize_numeric_llt_scratch::<f32>(Par::Seq, Spec::default()));
        symbolic
            .factorize_numeric_llt(
                &mut values,
                SparseColMatRef::new(pattern, lower),
                Side::Lower,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                Spec::default(),
            )
            .ok()?;
        values.iter().all(|value| value.is_finite()).then(|| Self { elimination: Arc::clone(elimination), values })
    }

    /// Solves in place.
    pub(super) fn solve(&self, field: &mut [DVec3]) {
        let symbolic = &self.elimination.symbolic;
        // Single precision reaches from 1e-38 to 1e38: the field is scaled to lie well within.
        let scale = field.iter().map(|x| x.abs().max_element()).fold(0.0, f64::max);
        if scale == 0.0 {
            return;
        }
        let mut right: Vec<f32> = field.iter().flat_map(|x| (*x / scale).as_vec3().to_array()).collect();
        let mut memory = MemBuffer::new(symbolic.solve_in_place_scratch::<f32>(1, Par::Seq));
        let n = right.len();
        LltRef::new(symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(&mut right, n, 1),
            Par::Seq,
            MemStack::new(&mut memory),
        );
        for (x, found) in field.iter_mut().zip(right.chunks_exact(3)) {
            *x = scale * DVec3::new(f64::from(found[0]), f64::from(found[1]), f64::from(found[2]));
        }
    }
}
