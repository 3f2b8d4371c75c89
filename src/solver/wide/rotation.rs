//! The rotations nearest to several deformation gradients, by the iteration of [`crate::solver::rotation`] on all at
//! once.

use super::lanes::{Lanes, Wide, quaternion_of};
use super::matrix::Mat3x;
use super::quaternion::Quatx;
use super::vector::Vec3x;
use crate::solver::rotation::{LAST_STEP, LONGEST_NEWTON_STEP, nearest_rotation};
use fearless_simd::prelude::*;
use glam::DMat3;

/// Newton's iteration is given up for the scalar one, which takes every case, after this many steps.
const MOST_STEPS: usize = 6;
/// Error of a rotation [rad] that is no more than that of its numbers.
const ROUND_OFF: f64 = 1e-15;
/// The same of short numbers.
const SHORT_ROUND_OFF: f64 = 1e-8;
/// What squares of short numbers are multiplied by before they are cubed.
const SHORT_UNIT: f64 = 1e9;
/// Angle [rad] below which the step that is taken leaves no error that short numbers hold: it is of its third power,
/// and of its square times the strain.
const LAST_SHORT_STEP: f64 = 5e-4;

/// [`nearest_rotation`] of several deformation gradients `f` from warm starts `q`.
///
/// Short numbers hold what deformation gradients are beyond the identity, and rotations near it are as exact as that.
#[inline(always)]
pub(crate) fn nearest_rotations<V: Wide>(f: Mat3x<V>, q: Quatx<V>) -> Quatx<V> {
    match newton(f, q) {
        Some(found) => found,
        None => one_by_one(&f, &q),
    }
}

/// Newton's iteration on all of them; none if one of them cannot be trusted to it.
#[inline(always)]
fn newton<V: Wide>(f: Mat3x<V>, mut q: Quatx<V>) -> Option<Quatx<V>> {
    let simd = q.0[0].token();
    let short = V::Memory::SHORT;
    let (one, half, minus_half) = (V::constant(simd, 1.0), V::constant(simd, 0.5), V::constant(simd, -0.5));
    let zero = V::constant(simd, 0.0);
    let regular_from = V::constant(simd, 1e-9);
    let longest = V::constant(simd, 0.25 * LONGEST_NEWTON_STEP * LONGEST_NEWTON_STEP);
    let (last, exact) = if short { (LAST_SHORT_STEP, SHORT_ROUND_OFF) } else { (LAST_STEP, ROUND_OFF) };
    let last = V::constant(simd, 0.25 * last * last);
    // The cube of a small square would be too small for short numbers.
    let (unit, unit_cubed) = (V::constant(simd, SHORT_UNIT), SHORT_UNIT * SHORT_UNIT * SHORT_UNIT);
    let exact = V::constant(simd, 0.25 * exact * exact * if short { unit_cubed } else { 1.0 });
    let mut before = zero;
    // S, or S less the identity where numbers are short.
    let mut s = if short {
        let turn = Mat3x::from_quat_beyond_identity(q);
        turn.transpose() + f + turn.transpose_mul(f)
    } else {
        Mat3x::from_quat(q).transpose_mul(f)
    };
    for _ in 0..MOST_STEPS {
        let spin = Vec3x([s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]]);
        // tr(S) I - S, symmetric, and its adjugate.
        let (mut k00, mut k11, mut k22) = (s[1][1] + s[2][2], s[0][0] + s[2][2], s[0][0] + s[1][1]);
        if short {
            let two = one + one;
            (k00, k11, k22) = (k00 + two, k11 + two, k22 + two);
        }
        let k01 = minus_half * (s[0][1] + s[1][0]);
        let k02 = minus_half * (s[0][2] + s[2][0]);
        let k12 = minus_half * (s[1][2] + s[2][1]);
        let a00 = k11.mul_sub(k22, k12 * k12);
        let a01 = k02.mul_sub(k12, k01 * k22);
        let a02 = k01.mul_sub(k12, k02 * k11);
        let a11 = k00.mul_sub(k22, k02 * k02);
        let a12 = k01.mul_sub(k02, k00 * k12);
        let a22 = k00.mul_sub(k11, k01 * k01);
        let determinant = Vec3x([k00, k01, k02]).dot(Vec3x([a00, a01, a02]));
        let trace = k00 + k11 + k22;
        let inverse = half / determinant;
        // Half the turn of this step.
        let h = Mat3x::symmetric([a00, a01, a02, a11, a12, a22]) * spin * inverse;
        let square = h.dot(h);
        let positive = k00.simd_gt(zero) & a22.simd_gt(zero);
        let regular = determinant.simd_gt(regular_from * trace * trace * trace);
        let near = square.simd_lt(longest);
        if (positive & regular & near).any_false() {
            return None;
        }
        q = q.turned_by(h);
        // The error left is to this step's square as this step is to the square of the one before.
        let scaled = if short { square * unit } else { square };
        let exact = (scaled * scaled * scaled).simd_lt(exact * before * before);
        if (exact | square.simd_lt(last)).all_true() {
            return Some(q.normalize());
        }
        before = square;
        // The turn (h, 1) / sqrt(1 + h²) as a matrix, taken off S.
        let scale = one / (one + square);
        let t = h * (scale + scale);
        // Of short numbers, what the turn is beyond the identity.
        let diagonal = if short { -(scale + scale) * square } else { scale * (one - square) };
        let (t01, t02, t12) = (t[0] * h[1], t[0] * h[2], t[1] * h[2]);
        let turn = Mat3x([
            Vec3x([t[0].mul_add(h[0], diagonal), t01 + t[2], t02 - t[1]]),
            Vec3x([t01 - t[2], t[1].mul_add(h[1], diagonal), t12 + t[0]]),
            Vec3x([t02 + t[1], t12 - t[0], t[2].mul_add(h[2], diagonal)]),
        ]);
        let turned = turn.transpose_mul(s);
        s = if short { turn.transpose() + s + turned } else { turned };
    }
    None
}

