//! Weighted sums over the particles around many points, and forces on those points passed back by the same weights.
//!
//! Over the blocks of a strip the weights are a matrix with a row for each point. Its rows and columns have one run of
//! weights each, hardly with a gap, and gaps are zeros. So no sum looks up an index, and none is written before it is
//! complete: positions are summed along rows, forces along columns, each in the order in which its weights stand in
//! memory.

use super::soa::SoaVectors;
use super::strip::{BlockVectors, StripIndex, WIDTH};
use crate::solver::wide::{LANES, Lanes4, Lanes8, Vec3x, Wide};
use fearless_simd::{Simd, f64x4, f64x8, prelude::*};
use glam::DVec3;
use std::collections::BTreeMap;
use std::ops::Range;

/// Weights of N kinds of many points over a strip, in both orders.
#[derive(Clone, Debug)]
pub(super) struct BandMatrix<const N: usize> {
    points: SkylineRows<N>,
    blocks: SkylineRows<N>,
}

/// Points with their weights, before they are put into a band.
#[derive(Debug, Default)]
pub(super) struct BandBuilder<const N: usize> {
    count: usize,
    /// Weights of a point and a block.
    entries: BTreeMap<[usize; 2], [Lanes8; N]>,
}

impl<const N: usize> BandBuilder<N> {
    /// Adds a point by its particles and their weights.
    pub(super) fn add(&mut self, index: &StripIndex, particles: impl Iterator<Item = (u32, [f64; N])>) {
        for (particle, weights) in particles {
            let (block, place) = index.of(particle);
            let entry = self.entries.entry([self.count, block]).or_insert([Lanes8::default(); N]);
            for (entry, weight) in entry.iter_mut().zip(weights) {
                entry.0[place] += weight;
            }
        }
        self.count += 1;
    }

    /// The band over this many blocks.
    pub(super) fn band(&self, blocks: usize) -> BandMatrix<N> {
        let points = SkylineRows::new(self.count, self.entries.iter().map(|(&[point, block], w)| ([point, block], w)));
        let blocks = SkylineRows::new(blocks, self.entries.iter().map(|(&[point, block], w)| ([block, point], w)));
        BandMatrix { points, blocks }
    }
}

/// Rows of a matrix in skyline storage: each from its first entry to its last, gaps between them filled with zeros.
#[derive(Clone, Debug)]
struct SkylineRows<const N: usize> {
    /// First column of each row, and where its entries begin and end.
    rows: Vec<(u32, Range<u32>)>,
    entries: Vec<[Lanes8; N]>,
}

impl<const N: usize> SkylineRows<N> {
    fn new<'a>(rows: usize, entries: impl Iterator<Item = ([usize; 2], &'a [Lanes8; N])> + Clone) -> Self {
        let mut columns = vec![0..0; rows];
        for ([row, column], _) in entries.clone() {
            let Range { start, end } = &mut columns[row];
            *start = if start == end { column } else { column.min(*start) };
            *end = (column + 1).max(*end);
        }
        let mut this = Self { rows: Vec::new(), entries: Vec::new() };
        for columns in &columns {
            let begun = this.entries.len();
            this.entries.resize(begun + columns.len(), [Lanes8::default(); N]);
            this.rows.push((columns.start as u32, begun as u32..this.entries.len() as u32));
        }
        for ([row, column], weights) in entries {
            let begun = this.rows[row].1.start as usize;
            this.entries[begun + column - columns[row].start] = *weights;
        }
        this
    }

    /// Columns of a row and the entries there.
    #[inline(always)]
    fn row(&self, row: usize) -> (Range<usize>, &[[Lanes8; N]]) {
        let (first, entries) = &self.rows[row];
        let entries = &self.entries[entries.start as usize..entries.end as usize];
        (*first as usize..*first as usize + entries.len(), entries)
    }
}

impl<const N: usize> BandMatrix<N> {
    /// What [`Self::gather`] gives, before the lanes are added up.
    #[inline(always)]
    fn sums<S: Simd>(&self, simd: S, point: usize, blocks: &[BlockVectors]) -> [Vec3x<f64x8<S>>; N] {
        let (columns, weights) = self.points.row(point);
        let blocks = &blocks[columns];
        let mut sums = [Vec3x::splat(f64x8::splat(simd, 0.0)); N];
        for k in 0..weights.len().min(blocks.len()) {
            for kind in 0..N {
                let weights = f64x8::load(simd, &weights[k][kind]);
                sums[kind] = Vec3x::load(simd, &blocks[k]).mul_add(weights, sums[kind]);
            }
        }
        sums
    }

