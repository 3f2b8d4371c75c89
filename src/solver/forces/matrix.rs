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
//! Two passes over the neighbours, each in four-wide vectors.

use super::Force;
use crate::solver::energy::Energies;
use crate::solver::neighbourhood::{Neighbourhood, outer};
use crate::solver::rotation::nearest_rotation;
use crate::solver::state::ParticleState;
use fearless_simd::{Level, Simd, dispatch, f64x4, prelude::*};
use glam::{DMat3, DQuat, DVec3};
use rayon::prelude::*;
use std::sync::Arc;

/// Particles a thread works on at a time; a body of fewer than [`PARALLEL_FROM`] stays on one thread.
const CHUNK: usize = 128;
const PARALLEL_FROM: usize = 512;

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
    neighbourhood: Arc<Neighbourhood>,
    /// Rest positions [m], model frame.
    rest: Arc<[DVec3]>,
    elasticity: Elasticity,
    volume: f64,
    /// Share of matrix at every particle, `1 - l_i`.
    share: Arc<[f64]>,
    level: Level,
    scratch: Scratch,
}

/// Kept between evaluations: warm starts and buffers.
#[derive(Clone, Default)]
struct Scratch {
    rotations: Vec<DQuat>,
    deviations: Vec<[f64; 4]>,
    fields: Vec<Field>,
    own: Vec<DVec3>,
}

/// What a particle offers its neighbours: the columns of Q, then Y with `al` in the fourth lane.
#[derive(Clone, Copy, Default)]
#[repr(C, align(32))]
struct Field([[f64; 4]; 4]);

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
        let n = neighbourhood.len();
        Self {
            neighbourhood,
            rest,
            elasticity,
            volume,
            share,
            level: Level::new(),
            scratch: Scratch {
                rotations: vec![orientation; n],
                deviations: vec![[0.0; 4]; n],
                fields: vec![Field::default(); n],
                own: vec![DVec3::ZERO; n],
            },
        }
    }

    /// Deformation gradient of particle i, by the plain sums; the evaluation itself works four-wide.
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
}

/// What the first pass writes for some consecutive particles.
type FirstChunk<'a> = ((&'a mut [DQuat], &'a mut [Field]), &'a mut [DVec3]);

/// Read-only part of an evaluation, shared by all threads.
struct Pass<'a> {
    neighbourhood: &'a Neighbourhood,
    elasticity: Elasticity,
    volume: f64,
    share: &'a [f64],
    /// Rigid turn R_b of the whole body, and every particle's deviation u from it [m].
    body_turn: DMat3,
    deviations: &'a [[f64; 4]],
}

impl Pass<'_> {
    /// Pass 1: deformation gradient, rotation and stress of the particles from `first` on.
    #[inline(always)]
    fn stresses<S: Simd>(
        &self,
        simd: S,
        first: usize,
        rotations: &mut [DQuat],
        fields: &mut [Field],
        own: &mut [DVec3],
    ) {
        let rest = self.neighbourhood;
        for (k, rotation) in rotations.iter_mut().enumerate() {
            let i = first + k;
            let here = f64x4::simd_from(simd, self.deviations[i]);
            let zero = f64x4::splat(simd, 0.0);
            let (mut c0, mut c1, mut c2, mut sum) = (zero, zero, zero, zero);
            for (j, bond) in rest.bonds(i) {
                let u = f64x4::simd_from(simd, self.deviations[j]) - here;
                c0 = u.mul_add(f64x4::splat(simd, bond.weighted_offset.x), c0);
                c1 = u.mul_add(f64x4::splat(simd, bond.weighted_offset.y), c1);
                c2 = u.mul_add(f64x4::splat(simd, bond.weighted_offset.z), c2);
                sum = u.mul_add(f64x4::splat(simd, bond.weight), sum);
            }
            let moment = DMat3::from_cols(vec3(c0), vec3(c1), vec3(c2));
            let (field, base) = self.finish(i, moment, vec3(sum), rotation);
            fields[k] = field;
            own[k] = base;
        }
    }

    /// Stress and what follows from it, once the sums of pass 1 are there.
    #[inline]
    fn finish(&self, i: usize, moment: DMat3, sum: DVec3, rotation: &mut DQuat) -> (Field, DVec3) {
        let rest = self.neighbourhood;
        let inverse = rest.inverse_moment[i];
        let weighted_sum = rest.weighted_sum[i];
        let g = moment * inverse;
        let f = self.body_turn + g;
        let residual_sum = sum - g * weighted_sum;
        *rotation = nearest_rotation(f, *rotation);
        let (stress, _) = self.elasticity.stress(f, DMat3::from_quat(*rotation));
        let scale = self.share[i] * self.volume;
        let Elasticity { residual_penalty: a, sum_penalty: beta, .. } = self.elasticity;
        let q = scale * (stress * inverse - a * g - beta * outer(residual_sum, inverse * weighted_sum));
        let y = scale * beta * residual_sum;
        let al = scale * a;
        let columns = q.to_cols_array_2d();
        let [q0, q1, q2] = columns.map(|[x, y, z]| [x, y, z, 0.0]);
        let own = q * weighted_sum + al * sum + rest.weight_sum[i] * y;
        (Field([q0, q1, q2, [y.x, y.y, y.z, al]]), own)
    }

    /// Pass 2: forces on the particles from `first` on.
    #[inline(always)]
    fn gather<S: Simd>(&self, simd: S, first: usize, fields: &[Field], own: &[DVec3], forces: &mut [DVec3]) {
        for (k, force) in forces.iter_mut().enumerate() {
            let i = first + k;
            let here = f64x4::simd_from(simd, self.deviations[i]);
            let zero = f64x4::splat(simd, 0.0);
            let (mut sum, mut sum2) = (zero, zero);
            for (j, bond) in self.neighbourhood.bonds(i) {
                let [q0, q1, q2, y] = &fields[j].0;
                let u = f64x4::simd_from(simd, self.deviations[j]) - here;
                sum = f64x4::simd_from(simd, *q0).mul_add(f64x4::splat(simd, bond.weighted_offset.x), sum);
                sum2 = f64x4::simd_from(simd, *q1).mul_add(f64x4::splat(simd, bond.weighted_offset.y), sum2);
                sum = f64x4::simd_from(simd, *q2).mul_add(f64x4::splat(simd, bond.weighted_offset.z), sum);
                let rest = u * f64x4::splat(simd, y[3]) - f64x4::simd_from(simd, *y);
                sum2 = rest.mul_add(f64x4::splat(simd, bond.weight), sum2);
            }
            *force += own[k] + vec3(sum + sum2);
        }
    }
}

