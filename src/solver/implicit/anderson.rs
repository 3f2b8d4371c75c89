//! Anderson's acceleration of a fixed-point iteration.

use crate::solver::linear_algebra::vectors::{axpy, dot};
use glam::DVec3;

/// Steps that are remembered.
const MEMORY: usize = 5;

/// What the last steps of an iteration `x := x + p(x)` tell about the next.
#[derive(Debug, Default)]
pub(super) struct Anderson {
    /// The x and p of the step before.
    last: Option<[Vec<DVec3>; 2]>,
    /// Differences of x and of p from step to step, the newest last.
    differences: Vec<[Vec<DVec3>; 2]>,
}

impl Anderson {
    /// Forgets everything.
    pub(super) fn clear(&mut self) {
        self.last = None;
        self.differences.clear();
    }

    /// From `x`, whose plain step is `p`, the step that is taken instead: of all combinations of what is remembered the
    /// one whose own step would be least, were the iteration linear.
    pub(super) fn step(&mut self, x: &[DVec3], p: &[DVec3]) -> Vec<DVec3> {
        if let Some([last_x, last_p]) = self.last.take() {
            if self.differences.len() == MEMORY {
                self.differences.remove(0);
            }
            let minus = |a: &[DVec3], b: Vec<DVec3>| a.iter().zip(b).map(|(&a, b)| a - b).collect();
            self.differences.push([minus(x, last_x), minus(p, last_p)]);
        }
        self.last = Some([x.to_vec(), p.to_vec()]);
        let mut step = p.to_vec();
        let gram: Vec<Vec<f64>> =
            self.differences.iter().map(|a| self.differences.iter().map(|b| dot(&a[1], &b[1])).collect()).collect();
        let right = self.differences.iter().map(|a| dot(&a[1], p)).collect();
        for (share, [of_x, of_p]) in least_squares(gram, right).into_iter().zip(&self.differences) {
            axpy(-share, of_x, &mut step);
            axpy(-share, of_p, &mut step);
        }
        step
    }
}

/// Solves the small positive system of a least-squares problem, by elimination without exchanges; what is not told
/// apart from round-off gets no share.
fn least_squares(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    let before: Vec<f64> = (0..n).map(|k| a[k][k]).collect();
    // The newest difference says most: it is eliminated first.
    let mut used = vec![false; n];
    for k in (0..n).rev() {
        if a[k][k] <= 1e-10 * before[k] || before[k] == 0.0 {
            continue;
        }
        used[k] = true;
        for row in 0..k {
            let share = a[row][k] / a[k][k];
            for column in 0..=k {
                a[row][column] -= share * a[k][column];
            }
            b[row] -= share * b[k];
        }
    }
    let mut x = vec![0.0; n];
    for k in 0..n {
        if used[k] {
            let known: f64 = (0..k).map(|j| a[k][j] * x[j]).sum();
            x[k] = (b[k] - known) / a[k][k];
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_iteration_of_few_directions_ends_exactly() {
        // p(x) = B (target - x) with three different rates, one of them far from converging by itself.
        let target = DVec3::new(1.0, -2.0, 0.5);
        let rates = DVec3::new(1.0, 0.1, 7.0);
        let (mut anderson, mut x) = (Anderson::default(), vec![DVec3::ZERO]);
        for _ in 0..5 {
            let p = [rates * (target - x[0])];
            let step = anderson.step(&x, &p);
            x[0] += step[0];
        }
        assert!(x[0].distance(target) < 1e-9, "{}", x[0]);
    }

    #[test]
    fn what_was_said_twice_counts_once() {
        let found = least_squares(vec![vec![1.0, 1.0], vec![1.0, 1.0]], vec![3.0, 3.0]);
        assert_eq!(found, [0.0, 3.0]);
    }
}
