//! Fibres: rods that bend and stretch (sec. 4.1), riding on the material particles.
//!
//! Per edge `l_f (EA / 2 l0) (|e| - l0)²`; per inner vertex `l_f (EI / L0) |kb - R_s kb0|²` with the curvature binormal
//! of eq. 6, `L0` the rest lengths of both edges and `R_s` the turn of the material around the vertex. The gradients
//! are exact: the paper's own (the centre vertex's, with half reactions on its neighbours) is 28 to 56 % off and makes
//! torque. A straight rest shape needs no `R_s`: `l_f (4 EI / L0) (1 - c) / (1 + c)`, c the cosine of the turn.
//!
//! Eq. 7 is half of Bergou's energy, so that EI is the paper's `K_b / 2`. The energy of eq. 6 is unbounded where a
//! fibre folds back on itself; below `c = -1/2` it continues linearly in c.

use super::Force;
use super::breaking::{BreakLimits, Breakage, FibreBreak};
use crate::solver::embedding::{Stencil, TurnStencil};
use crate::solver::energy::Energies;
use crate::solver::neighbourhood::outer;
use crate::solver::rotation::{nearest_rotation, turn_stiffness};
use crate::solver::state::ParticleState;
use glam::{DMat3, DQuat, DVec3};
use std::sync::Arc;

/// One fibre at rest, ready to be evaluated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FibreRest {
    /// Its vertices (structure particles).
    pub vertices: Vec<Stencil>,
    /// `l_f EA / l0` of every edge [N/m], and its rest length l0 [m].
    pub edges: Vec<(f64, f64)>,
    /// Bending of every inner vertex, the first one's at index 0.
    pub bends: Vec<Bend>,
    /// What it stands before it breaks.
    pub limits: BreakLimits,
    /// Index of the centre line that it is part of, among the body's.
    pub line: u32,
    /// Index on that line of its first vertex.
    pub first_vertex: u32,
}

/// Bending at one inner vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bend {
    /// `l_f EI / L0` with the factors for ends and curvature [N m].
    pub stiffness: f64,
    /// Rest shape where it is curved there.
    pub curved: Option<CurvedRest>,
}

/// Curved rest shape at one vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurvedRest {
    /// Curvature binormal kb0 at rest, model frame.
    pub binormal: DVec3,
    /// How the turn of the material is read.
    pub turn: TurnStencil,
}

/// Turning cosine below which the bending energy continues linearly.
const FOLD: f64 = -0.5;

/// `(1 - c) / (1 + c)` and its derivative, continued linearly where the fibre folds.
fn straight_energy(c: f64) -> (f64, f64) {
    if c < FOLD { (-1.0 - 8.0 * c, -8.0) } else { ((1.0 - c) / (1.0 + c), -2.0 / (1.0 + c).powi(2)) }
}

/// `1 / (1 + c)` and its derivative, continued likewise.
fn inverse_half(c: f64) -> (f64, f64) {
    if c < FOLD { (4.0 - 4.0 * (1.0 + c), -4.0) } else { (1.0 / (1.0 + c), -1.0 / (1.0 + c).powi(2)) }
}

/// Curvature binormal of eq. 6 from the unit tangents of two consecutive edges.
pub fn curvature_binormal(before: DVec3, after: DVec3) -> DVec3 {
    2.0 * inverse_half(before.dot(after)).0 * before.cross(after)
}