    /// [`Self::sums`], both halves of which are added: one after the other, so that the sums of several kinds of weight
    /// stay in sixteen registers.
    #[inline(always)]
    fn sums_by_halves<S: Simd>(&self, simd: S, point: usize, blocks: &[BlockVectors]) -> [Vec3x<f64x4<S>>; N] {
        let (columns, weights) = self.points.row(point);
        let blocks = &blocks[columns];
        let mut added = [Vec3x::splat(f64x4::splat(simd, 0.0)); N];
        for half in 0..2 {
            let mut sums = [Vec3x::splat(f64x4::splat(simd, 0.0)); N];
            for (weights, [x, y, z]) in weights.iter().zip(blocks) {
                let at = Vec3x([x.half(simd, half), y.half(simd, half), z.half(simd, half)]);
                for kind in 0..N {
                    sums[kind] = at.mul_add(weights[kind].half(simd, half), sums[kind]);
                }
            }
            for kind in 0..N {
                added[kind] += sums[kind];
            }
        }
        added
    }

    /// [`Self::gather`] of four points from one on, those that there are, by the components of every kind.
    #[inline(always)]
    pub(super) fn gather_four<S: Simd>(
        &self,
        simd: S,
        first: usize,
        blocks: &[BlockVectors],
        gathered: &mut [[Lanes4; 3]; N],
    ) {
        let zero = f64x4::splat(simd, 0.0);
        let mut halves = [[[zero; LANES]; 3]; N];
        for lane in 0..LANES.min(self.points.rows.len() - first) {
            let sums = self.sums_by_halves(simd, first + lane, blocks);
            for kind in 0..N {
                for c in 0..3 {
                    halves[kind][c][lane] = sums[kind][c];
                }
            }
        }
        for kind in 0..N {
            for c in 0..3 {
                gathered[kind][c] = totals(simd, halves[kind][c]).store();
            }
        }
    }

    /// `sum w x` over the particles around a point, for every kind of weight.
    #[inline(always)]
    pub(super) fn gather<S: Simd>(&self, simd: S, point: usize, blocks: &[BlockVectors]) -> [DVec3; N] {
        let sums = self.sums(simd, point, blocks);
        let mut gathered = [DVec3::ZERO; N];
        for kind in 0..N {
            gathered[kind] =
                DVec3::new(total(simd, sums[kind][0]), total(simd, sums[kind][1]), total(simd, sums[kind][2]));
        }
        gathered
    }

    /// Adds to the vectors of a block's particles `sum w value` over the points around it, for every kind of weight.
    #[inline(always)]
    pub(super) fn scatter<S: Simd>(&self, simd: S, block: usize, values: &[SoaVectors; N], sums: &mut Vec3x<f64x8<S>>) {
        let (points, weights) = self.blocks.row(block);
        for kind in 0..N {
            let [x, y, z] = &values[kind];
            let (x, y, z) = (&x[points.clone()], &y[points.clone()], &z[points.clone()]);
            for k in 0..weights.len() {
                let weights = f64x8::load(simd, &weights[k][kind]);
                let value = Vec3x([f64x8::splat(simd, x[k]), f64x8::splat(simd, y[k]), f64x8::splat(simd, z[k])]);
                *sums = value.mul_add(weights, *sums);
            }
        }
    }
}

/// Sums of the lanes of four registers, each in the order of [`total`].
#[inline(always)]
fn totals<S: Simd>(simd: S, [a, b, c, d]: [f64x4<S>; LANES]) -> f64x4<S> {
    let even = [simd.unzip_low_f64x4(a, b), simd.unzip_low_f64x4(c, d)];
    let odd = [simd.unzip_high_f64x4(a, b), simd.unzip_high_f64x4(c, d)];
    let first = simd.unzip_low_f64x4(even[0], even[1]) + simd.unzip_high_f64x4(even[0], even[1]);
    first + (simd.unzip_low_f64x4(odd[0], odd[1]) + simd.unzip_high_f64x4(odd[0], odd[1]))
}

