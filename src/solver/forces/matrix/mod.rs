//! The matrix: corotated linear elasticity on meshfree particles (sec. 4.2), in a conservative form.
//!
//! The paper takes the rotation from eq. 15 and the strain from eq. 12 without correction; the force then is not the
//! gradient of any energy, and linear deformations are wrong by 3 % inside and up to 73 % at corners. Here, with
//! `x_ji = x_j - x_i`, capital letters at rest, and `w_ij = -V W'(r) / r`:
//!
//! - `F_i = (sum x_ji (x) w_ij X_ji) A_i^-1`, exact for linear deformations;
//! - `R_i = polar(F_i)`, `e = sym(R^T F) - I`, `P = R (2 mu e + lambda tr(e) I)`;
//! - residuals `d_ij = x_ji - F_i X_ji` and their sum `L_i = sum w_ij d_ij`, which no F sees (zero-energy modes);
//! - `E_i = s_i V [e : sigma / 2 + a/2 sum w_ij |d_ij|² + beta/2 |L_i|²]`, `s_i` the share of matrix at i.
//!
//! Its exact gradient is the sum over pairs of `t_ij = s_i V w_ij [P A^-1 X + a d + beta (1 - b . X) L]` with
//! `b_i = A_i^-1 B_i`, added to i and taken from j: `sum_j w d (x) X = 0` makes every other term vanish.
//!
//! It is evaluated on the deviation `u = x - R_b X` from a rigid turn R_b of the whole body, because terms of the size
//! of the rest shape would otherwise cancel only to round-off and leak momentum. With `G = F - R_b`,
//! `Q = s V (P A^-1 - a G - beta L (x) b)`, `al = s V a`, `Y = s V beta L`, gathered at each particle:
//!
//! `f_i = Q_i B_i + al_i S_i + (sum w) Y_i + sum_j w_ij (Q_j X_ji + al_j u_ji - Y_j)`, `S_i = sum w_ij u_ji`.
//!
//! Two passes over the neighbours, by either of two kernels that give the same forces up to round-off:
//!
//! - *stencil*, for particles on a lattice: an offset there has the same weight all over the body, so that whole rows of
//!   particles are added at a time, without looking any neighbour up. The one in use wherever it can be.
//! - *pair list*: particle by particle through its neighbours, four to five times slower. It takes any spacing, says in few lines
//!   what is computed, and is what the stencil is held against.

mod equivalent;
pub(super) mod lanes;
mod layout;
mod pairs;
mod rest;
mod rows;
mod stencil;

use super::Force;
use crate::solver::energy::Energies;
use crate::solver::neighbourhood::{Neighbourhood, outer};
use crate::solver::rotation::nearest_rotation;
use crate::solver::state::ParticleState;
use glam::{DMat3, DQuat, DVec3};
use pairs::PairList;
use rayon::prelude::*;
use std::sync::Arc;
use stencil::Stencil;

/// Particles whose energy a thread computes at a time.
const CHUNK: usize = 128;

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

    /// First Piola-Kirchhoff stress P [Pa] and energy density [J/m³] of a deformation gradient with rotation `r`.
    fn stress(&self, f: DMat3, r: DMat3) -> (DMat3, f64) {
        let g = r.transpose() * f;
        let strain = 0.5 * (g + g.transpose()) - DMat3::IDENTITY;
        let trace = strain.x_axis.x + strain.y_axis.y + strain.z_axis.z;
        let sigma = 2.0 * self.mu * strain + DMat3::from_diagonal(DVec3::splat(self.lambda * trace));
        let work = strain.x_axis.dot(sigma.x_axis) + strain.y_axis.dot(sigma.y_axis) + strain.z_axis.dot(sigma.z_axis);
        (r * sigma, 0.5 * work)
    }
}

/// Elastic force of the matrix.
#[derive(Clone)]
pub struct MatrixForce {
    matter: Matter,
    kernel: Kernel,
}

/// What the force is made of, whichever way it is computed.
#[derive(Clone)]
struct Matter {
    neighbourhood: Arc<Neighbourhood>,
    /// Rest positions [m], model frame.
    rest: Arc<[DVec3]>,
    elasticity: Elasticity,
    /// Volume of a particle [m³].
    volume: f64,
    /// Share of matrix at every particle, `1 - l_i`.
    share: Arc<[f64]>,
}

/// How the sums over neighbours are computed, with warm starts and buffers kept between evaluations.
#[derive(Clone)]
enum Kernel {
    Stencil(Stencil),
    Pairs(PairList),
}

