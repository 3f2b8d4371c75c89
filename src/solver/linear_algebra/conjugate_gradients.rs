//! Conjugate gradients, preconditioned with a diagonal.

use super::vectors::{axpy, dot};
use glam::DVec3;

/// Solves `A x = right` for a symmetric positive definite A, given by `apply`, into `x`. The preconditioner is the
/// `diagonal`, one positive number a particle; it ends once the residual has fallen to `tolerance` of what it was, in the
/// preconditioner's norm, or after `most` steps.
///
/// Where A turns out not to be positive along a direction, x is what has been found so far, or the right side over the
/// diagonal if nothing has.
pub(crate) fn conjugate_gradients(
    right: &[DVec3],
    diagonal: &[f64],
    tolerance: f64,
    most: usize,
    x: &mut Vec<DVec3>,
    mut apply: impl FnMut(&[DVec3]) -> Vec<DVec3>,
) {
    let precondition = |r: &[DVec3]| -> Vec<DVec3> { r.iter().zip(diagonal).map(|(&r, &d)| r / d).collect() };
    x.clear();
    x.resize(right.len(), DVec3::ZERO);
    let mut r = right.to_vec();
    let mut z = precondition(&r);
    let mut p = z.clone();
    let mut rz = dot(&r, &z);
    let enough = tolerance * tolerance * rz;
    for _ in 0..most {
        if rz <= enough || rz == 0.0 {
            break;
        }
        let product = apply(&p);
        let curvature = dot(&p, &product);
        if curvature <= 0.0 {
            if dot(x, x) == 0.0 {
                x.clone_from(&z);
            }
            break;
        }
        let step = rz / curvature;
        axpy(step, &p, x);
        axpy(-step, &product, &mut r);
        z = precondition(&r);
        let next = dot(&r, &z);
        let share = next / rz;
        for (p, &z) in p.iter_mut().zip(&z) {
            *p = z + share * *p;
        }
        rz = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of springs, held at both ends.
    fn chain(x: &[DVec3]) -> Vec<DVec3> {
        let at = |i: Option<usize>| i.and_then(|i| x.get(i)).copied().unwrap_or_default();
        (0..x.len()).map(|i| 2.5 * x[i] - at(i.checked_sub(1)) - at(Some(i + 1))).collect()
    }

    #[test]
    fn solves_a_chain() {
        let expected: Vec<DVec3> = (0..40).map(|i| DVec3::new(f64::from(i).sin(), 1.0, f64::from(i))).collect();
        let right = chain(&expected);
        let mut found = Vec::new();
        conjugate_gradients(&right, &[2.5; 40], 1e-12, 200, &mut found, chain);
        for (found, expected) in found.iter().zip(&expected) {
            assert!(found.distance(*expected) < 1e-9, "{found}, not {expected}");
        }
    }

    #[test]
    fn goes_along_the_right_side_where_the_operator_is_negative() {
        let right = [DVec3::X, DVec3::Y];
        let mut found = Vec::new();
        let negative = |x: &[DVec3]| x.iter().map(|&x| -x).collect();
        conjugate_gradients(&right, &[2.0, 4.0], 1e-12, 200, &mut found, negative);
        assert_eq!(found, [0.5 * DVec3::X, 0.25 * DVec3::Y]);
    }
}
