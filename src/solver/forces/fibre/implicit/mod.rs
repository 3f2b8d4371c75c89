//! Stiff fibres stepped implicitly, whatever else acts on the particles.
//!
//! Fibres act on the particles through few vertices, which give way together by a constant matrix G ([`gram`]). So the
//! forces y at the vertices, at the positions that they themselves bring the vertices to, are the solution of a small
//! system, `p = c + a G g(p)`: c where the vertices get without any fibre's force, g the fibres' forces on them, a the
//! square of a time. Each of Newton's passes solves `(1 + a U H U^T) w = a U (g - y)`, where `G = U^T U`, `H = -dg/dp`,
//! and goes on from `y = g - H U^T w`. As y stays a sum of forces of edges and bends, it keeps the momentum of the body
//! whatever a pass leaves over.
//!
//! Of bends whose rest shape is as drawn, the turn of the material around them is that at the start of the step.

mod blocks;
mod gram;
mod ordering;
mod tangent;

use super::fibre_embedding::FibreEmbedding;
use super::force::FibreForce;
use super::material_turn::{material_spin, polar};
use super::soa::{put, zeros};
use super::strip::BlockVectors;
use crate::solver::scratch::Scratch;
use crate::solver::wide::{Lanes4, Vec3x, Wide};
use blocks::{Block, BlockMatrix};
use fearless_simd::{Level, Simd, dispatch, f64x4, f64x8, prelude::*};
use glam::{DMat3, DVec3};
use gram::{Gram, lanes};
use std::sync::Arc;
use tangent::{BAND, Tangent};

/// Passes after which a step counts as too long.
const MOST_PASSES: usize = 6;

/// Share of the shortest edge to which the vertices' positions are found.
const TOLERANCE: f64 = 1e-3;

/// The implicit fibres of a body, and what their next step goes on from.
#[derive(Clone)]
pub(in crate::solver) struct ImplicitFibres {
    level: Level,
    gram: Arc<Gram>,
    /// Length of the shortest edge [m].
    shortest: f64,
    /// Forces on the vertices in the last step [N], fibre after fibre.
    forces: Vec<DVec3>,
    work: Scratch<Work>,
}

/// A step that is too long for the fibres' places to be found.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Unconverged;

/// One step of the fibres.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct FibreStep<'a> {
    /// Where particles are [m].
    pub(in crate::solver) from: &'a [DVec3],
    /// Where they would be at the end without fibres [m].
    pub(in crate::solver) to: &'a [DVec3],
    /// Share of the way at which the fibres' forces are those of the whole step.
    pub(in crate::solver) share: f64,
    /// Time step [s].
    pub(in crate::solver) dt: f64,
}

/// What a pass works on; vectors in the order of G.
#[derive(Debug, Default)]
struct Work {
    tangent: Tangent,
    /// Blocks of H by rows, in the order of G.
    hessian: Vec<[Block; BAND]>,
    matrix: BlockMatrix,
    /// A row of `U H`.
    row: Vec<Block>,
    half: Vec<Lanes4>,
    whole: Vec<Lanes4>,
}

impl ImplicitFibres {
    /// Of the fibres of a body whose particles have these inverse masses [1/kg], zero along held axes.
    pub(in crate::solver) fn new(fibres: &FibreForce, inverse_masses: &[DVec3]) -> Self {
        let gram = Gram::new(&fibres.fibres, inverse_masses);
        let edges = fibres.fibres.iter().flat_map(|fibre| &fibre.edges);
        Self {
            level: Level::new(),
            shortest: edges.map(|&(_, length)| length).fold(f64::INFINITY, f64::min),
            forces: vec![DVec3::ZERO; gram.len()],
            gram: Arc::new(gram),
            work: Scratch::default(),
        }
    }

    /// About how many products of two 3 by 3 blocks a pass takes.
    pub(in crate::solver) fn products(&self) -> usize {
        self.gram.coupled.products()
    }

