//! How the vertices of fibres give way together: `G = Phi M^-1 Phi^T`, and its root.
//!
//! A force y on the vertices accelerates them by `G y`, along each axis for itself, since particles may be held along
//! some axes only. G is positive semi-definite: vertices that are carried by held particles alone do not move at all,
//! and more vertices than particles around them move together. Its root U, `G = U^T U`, exists all the same.

use super::blocks::Envelope;
use super::ordering::near_neighbours_first;
use super::tangent::BEND_REACH;
use crate::solver::forces::fibre::rest::FibreRest;
use crate::solver::wide::{Lanes4, Wide};
use fearless_simd::{Simd, f64x4, prelude::*};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Share of a diagonal entry below which what is left of it is round-off.
const ROUND_OFF: f64 = 1e-10;

/// The root of G, in an order of its own.
#[derive(Debug)]
pub(super) struct Gram {
    /// Place of every vertex, fibre after fibre.
    pub(super) places: Vec<usize>,
    /// Rows of U; all axes side by side.
    envelope: Envelope,
    root: Vec<Lanes4>,
    /// Envelope of `U H U^T`, where H couples each vertex with [`BEND_REACH`] to either side.
    pub(super) coupled: Envelope,
    /// For every row of H the blocks that may not be zero, by their number in the band and their column.
    columns: Vec<Vec<(usize, usize)>>,
}

impl Gram {
    /// Of fibres on particles of these inverse masses [1/kg], zero along held axes.
    pub(super) fn new(fibres: &[FibreRest], inverse_masses: &[DVec3]) -> Self {
        let mut on: BTreeMap<u32, Vec<(usize, f64)>> = BTreeMap::new();
        let vertices = fibres.iter().flat_map(|fibre| &fibre.vertices);
        let count = vertices.clone().count();
        for (vertex, weights) in vertices.enumerate() {
            for &(particle, phi) in &weights.weights {
                on.entry(particle).or_default().push((vertex, phi));
            }
        }
        let mut entries: BTreeMap<[usize; 2], DVec3> = BTreeMap::new();
        for (particle, weights) in &on {
            let inverse_mass = inverse_masses[*particle as usize];
            for &(a, by) in weights {
                for &(b, other) in weights {
                    *entries.entry([a, b]).or_default() += by * other * inverse_mass;
                }
            }
        }
        let bent = bent_together(fibres);
        let mut neighbours = bent.clone();
        for &[a, b] in entries.keys().filter(|[a, b]| a != b) {
            neighbours[a].insert(b);
        }
        let order = near_neighbours_first(&neighbours);
        let mut places = vec![0; count];
        for (place, &vertex) in order.iter().enumerate() {
            places[vertex] = place;
        }
        let mut ends: Vec<usize> = (1..=count).collect();
        for &[a, b] in entries.keys() {
            let (row, column) = (places[a].min(places[b]), places[a].max(places[b]));
            ends[row] = ends[row].max(column + 1);
        }
        let envelope = Envelope::new(ends);
        let mut root = vec![Lanes4::default(); envelope.entries()];
        for ([a, b], entry) in entries {
            if places[a] <= places[b] {
                root[envelope.row(places[a]).start + places[b] - places[a]] = lanes(entry);
            }
        }
        take_root(&mut root, &envelope);
        let columns: Vec<Vec<(usize, usize)>> = order
            .iter()
            .map(|&vertex| {
                let with_itself = bent[vertex].iter().chain([&vertex]);
                with_itself.map(|&other| (BEND_REACH + other - vertex, places[other])).collect()
            })
            .collect();
        let furthest: Vec<usize> =
            columns.iter().map(|row| row.iter().map(|&(_, column)| column + 1).fold(0, usize::max)).collect();
        let coupled = (0..count).map(|row| furthest[row..envelope.ends[row]].iter().copied().fold(0, usize::max));
        let coupled = Envelope::new(coupled);
        Self { places, envelope, root, coupled, columns }
    }

    /// Number of vertices.
    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// Columns of a row of U and its entries.
    #[inline(always)]
    pub(super) fn row(&self, row: usize) -> (usize, &[Lanes4]) {
        (self.envelope.ends[row], &self.root[self.envelope.row(row)])
    }

    /// The blocks of a row of H that may not be zero: each one's number in the band, and its column.
    #[inline(always)]
    pub(super) fn columns(&self, row: usize) -> &[(usize, usize)] {
        &self.columns[row]
    }

    /// `U v`.
    #[inline(always)]
    pub(super) fn root_times<S: Simd>(&self, simd: S, v: &[Lanes4], out: &mut [Lanes4]) {
        for row in 0..self.len() {
            let (end, entries) = self.row(row);
            let mut sum = f64x4::splat(simd, 0.0);
            for (entry, v) in entries.iter().zip(&v[row..end]) {
                sum = f64x4::load(simd, entry).mul_add(f64x4::load(simd, v), sum);
            }
            out[row] = sum.store();
        }
    }

