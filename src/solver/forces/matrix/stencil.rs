//! The matrix force on a lattice, by stencils over bricks of four particles ([`super::rows`], [`super::layout`]).
//!
//! The same sums as the pair list's, in another order. Rest data are taken along the stencil's axes, so that a lattice
//! that is turned in the model frame needs nothing of its own: `X = D o`, F maps from those axes to the world, and its
//! rotation is that of the matter times the axes. Sums over pairs are expanded: with n = sum w,
//! `sum w u_ji (x) X_ji = sum w u_j (x) X_ji - u_i (x) B_i`, and so on, so that neighbours enter by constant weights.

use super::lanes::{
    LANES, Lanes, Vectors, dot, load, load_all, mean_turn, nearest_rotations, product, scaled, splat_matrix, store,
    store_all, transform, turns, vector_of,
};
use super::layout::{Chunk, Layout, NONE};
use super::rest::{Rest, Share, rests, shares};
use super::rows::{Lines, MOST, Rows, Weights};
use super::{Elasticity, Matter};
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use fearless_simd::{Level, Simd, dispatch, f64x4, prelude::*};
use glam::{DMat3, DQuat, DVec3};
use rayon::prelude::*;
use std::array::from_fn;
use std::sync::Arc;

/// A body of fewer particles stays on one thread.
const PARALLEL_FROM: usize = 2000;
/// Bricks or particles that a thread copies at a time.
const COPIED: usize = 256;
/// Bricks whose rotations make up the mean turn of a body; any turn near the mean serves as well.
const SAMPLED: usize = 16;

/// Deviations of a brick's particles [m].
type Deviations = [Lanes; 3];
/// What a brick offers its neighbours: the columns of Q, then al u - Y.
type Fields = [Lanes; 12];

/// The kernel with its buffers.
#[derive(Clone)]
pub(super) struct Stencil {
    fixed: Arc<Fixed>,
    level: Level,
    /// Rotation of every brick's particles times the stencil's axes: x, y, z, w.
    rotations: Vec<[Lanes; 4]>,
    buffers: Scratch<Buffers>,
}

/// What an evaluation writes down for its second pass.
#[derive(Default)]
struct Buffers {
    /// Of the empty brick and all others.
    deviations: Vec<Deviations>,
    fields: Vec<Fields>,
    /// A particle's own part of its force, later the whole of it [N].
    forces: Vec<[Lanes; 3]>,
    lines: Lines,
}

impl Buffers {
    /// Makes room for so many bricks. Places without a particle are never written and stay zero.
    fn fit(&mut self, bricks: usize) {
        if self.forces.len() != bricks {
            self.deviations = vec![Deviations::default(); bricks + 1];
            self.fields = vec![Fields::default(); bricks + 1];
            self.forces = vec![[Lanes::default(); 3]; bricks];
            self.lines = Lines::new();
        }
    }
}

/// What does not change.
struct Fixed {
    layout: Layout,
    weights: Weights,
    /// Rows that the stencil looks at.
    reach: Reach,
    rests: Vec<Rest>,
    rest_of: Vec<u32>,
    shares: Vec<Share>,
    spacing: f64,
}

/// Stencils that there is code for, by the greatest |o|² they hold.
#[derive(Clone, Copy)]
enum Reach {
    /// D / h from 0.354 on, 0.4 among them.
    UpTo6,
    /// D / h from 0.289 on.
    UpTo11,
}

impl Reach {
    fn rows(self) -> usize {
        match self {
            Self::UpTo6 => 21,
            Self::UpTo11 => 37,
        }
    }
}

impl Stencil {
    /// The kernel of particles that start turned by `orientation`; none where the support holds too many of them.
    pub(super) fn new(matter: &Matter, orientation: DQuat) -> Option<Self> {
        let lattice = matter.neighbourhood.lattice();
        let weights: [f64; MOST + 1] = from_fn(|square| lattice.weight(square as u32));
        if lattice.weight(MOST as u32 + 1) > 0.0 {
            return None;
        }
        let reach = match weights.iter().rposition(|&weight| weight > 0.0) {
            None | Some(0..=6) => Reach::UpTo6,
            Some(_) => Reach::UpTo11,
        };
        let layout = Layout::new(lattice, reach.rows());
        let (rests, rest_of) = rests(matter, &layout);
        let shares = shares(matter, &layout);
        let turn = (orientation * DQuat::from_mat3(&layout.axes)).to_array().map(|entry| Lanes([entry; LANES]));
        let bricks = layout.particles.len();
        Some(Self {
            rotations: vec![turn; bricks],
            buffers: Scratch::default(),
            level: Level::new(),
            fixed: Arc::new(Fixed {
                weights: Weights::new(weights, lattice.spacing),
                spacing: lattice.spacing,
                layout,
                reach,
                rests,
                rest_of,
                shares,
            }),
        })
    }

