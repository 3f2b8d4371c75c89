//! The matrix force on a lattice, by stencils over bricks of four particles ([`row_stencil`], [`layout`]).
//!
//! The same sums as the pair list's, in another order. Rest data are taken along the stencil's axes, so that a lattice
//! that is turned in the model frame needs nothing of its own: `X = D o`, F maps from those axes to the world, and its
//! rotation is that of the material times the axes.

mod brick_data;
mod brick_law;
mod layout;
mod line_buffer;
mod parallel;
mod passes;
mod precomputed;
mod row_stencil;
mod row_table;

use super::elasticity::Elasticity;
use super::mean_rotation::mean_rotation;
use super::reference::ReferenceConfiguration;
use crate::solver::forces::bricks::brick_and_lane;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use crate::solver::wide::{LANES, Lanes4, quaternion_of, vector_of};
use brick_data::{BrickStress, BrickVectors};
use brick_law::BrickLaw;
use fearless_simd::{Level, dispatch};
use glam::{DMat3, DQuat, DVec3};
use line_buffer::LineBuffer;
use parallel::{COPIED, Remainder, over_slices, over_tasks};
use passes::{FirstPassOutput, StencilPasses};
use precomputed::{Precomputed, ROWS_UP_TO_6, ROWS_UP_TO_11, StencilSize};
use std::sync::Arc;

/// A body of fewer particles stays on one thread.
const PARALLEL_FROM: usize = 2000;
/// Bricks whose rotations make up the mean turn of a body; any turn near the mean serves as well.
const SAMPLED: usize = 16;

/// The evaluation by stencils: warm starts and buffers.
#[derive(Clone)]
pub(super) struct Stencil {
    fixed: Arc<Precomputed>,
    level: Level,
    /// Rotation of every brick's particles times the stencil's axes: x, y, z, w.
    rotations: Vec<[Lanes4; 4]>,
    buffers: Scratch<StencilBuffers>,
}

/// What an evaluation writes down for its second pass.
#[derive(Default)]
struct StencilBuffers {
    /// Of the empty brick and all others.
    deviations: Vec<BrickVectors>,
    stresses: Vec<BrickStress>,
    /// A particle's own part of its force, later the whole of it [N].
    forces: Vec<BrickVectors>,
    lines: LineBuffer,
}

impl StencilBuffers {
    /// Makes room for so many bricks. Places without a particle are never written and stay zero.
    fn fit(&mut self, bricks: usize) {
        if self.forces.len() != bricks {
            self.deviations = vec![BrickVectors::default(); bricks + 1];
            self.stresses = vec![BrickStress::default(); bricks + 1];
            self.forces = vec![BrickVectors::default(); bricks];
            self.lines = LineBuffer::new();
        }
    }
}

impl Stencil {
    /// The evaluation of particles that start turned by `orientation`; none where the support holds too many of them.
    pub(super) fn new(reference: &ReferenceConfiguration, orientation: DQuat) -> Option<Self> {
        let fixed = Precomputed::new(reference)?;
        let turn = (orientation * DQuat::from_mat3(&fixed.layout.axes)).to_array().map(Lanes4::splat);
        Some(Self {
            rotations: vec![turn; fixed.layout.bricks.len()],
            buffers: Scratch::default(),
            level: Level::new(),
            fixed: Arc::new(fixed),
        })
    }

    /// Rotation of particle i at the last evaluation.
    pub(super) fn rotation(&self, i: usize) -> DQuat {
        let (brick, lane) = brick_and_lane(self.fixed.layout.bricks.places[i]);
        let axes = DQuat::from_mat3(&self.fixed.layout.axes);
        quaternion_of(&self.rotations[brick], lane) * axes.conjugate()
    }

    /// Memory of the rotations [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.rotations)
    }

    /// Adds the forces [N].
    pub(super) fn add_forces(&mut self, elasticity: Elasticity, state: &ParticleState, forces: &mut [DVec3]) {
        match self.fixed.size {
            StencilSize::UpTo6 => self.evaluate::<6, ROWS_UP_TO_6>(elasticity, state, forces),
            StencilSize::UpTo11 => self.evaluate::<11, ROWS_UP_TO_11>(elasticity, state, forces),
        }
    }

    fn evaluate<const M: usize, const N: usize>(
        &mut self,
        elasticity: Elasticity,
        state: &ParticleState,
        forces: &mut [DVec3],
    ) {
        let Self { fixed, level, rotations, buffers } = self;
        buffers.fit(rotations.len());
        let StencilBuffers { deviations, stresses, forces: own, lines } = &mut **buffers;
        let (chunks, places) = (&fixed.layout.chunks, &fixed.layout.bricks.places);
        let parallel = state.len() >= PARALLEL_FROM;
        let body_turn = DMat3::from_quat(mean_turn(rotations));
        let passes = StencilPasses::<M, N> { fixed, law: BrickLaw { elasticity, body_turn }, origin: origin(state) };

        over_slices(parallel, &mut deviations[1..], |(part, deviations): (usize, &mut [BrickVectors])| {
            passes.deviate(part * COPIED, &state.positions, deviations);
        });

        let (mut own_left, mut stresses_left) = (Remainder(&mut own[..]), Remainder(&mut stresses[1..]));
        let mut rotations_left = Remainder(&mut rotations[..]);
        let first_pass = chunks.iter().map(|chunk| {
            let count = chunk.bricks.len();
            let (own, stresses) = (own_left.take(count), stresses_left.take(count));
            (chunk, FirstPassOutput { own, stresses, rotations: rotations_left.take(count) })
        });
        let deviations = &deviations[..];
        over_tasks(parallel, first_pass, lines, |(chunk, out), lines| {
            dispatch!(*level, simd => passes.stresses(simd, chunk, deviations, out, lines));
        });

        let mut own_left = Remainder(&mut own[..]);
        let second_pass = chunks.iter().map(|chunk| (chunk, own_left.take(chunk.bricks.len())));
        let stresses = &stresses[..];
        over_tasks(parallel, second_pass, lines, |(chunk, own), lines| {
            dispatch!(*level, simd => passes.gather(simd, chunk, stresses, own, lines));
        });

        // Forces within a body add up to nothing. What is left is round-off of the expanded sums, the same in step
        // after step, from which momentum would leak.
        let of_place = |place: u32| {
            let (brick, lane) = brick_and_lane(place);
            vector_of(&own[brick], lane)
        };
        let leak = places.iter().map(|&place| of_place(place)).sum::<DVec3>() / state.len().max(1) as f64;
        over_slices(parallel, forces, |(part, forces): (usize, &mut [DVec3])| {
            for (force, &place) in forces.iter_mut().zip(&places[part * COPIED..]) {
                *force += of_place(place) - leak;
            }
        });
    }
}

/// Mean turn of a body, by a sample of its bricks' rotations.
fn mean_turn(rotations: &[[Lanes4; 4]]) -> DQuat {
    let sample = rotations.iter().step_by(rotations.len().div_ceil(SAMPLED).max(1));
    mean_rotation(sample.flat_map(|brick| (0..LANES).map(|lane| quaternion_of(brick, lane))))
}

/// The first particle and how far the mean of all lies from it [m].
fn origin(state: &ParticleState) -> [DVec3; 2] {
    let first = state.positions.first().copied().unwrap_or_default();
    let mean = state.positions.iter().map(|x| *x - first).sum::<DVec3>() / state.len().max(1) as f64;
    [first, mean]
}
