//! Stretching and straight bending of all fibres of a body, four edges at a time.
//!
//! The fibres stand one after another in one long line, with an edge and two corners between them that have no stiffness,
//! as everything that is broken or bends by other rules has none. An energy's gradients by the edges are what is summed:
//! a vertex is pulled by the edge after it and against the edge before it.

use super::corner::{Corner, Edge, FOLD};
use super::rest::FibreRest;
use crate::solver::forces::matrix::lanes::{LANES, Vectors, dot, scaled};
use crate::solver::scratch::Scratch;
use fearless_simd::{Simd, f64x4, prelude::*};
use glam::DVec3;
use std::sync::Arc;

/// A vector for each vertex or edge, by components.
type Columns = [Vec<f64>; 3];

/// Vertices and edges of all fibres; edge and corner k begin with vertex k.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    count: usize,
    stretching: Arc<Vec<f64>>,
    rest_lengths: Arc<[f64]>,
    bending: Arc<Vec<f64>>,
    buffers: Scratch<Buffers>,
}

/// What is computed of vertices and edges.
#[derive(Debug, Default)]
struct Buffers {
    positions: Columns,
    tangents: Columns,
    lengths: Vec<f64>,
    inverse_lengths: Vec<f64>,
    /// Gradients by edges: of stretching and of the corner that the edge ends in.
    slopes: Columns,
    /// Of the corner that the edge begins in.
    slopes_after: Columns,
}

impl Buffers {
    /// Makes room for so many numbers; those beyond the fibres are never written and stay zero.
    fn fit(&mut self, numbers: usize) {
        let columns = [&mut self.positions, &mut self.tangents, &mut self.slopes, &mut self.slopes_after];
        let columns = columns.into_iter().flatten().chain([&mut self.lengths, &mut self.inverse_lengths]);
        columns.for_each(|column| column.resize(numbers, 0.0));
    }
}

impl Lines {
    /// The fibres at rest, with nothing broken.
    pub(super) fn new(fibres: &[FibreRest]) -> Self {
        let count = fibres.iter().map(|fibre| fibre.vertices.len()).sum::<usize>();
        // Whole lanes, and the vertices that the last of them look at beyond.
        let numbers = count.next_multiple_of(LANES) + LANES;
        let [mut stretching, mut rest_lengths, mut bending] = [(); 3].map(|()| vec![0.0; numbers]);
        let mut first = 0;
        for fibre in fibres {
            for (k, &(stiffness, rest_length)) in fibre.edges.iter().enumerate() {
                stretching[first + k] = stiffness;
                rest_lengths[first + k] = rest_length;
            }
            for (k, bend) in fibre.bends.iter().enumerate() {
                if bend.curved.is_none() {
                    bending[first + k] = bend.stiffness;
                }
            }
            first += fibre.vertices.len();
        }
        let (stretching, bending) = (Arc::new(stretching), Arc::new(bending));
        Self { count, stretching, rest_lengths: rest_lengths.into(), bending, buffers: Scratch::default() }
    }

