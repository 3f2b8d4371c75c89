//! Algebra of four particles at a time: every number of a vector, a matrix or a quaternion is a lane of four.
//!
//! Plain loops and no closures: a closure that is handed to the standard library (`map`, `from_fn`) is compiled without
//! the dispatched instruction set, and each of its vector operations then is a call.

use crate::solver::rotation::{LAST_STEP, LONGEST_NEWTON_STEP, nearest_rotation};
use fearless_simd::{Simd, f64x4, prelude::*};
use glam::{DMat3, DQuat, DVec3};

/// Particles side by side.
pub(in crate::solver::forces) const LANES: usize = 4;

/// A number of each of four particles, in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(32))]
pub(in crate::solver::forces) struct Lanes(pub(in crate::solver::forces) [f64; LANES]);

/// A vector of each particle.
pub(in crate::solver::forces) type Vectors<S> = [f64x4<S>; 3];
/// A matrix of each particle, by columns.
pub(super) type Matrices<S> = [Vectors<S>; 3];
/// A quaternion of each particle: x, y, z, w.
pub(super) type Quaternions<S> = [f64x4<S>; 4];

#[inline(always)]
pub(in crate::solver::forces) fn load<S: Simd>(simd: S, lanes: &Lanes) -> f64x4<S> {
    f64x4::simd_from(simd, lanes.0)
}

#[inline(always)]
pub(in crate::solver::forces) fn load_all<S: Simd, const N: usize>(simd: S, lanes: &[Lanes; N]) -> [f64x4<S>; N] {
    let mut values = [f64x4::splat(simd, 0.0); N];
    for k in 0..N {
        values[k] = load(simd, &lanes[k]);
    }
    values
}

#[inline(always)]
pub(in crate::solver::forces) fn store<S: Simd>(value: f64x4<S>) -> Lanes {
    Lanes(value.into())
}

#[inline(always)]
pub(in crate::solver::forces) fn store_all<S: Simd, const N: usize>(values: [f64x4<S>; N]) -> [Lanes; N] {
    let mut lanes = [Lanes::default(); N];
    for k in 0..N {
        lanes[k] = store(values[k]);
    }
    lanes
}

/// The same matrix for all four particles.
#[inline(always)]
pub(super) fn splat_matrix<S: Simd>(simd: S, m: &DMat3) -> Matrices<S> {
    let columns = m.to_cols_array_2d();
    let mut matrices = [[f64x4::splat(simd, 0.0); 3]; 3];
    for c in 0..3 {
        for r in 0..3 {
            matrices[c][r] = f64x4::splat(simd, columns[c][r]);
        }
    }
    matrices
}