impl MatrixForce {
    /// Elastic force over rest neighbourhoods of particles at `rest` [m] (model frame); `volume` is a particle's [m³],
    /// `share` the fraction of matrix at every particle, `orientation` the turn of the model frame in the world at the
    /// start.
    pub fn new(
        neighbourhood: Arc<Neighbourhood>,
        rest: Arc<[DVec3]>,
        elasticity: Elasticity,
        volume: f64,
        share: Arc<[f64]>,
        orientation: DQuat,
    ) -> Self {
        let matter = Matter { neighbourhood, rest, elasticity, volume, share };
        let kernel = match Stencil::new(&matter, orientation) {
            Some(stencil) => Kernel::Stencil(stencil),
            None => Kernel::Pairs(PairList::new(vec![orientation; matter.rest.len()])),
        };
        Self { matter, kernel }
    }

    /// The same force, computed from the pair list: slower, for comparison.
    #[must_use]
    pub fn with_pair_list(self) -> Self {
        let rotations = (0..self.matter.rest.len()).map(|i| self.rotation(i)).collect();
        Self { kernel: Kernel::Pairs(PairList::new(rotations)), matter: self.matter }
    }

    /// Memory of the rest data, which copies share [bytes].
    pub(in crate::solver) fn shared_bytes(&self) -> usize {
        self.matter.neighbourhood.bytes() + size_of_val(&*self.matter.rest) + size_of_val(&*self.matter.share)
    }

    /// Whether it is computed by a stencil, not from the pair list.
    pub fn is_stencil(&self) -> bool {
        matches!(self.kernel, Kernel::Stencil(_))
    }

    /// Rotation of particle i at the last evaluation.
    fn rotation(&self, i: usize) -> DQuat {
        match &self.kernel {
            Kernel::Stencil(stencil) => stencil.rotation(i),
            Kernel::Pairs(pairs) => pairs.rotation(i),
        }
    }
}

impl Matter {
    /// Deformation gradient of particle i and the sum of its residuals, by the plain sums.
    fn gradient(&self, i: usize, positions: &[DVec3]) -> (DMat3, DVec3) {
        let (mut moment, mut sum) = (DMat3::ZERO, DVec3::ZERO);
        for (j, bond) in self.neighbourhood.bonds(i) {
            let x = positions[j] - positions[i];
            moment += outer(x, bond.weighted_offset);
            sum += bond.weight * x;
        }
        let f = moment * self.neighbourhood.inverse_moment[i];
        (f, sum - f * self.neighbourhood.weighted_sum[i])
    }

    /// Elastic and zero-energy energy of particle i [J].
    fn energy(&self, i: usize, positions: &[DVec3], start: DQuat) -> (f64, f64) {
        let Elasticity { residual_penalty: a, sum_penalty: beta, .. } = self.elasticity;
        let (f, residual_sum) = self.gradient(i, positions);
        let rotation = nearest_rotation(f, start);
        let (_, density) = self.elasticity.stress(f, DMat3::from_quat(rotation));
        let offsets = self.neighbourhood.offsets(i);
        let residuals: f64 = self
            .neighbourhood
            .bonds(i)
            .zip(offsets)
            .map(|((j, bond), (_, offset))| bond.weight * (positions[j] - positions[i] - f * offset).length_squared())
            .sum();
        let scale = self.share[i] * self.volume;
        (scale * density, 0.5 * scale * (a * residuals + beta * residual_sum.length_squared()))
    }
}

impl Force for MatrixForce {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        match &mut self.kernel {
            Kernel::Stencil(stencil) => stencil.add_forces(&self.matter, state, forces),
            Kernel::Pairs(pairs) => pairs.add_forces(&self.matter, state, forces),
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        // Collected in order, then summed in order: the same bits on any number of threads.
        let each: Vec<(f64, f64)> = (0..state.len())
            .into_par_iter()
            .with_min_len(CHUNK)
            .map(|i| self.matter.energy(i, &state.positions, self.rotation(i)))
            .collect();
        for (matrix, zero_energy) in each {
            energies.matrix += matrix;
            energies.zero_energy += zero_energy;
        }
    }

    fn name(&self) -> &'static str {
        "matrix"
    }

    fn matrix(&self) -> Option<&MatrixForce> {
        Some(self)
    }

    fn bytes(&self) -> usize {
        let rotations = match &self.kernel {
            Kernel::Stencil(stencil) => stencil.bytes(),
            Kernel::Pairs(pairs) => pairs.bytes(),
        };
        size_of_val(self) + rotations
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
