//! Stretching and straight bending of all fibres of a body, four edges at a time.
//!
//! The fibres stand one after another in one long line, with an edge and two corners between them that have no stiffness,
//! as everything that is broken or bends by other rules has none. An energy's gradients by the edges are what is summed:
//! a vertex is pulled by the edge after it and against the edge before it.

use super::corner::{Corner, Edge, FOLD};
use super::rest::FibreRest;
use crate::solver::forces::matrix::lanes::{LANES, Lanes, Vectors, dot, load, load_all, scaled, store, store_all};
use fearless_simd::{Simd, f64x4, prelude::*};
use glam::DVec3;

/// A vector for each vertex, by components.
pub(super) type Columns = [Vec<f64>; 3];

/// Vertices and edges of all fibres; edge and corner k begin with vertex k.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    count: usize,
    /// All of them, and an empty four, which the last one looks at.
    fours: Vec<Four>,
    /// Forces on vertices.
    forces: Columns,
}

/// Four vertices with the edges and corners that begin with them.
#[derive(Clone, Debug, Default)]
struct Four {
    stretching: Lanes,
    rest_lengths: Lanes,
    bending: Lanes,
    positions: [Lanes; 3],
    tangents: [Lanes; 3],
    lengths: Lanes,
    inverse_lengths: Lanes,
    /// Gradients by edges: of stretching and of the corner that begins with the same vertex.
    slopes: [Lanes; 3],
    /// Of that corner, by the edge after.
    slopes_after: [Lanes; 3],
}

