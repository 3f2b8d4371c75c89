//! From the sums of pass 1 to stresses: the material law of the module's head, a brick at a time.

use super::brick_data::{BrickRest, BrickStress, BrickVectors, MatrixVolume};
use super::row_stencil::DeviationSums;
use crate::solver::forces::matrix::elasticity::Elasticity;
use crate::solver::wide::{Lanes4, Mat3x, Quatx, Vec3x, Wide, load_all, nearest_rotations};
use fearless_simd::{Simd, f64x4, prelude::*};
use glam::DMat3;

/// The law and the rigid turn that deviations are taken from.
pub(super) struct BrickLaw {
    pub(super) elasticity: Elasticity,
    /// Rigid turn R_b of the whole body times the stencil's axes.
    pub(super) body_turn: DMat3,
}

/// A brick as pass 1 finds it.
pub(super) struct BrickState<'a> {
    pub(super) rest: &'a BrickRest,
    pub(super) matrix: &'a MatrixVolume,
    /// Deviations u [m].
    pub(super) deviations: &'a BrickVectors,
}

impl BrickLaw {
    /// The particles' own part of their forces [N], and what their neighbours feel of them; `rotations` are those of
    /// the last evaluation, and of this one afterwards.
    #[inline(always)]
    #[allow(clippy::needless_pass_by_value, reason = "the sums lie in registers")]
    pub(super) fn finish<S: Simd>(
        &self,
        simd: S,
        brick: &BrickState<'_>,
        sums: DeviationSums<S>,
        rotations: &mut [Lanes4; 4],
    ) -> (BrickVectors, BrickStress) {
        let inverse_moment = Mat3x::symmetric(load_all(simd, &brick.rest.inverse_moment));
        let weighted_sum = Vec3x::load(simd, &brick.rest.weighted_sum);
        let weight_sum = f64x4::load(simd, &brick.rest.weight_sum);
        let u = Vec3x::load(simd, brick.deviations);
        // S = sum w u_ji and sum w u_ji (x) X_ji, of the sums over u_j.
        let sum = sums.plain - u * weight_sum;
        let moment = sums.moment - Mat3x::outer(u, weighted_sum);

        // F = R_b + G (eq. 12, with A^-1) and its rotation (in place of eq. 15's).
        let g = moment * inverse_moment;
        let deformation_gradient = Mat3x::splat(simd, &self.body_turn) + g;
        let quaternion = nearest_rotations(deformation_gradient, Quatx::load(simd, rotations));
        *rotations = quaternion.store();
        let rotation = Mat3x::from_quat(quaternion);

        // P = R (2 mu e + lambda tr(e) I) with e = sym(R^T F) - I (in place of eq. 10's). R e is F - R, because
        // R sym(R^T F) is F up to round-off.
        let Elasticity { lambda, mu, residual_penalty, sum_penalty } = self.elasticity;
        let rotated_strain = deformation_gradient - rotation;
        let strain_trace = rotation.double_dot(deformation_gradient) - f64x4::splat(simd, 3.0);
        let pressure = f64x4::splat(simd, lambda) * strain_trace;
        let stress = rotated_strain.mul_add(f64x4::splat(simd, 2.0 * mu), rotation * pressure);

        // Q = s V (P A^-1 - a G - beta L (x) b), al = s V a, Y = s V beta L, L = S - G B, b = A^-1 B.
        let matrix_volume = f64x4::load(simd, &brick.matrix.own);
        let a = f64x4::splat(simd, residual_penalty);
        let al = matrix_volume * a;
        let beta_l = (sum - g * weighted_sum) * f64x4::splat(simd, sum_penalty);
        let b = inverse_moment * weighted_sum;
        let q = (stress * inverse_moment - g * a - Mat3x::outer(beta_l, b)) * matrix_volume;
        let y = beta_l * matrix_volume;

        // Q B + al S + n Y - (sum_j w_ij al_j) u, and z = al u - Y.
        let al_around = a * f64x4::load(simd, &brick.matrix.around);
        let own = q * weighted_sum + (sum * al + y * weight_sum - u * al_around);
        let z = u * al - y;
        let [q0, q1, q2, z] = [q[0].store(), q[1].store(), q[2].store(), z.store()];
        let stress = [q0[0], q0[1], q0[2], q1[0], q1[1], q1[2], q2[0], q2[1], q2[2], z[0], z[1], z[2]];
        (own.store(), stress)
    }
}
