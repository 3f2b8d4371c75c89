//! Stretching and straight bending of all fibres of a body, four edges at a time.
//!
//! The fibres stand one after another in one long line, with an edge and two corners between them that have no
//! stiffness, as everything that is broken or bends by other rules has none. An energy's gradients by the edges are
//! what is summed: a vertex is pulled by the edge after it and against the edge before it.

use super::corner::{Edge, FOLD};
use super::rest::FibreRest;
use super::soa::{SoaVectors, zeros};
use crate::solver::wide::{LANES, Lanes4, Vec3x, Wide, vector_of};
use fearless_simd::{Simd, f64x4, prelude::*};
use glam::DVec3;

/// Vertices and edges of all fibres; edge and corner k begin with vertex k.
#[derive(Clone, Debug)]
pub(super) struct PackedRods {
    count: usize,
    /// All of them, and an empty pack, which the last one looks at.
    packs: Vec<RodPack>,
    /// Forces on vertices.
    forces: SoaVectors,
}

/// Four vertices with the edges and corners that begin with them.
#[derive(Clone, Debug, Default)]
struct RodPack {
    stretching: Lanes4,
    rest_lengths: Lanes4,
    bending: Lanes4,
    positions: [Lanes4; 3],
    tangents: [Lanes4; 3],
    lengths: Lanes4,
    inverse_lengths: Lanes4,
    /// Gradients by edges: of stretching and of the corner that begins with the same vertex.
    gradients: [Lanes4; 3],
    /// Of that corner, by the edge after.
    gradients_after: [Lanes4; 3],
}

impl PackedRods {
    /// The fibres at rest, with nothing broken.
    pub(super) fn new(fibres: &[FibreRest]) -> Self {
        let count = fibres.iter().map(|fibre| fibre.vertices.len()).sum::<usize>();
        let packs = count.div_ceil(LANES);
        let mut this = Self { count, packs: vec![RodPack::default(); packs + 1], forces: zeros(LANES * packs) };
        let mut first = 0;
        for fibre in fibres {
            for (k, &(stiffness, rest_length)) in fibre.edges.iter().enumerate() {
                let (pack, lane) = this.pack(first + k);
                pack.stretching.0[lane] = stiffness;
                pack.rest_lengths.0[lane] = rest_length;
            }
            for (k, bend) in fibre.bends.iter().enumerate().filter(|(_, bend)| bend.curved.is_none()) {
                let (pack, lane) = this.pack(first + k);
                pack.bending.0[lane] = bend.stiffness;
            }
            first += fibre.vertices.len();
        }
        this
    }

    /// Number of vertices.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    #[inline(always)]
    fn pack(&mut self, vertex: usize) -> (&mut RodPack, usize) {
        (&mut self.packs[vertex / LANES], vertex % LANES)
    }

    /// Releases what is broken of the fibre whose first vertex is this one: it carries nothing any more.
    pub(super) fn release(&mut self, first: usize, bends: &[bool], edges: &[bool]) {
        for (k, _) in bends.iter().enumerate().filter(|(_, broken)| **broken) {
            let (pack, lane) = self.pack(first + k);
            pack.bending.0[lane] = 0.0;
        }
        for (k, _) in edges.iter().enumerate().filter(|(_, broken)| **broken) {
            let (pack, lane) = self.pack(first + k);
            pack.stretching.0[lane] = 0.0;
        }
    }

    /// Gives the edge that begins with a vertex another length at rest [m].
    pub(super) fn rest_at(&mut self, vertex: usize, length: f64) {
        let (pack, lane) = self.pack(vertex);
        pack.rest_lengths.0[lane] = length;
    }

    /// Gives the edge that begins with a vertex another stiffness [N/m].
    pub(super) fn stiffen_edge(&mut self, vertex: usize, stiffness: f64) {
        let (pack, lane) = self.pack(vertex);
        pack.stretching.0[lane] = stiffness;
    }

    /// Gives the straight bend that begins with a vertex another stiffness [N m].
    pub(super) fn stiffen_bend(&mut self, vertex: usize, stiffness: f64) {
        let (pack, lane) = self.pack(vertex);
        pack.bending.0[lane] = stiffness;
    }

    /// Puts a vertex somewhere [m].
    #[inline(always)]
    pub(super) fn put(&mut self, vertex: usize, at: DVec3) {
        let (pack, lane) = self.pack(vertex);
        for c in 0..3 {
            pack.positions[c].0[lane] = at[c];
        }
    }

