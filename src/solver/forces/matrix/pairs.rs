//! The matrix force from the pair list: particle by particle through its neighbours, four-wide in x, y, z.

use super::lanes::mean_turn;
use super::{Elasticity, Matter};
use crate::solver::neighbourhood::{Neighbourhood, outer};
use crate::solver::rotation::nearest_rotation;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use fearless_simd::{Level, Simd, dispatch, f64x4, prelude::*};
use glam::{DMat3, DQuat, DVec3};
use rayon::prelude::*;

/// Particles a thread works on at a time; a body of fewer than [`PARALLEL_FROM`] stays on one thread.
const CHUNK: usize = 128;
const PARALLEL_FROM: usize = 512;

/// The kernel: warm starts and buffers.
#[derive(Clone)]
pub(super) struct PairList {
    level: Level,
    rotations: Vec<DQuat>,
    buffers: Scratch<Buffers>,
}

#[derive(Default)]
struct Buffers {
    deviations: Vec<[f64; 4]>,
    fields: Vec<Field>,
    own: Vec<DVec3>,
}

/// What a particle offers its neighbours: the columns of Q, then Y with `al` in the fourth lane.
#[derive(Clone, Copy, Default)]
#[repr(C, align(32))]
struct Field([[f64; 4]; 4]);

impl PairList {
    /// The kernel of particles that start with these rotations.
    pub(super) fn new(rotations: Vec<DQuat>) -> Self {
        Self { level: Level::new(), rotations, buffers: Scratch::default() }
    }

    /// Memory of the rotations [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.rotations)
    }

    /// Rotation of particle i at the last evaluation.
    pub(super) fn rotation(&self, i: usize) -> DQuat {
        self.rotations[i]
    }

    /// Adds the forces [N].
    pub(super) fn add_forces(&mut self, matter: &Matter, state: &ParticleState, forces: &mut [DVec3]) {
        let Self { level, rotations, buffers } = self;
        let n = rotations.len();
        let Buffers { deviations, fields, own } = &mut **buffers;
        deviations.resize(n, [0.0; 4]);
        fields.resize(n, Field::default());
        own.resize(n, DVec3::ZERO);
        let body_turn = DMat3::from_quat(mean_turn(rotations.iter().copied()));
        for (deviation, (&x, &rest)) in deviations.iter_mut().zip(state.positions.iter().zip(matter.rest.iter())) {
            // Differences to particle 0 first: they are exact far from the origin, too.
            let u = (x - state.positions[0]) - body_turn * (rest - matter.rest[0]);
            *deviation = [u.x, u.y, u.z, 0.0];
        }
        let pass = Pass {
            neighbourhood: &matter.neighbourhood,
            elasticity: matter.elasticity,
            volume: matter.volume,
            share: &matter.share,
            body_turn,
            deviations,
        };
        let level = *level;
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

#[inline(always)]
fn vec3<S: Simd>(v: f64x4<S>) -> DVec3 {
    let [x, y, z, _]: [f64; 4] = v.into();
    DVec3::new(x, y, z)
}
