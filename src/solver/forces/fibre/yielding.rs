//! Fibres that yield: a wire that was bent too far stays bent, one that was pulled too hard stays long.
//!
//! Past its limit an edge takes another length at rest, a bend another curvature, at the end of a step and at once,
//! until what it carries is the limit again: `l += sign(T) (|T| - Ty) / k`, `kb0 += d (1 - dy / |d|)` with `d = R^T
//! kb - kb0`. The energy that goes, `(T² - Ty²) / 2k` and `S (|d|² - dy²)`, is lost for good.

use super::corner::Corner;
use super::material_turn::turn_of_material;
use super::rest::FibreRest;
use glam::{DQuat, DVec3};

/// Lengths over the drawn one between which an edge may come to rest.
const LENGTHS: std::ops::RangeInclusive<f64> = 0.2..=5.0;

/// Greatest curvature binormal at rest that a bend may take, that of a right angle from edge to edge.
const MOST_CURVED: f64 = 2.0;

/// What has yielded in the fibres of one body.
#[derive(Clone, Debug, Default)]
pub(super) struct Yielded {
    /// By how much every edge of all fibres has become longer [m], one after another; empty where none may yield.
    stretches: Vec<f64>,
    /// What every bend has taken on beside its curvature binormal at rest, model frame.
    binormals: Vec<DVec3>,
    /// Energy that was lost [J].
    pub(super) dissipated: f64,
}

impl Yielded {
    /// Nothing as yet.
    pub(super) fn none(fibres: &[FibreRest]) -> Self {
        if !fibres.iter().any(|fibre| fibre.yields.is_finite()) {
            return Self::default();
        }
        Self {
            stretches: vec![0.0; fibres.iter().map(|fibre| fibre.edges.len()).sum()],
            binormals: vec![DVec3::ZERO; fibres.iter().map(|fibre| fibre.bends.len()).sum()],
            dissipated: 0.0,
        }
    }

    /// By how much an edge has become longer [m].
    pub(super) fn stretch(&self, edge: usize) -> f64 {
        self.stretches.get(edge).copied().unwrap_or(0.0)
    }

    /// What a bend has taken on, model frame.
    pub(super) fn binormal(&self, bend: usize) -> DVec3 {
        self.binormals.get(bend).copied().unwrap_or(DVec3::ZERO)
    }

    /// Whether any may yield.
    pub(super) fn may(&self) -> bool {
        !self.stretches.is_empty()
    }

    /// Yields where particles at `positions` [m] pass a limit; `broken` are the bends and edges that carry nothing,
    /// `turns` the last turns at all bends. Whether anything did.
    pub(super) fn follow(
        &mut self,
        fibres: &[FibreRest],
        [bends, edges]: [&[bool]; 2],
        turns: &[DQuat],
        positions: &[DVec3],
    ) -> bool {
        let before = self.dissipated;
        let (mut first_edge, mut first_bend) = (0, 0);
        for fibre in fibres {
            if fibre.yields.is_finite() {
                let x: Vec<DVec3> = fibre.vertices.iter().map(|vertex| vertex.gather(positions)).collect();
                for k in (0..fibre.edges.len()).filter(|k| !edges[first_edge + k]) {
                    self.stretch_edge(fibre, k, first_edge + k, x[k].distance(x[k + 1]));
                }
                for k in (0..fibre.bends.len()).filter(|k| !bends[first_bend + k]) {
                    self.turn_bend(fibre, k, first_bend + k, &x, (positions, turns[first_bend + k]));
                }
            }
            first_edge += fibre.edges.len();
            first_bend += fibre.bends.len();
        }
        self.dissipated > before
    }

    fn stretch_edge(&mut self, fibre: &FibreRest, k: usize, edge: usize, length: f64) {
        let (stiffness, drawn) = fibre.edges[k];
        let limit = fibre.yields.tension;
        let tension = stiffness * (length - drawn - self.stretches[edge]);
        let beyond = tension.abs() - limit;
        if beyond <= 0.0 {
            return;
        }
        let stretched = self.stretches[edge] + tension.signum() * beyond / stiffness;
        if LENGTHS.contains(&(1.0 + stretched / drawn)) {
            self.stretches[edge] = stretched;
            self.dissipated += 0.5 * (tension * tension - limit * limit) / stiffness;
        }
    }

    fn turn_bend(
        &mut self,
        fibre: &FibreRest,
        k: usize,
        bend: usize,
        x: &[DVec3],
        (positions, mut turn): (&[DVec3], DQuat),
    ) {
        let (Some(corner), Some(rest)) = (Corner::at(x, k), &fibre.bends[k].curved) else { return };
        let limit = 0.5 * fibre.yields.curvature * (fibre.edges[k].1 + fibre.edges[k + 1].1);
        let (r, _) = turn_of_material(&rest.turn, positions, &mut turn);
        let away = r.transpose() * corner.binormal() - rest.binormal - self.binormals[bend];
        let size = away.length();
        if size <= limit {
            return;
        }
        let binormal = self.binormals[bend] + away * (1.0 - limit / size);
        if (rest.binormal + binormal).length() <= MOST_CURVED {
            self.binormals[bend] = binormal;
            self.dissipated += fibre.bends[k].stiffness * (size * size - limit * limit);
        }
    }

    /// What has yielded in the fibres `before` an edit, carried to those `after` it that run along the same vertices.
    pub(super) fn carried(&self, [before, after]: [&[FibreRest]; 2]) -> Self {
        let mut carried = Self { dissipated: self.dissipated, ..Self::none(after) };
        if !carried.may() || !self.may() {
            return carried;
        }
        let mut taken = vec![false; before.len()];
        let (mut edge, mut bend) = (0, 0);
        for fibre in after {
            let (mut old_edge, mut old_bend) = (0, 0);
            for (old, taken) in before.iter().zip(&mut taken) {
                if !*taken && old.vertices == fibre.vertices && old.first_vertex == fibre.first_vertex {
                    *taken = true;
                    let (edges, bends) = (fibre.edges.len(), fibre.bends.len());
                    carried.stretches[edge..edge + edges].copy_from_slice(&self.stretches[old_edge..][..edges]);
                    carried.binormals[bend..bend + bends].copy_from_slice(&self.binormals[old_bend..][..bends]);
                    break;
                }
                old_edge += old.edges.len();
                old_bend += old.bends.len();
            }
            edge += fibre.edges.len();
            bend += fibre.bends.len();
        }
        carried
    }

    /// Every number of it that the motion goes on from.
    pub(super) fn remembered(&self, number: &mut dyn FnMut(f64)) {
        self.stretches.iter().copied().for_each(&mut *number);
        self.binormals.iter().flat_map(DVec3::to_array).for_each(number);
    }

    /// Memory of the lists [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.stretches) + size_of_val(&*self.binormals)
    }
}
