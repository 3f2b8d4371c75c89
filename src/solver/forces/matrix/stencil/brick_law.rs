//! From the sums of pass 1 to stresses: the material law of the module's head, a brick at a time.

use super::brick_data::{BrickRest, BrickStress, BrickVectors, MatrixVolume};
use super::row_stencil::DeviationSums;
use crate::solver::forces::matrix::elasticity::Elasticity;
use crate::solver::wide::{Lanes, Mat3x, Quatx, Vec3x, Wide, load_all, nearest_rotations};
use fearless_simd::Simd;
use glam::DMat3;

/// The law and the rigid turn that deviations are taken from.
pub(super) struct BrickLaw {
    pub(super) elasticity: Elasticity,
    /// Rigid turn R_b of the whole body times the stencil's axes. Short numbers are taken along these, so that they
    /// know of no turn.
    pub(super) body_turn: DMat3,
}

/// A brick as pass 1 finds it.
pub(super) struct BrickState<'a, L> {
    pub(super) rest: &'a BrickRest<L>,
    pub(super) matrix: &'a MatrixVolume<L>,
    /// Deviations u [m].
    pub(super) deviations: &'a BrickVectors<L>,
}

impl BrickLaw {
    /// The particles' own part of their forces [N], and what their neighbours feel of them; `rotations` are those of
    /// the last evaluation, and of this one afterwards.
    #[inline(always)]
    #[allow(clippy::needless_pass_by_value, reason = "the sums lie in registers")]
    pub(super) fn finish<S: Simd, L: Lanes>(
        &self,
        simd: S,
        brick: &BrickState<'_, L>,
        sums: DeviationSums<L::Register<S>>,
        rotations: &mut [L; 4],
    ) -> (BrickVectors<L>, [BrickStress<L>; 3]) {
        let inverse_moment = Mat3x::symmetric(load_all(simd, &brick.rest.inverse_moment));
        let weighted_sum = Vec3x::load(simd, &brick.rest.weighted_sum);
        let weight_sum = L::Register::load(simd, &brick.rest.weight_sum);
        let u = Vec3x::load(simd, brick.deviations);
        // S = sum w u_ji and sum w u_ji (x) X_ji, of the sums over u_j.
        let sum = sums.plain - u * weight_sum;
        let moment = sums.moment - Mat3x::outer(u, weighted_sum);

        // F = R_b + G (eq. 12, with A^-1) and its rotation (in place of eq. 15's).
        let g = moment * inverse_moment;
        let deformation_gradient = if L::SHORT { g } else { Mat3x::splat(simd, &self.body_turn) + g };
        let quaternion = nearest_rotations(deformation_gradient, Quatx::load(simd, rotations));
        *rotations = quaternion.store();
        let rotation = Mat3x::from_quat(quaternion);

        // P = R (2 mu e + lambda tr(e) I) with e = sym(R^T F) - I (in place of eq. 10's). R e is F - R, because
        // R sym(R^T F) is F up to round-off.
        let Elasticity { lambda, mu, residual_penalty, sum_penalty } = self.elasticity;
        let (rotated_strain, strain_trace) = if L::SHORT {
            // The identity is in neither F nor R, and tr(e) is R : R e.
            let rotated_strain = g - Mat3x::from_quat_beyond_identity(quaternion);
            (rotated_strain, rotation.double_dot(rotated_strain))
        } else {
            let strain_trace = rotation.double_dot(deformation_gradient) - L::Register::constant(simd, 3.0);
            (deformation_gradient - rotation, strain_trace)
        };
        let pressure = L::Register::constant(simd, lambda) * strain_trace;
        let stress = rotated_strain.mul_add(L::Register::constant(simd, 2.0 * mu), rotation * pressure);

        // Q = s V (P A^-1 - a G - beta L (x) b), al = s V a, Y = s V beta L, L = S - G B, b = A^-1 B.
        let matrix_volume = L::Register::load(simd, &brick.matrix.own);
        let a = L::Register::constant(simd, residual_penalty);
        let al = matrix_volume * a;
        let beta_l = (sum - g * weighted_sum) * L::Register::constant(simd, sum_penalty);
        let b = inverse_moment * weighted_sum;
        let q = (stress * inverse_moment - g * a - Mat3x::outer(beta_l, b)) * matrix_volume;
        let y = beta_l * matrix_volume;

        // Q B + al S + n Y - (sum_j w_ij al_j) u, and z = al u - Y.
        let al_around = a * L::Register::load(simd, &brick.matrix.around);
        let own = q * weighted_sum + (sum * al + y * weight_sum - u * al_around);
        let z = u * al - y;
        let [q0, q1, q2, z] = [q[0].store(), q[1].store(), q[2].store(), z.store()];
        let mut stress = [[L::default(); 4]; 3];
        for k in 0..3 {
            stress[k] = [q0[k], q1[k], q2[k], z[k]];
        }
        (own.store(), stress)
    }
}