    /// Memory of its own [bytes].
    pub(in crate::solver) fn bytes(&self) -> usize {
        size_of_val(&*self.forces)
    }

    /// Finds the fibres' forces on the particles [N] in a step; they are added to `out`.
    ///
    /// # Errors
    /// A step that is too long; nothing but warm starts is changed then.
    pub(in crate::solver) fn step(
        &mut self,
        fibres: &mut FibreForce,
        step: FibreStep<'_>,
        out: &mut [DVec3],
    ) -> Result<(), Unconverged> {
        dispatch!(self.level, simd => self.find(simd, fibres, step, out))
    }

    #[inline(always)]
    fn find<S: Simd>(
        &mut self,
        simd: S,
        fibres: &mut FibreForce,
        FibreStep { from, to, share, dt }: FibreStep<'_>,
        out: &mut [DVec3],
    ) -> Result<(), Unconverged> {
        let Self { gram, shortest, work, .. } = self;
        let FibreForce { fibres, embedding, turns, broken, .. } = fibres;
        let FibreEmbedding { strip, vertices, turns: turning, curved } = &**embedding;
        let a = share * share * dt * dt;

        // Where the vertices get without the fibres' forces, up to one translation of them all.
        let mut near = vec![BlockVectors::default(); strip.len()];
        strip.fill(simd, from, &mut near);
        let mut material = Vec::with_capacity(curved.len());
        for (k, bend) in curved.iter().enumerate() {
            let [x, y, z] = turning.gather(simd, k, &near);
            material.push(polar(DMat3::from_cols(x, y, z), &mut turns[bend.bend]));
        }
        let rest: Vec<DVec3> = material.iter().zip(curved).map(|((r, _), bend)| *r * bend.binormal).collect();
        let mut free = Vec::with_capacity(gram.len());
        for vertex in 0..gram.len() {
            let [at] = vertices.gather(simd, vertex, &near);
            free.push(at);
        }
        strip.fill(simd, to, &mut near);
        for (vertex, free) in free.iter_mut().enumerate() {
            let [at] = vertices.gather(simd, vertex, &near);
            *free += share * (at - *free);
        }

        let mut forces = self.forces.clone();
        work.fit(gram);
        let mut pass = 0;
        loop {
            work.give_way(simd, gram, |vertex| forces[vertex]);
            let at: Vec<DVec3> =
                free.iter().zip(&gram.places).map(|(&free, &place)| free + a * vector(&work.whole[place])).collect();
            work.tangent.evaluate(fibres, broken, &at, &rest);
            let residual: Vec<DVec3> = work.tangent.forces.iter().zip(&forces).map(|(&found, &y)| found - y).collect();
            work.give_way(simd, gram, |vertex| residual[vertex]);
            let off = work.whole.iter().map(|moved| a * vector(moved).length()).fold(0.0, f64::max);
            if pass > 0 && off <= TOLERANCE * *shortest {
                break;
            }
            if pass == MOST_PASSES || !off.is_finite() || !work.solve(simd, gram, a) {
                return Err(Unconverged);
            }
            let moves: Vec<DVec3> = gram.places.iter().map(|&place| vector(&work.whole[place])).collect();
            forces.clone_from(&work.tangent.forces);
            work.tangent.subtract_product(&moves, &mut forces);
            pass += 1;
        }

        let mut pulls = [zeros(forces.len())];
        for (vertex, force) in forces.iter().enumerate() {
            put(&mut pulls[0], vertex, *force);
        }
        let mut spins = [0, 1, 2].map(|_| zeros(curved.len()));
        for (k, (((r, stretch), bend), gradient)) in material.iter().zip(curved).zip(&work.tangent.moments).enumerate()
        {
            let spun = material_spin(*r, *stretch, bend.binormal, *gradient);
            for (spin, value) in spins.iter_mut().zip(spun) {
                put(spin, k, value);
            }
        }
        for block in 0..strip.len() {
            let mut sums = Vec3x::splat(f64x8::splat(simd, 0.0));
            vertices.scatter(simd, block, &pulls, &mut sums);
            if !curved.is_empty() {
                turning.scatter(simd, block, &spins, &mut sums);
            }
            strip.pass_on(block, sums, out);
        }
        self.forces = forces;
        Ok(())
    }
}