    /// Memory that a copy of its own takes once something is broken [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&**self.stretching) + size_of_val(&**self.bending)
    }

    /// Number of vertices.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// What is broken of the fibre whose first vertex is this one carries nothing any more.
    pub(super) fn lose(&mut self, first: usize, bends: &[bool], edges: &[bool]) {
        for (stiffness, broken) in [(&mut self.bending, bends), (&mut self.stretching, edges)] {
            for k in (0..broken.len()).filter(|&k| broken[k]) {
                // Copies share what is as it was.
                if stiffness[first + k] != 0.0 {
                    Arc::make_mut(stiffness)[first + k] = 0.0;
                }
            }
        }
    }

    /// Makes ready for vertices to be put.
    pub(super) fn begin(&mut self) {
        self.buffers.fit(self.rest_lengths.len());
    }

    /// Puts a vertex somewhere [m].
    #[inline(always)]
    pub(super) fn put(&mut self, vertex: usize, at: DVec3) {
        for (column, number) in self.buffers.positions.iter_mut().zip(at.to_array()) {
            column[vertex] = number;
        }
    }

    /// Gradients [N] by all edges, of stretching and straight bending.
    #[inline(always)]
    pub(super) fn slopes<S: Simd>(&mut self, simd: S) {
        let Self { count, stretching, rest_lengths, bending, buffers } = self;
        let Buffers { positions, tangents, lengths, inverse_lengths, slopes, slopes_after } = &mut **buffers;
        let zero = f64x4::splat(simd, 0.0);
        let one = f64x4::splat(simd, 1.0);
        for k in (0..*count).step_by(LANES) {
            let mut edge = [zero; 3];
            for c in 0..3 {
                edge[c] = at(simd, &positions[c], k + 1) - at(simd, &positions[c], k);
            }
            let length = dot(&edge, &edge).sqrt();
            let inverse = length.simd_gt(zero).select(one / length, zero);
            let tangent = scaled(inverse, edge);
            let pull = at(simd, stretching, k) * (length - at(simd, rest_lengths, k));
            set_all(tangents, k, tangent);
            set(lengths, k, length);
            set(inverse_lengths, k, inverse);
            set_all(slopes, k, scaled(pull, tangent));
        }
        let (eight, fold) = (f64x4::splat(simd, 8.0), f64x4::splat(simd, FOLD));
        for k in (0..*count).step_by(LANES) {
            let (before, after) = (all(simd, tangents, k), all(simd, tangents, k + 1));
            let cosine = dot(&before, &after);
            let inverse = one / (one + cosine);
            // `-d/dc (1 - c) / (1 + c)`, twice over: 8 stands for 4 times 2 beyond the fold's 4 times 8, too.
            let steepness = cosine.simd_lt(fold).select(f64x4::splat(simd, 4.0), inverse * inverse);
            let slope = zero - eight * at(simd, bending, k) * steepness;
            let across = |of: Vectors<S>, other: Vectors<S>, inverse_length: f64x4<S>| {
                // The part of the other tangent that lies across this one.
                let mut part = other;
                for c in 0..3 {
                    part[c] -= of[c] * cosine;
                }
                scaled(slope * inverse_length, part)
            };
            let by_before = across(before, after, at(simd, inverse_lengths, k));
            let by_after = across(after, before, at(simd, inverse_lengths, k + 1));
            let mut sum = all(simd, slopes, k);
            for c in 0..3 {
                sum[c] += by_before[c];
            }
            set_all(slopes, k, sum);
            set_all(slopes_after, k + 1, by_after);
        }
    }

    /// Corner k as it stands; none if one of its edges has no length.
    pub(super) fn corner(&self, k: usize) -> Option<Corner> {
        let edge = |k: usize| Edge {
            tangent: DVec3::from_array([0, 1, 2].map(|c| self.buffers.tangents[c][k])),
            length: self.buffers.lengths[k],
        };
        Corner::between(edge(k), edge(k + 1))
    }

    /// Adds gradients [N] by both edges of corner k.
    pub(super) fn add(&mut self, k: usize, (before, after): (DVec3, DVec3)) {
        for c in 0..3 {
            self.buffers.slopes[c][k] += before[c];
            self.buffers.slopes_after[c][k + 1] += after[c];
        }
    }

    /// Force on a vertex [N].
    #[inline(always)]
    pub(super) fn force(&self, vertex: usize) -> DVec3 {
        let edge = |k: usize, c: usize| self.buffers.slopes[c][k] + self.buffers.slopes_after[c][k];
        let before = |c: usize| if vertex > 0 { edge(vertex - 1, c) } else { 0.0 };
        DVec3::new(edge(vertex, 0) - before(0), edge(vertex, 1) - before(1), edge(vertex, 2) - before(2))
    }
}

#[inline(always)]
fn at<S: Simd>(simd: S, column: &[f64], k: usize) -> f64x4<S> {
    f64x4::from_slice(simd, &column[k..k + LANES])
}

#[inline(always)]
fn all<S: Simd>(simd: S, columns: &Columns, k: usize) -> Vectors<S> {
    [at(simd, &columns[0], k), at(simd, &columns[1], k), at(simd, &columns[2], k)]
}

#[inline(always)]
fn set<S: Simd>(column: &mut [f64], k: usize, value: f64x4<S>) {
    value.store_slice(&mut column[k..k + LANES]);
}

#[inline(always)]
fn set_all<S: Simd>(columns: &mut Columns, k: usize, values: Vectors<S>) {
    for c in 0..3 {
        set(&mut columns[c], k, values[c]);
    }
}