impl FibreRest {
    /// A fibre through embedded `vertices` at rest positions `at` [m] (model frame), with axial rigidity `ea` [N],
    /// bending stiffness `ei` [N m²] and volume fraction `fraction`; `turns` gives the turn stencil of each inner
    /// vertex where the rest shape is as drawn, or nothing where it is straight.
    ///
    /// Ends carry no bending of their own, so the first and last inner vertex count for the half edge beyond them:
    /// `1 + l_end / L0`. A curved rest shape counts `((1 + c0) / 2)²`, which keeps EI the stiffness near it.
    pub fn new(
        vertices: Vec<Stencil>,
        at: &[DVec3],
        ea: f64,
        ei: f64,
        fraction: f64,
        turns: Vec<Option<TurnStencil>>,
    ) -> Self {
        let lengths: Vec<f64> = at.windows(2).map(|pair| pair[0].distance(pair[1])).collect();
        let inner = at.len().saturating_sub(2);
        let bends = turns
            .into_iter()
            .take(inner)
            .enumerate()
            .map(|(k, turn)| {
                let before = (at[k + 1] - at[k]) / lengths[k];
                let after = (at[k + 2] - at[k + 1]) / lengths[k + 1];
                let both = lengths[k] + lengths[k + 1];
                let mut stiffness = fraction * ei / both;
                let mut ends = 1.0;
                if k == 0 {
                    ends += lengths[k] / both;
                }
                if k + 1 == inner {
                    ends += lengths[k + 1] / both;
                }
                stiffness *= ends;
                let curved = turn.map(|turn| {
                    stiffness *= (0.5 * (1.0 + before.dot(after))).powi(2);
                    CurvedRest { binormal: curvature_binormal(before, after), turn }
                });
                Bend { stiffness, curved }
            })
            .collect();
        let edges = lengths.iter().map(|&length| (fraction * ea / length, length)).collect();
        Self { vertices, edges, bends, ..Self::default() }
    }

    /// The same fibre, which breaks past `limits`.
    #[must_use]
    pub fn breaking(self, limits: BreakLimits) -> Self {
        Self { limits, ..self }
    }

    /// The same fibre as the part of centre line `line` that begins with its vertex `first_vertex`.
    #[must_use]
    pub fn on_line(self, line: u32, first_vertex: u32) -> Self {
        Self { line, first_vertex, ..self }
    }

    /// The same fibre with its stiffnesses multiplied by `by`.
    #[must_use]
    pub fn scaled(mut self, by: f64) -> Self {
        self.edges.iter_mut().for_each(|(stiffness, _)| *stiffness *= by);
        self.bends.iter_mut().for_each(|bend| bend.stiffness *= by);
        self
    }

    /// Greatest stiffness [N/m] with which it resists a move of one vertex, by stretching or by bending.
    pub fn stiffest(&self) -> f64 {
        let shortest = self.edges.iter().map(|&(_, length)| length).fold(f64::INFINITY, f64::min);
        let stretching = self.edges.iter().map(|&(stiffness, _)| stiffness).fold(0.0, f64::max);
        // A vertex bends its own corner by twice its move over the edge, `kb = 2 x / l`, and the energy is `S kb²`.
        let bending = self.bends.iter().map(|bend| 8.0 * bend.stiffness / shortest.powi(2)).fold(0.0, f64::max);
        stretching.max(bending)
    }
}

/// Stretching and bending of all fibres of a body.
#[derive(Clone)]
pub struct FibreForce {
    fibres: Arc<[FibreRest]>,
    /// Last turn at every bend of every fibre, the warm start of the next.
    turns: Vec<DQuat>,
    broken: Breakage,
    vertices: Vec<DVec3>,
    pulls: Vec<DVec3>,
}

impl FibreForce {
    /// Forces of `fibres`; `orientation` is the turn of the model frame in the world at the start.
    pub fn new(fibres: Arc<[FibreRest]>, orientation: DQuat) -> Self {
        let bends = fibres.iter().map(|fibre| fibre.bends.len()).sum();
        let broken = Breakage::none(&fibres);
        Self { fibres, turns: vec![orientation; bends], broken, vertices: Vec::new(), pulls: Vec::new() }
    }
}

