//! What a material particle does that is not elastic: how it yields and creeps, and how it resists being strained fast.

use crate::solver::rotation::turn_stiffness;
use glam::{DMat3, DVec3};

/// Resistance of the matrix against being strained fast (Kelvin and Voigt).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Viscosity {
    /// Against a change of shape [Pa s].
    pub(crate) shear: f64,
    /// Against a change of volume [Pa s].
    pub(crate) bulk: f64,
}

impl Viscosity {
    /// `sigma = 2 eta dev S' + eta_v tr S' I` [Pa] of a rate of stretch S' [1/s].
    pub(super) fn stress(self, rate: DMat3) -> DMat3 {
        2.0 * self.shear * deviator(rate) + DMat3::from_diagonal(DVec3::splat(self.bulk * trace(rate)))
    }
}

/// Yield of the matrix (von Mises), with hardening and creep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Plasticity {
    /// Stress at which a pulled bar yields [Pa].
    pub(crate) yield_stress: f64,
    /// By how much that grows with the plastic strain [Pa].
    pub(crate) hardening: f64,
    /// Time in which a stress above it fades [s]; at once where zero.
    pub(crate) creep_time: f64,
}

/// What has yielded at one particle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PlasticStrain {
    /// Symmetric and without a trace, in the frame that turns with the material: xx, yy, zz, xy, yz, zx.
    strain: [f64; 6],
    /// All that it has yielded, there and back, as the equivalent strain of a pulled bar.
    pub(crate) equivalent: f64,
}

/// Plastic strain (its norm) beyond which a particle no longer yields: the small-strain law has no meaning further on.
const MOST: f64 = 0.3;

impl PlasticStrain {
    pub(super) fn matrix(&self) -> DMat3 {
        let [xx, yy, zz, xy, yz, zx] = self.strain;
        DMat3::from_cols(DVec3::new(xx, xy, zx), DVec3::new(xy, yy, yz), DVec3::new(zx, yz, zz))
    }

    /// Yields over `dt` [s] under a strain of the rotated frame, in a material of shear modulus `mu` [Pa]; the elastic
    /// energy that goes [J/m³].
    pub(super) fn yields(&mut self, strain: DMat3, mu: f64, law: &Plasticity, dt: f64) -> f64 {
        let elastic = deviator(strain) - self.matrix();
        let trial = 2.0 * mu * norm(elastic);
        let root = (2.0_f64 / 3.0).sqrt();
        let beyond = trial - root * (law.yield_stress + law.hardening * self.equivalent);
        if beyond <= 0.0 {
            return 0.0;
        }
        // Radial return: what is left of the excess after `dt` fades with the creep time.
        let faded = if law.creep_time > 0.0 { -(-dt / law.creep_time).exp_m1() } else { 1.0 };
        let slip = faded * beyond / (2.0 * mu + law.hardening / 1.5);
        let yielded = self.matrix() + elastic * (slip * 2.0 * mu / trial);
        if norm(yielded) > MOST {
            return 0.0;
        }
        let DMat3 { x_axis: x, y_axis: y, z_axis: z } = yielded;
        self.strain = [x.x, y.y, z.z, x.y, y.z, z.x];
        self.equivalent += root * slip;
        let left = trial - 2.0 * mu * slip;
        (trial * trial - left * left) / (4.0 * mu)
    }
}

/// The k by which a stress sigma that does not lie along the stretch S is completed, `P = R (sigma + [k]x)`: what turns
/// R takes its part, too, and no torque is left.
pub(super) fn turning_part(stretch: DMat3, sigma: DMat3, inverse: DMat3) -> DVec3 {
    inverse * vee(stretch * sigma)
}

/// `(tr S I - S)^-1`; zero where a neighbourhood is so far turned over that it has none.
pub(super) fn turn_compliance(stretch: DMat3) -> DMat3 {
    let stiffness = turn_stiffness(stretch);
    if stiffness.determinant() > 1e-9 { stiffness.inverse() } else { DMat3::ZERO }
}

/// Axial vector of `m - m^T`.
pub(super) fn vee(m: DMat3) -> DVec3 {
    DVec3::new(m.y_axis.z - m.z_axis.y, m.z_axis.x - m.x_axis.z, m.x_axis.y - m.y_axis.x)
}

/// The matrix that takes a vector v to `a x v`.
pub(super) fn crossing(a: DVec3) -> DMat3 {
    DMat3::from_cols(a.cross(DVec3::X), a.cross(DVec3::Y), a.cross(DVec3::Z))
}

pub(super) fn trace(m: DMat3) -> f64 {
    m.x_axis.x + m.y_axis.y + m.z_axis.z
}

pub(super) fn deviator(m: DMat3) -> DMat3 {
    m - DMat3::from_diagonal(DVec3::splat(trace(m) / 3.0))
}

/// `a : b`.
pub(super) fn double_dot(a: DMat3, b: DMat3) -> f64 {
    a.x_axis.dot(b.x_axis) + a.y_axis.dot(b.y_axis) + a.z_axis.dot(b.z_axis)
}

fn norm(m: DMat3) -> f64 {
    double_dot(m, m).sqrt()
}