    /// Rotation of particle i at the last evaluation.
    pub(super) fn rotation(&self, i: usize) -> DQuat {
        let place = self.fixed.layout.places[i] as usize;
        let axes = DQuat::from_mat3(&self.fixed.layout.axes);
        rotation(&self.rotations[place / LANES], place % LANES) * axes.conjugate()
    }

    /// Memory of the rotations [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.rotations)
    }

    /// Adds the forces [N].
    pub(super) fn add_forces(&mut self, matter: &Matter, state: &ParticleState, forces: &mut [DVec3]) {
        match self.fixed.reach {
            Reach::UpTo6 => self.evaluate::<6, 21>(matter, state, forces),
            Reach::UpTo11 => self.evaluate::<11, 37>(matter, state, forces),
        }
    }

    fn evaluate<const M: usize, const N: usize>(
        &mut self,
        matter: &Matter,
        state: &ParticleState,
        forces: &mut [DVec3],
    ) {
        let Self { fixed, level, rotations, buffers } = self;
        buffers.fit(rotations.len());
        let Buffers { deviations, fields, forces: own, lines } = &mut **buffers;
        let layout = &fixed.layout;
        let parallel = state.len() >= PARALLEL_FROM;
        let sample = rotations.iter().step_by(rotations.len().div_ceil(SAMPLED).max(1));
        let turn = mean_turn(sample.flat_map(|turns| (0..LANES).map(|lane| rotation(turns, lane))));
        let first = state.positions.first().copied().unwrap_or_default();
        let mean = state.positions.iter().map(|x| *x - first).sum::<DVec3>() / state.len().max(1) as f64;
        let origin = [first, mean];
        let pass = Pass::<M, N> { fixed, elasticity: matter.elasticity, turn: DMat3::from_quat(turn), origin };

        let deviate = |(chunk, deviations): (usize, &mut [Deviations])| {
            pass.deviate(chunk * COPIED, &state.positions, deviations);
        };
        over_slices(parallel, &mut deviations[1..], deviate);

        let (mut own_left, mut fields_left) = (Left(&mut own[..]), Left(&mut fields[1..]));
        let mut rotations_left = Left(&mut rotations[..]);
        let first = layout.chunks.iter().map(|chunk| {
            let count = chunk.bricks.len();
            let (own, fields) = (own_left.take(count), fields_left.take(count));
            (chunk, own, FirstPass { fields, rotations: rotations_left.take(count) })
        });
        let deviations = &deviations[..];
        over_chunks(parallel, first, lines, |(chunk, own, out), lines| {
            dispatch!(*level, simd => pass.stresses(simd, chunk, deviations, own, out, lines));
        });

        let mut own_left = Left(&mut own[..]);
        let second = layout.chunks.iter().map(|chunk| (chunk, own_left.take(chunk.bricks.len())));
        let fields = &fields[..];
        over_chunks(parallel, second, lines, |(chunk, own), lines| {
            dispatch!(*level, simd => pass.gather(simd, chunk, fields, own, lines));
        });

        // Forces within a body add up to nothing. What is left is round-off of the expanded sums, the same in step after
        // step, from which momentum would leak.
        let of_place = |place: u32| vector_of(&own[place as usize / LANES], place as usize % LANES);
        let leak = layout.places.iter().map(|&place| of_place(place)).sum::<DVec3>() / state.len().max(1) as f64;
        over_slices(parallel, forces, |(chunk, forces): (usize, &mut [DVec3])| {
            for (force, &place) in forces.iter_mut().zip(&layout.places[chunk * COPIED..]) {
                *force += of_place(place) - leak;
            }
        });
    }
}