    /// `U^T v`.
    #[inline(always)]
    pub(super) fn transposed_times<S: Simd>(&self, simd: S, v: &[Lanes4], out: &mut [Lanes4]) {
        out.fill(Lanes4::default());
        for row in 0..self.len() {
            let (end, entries) = self.row(row);
            let by = f64x4::load(simd, &v[row]);
            for (entry, out) in entries.iter().zip(&mut out[row..end]) {
                *out = f64x4::load(simd, entry).mul_add(by, f64x4::load(simd, out)).store();
            }
        }
    }
}

/// A vector in three of four lanes.
pub(super) fn lanes(vector: DVec3) -> Lanes4 {
    Lanes4([vector.x, vector.y, vector.z, 0.0])
}

/// For every vertex the others of its fibre that bend with it.
fn bent_together(fibres: &[FibreRest]) -> Vec<BTreeSet<usize>> {
    let mut bent = Vec::new();
    for fibre in fibres {
        let (first, end) = (bent.len(), bent.len() + fibre.vertices.len());
        for vertex in first..end {
            let near = vertex.saturating_sub(BEND_REACH).max(first)..(vertex + BEND_REACH + 1).min(end);
            bent.push(near.filter(|&near| near != vertex).collect());
        }
    }
    bent
}

/// Cholesky's factor of a semi-definite matrix in place, each lane for itself: a row whose pivot is round-off is zero.
fn take_root(rows: &mut [Lanes4], envelope: &Envelope) {
    let diagonal: Vec<Lanes4> = (0..envelope.len()).map(|row| rows[envelope.row(row).start]).collect();
    for (j, diagonal) in diagonal.iter().enumerate() {
        let at = envelope.row(j);
        for lane in 0..3 {
            let pivot = rows[at.start].0[lane];
            let scale = if pivot > ROUND_OFF * diagonal.0[lane] { 1.0 / pivot.sqrt() } else { 0.0 };
            for entry in &mut rows[at.clone()] {
                entry.0[lane] *= scale;
            }
        }
        for k in 1..at.len() {
            let by = rows[at.start + k];
            let target = envelope.row(j + k).start;
            for l in k..at.len() {
                let source = rows[at.start + l];
                for lane in 0..3 {
                    rows[target + l - k].0[lane] -= by.0[lane] * source.0[lane];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::embedding::EmbeddingWeights;
    use fearless_simd::{Level, dispatch};

    #[test]
    fn its_root_squared_is_what_particles_make_of_it() {
        // Two fibres over twelve particles, one of them on the same particles as the other, one vertex on a held
        // particle.
        let vertex = |picks: &[(u32, f64)]| EmbeddingWeights { weights: picks.to_vec() };
        let fibre = |vertices: Vec<EmbeddingWeights>| FibreRest { vertices, ..FibreRest::default() };
        let along = |first: u32| (0..6).map(move |k| vertex(&[(first + k, 0.3), (first + k + 1, 0.5), (11 - k, 0.2)]));
        let fibres =
            [fibre(along(0).chain([vertex(&[(9, 1.0)])]).collect()), fibre(along(0).chain(along(2)).collect())];
        let mut inverse_masses: Vec<DVec3> = (0..12).map(|k| DVec3::splat(1.0 + f64::from(k))).collect();
        inverse_masses[9] = DVec3::ZERO;
        inverse_masses[4].y = 0.0;
        let gram = Gram::new(&fibres, &inverse_masses);
        let vertices: Vec<&EmbeddingWeights> = fibres.iter().flat_map(|fibre| &fibre.vertices).collect();
        let forces: Vec<DVec3> = (0..vertices.len()).map(|k| DVec3::new(k as f64, -1.0, (k * k) as f64)).collect();
        let mut on_particles = vec![DVec3::ZERO; 12];
        for (vertex, force) in vertices.iter().zip(&forces) {
            vertex.scatter(*force, &mut on_particles);
        }
        for (force, inverse_mass) in on_particles.iter_mut().zip(&inverse_masses) {
            *force *= *inverse_mass;
        }
        let mut y = vec![Lanes4::default(); gram.len()];
        for (vertex, force) in forces.iter().enumerate() {
            y[gram.places[vertex]] = lanes(*force);
        }
        let (mut half, mut found) = (y.clone(), y.clone());
        dispatch!(Level::new(), simd => {
            Gram::root_times(&gram, simd, &y, &mut half);
            Gram::transposed_times(&gram, simd, &half, &mut found);
        });
        for (index, vertex) in vertices.iter().enumerate() {
            let expected = vertex.gather(&on_particles);
            let [x, y, z, _] = found[gram.places[index]].0;
            assert!(DVec3::new(x, y, z).distance(expected) < 1e-9, "{index}: {found:?}, not {expected}");
        }
    }
}
