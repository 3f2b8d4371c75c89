//! Arnoldi iteration: an orthonormal basis of a Krylov space, and an operator seen in it.

use super::vectors::{axpy, divide, dot, norm};
use glam::DVec3;

/// What an operator does in the space that is spanned by a vector and what becomes of it.
#[derive(Clone, Debug)]
pub(crate) struct KrylovSpace {
    /// Orthonormal basis.
    pub basis: Vec<Vec<DVec3>>,
    /// The operator in the basis, an upper Hessenberg matrix row by row.
    pub matrix: Vec<Vec<f64>>,
    /// Length of what leads out of the space: the last entry of an eigenvector of `matrix` times this is its residual.
    pub residual: f64,
}

/// The Krylov space of the operator `apply` and a unit vector `start`, of `most` vectors at most. What is shorter than
/// a billionth of `scale` counts as rounding: the space is complete then. None where `stop`, asked before every
/// product, says that it is no longer wanted.
pub(crate) fn krylov_space(
    start: Vec<DVec3>,
    most: usize,
    scale: f64,
    mut apply: impl FnMut(&[DVec3]) -> Vec<DVec3>,
    stop: &mut dyn FnMut() -> bool,
) -> Option<KrylovSpace> {
    let mut basis = vec![start];
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut residual = 0.0;
    for k in 0..most {
        if stop() {
            return None;
        }
        let mut w = apply(&basis[k]);
        let before = norm(&w);
        let mut column = vec![0.0; k + 1];
        // Twice is enough to keep the basis orthogonal.
        for _ in 0..2 {
            for (entry, base) in column.iter_mut().zip(&basis) {
                let share = dot(&w, base);
                *entry += share;
                axpy(-share, base, &mut w);
            }
        }
        columns.push(column);
        residual = norm(&w);
        if residual <= 1e-9 * before.max(scale) || !residual.is_finite() {
            residual = 0.0;
            break;
        }
        if k + 1 < most {
            if let Some(column) = columns.last_mut() {
                column.push(residual);
            }
            divide(&mut w, residual);
            basis.push(w);
        }
    }
    let size = columns.len();
    let entry = |row: usize, column: usize| columns[column].get(row).copied().unwrap_or(0.0);
    let matrix = (0..size).map(|row| (0..size).map(|column| entry(row, column)).collect()).collect();
    Some(KrylovSpace { basis, matrix, residual })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A turn by a right angle about z and a stretch along it: three vectors span all of it, and nothing leads out.
    #[test]
    fn the_operator_is_seen_whole_in_a_complete_space() {
        let apply = |y: &[DVec3]| vec![DVec3::new(-y[0].y, y[0].x, 3.0 * y[0].z)];
        let start = vec![DVec3::new(0.6, 0.0, 0.8)];
        let KrylovSpace { basis, matrix, residual } =
            krylov_space(start, 6, 1.0, apply, &mut || false).expect("nothing stops it");
        assert_eq!((basis.len(), matrix.len(), residual), (3, 3, 0.0));
        for (k, base) in basis.iter().enumerate() {
            let image = apply(base);
            let mut seen = vec![DVec3::ZERO];
            for (row, other) in basis.iter().enumerate() {
                assert!((dot(base, other) - f64::from(u8::from(k == row))).abs() < 1e-14);
                axpy(matrix[row][k], other, &mut seen);
            }
            assert!(image[0].distance(seen[0]) < 1e-14, "{image:?}, not {seen:?}");
        }
    }
}