impl Force for FibreForce {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let mut turns = self.turns.iter_mut().zip(&self.broken.bends);
        let mut edges_broken = self.broken.edges.iter();
        for fibre in self.fibres.iter() {
            self.vertices.clear();
            self.vertices.extend(fibre.vertices.iter().map(|vertex| vertex.gather(&state.positions)));
            self.pulls.clear();
            self.pulls.resize(self.vertices.len(), DVec3::ZERO);
            let (x, pulls) = (&self.vertices, &mut self.pulls);
            for (k, (&(stiffness, rest_length), &broken)) in fibre.edges.iter().zip(edges_broken.by_ref()).enumerate() {
                if broken {
                    continue;
                }
                let edge = x[k + 1] - x[k];
                let length = edge.length();
                if length > 0.0 {
                    let pull = edge * (stiffness * (length - rest_length) / length);
                    pulls[k] += pull;
                    pulls[k + 1] -= pull;
                }
            }
            for (k, (bend, (turn, &broken))) in fibre.bends.iter().zip(turns.by_ref()).enumerate() {
                if broken {
                    continue;
                }
                let Some(corner) = Corner::at(x, k) else { continue };
                let (before, after) = match &bend.curved {
                    None => corner.straight_slopes(bend.stiffness),
                    Some(curved) => {
                        let (r, stretch) = turned(&curved.turn, &state.positions, turn);
                        let kb = curvature_binormal(corner.before, corner.after);
                        let y = 2.0 * bend.stiffness * (kb - r * curved.binormal);
                        let moment = -curved.binormal.cross(r.transpose() * y);
                        let p = turn_stiffness(stretch).inverse() * moment;
                        for &(particle, z) in &curved.turn.weights {
                            forces[particle as usize] -= r * p.cross(z);
                        }
                        corner.curved_slopes(y)
                    }
                };
                pulls[k] += before;
                pulls[k + 1] += after - before;
                pulls[k + 2] -= after;
            }
            for (vertex, &pull) in fibre.vertices.iter().zip(pulls.iter()) {
                vertex.scatter(pull, forces);
            }
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        let mut turns = self.turns.iter().zip(&self.broken.bends);
        let mut edges_broken = self.broken.edges.iter();
        for fibre in self.fibres.iter() {
            let x: Vec<DVec3> = fibre.vertices.iter().map(|vertex| vertex.gather(&state.positions)).collect();
            for (k, (&(stiffness, rest_length), &broken)) in fibre.edges.iter().zip(edges_broken.by_ref()).enumerate() {
                if broken {
                    continue;
                }
                let stretch = x[k + 1].distance(x[k]) - rest_length;
                energies.stretching += 0.5 * stiffness * stretch * stretch;
            }
            for (k, (bend, (turn, &broken))) in fibre.bends.iter().zip(turns.by_ref()).enumerate() {
                if broken {
                    continue;
                }
                let Some(corner) = Corner::at(&x, k) else { continue };
                energies.bending += match &bend.curved {
                    None => 4.0 * bend.stiffness * straight_energy(corner.cosine).0,
                    Some(curved) => {
                        let (r, _) = turned(&curved.turn, &state.positions, &mut turn.clone());
                        let kb = curvature_binormal(corner.before, corner.after);
                        bend.stiffness * (kb - r * curved.binormal).length_squared()
                    }
                };
            }
        }
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        let before = self.broken.breaks.len();
        let (mut first_bend, mut first_edge) = (0, 0);
        for fibre in self.fibres.iter() {
            if fibre.limits.is_finite() {
                let x: Vec<DVec3> = fibre.vertices.iter().map(|vertex| vertex.gather(&state.positions)).collect();
                let pulls = (0..fibre.edges.len())
                    .filter(|k| !self.broken.edges[first_edge + k])
                    .map(|k| (fibre.tension(&x, k) / fibre.limits.tension, k));
                let turns = (0..fibre.bends.len())
                    .filter(|k| !self.broken.bends[first_bend + k])
                    .map(|k| (fibre.turn(&x, k, &state.positions, self.turns[first_bend + k]) / fibre.limits.angle, k));
                let (pull, turn) = (furthest(pulls), furthest(turns));
                match (pull, turn) {
                    ((by, k), (less, _)) if by > 1.0 && by >= less => {
                        self.broken.at_edge(fibre, [first_bend, first_edge], k, time);
                    }
                    (_, (by, k)) if by > 1.0 => self.broken.at_vertex(fibre, first_bend, k, time),
                    _ => {}
                }
            }
            first_bend += fibre.bends.len();
            first_edge += fibre.edges.len();
        }
        self.broken.breaks.len() > before
    }

