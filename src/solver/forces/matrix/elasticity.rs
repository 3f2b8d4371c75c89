//! The material law: corotated linear elasticity.

use glam::{DMat3, DVec3};

/// Elastic constants of the matrix and the weights of its zero-energy terms, all in Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elasticity {
    /// First Lamé constant [Pa].
    pub lambda: f64,
    /// Shear modulus [Pa].
    pub mu: f64,
    /// Penalty a on each residual [Pa].
    pub residual_penalty: f64,
    /// Penalty beta on the sum of the residuals, times a length squared [Pa m²].
    pub sum_penalty: f64,
}

impl Elasticity {
    /// Constants for Young's modulus [Pa], Poisson's ratio and particle spacing [m].
    ///
    /// `a = 1.5 mu` and `beta = 3 mu D²` (less below a Poisson ratio of 0.25) keep bending and torsion of rods from
    /// three layers on within a few per cent of theory; a stiffer penalty on each residual would hide the
    /// zero-energy modes at the price of torsion 1.4 times too stiff.
    pub fn new(young_modulus: f64, poisson_ratio: f64, spacing: f64) -> Self {
        let nu = poisson_ratio;
        let mu = young_modulus / (2.0 * (1.0 + nu));
        let lambda = young_modulus * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
        let beta = if nu < 0.25 { 1.6 * (1.0 + 4.0 * nu - 4.0 * nu * nu) } else { 3.0 };
        Self { lambda, mu, residual_penalty: 1.5 * mu, sum_penalty: beta * mu * spacing * spacing }
    }

    /// The same on a lattice that is stretched by a factor along the directions in which the body is long. What
    /// residuals cost when it bends or twists, a good part of the stiffness of few layers, goes with its square.
    #[must_use]
    pub fn stretched_by(self, stretch: f64) -> Self {
        let by = stretch.powi(-2);
        Self { residual_penalty: by * self.residual_penalty, sum_penalty: by * self.sum_penalty, ..self }
    }

    /// First Piola-Kirchhoff stress `P = R (2 mu e + lambda tr(e) I)` [Pa] and energy density `e : sigma / 2` [J/m³] of
    /// a deformation gradient F with rotation R.
    pub(super) fn stress(&self, f: DMat3, r: DMat3) -> (DMat3, f64) {
        let strain = corotated_strain(f, r);
        let trace = strain.x_axis.x + strain.y_axis.y + strain.z_axis.z;
        let sigma = 2.0 * self.mu * strain + DMat3::from_diagonal(DVec3::splat(self.lambda * trace));
        let work = strain.x_axis.dot(sigma.x_axis) + strain.y_axis.dot(sigma.y_axis) + strain.z_axis.dot(sigma.z_axis);
        (r * sigma, 0.5 * work)
    }
}

/// `e = sym(R^T F) - I` of a deformation gradient F with rotation R.
pub(super) fn corotated_strain(f: DMat3, r: DMat3) -> DMat3 {
    let g = r.transpose() * f;
    0.5 * (g + g.transpose()) - DMat3::IDENTITY
}
