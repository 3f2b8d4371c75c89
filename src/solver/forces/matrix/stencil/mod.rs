//! The matrix force on a lattice, by stencils over bricks of four particles, or of eight in short numbers
//! ([`row_stencil`], [`layout`]).
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
use super::evaluation::{Evaluation, EvaluationKind};
use super::mean_rotation::mean_rotation;
use super::reference::ReferenceConfiguration;
use crate::solver::forces::bricks::brick_and_lane;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use crate::solver::wide::{Lanes, quaternion_of, vector_of};
use brick_data::{BrickStress, BrickVectors};
use brick_law::BrickLaw;
use fearless_simd::{Level, dispatch};
use glam::{DMat3, DQuat, DVec3};
use line_buffer::LineBuffer;
use parallel::{COPIED, Remainder, over_slices, over_tasks};
use passes::{FirstPassOutput, StencilPasses};
use precomputed::{Precomputed, ROWS_UP_TO_6, ROWS_UP_TO_11, StencilSize};
use std::array::from_fn;
use std::sync::Arc;

/// A body of fewer particles stays on one thread.
const PARALLEL_FROM: usize = 2000;
/// Bricks whose rotations make up the mean turn of a body; any turn near the mean serves as well.
const SAMPLED: usize = 16;

/// The evaluation by stencils: warm starts and buffers.
#[derive(Clone)]
pub(super) struct Stencil<L: Lanes> {
    fixed: Arc<Precomputed<L>>,
    level: Level,
    /// What rotations are taken from: the rigid turn of the whole body at the last evaluation times the stencil's axes
    /// where numbers are short, nothing else.
    turn: DQuat,
    /// Rotation of every brick's particles times the stencil's axes, from `turn` on: x, y, z, w.
    rotations: Vec<[L; 4]>,
    buffers: Scratch<StencilBuffers<L>>,
}

/// What an evaluation writes down for its second pass.
struct StencilBuffers<L> {
    /// Of the empty brick and all others.
    deviations: Vec<BrickVectors<L>>,
    stresses: [Vec<BrickStress<L>>; 3],
    /// A particle's own part of its force, later the whole of it [N].
    forces: Vec<BrickVectors<L>>,
    lines: LineBuffer<L>,
}

impl<L> Default for StencilBuffers<L> {
    fn default() -> Self {
        Self { deviations: Vec::new(), stresses: Default::default(), forces: Vec::new(), lines: LineBuffer(Vec::new()) }
    }
}

impl<L: Lanes> StencilBuffers<L> {
    /// Makes room for so many bricks and the empty one. Places without a particle are never written and stay zero; what
    /// is read by numbers of bricks is as long as a power of two.
    fn fit(&mut self, bricks: usize) {
        if self.forces.len() != bricks {
            let length = (bricks + 1).next_power_of_two();
            self.deviations = vec![[L::default(); 3]; length];
            self.stresses = from_fn(|_| vec![[L::default(); 4]; length]);
            self.forces = vec![[L::default(); 3]; bricks];
            self.lines = LineBuffer::new();
        }
    }
}

impl<L: Lanes> Stencil<L> {
    /// The evaluation of particles that start turned by `orientation`.
    fn new(fixed: Precomputed<L>, orientation: DQuat) -> Self {
        let turn = orientation * DQuat::from_mat3(&fixed.layout.axes);
        let [turn, rotation] = if L::SHORT { [turn, DQuat::IDENTITY] } else { [DQuat::IDENTITY, turn] };
        Self {
            turn,
            rotations: vec![rotation.to_array().map(L::splat); fixed.layout.bricks.len()],
            buffers: Scratch::default(),
            level: Level::new(),
            fixed: Arc::new(fixed),
        }
    }

