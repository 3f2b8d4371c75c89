//! Eigenvalues of small symmetric matrices.

use glam::{DMat3, DVec3};

/// Sweeps after which a matrix of finite numbers is diagonal to round-off; five or six do it.
const SWEEPS: usize = 12;

/// Eigenvalues of a symmetric matrix, in no order, and its eigenvectors as the columns of a rotation or reflection, by
/// Jacobi's rotations: small eigenvalues come out to round-off of the largest, however many of them are alike.
pub(crate) fn eigen(matrix: DMat3) -> (DVec3, DMat3) {
    let (mut a, mut vectors) = (matrix, DMat3::IDENTITY);
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let off = a.col(p)[q];
            if off == 0.0 {
                continue;
            }
            let theta = (a.col(q)[q] - a.col(p)[p]) / (2.0 * off);
            let tangent = theta.signum() / (theta.abs() + theta.hypot(1.0));
            let cosine = 1.0 / tangent.hypot(1.0);
            let sine = tangent * cosine;
            let mut turn = DMat3::IDENTITY;
            turn.col_mut(p)[p] = cosine;
            turn.col_mut(q)[q] = cosine;
            turn.col_mut(p)[q] = -sine;
            turn.col_mut(q)[p] = sine;
            a = turn.transpose() * a * turn;
            a.col_mut(p)[q] = 0.0;
            a.col_mut(q)[p] = 0.0;
            vectors *= turn;
        }
    }
    (DVec3::new(a.x_axis.x, a.y_axis.y, a.z_axis.z), vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_of_any_rank_are_put_together_again() {
        for k in 0..200 {
            let k = f64::from(k);
            let turn = DMat3::from_euler(glam::EulerRot::XYZ, k, 0.7 * k, 1.9 * k);
            for values in [DVec3::new(3.0, 1.0, 0.2), DVec3::new(1.0, 1.0, 1e-12), DVec3::X, DVec3::ZERO, DVec3::ONE] {
                let matrix = turn * DMat3::from_diagonal(values) * turn.transpose();
                let matrix = 0.5 * (matrix + matrix.transpose());
                let (found, vectors) = eigen(matrix);
                let again = vectors * DMat3::from_diagonal(found) * vectors.transpose();
                assert!(again.abs_diff_eq(matrix, 1e-14), "{matrix} {again}");
                assert!((vectors.transpose() * vectors).abs_diff_eq(DMat3::IDENTITY, 1e-14));
                let (mut found, mut values) = (found.to_array(), values.to_array());
                found.sort_by(f64::total_cmp);
                values.sort_by(f64::total_cmp);
                assert!(DVec3::from_array(found).distance(DVec3::from_array(values)) < 1e-14);
            }
        }
    }
}