/// The scalar iteration for each of them: far from the start, singular, inverted.
#[cold]
#[inline(never)]
fn one_by_one<V: Wide>(f: &Mat3x<V>, q: &Quatx<V>) -> Quatx<V> {
    let simd = q.0[0].token();
    let f = f.0.map(|column| column.0.map(Wide::store));
    let mut q = q.store();
    for k in 0..V::Memory::COUNT {
        let mut gradient = DMat3::from_cols_array_2d(&f.map(|column| column.map(|entry| entry.get(k))));
        if V::Memory::SHORT {
            gradient += DMat3::IDENTITY;
        }
        let start = quaternion_of(&q, k);
        for (entry, found) in q.iter_mut().zip(nearest_rotation(gradient, start.normalize()).to_array()) {
            entry.set(k, found);
        }
    }
    Quatx::load(simd, &q)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::wide::LANES;
    use fearless_simd::{Level, Simd, dispatch, f64x4};
    use glam::{DQuat, DVec3};
    use std::array::from_fn;

    fn batch(f: &[DMat3; LANES], start: &[DQuat; LANES]) -> [DQuat; LANES] {
        #[inline(always)]
        fn run<S: Simd>(simd: S, f: &[DMat3; LANES], start: &[DQuat; LANES]) -> [DQuat; LANES] {
            let columns = f.map(|m| m.to_cols_array_2d());
            let entry = |c: usize, r: usize| f64x4::simd_from(simd, columns.map(|m| m[c][r]));
            let f = Mat3x(from_fn(|c| Vec3x(from_fn(|r| entry(c, r)))));
            let start = start.map(|q| q.to_array());
            let q = Quatx(from_fn(|k| f64x4::simd_from(simd, start.map(|q| q[k]))));
            let found: [[f64; LANES]; 4] = nearest_rotations(f, q).0.map(Into::into);
            from_fn(|lane| DQuat::from_array(found.map(|entry| entry[lane])))
        }
        dispatch!(Level::new(), simd => run(simd, f, start))
    }

    fn sample(k: usize) -> (DMat3, DQuat) {
        let k = k as f64;
        let stretch = DMat3::from_cols_array(&[1.3, 0.1, -0.2, 0.1, 0.8, 0.05, -0.2, 0.05, 1.1]);
        let axis = DVec3::new((0.7 * k).sin(), (1.3 * k).cos(), 0.3).normalize_or_zero();
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