impl Work {
    fn fit(&mut self, gram: &Gram) {
        self.matrix.fit(&gram.coupled);
        self.hessian.resize(gram.len(), [Block::default(); BAND]);
        self.half.resize(gram.len(), Lanes4::default());
        self.whole.resize(gram.len(), Lanes4::default());
    }

    /// `U y` into `half` and `G y` into `whole`, by vertex.
    #[inline(always)]
    fn give_way<S: Simd>(&mut self, simd: S, gram: &Gram, y: impl Fn(usize) -> DVec3) {
        for (vertex, &place) in gram.places.iter().enumerate() {
            self.whole[place] = lanes(y(vertex));
        }
        gram.root_times(simd, &self.whole, &mut self.half);
        gram.transposed_times(simd, &self.half, &mut self.whole);
    }

    /// Solves `(1 + a U H U^T) w = a half` and puts `U^T w` into `whole`; false where it cannot be solved.
    #[inline(always)]
    fn solve<S: Simd>(&mut self, simd: S, gram: &Gram, a: f64) -> bool {
        for (row, &place) in self.tangent.hessian.iter().zip(&gram.places) {
            for (block, matrix) in self.hessian[place].iter_mut().zip(row) {
                *block = rows_of(matrix);
            }
        }
        for i in 0..gram.len() {
            self.fill_row(simd, gram, i, a);
        }
        if !self.matrix.factor(simd, &gram.coupled) {
            return false;
        }
        for half in &mut self.half {
            *half = (f64x4::load(simd, half) * f64x4::splat(simd, a)).store();
        }
        self.matrix.solve(simd, &gram.coupled, &mut self.half);
        gram.transposed_times(simd, &self.half, &mut self.whole);
        true
    }

    /// Row i of `1 + a U H U^T`.
    #[inline(always)]
    fn fill_row<S: Simd>(&mut self, simd: S, gram: &Gram, i: usize, a: f64) {
        let end = gram.coupled.ends[i];
        self.row.clear();
        self.row.resize(end - i, Block::default());
        let (last, root) = gram.row(i);
        for (by, k) in root.iter().zip(i..last) {
            let by = by.0;
            for &(band, column) in gram.columns(k) {
                if column < i {
                    continue;
                }
                let (sum, block) = (&mut self.row[column - i], &self.hessian[k][band]);
                for c in 0..3 {
                    let by = f64x4::splat(simd, by[c]);
                    sum[c] = f64x4::load(simd, &block[c]).mul_add(by, f64x4::load(simd, &sum[c])).store();
                }
            }
        }
        for (j, target) in (i..end).zip(self.matrix.row_mut(&gram.coupled, i)) {
            let (last, root) = gram.row(j);
            let mut sums = [f64x4::splat(simd, 0.0); 3];
            for (by, block) in root.iter().zip(&self.row[j - i..last.min(end) - i]) {
                let by = f64x4::load(simd, by);
                for c in 0..3 {
                    sums[c] = f64x4::load(simd, &block[c]).mul_add(by, sums[c]);
                }
            }
            for c in 0..3 {
                target[c] = (sums[c] * f64x4::splat(simd, a)).store();
                if j == i {
                    target[c].0[c] += 1.0;
                }
            }
        }
    }
}

/// The vector in three of four lanes.
fn vector(lanes: &Lanes4) -> DVec3 {
    let [x, y, z, _] = lanes.0;
    DVec3::new(x, y, z)
}

/// A matrix by rows.
fn rows_of(matrix: &DMat3) -> Block {
    let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    [0, 1, 2].map(|row| Lanes4([x[row], y[row], z[row], 0.0]))
}
