//! The matrix force from the pair list: particle by particle through its neighbours, x, y and z of a vector side by
//! side in a register.

use super::elasticity::Elasticity;
use super::evaluation::{Evaluation, EvaluationKind};
use super::mean_rotation::mean_rotation;
use super::reference::ReferenceConfiguration;
use crate::solver::neighbourhood::outer;
use crate::solver::rotation::nearest_rotation;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use fearless_simd::{Level, Simd, dispatch, f64x4, prelude::*};
use glam::{DMat3, DQuat, DVec3};
use rayon::prelude::*;

/// Particles a thread works on at a time; a body of fewer than [`PARALLEL_FROM`] stays on one thread.
pub(super) const CHUNK: usize = 128;
const PARALLEL_FROM: usize = 512;

/// The evaluation by pairs: warm starts and buffers.
#[derive(Clone)]
pub(super) struct PairList {
    level: Level,
    rotations: Vec<DQuat>,
    buffers: Scratch<PairListBuffers>,
}

#[derive(Default)]
struct PairListBuffers {
    deviations: Vec<[f64; 4]>,
    stresses: Vec<ParticleStress>,
    /// The part of every particle's force that is its own [N].
    own: Vec<DVec3>,
}

/// What a particle's neighbours feel of it: the columns of Q, then Y with `al` in the fourth lane.
#[derive(Clone, Copy, Default)]
#[repr(C, align(32))]
pub(super) struct ParticleStress([[f64; 4]; 4]);

impl ParticleStress {
    /// `w (Q X_ji + al u_ji + Y)` [N]: what the particle pulls itself by and a neighbour back, of weight w [1/m²] and
    /// weighted offset w X_ji [1/m], whose deviation differs from its own by u_ji [m].
    pub(super) fn pull(&self, weight: f64, weighted_offset: DVec3, u: DVec3) -> DVec3 {
        let [q0, q1, q2, [x, y, z, al]] = self.0;
        let column = |q: [f64; 4]| DVec3::new(q[0], q[1], q[2]);
        let q = DMat3::from_cols(column(q0), column(q1), column(q2));
        q * weighted_offset + weight * (al * u + DVec3::new(x, y, z))
    }
}

impl PairList {
    /// The evaluation of particles that start with these rotations.
    pub(super) fn new(rotations: Vec<DQuat>) -> Self {
        Self { level: Level::new(), rotations, buffers: Scratch::default() }
    }
}

impl Evaluation for PairList {
    fn rotation(&self, i: usize) -> DQuat {
        self.rotations[i]
    }

    fn bytes(&self) -> usize {
        size_of_val(&*self.rotations)
    }

    fn kind(&self) -> EvaluationKind {
        EvaluationKind::PairList
    }

    fn clone_box(&self) -> Box<dyn Evaluation> {
        Box::new(self.clone())
    }

    fn add_forces(&mut self, reference: &ReferenceConfiguration, state: &ParticleState, forces: &mut [DVec3]) {
        let Self { level, rotations, buffers } = self;
        let n = rotations.len();
        let PairListBuffers { deviations, stresses, own } = &mut **buffers;
        deviations.resize(n, [0.0; 4]);
        stresses.resize(n, ParticleStress::default());
        own.resize(n, DVec3::ZERO);
        let body_turn = DMat3::from_quat(mean_rotation(rotations.iter().copied()));
        for (deviation, (&x, &rest)) in
            deviations.iter_mut().zip(state.positions.iter().zip(reference.positions.iter()))
        {
            // Differences to particle 0 first: they are exact far from the origin, too.
            let u = (x - state.positions[0]) - body_turn * (rest - reference.positions[0]);
            *deviation = [u.x, u.y, u.z, 0.0];
        }
        let passes = PairListPasses { reference, body_turn, deviations };
        let level = *level;
        let first_pass = |(chunk, ((rotations, stresses), own)): (usize, FirstChunk<'_>)| {
            dispatch!(level, simd => passes.stresses(simd, chunk * CHUNK, rotations, stresses, own));
        };
        let parallel = rotations.len() >= PARALLEL_FROM;
        if parallel {
            rotations
                .par_chunks_mut(CHUNK)
                .zip(stresses.par_chunks_mut(CHUNK))
                .zip(own.par_chunks_mut(CHUNK))
                .enumerate()
                .for_each(first_pass);
        } else {
            rotations
                .chunks_mut(CHUNK)
                .zip(stresses.chunks_mut(CHUNK))
                .zip(own.chunks_mut(CHUNK))
                .enumerate()
                .for_each(first_pass);
        }
        let stresses: &[ParticleStress] = stresses;
        let second_pass = |(chunk, (own, forces)): (usize, (&[DVec3], &mut [DVec3]))| {
            dispatch!(level, simd => passes.gather(simd, chunk * CHUNK, stresses, own, forces));
        };
        if parallel {
            own.par_chunks(CHUNK).zip(forces.par_chunks_mut(CHUNK)).enumerate().for_each(second_pass);
        } else {
            own.chunks(CHUNK).zip(forces.chunks_mut(CHUNK)).enumerate().for_each(second_pass);
        }
    }
}

