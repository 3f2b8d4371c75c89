//! Fibres at rest.

use super::activation::FibreActivation;
use super::break_limits::BreakLimits;
use super::corner::{Corner, curvature_binormal};
use super::material_turn::turn_of_material;
use super::twist::FibreTwist;
use super::yield_limits::YieldLimits;
use crate::solver::embedding::{EmbeddingWeights, TurnWeights};
use crate::solver::hand::Hand;
use glam::{DQuat, DVec3};

/// One fibre at rest, ready to be evaluated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FibreRest {
    /// Its vertices (structure particles).
    pub vertices: Vec<EmbeddingWeights>,
    /// `l_f EA / l0` of every edge [N/m], and its rest length l0 [m].
    pub edges: Vec<(f64, f64)>,
    /// Bending of every inner vertex, the first one's at index 0.
    pub bends: Vec<Bend>,
    /// What it stands before it breaks.
    pub limits: BreakLimits,
    /// What it stands before it yields.
    pub(crate) yields: YieldLimits,
    /// How it resists twist; not at all unless given.
    pub(crate) twist: Option<FibreTwist>,
    /// What a drive does to it; nothing unless given.
    pub(crate) activation: Option<FibreActivation>,
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
    pub turn: TurnWeights,
}

impl FibreRest {
    /// A fibre through embedded `vertices` at rest positions `at` [m] (model frame), with axial rigidity `ea` [N],
    /// bending stiffness `ei` [N m²] and volume fraction `fraction`; `turns` gives the turn stencil of each inner
    /// vertex where the rest shape is as drawn, or nothing where it is straight.
    ///
    /// Ends carry no bending of their own, so the first and last inner vertex count for the half edge beyond them:
    /// `1 + l_end / L0`. A curved rest shape counts `((1 + c0) / 2)²`, which keeps EI the stiffness near it.
    pub fn new(
        vertices: Vec<EmbeddingWeights>,
        at: &[DVec3],
        ea: f64,
        ei: f64,
        fraction: f64,
        turns: Vec<Option<TurnWeights>>,
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

    /// The same fibre, which rests straight though its vertices may lie on a bow, and yet knows how the material turns.
    #[must_use]
    pub(crate) fn straightened(mut self) -> Self {
        for bend in &mut self.bends {
            if let Some(curved) = &mut bend.curved {
                // What its curvature takes off the stiffness.
                bend.stiffness *= (1.0 + 0.25 * curved.binormal.length_squared()).powi(2);
                curved.binormal = DVec3::ZERO;
            }
        }
        self
    }

    /// The same fibre, which yields past `limits`.
    #[must_use]
    pub(crate) fn yielding(self, yields: YieldLimits) -> Self {
        Self { yields, ..self }
    }

    /// The same fibre, which resists twist.
    #[must_use]
    pub(crate) fn twisting(self, twist: Option<FibreTwist>) -> Self {
        Self { twist, ..self }
    }

    /// The same fibre, driven.
    #[must_use]
    pub(crate) fn acting(self, activation: Option<FibreActivation>) -> Self {
        Self { activation, ..self }
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
        if let Some(twist) = &mut self.twist {
            twist.edges.iter_mut().for_each(|edge| edge.stiffness *= by);
        }
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

    /// The particles that it rides on, each with every vertex that it is around.
    pub(super) fn particles(&self) -> impl Iterator<Item = (usize, u32)> {
        let vertices = self.vertices.iter().enumerate();
        let curved = self.bends.iter().enumerate().filter_map(|(k, bend)| Some((k + 1, bend.curved.as_ref()?)));
        let vertices = vertices.flat_map(|(k, vertex)| vertex.weights.iter().map(move |&(particle, _)| (k, particle)));
        vertices.chain(curved.flat_map(|(k, rest)| rest.turn.weights.iter().map(move |&(particle, _)| (k, particle))))
    }

    /// The particles around every two vertices of an edge and every three of a bend, with those that turn them.
    pub(super) fn couplings(&self) -> impl Iterator<Item = Vec<u32>> {
        let around = |vertices: &[EmbeddingWeights], turn: &[(u32, DVec3)]| {
            let carried = vertices.iter().flat_map(|vertex| vertex.weights.iter().map(|&(particle, _)| particle));
            carried.chain(turn.iter().map(|&(particle, _)| particle)).collect()
        };
        let edges = self.vertices.windows(2).map(move |ends| around(ends, &[]));
        let bends = self.vertices.windows(3).zip(&self.bends);
        let turn_of = |bend: &'_ Bend| bend.curved.as_ref().map_or_else(Vec::new, |curved| curved.turn.weights.clone());
        let twists = self.twist.iter().flat_map(FibreTwist::couplings);
        edges.chain(bends.map(move |(vertices, bend)| around(vertices, &turn_of(bend)))).chain(twists)
    }

    /// The rest lengths of its edges [m] at a time [s].
    pub(super) fn lengths_at(&self, time: f64) -> impl Fn(usize) -> f64 + '_ {
        let contracted = self.activation.as_ref().map(|activation| activation.contractions(time));
        move |edge| {
            let (_, drawn) = self.edges[edge];
            contracted.as_ref().map_or(drawn, |contracted| drawn * (1.0 - contracted(edge)))
        }
    }

    /// The curvature binormals of its bends at rest at a time [s], model frame.
    pub(super) fn binormals_at(&self, time: f64) -> impl Fn(usize) -> DVec3 + '_ {
        let added = self.activation.as_ref().and_then(|activation| activation.binormals(time));
        move |bend| {
            let drawn = self.bends[bend].curved.as_ref().map_or(DVec3::ZERO, |curved| curved.binormal);
            added.as_ref().map_or(drawn, |added| drawn + added(bend))
        }
    }