impl Lines {
    /// The fibres at rest, with nothing broken.
    pub(super) fn new(fibres: &[FibreRest]) -> Self {
        let count = fibres.iter().map(|fibre| fibre.vertices.len()).sum::<usize>();
        let fours = count.div_ceil(LANES);
        let forces = [0, 1, 2].map(|_| vec![0.0; LANES * fours]);
        let mut this = Self { count, fours: vec![Four::default(); fours + 1], forces };
        let mut first = 0;
        for fibre in fibres {
            for (k, &(stiffness, rest_length)) in fibre.edges.iter().enumerate() {
                let (four, lane) = this.four(first + k);
                four.stretching.0[lane] = stiffness;
                four.rest_lengths.0[lane] = rest_length;
            }
            for (k, bend) in fibre.bends.iter().enumerate().filter(|(_, bend)| bend.curved.is_none()) {
                let (four, lane) = this.four(first + k);
                four.bending.0[lane] = bend.stiffness;
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
    fn four(&mut self, vertex: usize) -> (&mut Four, usize) {
        (&mut self.fours[vertex / LANES], vertex % LANES)
    }

    /// What is broken of the fibre whose first vertex is this one carries nothing any more.
    pub(super) fn lose(&mut self, first: usize, bends: &[bool], edges: &[bool]) {
        for (k, _) in bends.iter().enumerate().filter(|(_, broken)| **broken) {
            let (four, lane) = self.four(first + k);
            four.bending.0[lane] = 0.0;
        }
        for (k, _) in edges.iter().enumerate().filter(|(_, broken)| **broken) {
            let (four, lane) = self.four(first + k);
            four.stretching.0[lane] = 0.0;
        }
    }

    /// Puts a vertex somewhere [m].
    #[inline(always)]
    pub(super) fn put(&mut self, vertex: usize, at: DVec3) {
        let (four, lane) = self.four(vertex);
        for c in 0..3 {
            four.positions[c].0[lane] = at[c];
        }
    }

    /// Gradients [N] by all edges, of stretching and straight bending.
    #[inline(always)]
    pub(super) fn slopes<S: Simd>(&mut self, simd: S) {
        let zero = f64x4::splat(simd, 0.0);
        let one = f64x4::splat(simd, 1.0);
        for k in 1..self.fours.len() {
            let (before, after) = self.fours.split_at_mut(k);
            let (this, next) = (&mut before[k - 1], &after[0]);
            let positions = load_all(simd, &this.positions);
            let mut edge = shifted(simd, positions, load_all(simd, &next.positions));
            for c in 0..3 {
                edge[c] -= positions[c];
            }
            let length = dot(&edge, &edge).sqrt();
            let inverse = length.simd_gt(zero).select(one / length, zero);
            let tangent = scaled(inverse, edge);
            let pull = load(simd, &this.stretching) * (length - load(simd, &this.rest_lengths));
            this.tangents = store_all(tangent);
            this.lengths = store(length);
            this.inverse_lengths = store(inverse);
            this.slopes = store_all(scaled(pull, tangent));
        }
        let (eight, fold) = (f64x4::splat(simd, 8.0), f64x4::splat(simd, FOLD));
        for k in 1..self.fours.len() {
            let (before, after) = self.fours.split_at_mut(k);
            let (this, next) = (&mut before[k - 1], &after[0]);
            let before = load_all(simd, &this.tangents);
            let after = shifted(simd, before, load_all(simd, &next.tangents));
            let inverse_before = load(simd, &this.inverse_lengths);
            let inverse_after = simd.slide_f64x4::<1>(inverse_before, load(simd, &next.inverse_lengths));
            let cosine = dot(&before, &after);
            let inverse = one / (one + cosine);
            // `-d/dc (1 - c) / (1 + c)`, twice over: 8 stands for 4 times 2 beyond the fold's 4 times 8, too.
            let steepness = cosine.simd_lt(fold).select(f64x4::splat(simd, 4.0), inverse * inverse);
            let slope = zero - eight * load(simd, &this.bending) * steepness;
            let by_before = across(before, after, cosine, slope * inverse_before);
            let mut slopes = load_all(simd, &this.slopes);
            for c in 0..3 {
                slopes[c] += by_before[c];
            }
            this.slopes = store_all(slopes);
            this.slopes_after = store_all(across(after, before, cosine, slope * inverse_after));
        }
    }

    /// Corner k as it stands; none if one of its edges has no length.
    pub(super) fn corner(&self, k: usize) -> Option<Corner> {
        let edge = |k: usize| {
            let (four, lane) = (&self.fours[k / LANES], k % LANES);
            let tangent = DVec3::from_array([0, 1, 2].map(|c: usize| four.tangents[c].0[lane]));
            Edge { tangent, length: four.lengths.0[lane] }
        };
        Corner::between(edge(k), edge(k + 1))
    }

    /// Adds gradients [N] by both edges of corner k.
    pub(super) fn add(&mut self, k: usize, (before, after): (DVec3, DVec3)) {
        let (four, lane) = self.four(k);
        for c in 0..3 {
            four.slopes[c].0[lane] += before[c];
            four.slopes_after[c].0[lane] += after[c];
        }
    }

    /// Forces on all vertices [N].
    #[inline(always)]
    pub(super) fn forces<S: Simd>(&mut self, simd: S) -> &Columns {
        let zero = f64x4::splat(simd, 0.0);
        // Of the four before: gradients by the edges after, and all gradients by edges.
        let (mut after_before, mut sums_before) = ([zero; 3], [zero; 3]);
        let [x, y, z] = &mut self.forces;
        let columns = [x.as_chunks_mut().0, y.as_chunks_mut().0, z.as_chunks_mut().0];
        for (k, four) in self.fours.iter().enumerate().take(columns[0].len()) {
            let (slopes, after) = (load_all(simd, &four.slopes), load_all(simd, &four.slopes_after));
            for c in 0..3 {
                let sum = slopes[c] + simd.slide_f64x4::<3>(after_before[c], after[c]);
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
fn shifted<S: Simd>(simd: S, four: Vectors<S>, next: Vectors<S>) -> Vectors<S> {
    let mut out = four;
    for c in 0..3 {
        out[c] = simd.slide_f64x4::<1>(four[c], next[c]);
    }
    out
}

/// The part of another tangent that lies across a tangent, times a factor.
#[inline(always)]
fn across<S: Simd>(tangent: Vectors<S>, other: Vectors<S>, cosine: f64x4<S>, factor: f64x4<S>) -> Vectors<S> {
    let mut part = other;
    for c in 0..3 {
        part[c] -= tangent[c] * cosine;
    }
    scaled(factor, part)
}

/// Puts a vector into a place.
#[inline(always)]
pub(super) fn put(columns: &mut Columns, place: usize, vector: DVec3) {
    let [x, y, z] = columns;
    (x[place], y[place], z[place]) = (vector.x, vector.y, vector.z);
}
