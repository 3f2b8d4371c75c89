//! Eigenvalues and eigenvectors of a small upper Hessenberg matrix.

use std::ops::{Add, Mul, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Complex {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
}

impl Complex {
    /// A real number.
    pub(crate) fn real(re: f64) -> Self {
        Self { re, im: 0.0 }
    }

    /// Its distance from zero.
    pub(crate) fn abs(self) -> f64 {
        self.re.hypot(self.im)
    }

    fn conj(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    fn over(self, other: Self) -> Self {
        let size = other.abs();
        let unit = Self { re: other.re / size, im: -other.im / size };
        let product = self * unit;
        Self { re: product.re / size, im: product.im / size }
    }

    fn sqrt(self) -> Self {
        let size = self.abs();
        let re = (0.5 * (size + self.re)).max(0.0).sqrt();
        let im = (0.5 * (size - self.re)).max(0.0).sqrt();
        Self { re, im: im.copysign(self.im) }
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

/// Eigenvalues of a real upper Hessenberg matrix, given row by row, by QR iterations with Wilkinson's shift.
pub(crate) fn eigenvalues(matrix: &[Vec<f64>]) -> Vec<Complex> {
    const MOST_SWEEPS: usize = 60;
    let mut h: Vec<Vec<Complex>> = matrix.iter().map(|row| row.iter().map(|&x| Complex::real(x)).collect()).collect();
    let mut found = vec![Complex::default(); h.len()];
    let mut n = h.len();
    let mut sweeps = 0;
    while n > 0 {
        let last = n - 1;
        // The block that has not come apart yet: from `first` to `last`.
        let split = |k: usize| h[k][k - 1].abs() <= 1e-15 * (h[k][k].abs() + h[k - 1][k - 1].abs());
        let first = (1..n).rev().find(|&k| split(k)).unwrap_or(0);
        if first == last || sweeps == MOST_SWEEPS {
            found[last] = h[last][last];
            n = last;
            sweeps = 0;
            continue;
        }
        sweeps += 1;
        // An exceptional shift now and then breaks cycles.
        let shift = if sweeps % 10 == 0 { h[last][last] + h[last][last - 1] } else { wilkinson(&h, last) };
        sweep(&mut h, first, last, shift);
    }
    found
}

/// The eigenvalue of the trailing 2 x 2 block nearer to its last entry.
fn wilkinson(h: &[Vec<Complex>], last: usize) -> Complex {
    let (a, b, c, d) = (h[last - 1][last - 1], h[last - 1][last], h[last][last - 1], h[last][last]);
    let half = Complex::real(0.5);
    let delta = (a - d) * half;
    let root = (delta * delta + b * c).sqrt();
    let middle = (a + d) * half;
    let (one, other) = (middle + root, middle - root);
    if (one - d).abs() < (other - d).abs() { one } else { other }
}

/// One QR step on rows and columns `first..=last` by Givens rotations.
fn sweep(h: &mut [Vec<Complex>], first: usize, last: usize, shift: Complex) {
    for k in first..=last {
        h[k][k] = h[k][k] - shift;
    }
    let mut rotations = Vec::with_capacity(last - first);
    for k in first..last {
        let (a, b) = (h[k][k], h[k + 1][k]);
        let size = a.abs().hypot(b.abs());
        let (c, s) = if size > 0.0 {
            let scale = Complex::real(1.0 / size);
            (a * scale, b * scale)
        } else {
            (Complex::real(1.0), Complex::default())
        };
        for j in k..=last {
            let (x, y) = (h[k][j], h[k + 1][j]);
            h[k][j] = c.conj() * x + s.conj() * y;
            h[k + 1][j] = c * y - s * x;
        }
        rotations.push((c, s));
    }
    for (k, (c, s)) in (first..last).zip(rotations) {
        for row in &mut h[first..=(k + 1).min(last)] {
            let (x, y) = (row[k], row[k + 1]);
            row[k] = x * c + y * s;
            row[k + 1] = y * c.conj() - x * s.conj();
        }
    }
    for k in first..=last {
        h[k][k] = h[k][k] + shift;
    }
}

/// Unit eigenvector to an eigenvalue, by inverse iteration.
pub(crate) fn eigenvector(matrix: &[Vec<f64>], value: Complex) -> Vec<Complex> {
    let n = matrix.len();
    let scale = matrix.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    // A little beside the eigenvalue, so that the system can be solved.
    let value = value + Complex { re: 1e-13 * scale, im: 1e-13 * scale };
    let mut v: Vec<Complex> = (0..n).map(|k| Complex::real(1.0 + (k as f64 * 0.7).sin())).collect();
    for _ in 0..3 {
        v = solve(matrix, value, v);
        let length = v.iter().map(|x| x.re * x.re + x.im * x.im).sum::<f64>().sqrt();
        for x in &mut v {
            *x = *x * Complex::real(1.0 / length);
        }
    }
    v
}

/// Solves `(H - value I) x = right` by elimination with row exchanges, which a Hessenberg matrix keeps to neighbours.
fn solve(matrix: &[Vec<f64>], value: Complex, mut right: Vec<Complex>) -> Vec<Complex> {
    let n = matrix.len();
    let mut a: Vec<Vec<Complex>> = matrix.iter().map(|row| row.iter().map(|&x| Complex::real(x)).collect()).collect();
    for (k, row) in a.iter_mut().enumerate() {
        row[k] = row[k] - value;
    }
    for k in 0..n.saturating_sub(1) {
        if a[k + 1][k].abs() > a[k][k].abs() {
            a.swap(k, k + 1);
            right.swap(k, k + 1);
        }
        if a[k][k].abs() == 0.0 {
            a[k][k] = Complex::real(f64::MIN_POSITIVE.sqrt());
        }
        let factor = a[k + 1][k].over(a[k][k]);
        for j in k..n {
            let above = a[k][j];
            a[k + 1][j] = a[k + 1][j] - factor * above;
        }
        right[k + 1] = right[k + 1] - factor * right[k];
    }
    for k in (0..n).rev() {
        let sum = (k + 1..n).fold(right[k], |sum, j| sum - a[k][j] * right[j]);
        let pivot = if a[k][k].abs() == 0.0 { Complex::real(f64::MIN_POSITIVE.sqrt()) } else { a[k][k] };
        right[k] = sum.over(pivot);
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A companion matrix has the roots of its polynomial as eigenvalues: (x² + 2 x + 5)(x - 3)(x + 4).
    #[test]
    fn finds_the_roots_of_a_polynomial() {
        let coefficients: [f64; 4] = [-60.0, -19.0, -5.0, 3.0];
        let mut matrix = vec![vec![0.0; 4]; 4];
        for k in 0..4 {
            matrix[k][3] = -coefficients[k];
            if k > 0 {
                matrix[k][k - 1] = 1.0;
            }
        }
        let mut found = eigenvalues(&matrix);
        found.sort_by(|a, b| a.re.total_cmp(&b.re).then(a.im.total_cmp(&b.im)));
        for (found, (re, im)) in found.iter().zip([(-4.0, 0.0), (-1.0, -2.0), (-1.0, 2.0), (3.0, 0.0)]) {
            assert!((*found - Complex { re, im }).abs() < 1e-10, "{found:?}");
            let v = eigenvector(&matrix, *found);
            for (row, x) in matrix.iter().zip(&v) {
                let product = row.iter().zip(&v).fold(Complex::default(), |sum, (&a, &v)| sum + Complex::real(a) * v);
                assert!((product - *found * *x).abs() < 1e-9, "{found:?}");
            }
        }
    }
}