#[inline(always)]
pub(in crate::solver::forces) fn dot<S: Simd>(a: &Vectors<S>, b: &Vectors<S>) -> f64x4<S> {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

/// `m v`.
#[inline(always)]
pub(super) fn transform<S: Simd>(m: &Matrices<S>, v: &Vectors<S>) -> Vectors<S> {
    let mut out = *v;
    for r in 0..3 {
        out[r] = m[2][r].mul_add(v[2], m[1][r].mul_add(v[1], m[0][r] * v[0]));
    }
    out
}

/// `a b`.
#[inline(always)]
pub(super) fn product<S: Simd>(a: &Matrices<S>, b: &Matrices<S>) -> Matrices<S> {
    [transform(a, &b[0]), transform(a, &b[1]), transform(a, &b[2])]
}

/// `aᵀ b`.
#[inline(always)]
pub(super) fn transposed_product<S: Simd>(a: &Matrices<S>, b: &Matrices<S>) -> Matrices<S> {
    let mut out = *b;
    for c in 0..3 {
        out[c] = [dot(&a[0], &b[c]), dot(&a[1], &b[c]), dot(&a[2], &b[c])];
    }
    out
}

/// `s v`.
#[inline(always)]
pub(in crate::solver::forces) fn scaled<S: Simd, const N: usize>(s: f64x4<S>, mut v: [f64x4<S>; N]) -> [f64x4<S>; N] {
    for k in 0..N {
        v[k] = s * v[k];
    }
    v
}

/// The matrices of unit quaternions.
#[inline(always)]
pub(super) fn turns<S: Simd>([x, y, z, w]: Quaternions<S>) -> Matrices<S> {
    let one = f64x4::splat(x.simd, 1.0);
    let (x2, y2, z2) = (x + x, y + y, z + z);
    let (xx, xy, xz) = (x * x2, x * y2, x * z2);
    let (yy, yz, zz) = (y * y2, y * z2, z * z2);
    let (wx, wy, wz) = (w * x2, w * y2, w * z2);
    [[one - (yy + zz), xy + wz, xz - wy], [xy - wz, one - (xx + zz), yz + wx], [xz + wy, yz - wx, one - (xx + yy)]]
}

/// Newton's iteration is given up for the scalar one, which takes every case, after this many steps.
const MOST_STEPS: usize = 6;
/// Error of a rotation [rad] that is no more than that of its numbers.
const ROUND_OFF: f64 = 1e-15;

/// [`nearest_rotation`] of four deformation gradients `f` from warm starts `q`.
#[inline(always)]
pub(super) fn nearest_rotations<S: Simd>(f: &Matrices<S>, q: Quaternions<S>) -> Quaternions<S> {
    match newton(f, q) {
        Some(found) => found,
        None => one_by_one(f, q),
    }
}

/// Newton's iteration on all four; none if one of them cannot be trusted to it.
#[inline(always)]
fn newton<S: Simd>(f: &Matrices<S>, mut q: Quaternions<S>) -> Option<Quaternions<S>> {
    let simd = q[0].simd;
    let (one, half, minus_half) = (f64x4::splat(simd, 1.0), f64x4::splat(simd, 0.5), f64x4::splat(simd, -0.5));
    let zero = f64x4::splat(simd, 0.0);
    let regular_from = f64x4::splat(simd, 1e-9);
    let longest = f64x4::splat(simd, 0.25 * LONGEST_NEWTON_STEP * LONGEST_NEWTON_STEP);
    let last = f64x4::splat(simd, 0.25 * LAST_STEP * LAST_STEP);
    let exact = f64x4::splat(simd, 0.25 * ROUND_OFF * ROUND_OFF);
    let mut before = zero;
    let mut s = transposed_product(&turns(q), f);
    for _ in 0..MOST_STEPS {
        let spin = [s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]];
        // tr(S) I - S, symmetric, and its adjugate.
        let (k00, k11, k22) = (s[1][1] + s[2][2], s[0][0] + s[2][2], s[0][0] + s[1][1]);
        let k01 = minus_half * (s[0][1] + s[1][0]);
        let k02 = minus_half * (s[0][2] + s[2][0]);
        let k12 = minus_half * (s[1][2] + s[2][1]);
        let a00 = k11.mul_sub(k22, k12 * k12);
        let a01 = k02.mul_sub(k12, k01 * k22);
        let a02 = k01.mul_sub(k12, k02 * k11);
        let a11 = k00.mul_sub(k22, k02 * k02);
        let a12 = k01.mul_sub(k02, k00 * k12);
        let a22 = k00.mul_sub(k11, k01 * k01);
        let determinant = dot(&[k00, k01, k02], &[a00, a01, a02]);
        let trace = k00 + k11 + k22;
        let inverse = half / determinant;
        // Half the turn of this step.
        let adjugate = [[a00, a01, a02], [a01, a11, a12], [a02, a12, a22]];
        let h = scaled(inverse, transform(&adjugate, &spin));
        let square = dot(&h, &h);
        let positive = k00.simd_gt(zero) & a22.simd_gt(zero);
        let regular = determinant.simd_gt(regular_from * trace * trace * trace);
        let near = square.simd_lt(longest);
        if (positive & regular & near).any_false() {
            return None;
        }
        let [x, y, z, w] = q;
        q = [
            z.mul_add(-h[1], y.mul_add(h[2], w.mul_add(h[0], x))),
            x.mul_add(-h[2], z.mul_add(h[0], w.mul_add(h[1], y))),
            y.mul_add(-h[0], x.mul_add(h[1], w.mul_add(h[2], z))),
            w - dot(&[x, y, z], &h),
        ];
        // The error left is to this step's square as this step is to the square of the one before.
        let exact = (square * square * square).simd_lt(exact * before * before);
        if (exact | square.simd_lt(last)).all_true() {
            let norm = q[3].mul_add(q[3], dot(&[q[0], q[1], q[2]], &[q[0], q[1], q[2]]));
            return Some(scaled(one / norm.sqrt(), q));
        }
        before = square;
        // The turn (h, 1) / sqrt(1 + h²) as a matrix, taken off S.
        let scale = one / (one + square);
        let diagonal = scale * (one - square);
        let t = scaled(scale + scale, h);
        let (t01, t02, t12) = (t[0] * h[1], t[0] * h[2], t[1] * h[2]);
        let turn = [
            [t[0].mul_add(h[0], diagonal), t01 + t[2], t02 - t[1]],
            [t01 - t[2], t[1].mul_add(h[1], diagonal), t12 + t[0]],
            [t02 + t[1], t12 - t[0], t[2].mul_add(h[2], diagonal)],
        ];
        s = transposed_product(&turn, &s);
    }
    None
}