/// What the first pass writes for some consecutive particles.
type FirstChunk<'a> = ((&'a mut [DQuat], &'a mut [ParticleStress]), &'a mut [DVec3]);

/// The two passes of an evaluation and what they read, which all threads share.
pub(super) struct PairListPasses<'a> {
    pub(super) reference: &'a ReferenceConfiguration,
    /// Rigid turn R_b of the whole body, and every particle's deviation u from it [m].
    pub(super) body_turn: DMat3,
    pub(super) deviations: &'a [[f64; 4]],
}

impl PairListPasses<'_> {
    /// Pass 1: deformation gradient, rotation and stress of the particles from `first` on.
    #[inline(always)]
    fn stresses<S: Simd>(
        &self,
        simd: S,
        first: usize,
        rotations: &mut [DQuat],
        stresses: &mut [ParticleStress],
        own: &mut [DVec3],
    ) {
        for (k, rotation) in rotations.iter_mut().enumerate() {
            let weight = self.reference.matrix_weight[first + k];
            (stresses[k], own[k]) = self.stress(simd, first + k, weight, rotation);
        }
    }

    /// The same of particle i, of this matrix weight; and the part of its force that is its own
    /// [N].
    #[inline(always)]
    pub(super) fn stress<S: Simd>(
        &self,
        simd: S,
        i: usize,
        matrix_weight: f64,
        rotation: &mut DQuat,
    ) -> (ParticleStress, DVec3) {
        let here = f64x4::simd_from(simd, self.deviations[i]);
        let zero = f64x4::splat(simd, 0.0);
        let (mut c0, mut c1, mut c2, mut sum) = (zero, zero, zero, zero);
        for (j, bond) in self.reference.neighbourhood.bonds(i) {
            let u = f64x4::simd_from(simd, self.deviations[j]) - here;
            c0 = u.mul_add(f64x4::splat(simd, bond.weighted_offset.x), c0);
            c1 = u.mul_add(f64x4::splat(simd, bond.weighted_offset.y), c1);
            c2 = u.mul_add(f64x4::splat(simd, bond.weighted_offset.z), c2);
            sum = u.mul_add(f64x4::splat(simd, bond.weight), sum);
        }
        let moment = DMat3::from_cols(vec3(c0), vec3(c1), vec3(c2));
        self.finish((i, matrix_weight), moment, vec3(sum), rotation)
    }

    /// Deviation of particle i [m].
    pub(super) fn deviation(&self, i: usize) -> DVec3 {
        let [x, y, z, _] = self.deviations[i];
        DVec3::new(x, y, z)
    }

    /// Stress and what follows from it, once the sums of pass 1 are there.
    #[inline]
    fn finish(
        &self,
        (i, matrix_weight): (usize, f64),
        moment: DMat3,
        sum: DVec3,
        rotation: &mut DQuat,
    ) -> (ParticleStress, DVec3) {
        let ReferenceConfiguration { neighbourhood: rest, elasticity, volume, .. } = self.reference;
        let inverse = rest.inverse_moment[i];
        let weighted_sum = rest.weighted_sum[i];
        let g = moment * inverse;
        let f = self.body_turn + g;
        let residual_sum = sum - g * weighted_sum;
        *rotation = nearest_rotation(f, *rotation);
        let (stress, _) = elasticity.stress(f, DMat3::from_quat(*rotation));
        let scale = matrix_weight * volume;
        let Elasticity { residual_penalty: a, sum_penalty: beta, .. } = *elasticity;
        let q = scale * (stress * inverse - a * g - beta * outer(residual_sum, inverse * weighted_sum));
        let y = scale * beta * residual_sum;
        let al = scale * a;
        let columns = q.to_cols_array_2d();
        let [q0, q1, q2] = columns.map(|[x, y, z]| [x, y, z, 0.0]);
        let own = q * weighted_sum + al * sum + rest.weight_sum[i] * y;
        (ParticleStress([q0, q1, q2, [y.x, y.y, y.z, al]]), own)
    }

    /// Pass 2: forces on the particles from `first` on.
    #[inline(always)]
    fn gather<S: Simd>(&self, simd: S, first: usize, stresses: &[ParticleStress], own: &[DVec3], forces: &mut [DVec3]) {
        for (k, force) in forces.iter_mut().enumerate() {
            let i = first + k;
            let here = f64x4::simd_from(simd, self.deviations[i]);
            let zero = f64x4::splat(simd, 0.0);
            let (mut sum, mut sum2) = (zero, zero);
            for (j, bond) in self.reference.neighbourhood.bonds(i) {
                let [q0, q1, q2, y] = &stresses[j].0;
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

#[inline(always)]
fn vec3<S: Simd>(v: f64x4<S>) -> DVec3 {
    let [x, y, z, _]: [f64; 4] = v.into();
    DVec3::new(x, y, z)
}