    /// Computes the gradients [N] by all edges, of stretching and straight bending.
    #[inline(always)]
    pub(super) fn compute_gradients<S: Simd>(&mut self, simd: S) {
        let zero = f64x4::splat(simd, 0.0);
        let one = f64x4::splat(simd, 1.0);
        for k in 1..self.packs.len() {
            let (before, after) = self.packs.split_at_mut(k);
            let (this, next) = (&mut before[k - 1], &after[0]);
            let positions = Vec3x::load(simd, &this.positions);
            let edge = shifted(simd, positions, Vec3x::load(simd, &next.positions)) - positions;
            let length = edge.dot(edge).sqrt();
            let inverse = length.simd_gt(zero).select(one / length, zero);
            let tangent = edge * inverse;
            let pull = f64x4::load(simd, &this.stretching) * (length - f64x4::load(simd, &this.rest_lengths));
            this.tangents = tangent.store();
            this.lengths = length.store();
            this.inverse_lengths = inverse.store();
            this.gradients = (tangent * pull).store();
        }
        let (eight, fold) = (f64x4::splat(simd, 8.0), f64x4::splat(simd, FOLD));
        for k in 1..self.packs.len() {
            let (before, after) = self.packs.split_at_mut(k);
            let (this, next) = (&mut before[k - 1], &after[0]);
            let before = Vec3x::load(simd, &this.tangents);
            let after = shifted(simd, before, Vec3x::load(simd, &next.tangents));
            let inverse_before = f64x4::load(simd, &this.inverse_lengths);
            let inverse_after = simd.slide_f64x4::<1>(inverse_before, f64x4::load(simd, &next.inverse_lengths));
            let cosine = before.dot(after);
            let inverse = one / (one + cosine);
            // `-d/dc (1 - c) / (1 + c)`, twice over: 8 stands for 4 times 2 beyond the fold's 4 times 8, too.
            let steepness = cosine.simd_lt(fold).select(f64x4::splat(simd, 4.0), inverse * inverse);
            let slope = zero - eight * f64x4::load(simd, &this.bending) * steepness;
            let by_before = across(before, after, cosine, slope * inverse_before);
            this.gradients = (Vec3x::load(simd, &this.gradients) + by_before).store();
            this.gradients_after = across(after, before, cosine, slope * inverse_after).store();
        }
    }

    /// The edge that begins with a vertex, as it stands.
    pub(super) fn edge(&self, vertex: usize) -> Edge {
        let (pack, lane) = (&self.packs[vertex / LANES], vertex % LANES);
        Edge { tangent: vector_of(&pack.tangents, lane), length: pack.lengths.0[lane] }
    }

    /// Adds gradients [N] by both edges of corner k.
    pub(super) fn add(&mut self, k: usize, (before, after): (DVec3, DVec3)) {
        let (pack, lane) = self.pack(k);
        for c in 0..3 {
            pack.gradients[c].0[lane] += before[c];
            pack.gradients_after[c].0[lane] += after[c];
        }
    }

    /// Forces on all vertices [N].
    #[inline(always)]
    pub(super) fn forces<S: Simd>(&mut self, simd: S) -> &SoaVectors {
        let zero = f64x4::splat(simd, 0.0);
        // Of the four before: gradients by the edges after, and all gradients by edges.
        let (mut after_before, mut sums_before) = (Vec3x::splat(zero), Vec3x::splat(zero));
        let [x, y, z] = &mut self.forces;
        let columns = [x.as_chunks_mut().0, y.as_chunks_mut().0, z.as_chunks_mut().0];
        for (k, pack) in self.packs.iter().enumerate().take(columns[0].len()) {
            let gradients: Vec3x<f64x4<S>> = Vec3x::load(simd, &pack.gradients);
            let after = Vec3x::load(simd, &pack.gradients_after);
            for c in 0..3 {
                let sum = gradients[c] + simd.slide_f64x4::<3>(after_before[c], after[c]);
                columns[c][k] = (sum - simd.slide_f64x4::<3>(sums_before[c], sum)).into();
                sums_before[c] = sum;
            }
            after_before = after;
        }
        &self.forces
    }
}

/// The vectors that follow those of four, of which the next four are given.
#[inline(always)]
fn shifted<S: Simd>(simd: S, four: Vec3x<f64x4<S>>, next: Vec3x<f64x4<S>>) -> Vec3x<f64x4<S>> {
    let mut out = four;
    for c in 0..3 {
        out[c] = simd.slide_f64x4::<1>(four[c], next[c]);
    }
    out
}

/// The part of another tangent that lies across a tangent, times a factor.
#[inline(always)]
fn across<V: Wide>(tangent: Vec3x<V>, other: Vec3x<V>, cosine: V, factor: V) -> Vec3x<V> {
    (other - tangent * cosine) * factor
}