    fn name(&self) -> &'static str {
        "fibres"
    }

    fn breaks(&self) -> &[FibreBreak] {
        &self.broken.breaks
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

/// The greatest share of a limit and where it is; zero where there is none.
fn furthest(shares: impl Iterator<Item = (f64, usize)>) -> (f64, usize) {
    shares.fold((0.0, 0), |most, share| if share.0 > most.0 { share } else { most })
}

impl FibreRest {
    /// Force [N] that edge `k` carries between vertices at `x`; negative where it is pressed.
    fn tension(&self, x: &[DVec3], k: usize) -> f64 {
        let (stiffness, rest_length) = self.edges[k];
        stiffness * (x[k + 1].distance(x[k]) - rest_length)
    }

    /// Turn [rad] of bend `k` away from its rest shape, `2 atan(|kb - R_s kb0| / 2)`: the turning angle of eq. 6 itself
    /// where the rest shape is straight.
    fn turn(&self, x: &[DVec3], k: usize, positions: &[DVec3], warm_start: DQuat) -> f64 {
        let Some(corner) = Corner::at(x, k) else { return 0.0 };
        let across = corner.before.cross(corner.after);
        let Some(curved) = &self.bends[k].curved else { return across.length().atan2(corner.cosine) };
        // Not the binormal that is continued beyond a fold: that one falls again as the fibre closes.
        let binormal = 2.0 * across / (1.0 + corner.cosine).max(f64::EPSILON);
        let (r, _) = turned(&curved.turn, positions, &mut warm_start.clone());
        2.0 * (0.5 * (binormal - r * curved.binormal).length()).atan()
    }
}

/// Turn of the material around a vertex and its stretch `R^T A`.
fn turned(stencil: &TurnStencil, positions: &[DVec3], turn: &mut DQuat) -> (DMat3, DMat3) {
    // The weights sum to zero: taken against one particle, the sum stays exact far from the origin.
    let origin = stencil.weights.first().map_or(DVec3::ZERO, |&(k, _)| positions[k as usize]);
    let mut gradient = DMat3::ZERO;
    for &(k, z) in &stencil.weights {
        gradient += outer(positions[k as usize] - origin, z);
    }
    *turn = nearest_rotation(gradient, *turn);
    let r = DMat3::from_quat(*turn);
    (r, r.transpose() * gradient)
}

/// Two consecutive edges.
struct Corner {
    /// Unit tangents.
    before: DVec3,
    after: DVec3,
    /// Edge lengths [m].
    lengths: (f64, f64),
    cosine: f64,
}

impl Corner {
    /// The corner at inner vertex `k + 1`; none if an edge has no length.
    fn at(x: &[DVec3], k: usize) -> Option<Self> {
        let (e0, e1) = (x[k + 1] - x[k], x[k + 2] - x[k + 1]);
        let lengths = (e0.length(), e1.length());
        if lengths.0 <= 0.0 || lengths.1 <= 0.0 {
            return None;
        }
        let (before, after) = (e0 / lengths.0, e1 / lengths.1);
        Some(Self { before, after, lengths, cosine: before.dot(after) })
    }

    /// Gradients of the straight fibre's bending energy by the two edges [N].
    fn straight_slopes(&self, stiffness: f64) -> (DVec3, DVec3) {
        let slope = 4.0 * stiffness * straight_energy(self.cosine).1;
        self.by_edges(slope * self.after, slope * self.before)
    }

    /// Gradients by the two edges [N] of an energy whose gradient by the curvature binormal is `y`.
    fn curved_slopes(&self, y: DVec3) -> (DVec3, DVec3) {
        let (g, dg) = inverse_half(self.cosine);
        let along = 2.0 * dg * y.dot(self.before.cross(self.after));
        self.by_edges(
            along * self.after + 2.0 * g * self.after.cross(y),
            along * self.before + 2.0 * g * y.cross(self.before),
        )
    }

    /// From gradients by the unit tangents to gradients by the edges.
    fn by_edges(&self, by_before: DVec3, by_after: DVec3) -> (DVec3, DVec3) {
        (
            (by_before - self.before * self.before.dot(by_before)) / self.lengths.0,
            (by_after - self.after * self.after.dot(by_after)) / self.lengths.1,
        )
    }
}