/// Mean of turns that lie near each other.
fn mean_turn(turns: &[DQuat]) -> DQuat {
    let Some(&first) = turns.first() else { return DQuat::IDENTITY };
    let sum = turns.iter().fold(DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0), |sum, &turn| {
        if turn.dot(first) < 0.0 { sum - turn } else { sum + turn }
    });
    if sum.length_squared() > 0.0 { sum.normalize() } else { first }
}

#[inline(always)]
fn vec3<S: Simd>(v: f64x4<S>) -> DVec3 {
    let [x, y, z, _]: [f64; 4] = v.into();
    DVec3::new(x, y, z)
}

impl Force for MatrixForce {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let Scratch { rotations, deviations, fields, own } = &mut self.scratch;
        let body_turn = DMat3::from_quat(mean_turn(rotations));
        for (deviation, (&x, &rest)) in deviations.iter_mut().zip(state.positions.iter().zip(self.rest.iter())) {
            // Differences to particle 0 first: they are exact far from the origin, too.
            let u = (x - state.positions[0]) - body_turn * (rest - self.rest[0]);
            *deviation = [u.x, u.y, u.z, 0.0];
        }
        let pass = Pass {
            neighbourhood: &self.neighbourhood,
            elasticity: self.elasticity,
            volume: self.volume,
            share: &self.share,
            body_turn,
            deviations,
        };
        let level = self.level;
        let first_pass = |(chunk, ((rotations, fields), own)): (usize, FirstChunk<'_>)| {
            dispatch!(level, simd => pass.stresses(simd, chunk * CHUNK, rotations, fields, own));
        };
        let parallel = rotations.len() >= PARALLEL_FROM;
        if parallel {
            rotations
                .par_chunks_mut(CHUNK)
                .zip(fields.par_chunks_mut(CHUNK))
                .zip(own.par_chunks_mut(CHUNK))
                .enumerate()
                .for_each(first_pass);
        } else {
            rotations
                .chunks_mut(CHUNK)
                .zip(fields.chunks_mut(CHUNK))
                .zip(own.chunks_mut(CHUNK))
                .enumerate()
                .for_each(first_pass);
        }
        let fields: &[Field] = fields;
        let second_pass = |(chunk, (own, forces)): (usize, (&[DVec3], &mut [DVec3]))| {
            dispatch!(level, simd => pass.gather(simd, chunk * CHUNK, fields, own, forces));
        };
        if parallel {
            own.par_chunks(CHUNK).zip(forces.par_chunks_mut(CHUNK)).enumerate().for_each(second_pass);
        } else {
            own.chunks(CHUNK).zip(forces.chunks_mut(CHUNK)).enumerate().for_each(second_pass);
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        let Elasticity { residual_penalty: a, sum_penalty: beta, .. } = self.elasticity;
        // Collected in order, then summed in order: the same bits on any number of threads.
        let each: Vec<(f64, f64)> = (0..self.neighbourhood.len())
            .into_par_iter()
            .with_min_len(CHUNK)
            .map(|i| {
                let (f, residual_sum) = self.gradient(i, &state.positions);
                let rotation = nearest_rotation(f, self.scratch.rotations[i]);
                let (_, density) = self.elasticity.stress(f, DMat3::from_quat(rotation));
                let offsets = self.neighbourhood.offsets(i);
                let residuals: f64 = self
                    .neighbourhood
                    .bonds(i)
                    .zip(offsets)
                    .map(|((j, bond), (_, offset))| {
                        bond.weight * (state.positions[j] - state.positions[i] - f * offset).length_squared()
                    })
                    .sum();
                let scale = self.share[i] * self.volume;
                (scale * density, 0.5 * scale * (a * residuals + beta * residual_sum.length_squared()))
            })
            .collect();
        for (matrix, zero_energy) in each {
            energies.matrix += matrix;
            energies.zero_energy += zero_energy;
        }
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