/// The scalar iteration for each of the four: far from the start, singular, inverted.
#[cold]
#[inline(never)]
fn one_by_one<S: Simd>(f: &Matrices<S>, q: Quaternions<S>) -> Quaternions<S> {
    let simd = q[0].simd;
    let f: [[[f64; LANES]; 3]; 3] = f.map(|column| column.map(Into::into));
    let mut q: [[f64; LANES]; 4] = q.map(Into::into);
    for k in 0..LANES {
        let gradient = DMat3::from_cols_array_2d(&f.map(|column| column.map(|entry| entry[k])));
        let start = DQuat::from_array(q.map(|entry| entry[k]));
        for (entry, found) in q.iter_mut().zip(nearest_rotation(gradient, start.normalize()).to_array()) {
            entry[k] = found;
        }
    }
    q.map(|entry| f64x4::simd_from(simd, entry))
}

/// Mean of turns that lie near each other.
pub(super) fn mean_turn(turns: impl IntoIterator<Item = DQuat>) -> DQuat {
    let mut turns = turns.into_iter();
    let Some(first) = turns.next() else { return DQuat::IDENTITY };
    let sum = turns.fold(first, |sum, turn| if turn.dot(first) < 0.0 { sum - turn } else { sum + turn });
    if sum.length_squared() > 0.0 { sum.normalize() } else { first }
}

/// The vectors of four particles, one by one.
#[inline(always)]
pub(super) fn vector_of(lanes: &[Lanes; 3], lane: usize) -> DVec3 {
    DVec3::new(lanes[0].0[lane], lanes[1].0[lane], lanes[2].0[lane])
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};
    use std::array::from_fn;

    fn batch(f: &[DMat3; LANES], start: &[DQuat; LANES]) -> [DQuat; LANES] {
        #[inline(always)]
        fn run<S: Simd>(simd: S, f: &[DMat3; LANES], start: &[DQuat; LANES]) -> [DQuat; LANES] {
            let columns = f.map(|m| m.to_cols_array_2d());
            let f: Matrices<S> = from_fn(|c| from_fn(|r| f64x4::simd_from(simd, columns.map(|m| m[c][r]))));
            let start = start.map(|q| q.to_array());
            let q: Quaternions<S> = from_fn(|k| f64x4::simd_from(simd, start.map(|q| q[k])));
            let found: [[f64; LANES]; 4] = nearest_rotations(&f, q).map(Into::into);
            from_fn(|lane| DQuat::from_array(found.map(|entry| entry[lane])))
        }
        dispatch!(Level::new(), simd => run(simd, f, start))
    }

    fn sample(k: usize) -> (DMat3, DQuat) {
        let k = k as f64;
        let stretch = DMat3::from_cols_array(&[1.3, 0.1, -0.2, 0.1, 0.8, 0.05, -0.2, 0.05, 1.1]);
        let axis = DVec3::new((0.7 * k).sin(), (1.3 * k).cos(), 0.3).normalize();
        let turn = DQuat::from_axis_angle(axis, 0.1 * k);
        (DMat3::from_quat(turn) * stretch, turn)
    }

    #[test]
    fn four_rotations_are_those_of_the_scalar_iteration() {
        for k in 0..20 {
            // Near starts go through Newton's steps, far ones through the scalar iteration.
            for off in [0.0, 0.01, 0.3, 2.5] {
                let samples: [(DMat3, DQuat); LANES] = from_fn(|lane| sample(LANES * k + lane));
                let off = DQuat::from_rotation_y(off);
                let found = batch(&samples.map(|(f, _)| f), &samples.map(|(_, turn)| turn * off));
                for (found, (_, turn)) in found.into_iter().zip(samples) {
                    let error = (found - turn).length().min((found + turn).length());
                    assert!(error < 1e-14, "{k}: {error:e}");
                }
            }
        }
    }

    #[test]
    fn one_inverted_gradient_does_not_spoil_the_others() {
        let (f, turn) = sample(3);
        let inverted = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
        let found = batch(&[f, inverted, DMat3::ZERO, f], &[turn, DQuat::IDENTITY, turn, DQuat::IDENTITY]);
        assert!(found.iter().all(|q| (q.length() - 1.0).abs() < 1e-12), "{found:?}");
        for q in [found[0], found[3]] {
            assert!((q - turn).length().min((q + turn).length()) < 1e-14);
        }
    }
}
