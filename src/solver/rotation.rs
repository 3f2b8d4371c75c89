//! The rotation nearest to a deformation gradient (polar decomposition), by warm-started iteration.
//!
//! Newton's step solves for the small rotation that makes `S = R^T F` symmetric, `(tr S I - S) theta = vee(S - S^T)`,
//! and converges quadratically from the rotation of the step before (about two iterations). Where it cannot be trusted
//! (far away, inverted) the step of Müller et al. 2016, "A robust method to extract the rotational part of
//! deformations", takes over; it always goes downhill.

use glam::{DMat3, DQuat, DVec3};

/// Angle [rad] below which one more Newton step is exact to round-off.
pub(super) const LAST_STEP: f64 = 1e-8;
/// Newton steps longer than this [rad] are not trusted.
pub(super) const LONGEST_NEWTON_STEP: f64 = 0.5;
const MAX_ITERATIONS: usize = 100;

/// The rotation R that maximises `tr(R^T F)`, starting from `start`; R is exact to round-off.
///
/// For a singular or inverted F the result is still a proper rotation.
pub(crate) fn nearest_rotation(f: DMat3, start: DQuat) -> DQuat {
    let mut q = start;
    for _ in 0..MAX_ITERATIONS {
        let r = DMat3::from_quat(q);
        let s = r.transpose() * f;
        let spin = vee(s);
        let curvature = turn_stiffness(s);
        let newton =
            solve_positive(curvature, spin).filter(|theta| theta.length_squared() < LONGEST_NEWTON_STEP.powi(2));
        let theta = newton.unwrap_or_else(|| {
            let trace = s.x_axis.x + s.y_axis.y + s.z_axis.z;
            spin / (trace.abs() + 1e-9 * frobenius(f) + f64::MIN_POSITIVE)
        });
        q = (q * small_turn(theta)).normalize();
        if theta.length_squared() < LAST_STEP * LAST_STEP {
            break;
        }
    }
    q
}

/// The rotation R that maximises `tr(R^T F)` wherever it lies: of `near` and its half turns, the one that F is turned
/// by less than 120 degrees from is where the search begins. What F leaves open (a line's turn about itself) stays as
/// in there.
pub(super) fn rotation_of(f: DMat3, near: DQuat) -> DQuat {
    let half_turns = [DQuat::IDENTITY, DQuat::from_xyzw(1.0, 0.0, 0.0, 0.0), DQuat::from_xyzw(0.0, 1.0, 0.0, 0.0)];
    let starts = half_turns.into_iter().chain([DQuat::from_xyzw(0.0, 0.0, 1.0, 0.0)]).map(|half| near * half);
    let alike = |q: &DQuat| {
        let s = DMat3::from_quat(*q).transpose() * f;
        s.x_axis.x + s.y_axis.y + s.z_axis.z
    };
    // The first of equals, so that nothing that does not turn jumps.
    let best = starts.reduce(|best, other| if alike(&other) > alike(&best) { other } else { best });
    nearest_rotation(f, best.unwrap_or(near))
}

/// `tr(S) I - S` of the symmetric part of `s`: how the energy of a turn grows around R.
pub(crate) fn turn_stiffness(s: DMat3) -> DMat3 {
    let sym = 0.5 * (s + s.transpose());
    let trace = sym.x_axis.x + sym.y_axis.y + sym.z_axis.z;
    DMat3::from_diagonal(DVec3::splat(trace)) - sym
}

/// Axial vector of `m - m^T`.
fn vee(m: DMat3) -> DVec3 {
    DVec3::new(m.y_axis.z - m.z_axis.y, m.z_axis.x - m.x_axis.z, m.x_axis.y - m.y_axis.x)
}

/// Solves `m x = b` for a symmetric positive definite m; none if it is not.
fn solve_positive(m: DMat3, b: DVec3) -> Option<DVec3> {
    let minor = m.x_axis.x * m.y_axis.y - m.x_axis.y * m.y_axis.x;
    let x = m.y_axis.cross(m.z_axis);
    let y = m.z_axis.cross(m.x_axis);
    let z = m.x_axis.cross(m.y_axis);
    let determinant = m.x_axis.dot(x);
    let scale = frobenius(m);
    let positive = m.x_axis.x > 0.0 && minor > 0.0 && determinant > 1e-9 * scale * scale * scale;
    positive.then(|| DVec3::new(x.dot(b), y.dot(b), z.dot(b)) / determinant)
}

fn frobenius(m: DMat3) -> f64 {
    (m.x_axis.length_squared() + m.y_axis.length_squared() + m.z_axis.length_squared()).sqrt()
}

/// Unit quaternion that turns by about `theta` (exact to third order, enough for a Newton step).
fn small_turn(theta: DVec3) -> DQuat {
    let half = 0.5 * theta;
    DQuat::from_xyzw(half.x, half.y, half.z, 1.0).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recovers_the_rotation_of_a_stretched_turn_from_any_start() {
        let stretch = DMat3::from_cols_array(&[1.3, 0.1, -0.2, 0.1, 0.8, 0.05, -0.2, 0.05, 1.1]);
        for k in 0..50 {
            let axis = DVec3::new((f64::from(k) * 0.7).sin(), (f64::from(k) * 1.3).cos(), 0.3).normalize_or_zero();
            let turn = DQuat::from_axis_angle(axis, 0.06 * f64::from(k));
            let f = DMat3::from_quat(turn) * stretch;
            let found = nearest_rotation(f, DQuat::IDENTITY);
            let error = (DMat3::from_quat(found) - DMat3::from_quat(turn))
                .to_cols_array()
                .iter()
                .map(|e| e.abs())
                .fold(0.0, f64::max);
            assert!(error < 1e-14, "{k}: {error}");
        }
    }

    #[test]
    fn a_warm_start_does_not_change_the_result() {
        let f = DMat3::from_cols_array(&[0.9, 0.3, -0.2, -0.4, 1.2, 0.1, 0.0, 0.2, 1.1]);
        let cold = nearest_rotation(f, DQuat::IDENTITY);
        let warm = nearest_rotation(f, DQuat::from_rotation_x(0.2) * cold);
        assert!((cold - warm).length().min((cold + warm).length()) < 1e-15);
    }

    #[test]
    fn a_turn_is_found_from_its_opposite_too() {
        let stretch = DMat3::from_cols_array(&[1.3, 0.1, -0.2, 0.1, 0.8, 0.05, -0.2, 0.05, 1.1]);
        let opposite = DQuat::from_rotation_z(std::f64::consts::PI);
        for turn in [DQuat::IDENTITY, DQuat::from_rotation_x(0.3), DQuat::from_rotation_y(std::f64::consts::PI)] {
            let found = rotation_of(DMat3::from_quat(turn) * stretch, turn * opposite);
            assert!((DMat3::from_quat(found) - DMat3::from_quat(turn)).abs_diff_eq(DMat3::ZERO, 1e-14), "{turn}");
            // A line does not say how it is turned about itself.
            let line = DMat3::from_cols(turn * DVec3::X, DVec3::ZERO, DVec3::ZERO);
            let found = rotation_of(line, turn);
            assert!((found * DVec3::Y).distance(turn * DVec3::Y) < 1e-14, "{turn}");
        }
    }

    #[test]
    fn singular_and_inverted_gradients_give_proper_rotations() {
        for f in [
            DMat3::ZERO,
            DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0)),
            DMat3::from_diagonal(DVec3::new(1.0, 0.0, 0.0)),
        ] {
            let q = nearest_rotation(f, DQuat::IDENTITY);
            assert!((q.length() - 1.0).abs() < 1e-12 && q.is_finite());
        }
    }
}