    fn evaluate<const M: usize, const N: usize>(
        &mut self,
        elasticity: Elasticity,
        state: &ParticleState,
        forces: &mut [DVec3],
    ) {
        let Self { fixed, level, turn, rotations, buffers } = self;
        buffers.fit(rotations.len());
        let StencilBuffers { deviations, stresses, forces: own, lines } = &mut **buffers;
        let (chunks, places) = (&fixed.layout.chunks, &fixed.layout.bricks.places);
        let parallel = state.len() >= PARALLEL_FROM;
        let mut mean = mean_turn(rotations);
        if L::SHORT {
            *turn = (*turn * mean).normalize();
            mean = *turn;
        }
        let law = BrickLaw { elasticity, body_turn: DMat3::from_quat(mean) };
        let passes = StencilPasses::<L, M, N> { fixed, law, origin: origin(state) };

        over_slices(parallel, &mut deviations[1..=own.len()], |(part, deviations): (usize, &mut [BrickVectors<L>])| {
            passes.deviate(part * COPIED, &state.positions, deviations);
        });

        let mut own_left = Remainder(&mut own[..]);
        let mut stresses_left = stresses.each_mut().map(|stresses| Remainder(&mut stresses[1..]));
        let mut rotations_left = Remainder(&mut rotations[..]);
        let first_pass = chunks.iter().map(|chunk| {
            let count = chunk.bricks.len();
            let (own, stresses) = (own_left.take(count), stresses_left.each_mut().map(|left| left.take(count)));
            (chunk, FirstPassOutput { own, stresses, rotations: rotations_left.take(count) })
        });
        let deviations = &deviations[..];
        over_tasks(parallel, first_pass, lines, |(chunk, out), lines| {
            dispatch!(*level, simd => passes.stresses(simd, chunk, deviations, out, lines));
        });

        let mut own_left = Remainder(&mut own[..]);
        let second_pass = chunks.iter().map(|chunk| (chunk, own_left.take(chunk.bricks.len())));
        let stresses = stresses.each_ref().map(|stresses| &stresses[..]);
        over_tasks(parallel, second_pass, lines, |(chunk, own), lines| {
            dispatch!(*level, simd => passes.gather(simd, chunk, stresses, own, lines));
        });

        // Forces within a body add up to nothing. What is left is round-off of the expanded sums, the same in step
        // after step, from which momentum would leak.
        let of_place = |place: u32| {
            let (brick, lane) = brick_and_lane::<L>(place);
            vector_of(&own[brick], lane)
        };
        let body_turn = passes.law.body_turn;
        let leak = places.iter().map(|&place| of_place(place)).sum::<DVec3>() / state.len().max(1) as f64;
        over_slices(parallel, forces, |(part, forces): (usize, &mut [DVec3])| {
            for (force, &place) in forces.iter_mut().zip(&places[part * COPIED..]) {
                let inner = of_place(place) - leak;
                *force += if L::SHORT { body_turn * inner } else { inner };
            }
        });
    }
}

impl<L: Lanes> Evaluation for Stencil<L> {
    fn add_forces(&mut self, reference: &ReferenceConfiguration, state: &ParticleState, forces: &mut [DVec3]) {
        match self.fixed.size {
            StencilSize::UpTo6 => self.evaluate::<6, ROWS_UP_TO_6>(reference.elasticity, state, forces),
            StencilSize::UpTo11 => self.evaluate::<11, ROWS_UP_TO_11>(reference.elasticity, state, forces),
        }
    }

    fn rotation(&self, i: usize) -> DQuat {
        let (brick, lane) = brick_and_lane::<L>(self.fixed.layout.bricks.places[i]);
        let axes = DQuat::from_mat3(&self.fixed.layout.axes);
        let rotation = quaternion_of(&self.rotations[brick], lane);
        if L::SHORT { (self.turn * rotation).normalize() * axes.conjugate() } else { rotation * axes.conjugate() }
    }

    fn bytes(&self) -> usize {
        size_of_val(self) + size_of_val(&*self.rotations)
    }

    fn kind(&self) -> EvaluationKind {
        if L::SHORT { EvaluationKind::Fast } else { EvaluationKind::Exact }
    }

    fn clone_box(&self) -> Box<dyn Evaluation> {
        Box::new(self.clone())
    }
}

/// The evaluation of particles that start turned by `orientation`, in f64 or f32 by the lanes; none where the support
/// holds too many of them.
pub(super) fn evaluation<L: Lanes>(
    reference: &ReferenceConfiguration,
    orientation: DQuat,
) -> Option<Box<dyn Evaluation>> {
    Some(Box::new(Stencil::<L>::new(Precomputed::new(reference)?, orientation)))
}

/// Mean turn of a body, by a sample of its bricks' rotations.
fn mean_turn<L: Lanes>(rotations: &[[L; 4]]) -> DQuat {
    let sample = rotations.iter().step_by(rotations.len().div_ceil(SAMPLED).max(1));
    mean_rotation(sample.flat_map(|brick| (0..L::COUNT).map(|lane| quaternion_of(brick, lane))))
}

/// The first particle and how far the mean of all lies from it [m].
fn origin(state: &ParticleState) -> [DVec3; 2] {
    let first = state.positions.first().copied().unwrap_or_default();
    let mean = state.positions.iter().map(|x| *x - first).sum::<DVec3>() / state.len().max(1) as f64;
    [first, mean]
}