/// Calls `work` with consecutive parts of a slice and their numbers.
fn over_slices<T: Send>(parallel: bool, slice: &mut [T], work: impl Fn((usize, &mut [T])) + Send + Sync) {
    if parallel {
        slice.par_chunks_mut(COPIED).enumerate().for_each(work);
    } else {
        slice.chunks_mut(COPIED).enumerate().for_each(work);
    }
}

/// Calls `work` with every task and a buffer.
fn over_chunks<T: Send>(
    parallel: bool,
    tasks: impl Iterator<Item = T>,
    lines: &mut Lines,
    work: impl Fn(T, &mut Lines) + Send + Sync,
) {
    if parallel {
        let tasks: Vec<T> = tasks.collect();
        tasks.into_par_iter().for_each_init(Lines::new, |lines, task| work(task, lines));
    } else {
        tasks.for_each(|task| work(task, lines));
    }
}

/// What is left of a slice from which parts are taken.
struct Left<'a, T>(&'a mut [T]);

impl<'a, T> Left<'a, T> {
    fn take(&mut self, count: usize) -> &'a mut [T] {
        self.0.split_off_mut(..count).unwrap_or_default()
    }
}

/// What the first pass writes beside the particles' own part of their forces.
struct FirstPass<'a> {
    fields: &'a mut [Fields],
    rotations: &'a mut [[Lanes; 4]],
}

/// Read-only part of an evaluation, shared by all threads.
struct Pass<'a, const M: usize, const N: usize> {
    fixed: &'a Fixed,
    elasticity: Elasticity,
    /// Rigid turn R_b of the whole body times the stencil's axes.
    turn: DMat3,
    /// A particle and how far the mean of all lies from it [m]: differences to a particle first, since they are exact far
    /// from the origin, too. Deviations from the mean add up to zero, and so does what rounding makes of constant ones.
    origin: [DVec3; 2],
}

