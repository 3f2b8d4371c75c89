//! Lanczos iteration: the greatest eigenvalue of a symmetric operator.
//!
//! A power iteration that uses all of its iterates, and so needs some forty products where the plain one needs hundreds
//! for 1 %.

use super::vectors::{axpy, divide, dot, norm};
use glam::DVec3;

const ITERATIONS: usize = 60;
/// The estimate is taken once it rises by less than this share over [`CHECK_EVERY`] iterations.
const SETTLED: f64 = 2e-4;
const CHECK_EVERY: usize = 8;

/// Greatest eigenvalue of the symmetric operator `apply`, from a unit vector `start` that has a part in it; none where
/// `stop`, asked before every product, says that it is no longer wanted.
pub(crate) fn greatest_eigenvalue(
    start: Vec<DVec3>,
    mut apply: impl FnMut(&[DVec3]) -> Vec<DVec3>,
    stop: &mut dyn FnMut() -> bool,
) -> Option<f64> {
    let mut before = vec![DVec3::ZERO; start.len()];
    let mut v = start;
    let (mut alphas, mut betas): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    let mut beta = 0.0;
    let mut last = 0.0;
    for iteration in 1..=ITERATIONS {
        if stop() {
            return None;
        }
        let mut w = apply(&v);
        axpy(-beta, &before, &mut w);
        let alpha = dot(&w, &v);
        axpy(-alpha, &v, &mut w);
        alphas.push(alpha);
        beta = norm(&w);
        if beta <= 1e-12 * alpha.abs() || !beta.is_finite() {
            break;
        }
        betas.push(beta);
        divide(&mut w, beta);
        before = std::mem::replace(&mut v, w);
        if iteration % CHECK_EVERY == 0 {
            let estimate = greatest_of_tridiagonal(&alphas, &betas);
            if estimate - last < SETTLED * estimate {
                break;
            }
            last = estimate;
        }
    }
    Some(greatest_of_tridiagonal(&alphas, &betas))
}

/// Greatest eigenvalue of the symmetric tridiagonal matrix with these diagonals, by bisection on Sturm counts.
fn greatest_of_tridiagonal(diagonal: &[f64], beside: &[f64]) -> f64 {
    let n = diagonal.len();
    let beside = |k: usize| beside.get(k).copied().filter(|_| k + 1 < n).unwrap_or(0.0).abs();
    let radius = |k: usize| beside(k) + if k > 0 { beside(k - 1) } else { 0.0 };
    let mut high = (0..n).map(|k| diagonal[k] + radius(k)).fold(f64::NEG_INFINITY, f64::max);
    let mut low = diagonal.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        // All eigenvalues lie below `middle` exactly if every pivot of T - middle I is negative.
        let mut pivot = diagonal[0] - middle;
        let mut all_below = pivot < 0.0;
        for k in 1..n {
            if !all_below {
                break;
            }
            pivot = diagonal[k] - middle - beside(k - 1).powi(2) / pivot;
            all_below = pivot < 0.0;
        }
        if all_below {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_greatest_eigenvalue_of_a_known_matrix() {
        // 2 on the diagonal, 1 beside it: eigenvalues 2 + 2 cos(k pi / (n + 1)).
        let n = 12;
        let found = greatest_of_tridiagonal(&vec![2.0; n], &vec![1.0; n - 1]);
        let expected = 2.0 + 2.0 * (std::f64::consts::PI / (n as f64 + 1.0)).cos();
        assert!((found - expected).abs() < 1e-12);
    }
}