/// Sum of all lanes.
#[inline(always)]
fn total<S: Simd>(simd: S, lanes: f64x8<S>) -> f64 {
    let (low, high) = simd.split_f64x8(lanes);
    let [a, b, c, d]: [f64; WIDTH / 2] = (low + high).into();
    (a + c) + (b + d)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::embedding::EmbeddingWeights;
    use crate::solver::forces::fibre::strip::Strip;
    use fearless_simd::{Level, dispatch};

    /// Points over thirty particles: in a row, with gaps, at the end, out of order, none.
    fn stencils() -> Vec<EmbeddingWeights> {
        let picks: [&[u32]; 6] =
            [&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9], &[10], &[7, 22, 9, 11, 12, 13, 14, 15, 16], &[27, 28, 29], &[], &[3, 29]];
        let weights = |picks: &&[u32]| picks.iter().map(|&k| (k, 0.3 + 0.1 * f64::from(k))).collect();
        picks.iter().map(|picks| EmbeddingWeights { weights: weights(picks) }).collect()
    }

    /// Two fibres with their points' weights and minus twice these.
    fn two_fibres(stencils: &[EmbeddingWeights]) -> (Strip, StripIndex, BandMatrix<2>) {
        let (mut strip, mut points) = (Strip::default(), BandBuilder::default());
        let mut add = |fibre: &[EmbeddingWeights]| {
            let around = |(k, stencil): (usize, &EmbeddingWeights)| {
                stencil.weights.clone().into_iter().map(move |(p, _)| (k, p))
            };
            let index = strip.add(fibre.iter().enumerate().flat_map(around));
            for stencil in fibre {
                points.add(&index, stencil.weights.iter().map(|&(k, w)| (k, [w, -2.0 * w])));
            }
            index
        };
        let index = add(&stencils[..3]);
        add(&stencils[3..]);
        let band = points.band(strip.len());
        (strip, index, band)
    }

    #[test]
    fn sums_are_those_of_the_stencils_one_by_one() {
        let stencils = stencils();
        let (strip, index, band) = two_fibres(&stencils);
        let field: Vec<DVec3> = (0..30).map(|k| DVec3::new(f64::from(k), 0.5 * f64::from(k * k), -3.0)).collect();
        let mut blocks = vec![BlockVectors::default(); strip.len()];
        dispatch!(Level::new(), simd => Strip::fill(&strip, simd, &field, &mut blocks));
        let (block, place) = index.of(5);
        let origin = field[5] - DVec3::from_array([0, 1, 2].map(|c| blocks[block][c].0[place]));
        for (point, stencil) in stencils.iter().enumerate() {
            let [sum, other] = dispatch!(Level::new(), simd => BandMatrix::gather(&band, simd, point, &blocks));
            let total: f64 = stencil.weights.iter().map(|(_, w)| w).sum();
            let expected = stencil.gather(&field) - total * origin;
            assert!(sum.distance(expected) < 1e-11, "{point}: {sum}, not {expected}");
            assert!(other.distance(-2.0 * expected) < 1e-11);
        }
    }

    #[test]
    fn four_points_at_once_are_those_one_by_one_to_the_bit() {
        let stencils = stencils();
        let (strip, _, band) = two_fibres(&stencils);
        let field: Vec<DVec3> = (0..30).map(|k| DVec3::new(f64::from(k).sin(), 0.3 * f64::from(k), -1.7)).collect();
        let mut blocks = vec![BlockVectors::default(); strip.len()];
        dispatch!(Level::new(), simd => Strip::fill(&strip, simd, &field, &mut blocks));
        for first in [0, 1, 4] {
            let mut four = [[Lanes4::default(); 3]; 2];
            dispatch!(Level::new(), simd => BandMatrix::gather_four(&band, simd, first, &blocks, &mut four));
            for lane in 0..4 {
                let one =
                    |point: usize| dispatch!(Level::new(), simd => BandMatrix::gather(&band, simd, point, &blocks));
                let expected = if first + lane < stencils.len() { one(first + lane) } else { [DVec3::ZERO; 2] };
                let found = [0, 1].map(|kind: usize| crate::solver::wide::vector_of(&four[kind], lane));
                assert_eq!(found, expected, "{first} + {lane}");
            }
        }
    }

    #[test]
    fn forces_are_those_of_the_stencils_one_by_one() {
        let stencils = stencils();
        let (strip, _, band) = two_fibres(&stencils);
        let values = |by: f64| [0, 1, 2].map(|c| (0..6).map(|k| by * f64::from(k + c).sin()).collect::<Vec<f64>>());
        let values = [values(1.0), values(0.3)];
        let (mut forces, mut one_by_one) = (vec![DVec3::X; 30], vec![DVec3::X; 30]);
        dispatch!(Level::new(), simd => {
            for block in 0..strip.len() {
                let mut sums = Vec3x::splat(f64x8::splat(simd, 0.0));
                BandMatrix::scatter(&band, simd, block, &values, &mut sums);
                Strip::pass_on(&strip, block, sums, &mut forces);
            }
        });
        for (point, stencil) in stencils.iter().enumerate() {
            let [value, other] = [0, 1].map(|kind: usize| DVec3::from_array([0, 1, 2].map(|c| values[kind][c][point])));
            stencil.scatter(value - 2.0 * other, &mut one_by_one);
        }
        for (force, expected) in forces.iter().zip(&one_by_one) {
            assert!(force.distance(*expected) < 1e-12, "{force}, not {expected}");
        }
    }
}