impl<const M: usize, const N: usize> Pass<'_, M, N> {
    /// Deviations from the rigid turn of the bricks from `first` on.
    fn deviate(&self, first: usize, positions: &[DVec3], deviations: &mut [Deviations]) {
        let layout = &self.fixed.layout;
        let step = self.fixed.spacing * self.turn;
        let [origin, mean] = self.origin;
        for (k, deviations) in deviations.iter_mut().enumerate() {
            let corner = step * layout.corners[first + k];
            for (lane, &i) in layout.particles[first + k].iter().enumerate() {
                if i != NONE {
                    let u = ((positions[i as usize] - origin) - mean) - (corner + lane as f64 * step.x_axis);
                    deviations[0].0[lane] = u.x;
                    deviations[1].0[lane] = u.y;
                    deviations[2].0[lane] = u.z;
                }
            }
        }
    }

    /// Pass 1: deformation gradients, rotations and stresses of a chunk of bricks.
    #[inline(always)]
    fn stresses<S: Simd>(
        &self,
        simd: S,
        chunk: &Chunk,
        deviations: &[Deviations],
        own: &mut [[Lanes; 3]],
        out: FirstPass<'_>,
        lines: &mut Lines,
    ) {
        let Fixed { layout, weights, .. } = self.fixed;
        let rows = Rows::<S, M, N> { simd, weights };
        for (k, site) in layout.sites[chunk.sites.clone()].iter().enumerate() {
            match site {
                Some(site) => rows.combine_deviations(layout.neighbours(*site), deviations, k, lines),
                None => rows.clear(k, lines),
            }
        }
        let bricks = own.iter_mut().zip(out.fields).zip(out.rotations);
        for (brick, ((own, fields), rotations)) in chunk.bricks.clone().zip(bricks) {
            let sums = rows.shift_deviations(layout.site_of[brick] as usize, lines);
            (*own, *fields) = self.finish(simd, brick, &deviations[brick + 1], sums, rotations);
        }
    }

    /// Stress and what follows from it, once the sums of pass 1 are there.
    #[inline(always)]
    fn finish<S: Simd>(
        &self,
        simd: S,
        brick: usize,
        deviations: &Deviations,
        [over_x, over_y, over_z, plain]: [Vectors<S>; 4],
        rotations: &mut [Lanes; 4],
    ) -> ([Lanes; 3], Fields) {
        let Rest { inverse, weighted_sum, weight_sum } = &self.fixed.rests[self.fixed.rest_of[brick] as usize];
        let [i00, i01, i02, i11, i12, i22] = load_all(simd, inverse);
        let inverse = [[i00, i01, i02], [i01, i11, i12], [i02, i12, i22]];
        let weighted_sum = load_all(simd, weighted_sum);
        let weight_sum = load(simd, weight_sum);
        let u = load_all(simd, deviations);
        let mut sum = plain;
        let mut moment = [over_x, over_y, over_z];
        for r in 0..3 {
            sum[r] -= u[r] * weight_sum;
            for c in 0..3 {
                moment[c][r] -= u[r] * weighted_sum[c];
            }
        }

        let g = product(&moment, &inverse);
        let mut f = splat_matrix(simd, &self.turn);
        for c in 0..3 {
            for r in 0..3 {
                f[c][r] += g[c][r];
            }
        }
        let found = nearest_rotations(&f, load_all(simd, rotations));
        *rotations = store_all(found);
        let rotation = turns(found);
        let Elasticity { lambda, mu, residual_penalty, sum_penalty } = self.elasticity;
        // R sym(R^T F) is F, up to round-off: P = 2 mu (F - R) + lambda tr(R^T F - I) R.
        let trace = dot(&rotation[0], &f[0]) + dot(&rotation[1], &f[1]) + dot(&rotation[2], &f[2]);
        let pressure = f64x4::splat(simd, lambda) * (trace - f64x4::splat(simd, 3.0));
        let shear = f64x4::splat(simd, 2.0 * mu);
        let mut stress = f;
        for c in 0..3 {
            for r in 0..3 {
                stress[c][r] = shear.mul_add(f[c][r] - rotation[c][r], pressure * rotation[c][r]);
            }
        }

        let share = &self.fixed.shares[brick];
        let volume = load(simd, &share.volume);
        let penalty = f64x4::splat(simd, residual_penalty);
        let al = volume * penalty;
        let removed = transform(&g, &weighted_sum);
        let mut y = sum;
        for r in 0..3 {
            y[r] = f64x4::splat(simd, sum_penalty) * (sum[r] - removed[r]);
        }
        let b = transform(&inverse, &weighted_sum);
        let mut q = product(&stress, &inverse);
        for c in 0..3 {
            for r in 0..3 {
                q[c][r] = volume * (q[c][r] - penalty * g[c][r] - y[r] * b[c]);
            }
        }
        let y = scaled(volume, y);
        let around = penalty * load(simd, &share.around);
        let mut own = transform(&q, &weighted_sum);
        let mut z = u;
        for r in 0..3 {
            own[r] += al * sum[r] + weight_sum * y[r] - around * u[r];
            z[r] = al * u[r] - y[r];
        }
        let [q0, q1, q2, z] = [store_all(q[0]), store_all(q[1]), store_all(q[2]), store_all(z)];
        let fields = [q0[0], q0[1], q0[2], q1[0], q1[1], q1[2], q2[0], q2[1], q2[2], z[0], z[1], z[2]];
        (store_all(own), fields)
    }

    /// Pass 2: forces on the particles of a chunk of bricks, of which `own` holds their own part.
    #[inline(always)]
    fn gather<S: Simd>(&self, simd: S, chunk: &Chunk, fields: &[Fields], own: &mut [[Lanes; 3]], lines: &mut Lines) {
        let Fixed { layout, weights, .. } = self.fixed;
        let rows = Rows::<S, M, N> { simd, weights };
        for (k, site) in layout.sites[chunk.sites.clone()].iter().enumerate() {
            match site {
                Some(site) => rows.combine_fields(layout.neighbours(*site), fields, k, lines),
                None => rows.clear(k, lines),
            }
        }
        for (brick, own) in chunk.bricks.clone().zip(own) {
            let sums = rows.shift_fields(layout.site_of[brick] as usize, lines);
            for r in 0..3 {
                own[r] = store(load(simd, &own[r]) + sums[r]);
            }
        }
    }
}

fn rotation(turns: &[Lanes; 4], lane: usize) -> DQuat {
    DQuat::from_array(turns.map(|entry| entry.0[lane]))
}