    /// Angles [rad] by which its edges want to be twisted at a time [s].
    pub(super) fn twists_at(&self, time: f64) -> impl Fn(usize) -> f64 + '_ {
        let wanted = self.activation.as_ref().map(|activation| activation.twists(time));
        move |edge| wanted.as_ref().map_or(0.0, |wanted| wanted(edge))
    }

    /// Shares of their stiffness that its edges and its bends have at a time [s].
    pub(super) fn thicknesses_at(&self, time: f64) -> [impl Fn(usize) -> f64 + '_; 2] {
        let [edges, bends] = match self.activation.as_ref().and_then(|activation| activation.thicknesses(time)) {
            Some([edges, bends]) => [Some(edges), Some(bends)],
            None => [None, None],
        };
        [edges, bends].map(|of| move |k: usize| of.as_ref().map_or(1.0, |of| of(k)))
    }

    /// The same fibre, as stiff as it ever gets while it acts, its drive at its greatest or its least.
    pub(super) fn at_extreme(&self, greatest: bool) -> Self {
        let Some(activation) = &self.activation else { return self.clone() };
        let mut extreme = Self { activation: Some(activation.at_extreme(greatest)), ..self.clone() };
        // A move of a vertex turns short edges further than those that were drawn, by which the step is measured.
        let steeper = activation.shortest(greatest).powi(-2);
        extreme.bends.iter_mut().for_each(|bend| bend.stiffness *= steeper);
        extreme
    }

    /// Has a hand lead a shared drive, or none.
    pub(super) fn give(&mut self, to: &str, led: Option<Hand>) {
        if let Some(activation) = &mut self.activation {
            activation.give(to, led);
        }
    }

    /// Until when [s] it changes by itself.
    pub(super) fn changes_until(&self) -> f64 {
        self.activation.as_ref().map_or(0.0, FibreActivation::until)
    }

    /// Number of vertices at which the turn of the material is read for its twist.
    pub(super) fn twisted_ends(&self) -> usize {
        self.twist.as_ref().map_or(0, FibreTwist::len)
    }

    /// The drive at the edges at a time [s], and by what share it has them want to be shorter; nothing where it does
    /// not act.
    pub(super) fn activations(&self, time: f64) -> Option<impl Fn(usize) -> [f64; 2] + '_> {
        self.activation.as_ref().map(|activation| activation.values(time))
    }

    /// Force [N] that each edge carries at a time [s] between vertices at `x`; negative where it is pressed.
    pub(super) fn tensions<'a>(&'a self, x: &'a [DVec3], time: f64) -> impl Fn(usize) -> f64 + 'a {
        let rest_length = self.lengths_at(time);
        let muscle = self.activation.as_ref().and_then(|activation| activation.excitations(time));
        let [thickness, _] = self.thicknesses_at(time);
        move |k| {
            let (stiffness, drawn) = self.edges[k];
            let length = x[k + 1].distance(x[k]);
            let pull = muscle.as_ref().map_or(0.0, |(muscle, excited)| muscle.pull(excited(k), length / drawn));
            thickness(k) * (stiffness * (length - rest_length(k)) + pull)
        }
    }

    /// Turn [rad] of bend `k` away from its rest shape, that by which it has yielded added: `2 atan(|kb - R_s kb0| /
    /// 2)`, the turning angle of eq. 6 itself where the rest shape is straight.
    pub(super) fn turn(&self, x: &[DVec3], k: usize, positions: &[DVec3], at: (f64, DQuat, DVec3)) -> f64 {
        let (time, warm_start, yielded) = at;
        let Some(corner) = Corner::at(x, k) else { return 0.0 };
        let across = corner.before.tangent.cross(corner.after.tangent);
        let Some(curved) = &self.bends[k].curved else { return across.length().atan2(corner.cosine) };
        // Not the binormal that is continued beyond a fold: that one falls again as the fibre closes.
        let binormal = 2.0 * across / (1.0 + corner.cosine).max(f64::EPSILON);
        let (r, _) = turn_of_material(&curved.turn, positions, &mut warm_start.clone());
        2.0 * (0.5 * (binormal - r * (self.binormals_at(time)(k) + yielded)).length()).atan()
    }
}
