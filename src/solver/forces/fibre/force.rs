//! The force of all fibres of a body, evaluated together.

use super::activity::{Activity, Now};
use super::break_limits::furthest;
use super::breaking::{Breakage, FibreBreak};
use super::curved_bends::CurvedBends;
use super::fibre_embedding::FibreEmbedding;
use super::packed_rods::PackedRods;
use super::rest::FibreRest;
use super::strip::BlockVectors;
use super::yielding::Yielded;
use crate::solver::energy::Energies;
use crate::solver::forces::force::Force;
use crate::solver::hand::Hand;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use crate::solver::wide::Vec3x;
use fearless_simd::{Level, Simd, dispatch, f64x8, prelude::*};
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// Stretching and bending of all fibres of a body.
#[derive(Clone)]
pub struct FibreForce {
    pub(super) fibres: Arc<[FibreRest]>,
    pub(super) embedding: Arc<FibreEmbedding>,
    level: Level,
    /// Last turn at every bend of every fibre, the warm start of the next.
    pub(super) turns: Vec<DQuat>,
    /// The same at every vertex of every fibre that resists twist.
    pub(super) ends: Vec<DQuat>,
    pub(super) broken: Breakage,
    pub(super) yielded: Yielded,
    /// Of what drives do; untouched where none does.
    pub(super) activity: Activity,
    /// Follows from all that is above.
    workspace: Scratch<Option<Workspace>>,
}

/// What an evaluation works on.
#[derive(Debug)]
struct Workspace {
    rods: PackedRods,
    /// Positions of the strip's particles [m].
    positions: Vec<BlockVectors>,
    curved: CurvedBends,
}

impl Workspace {
    fn new(fibres: &[FibreRest], embedding: &FibreEmbedding, (broken, yielded): (&Breakage, &Yielded)) -> Self {
        let mut rods = PackedRods::new(fibres);
        let (mut first, mut first_bend, mut first_edge) = (0, 0, 0);
        for fibre in fibres {
            let (bends, edges) = (fibre.bends.len(), fibre.edges.len());
            let broken = [&broken.bends[first_bend..][..bends], &broken.edges[first_edge..][..edges]];
            rods.release(first, broken[0], broken[1]);
            first += fibre.vertices.len();
            first_bend += bends;
            first_edge += edges;
        }
        let curved = CurvedBends::new(embedding, &broken.bends);
        let mut this = Self { rods, positions: vec![BlockVectors::default(); embedding.strip.len()], curved };
        this.rest_as(fibres, embedding, yielded);
        this
    }

    /// Rests where fibres that have yielded do.
    fn rest_as(&mut self, fibres: &[FibreRest], embedding: &FibreEmbedding, yielded: &Yielded) {
        if !yielded.may() {
            return;
        }
        let (mut first, mut first_edge) = (0, 0);
        for fibre in fibres {
            for (k, &(_, drawn)) in fibre.edges.iter().enumerate().filter(|_| fibre.yields.is_finite()) {
                self.rods.rest_at(first + k, drawn + yielded.stretch(first_edge + k));
            }
            first += fibre.vertices.len();
            first_edge += fibre.edges.len();
        }
        for (k, bend) in embedding.curved.iter().enumerate() {
            self.curved.rest_at(k, bend.binormal + yielded.binormal(bend.bend));
        }
    }
}

impl FibreForce {
    /// Forces of `fibres`; `orientation` is the turn of the model frame in the world at the start.
    pub fn new(fibres: Arc<[FibreRest]>, orientation: DQuat) -> Self {
        let bends = fibres.iter().map(|fibre| fibre.bends.len()).sum();
        Self {
            embedding: Arc::new(FibreEmbedding::new(&fibres)),
            level: Level::new(),
            turns: vec![orientation; bends],
            ends: vec![orientation; fibres.iter().map(FibreRest::twisted_ends).sum()],
            broken: Breakage::none(&fibres),
            yielded: Yielded::none(&fibres),
            activity: Activity::default(),
            workspace: Scratch::default(),
            fibres,
        }
    }

    /// The fibres at rest.
    pub fn rests(&self) -> &[FibreRest] {
        &self.fibres
    }

    /// Whether any of them is driven.
    pub(crate) fn is_driven(&self) -> bool {
        self.fibres.iter().any(|fibre| fibre.activation.is_some())
    }

    /// Whether all that they do can be stepped implicitly: nothing is driven, yields or resists twist.
    pub(crate) fn takes_implicit_steps(&self) -> bool {
        let is_plain =
            |fibre: &FibreRest| fibre.activation.is_none() && fibre.twist.is_none() && !fibre.yields.is_finite();
        self.fibres.iter().all(is_plain)
    }

    fn now<'a>(&'a self, time: f64, positions: &'a [DVec3]) -> Now<'a> {
        Now { fibres: &self.fibres, turns: &self.turns, ends: &self.ends, time, positions }
    }

    /// Makes the fibres rest as their drives have it at `time` [s].
    fn follow(&mut self, time: f64, positions: &[DVec3]) {
        let mut activity = std::mem::take(&mut self.activity);
        activity.begin(self.now(time, positions));
        self.activity = activity;
        let Self { fibres, embedding, broken, yielded, workspace, .. } = self;
        let Workspace { rods, curved: packed, .. } =
            workspace.get_or_insert_with(|| Workspace::new(fibres, embedding, (broken, yielded)));
        let (mut first, mut curved, mut first_edge, mut first_bend) = (0, 0, 0, 0);
        for fibre in fibres.iter() {
            let bends = (0..fibre.bends.len()).filter(|&k| fibre.bends[k].curved.is_some());
            if let Some(activation) = &fibre.activation {
                let length = fibre.lengths_at(time);
                (0..fibre.edges.len()).for_each(|k| rods.rest_at(first + k, length(k)));
                if activation.curls() {
                    let binormal = fibre.binormals_at(time);
                    bends.clone().zip(curved..).for_each(|(k, bend)| packed.rest_at(bend, binormal(k)));
                }
                if let Some([edge, bend]) = activation.thicknesses(time) {
                    for k in (0..fibre.edges.len()).filter(|k| !broken.edges[first_edge + k]) {
                        rods.stiffen_edge(first + k, edge(k) * fibre.edges[k].0);
                    }
                    for k in (0..fibre.bends.len()).filter(|&k| fibre.bends[k].curved.is_none()) {
                        if !broken.bends[first_bend + k] {
                            rods.stiffen_bend(first + k, bend(k) * fibre.bends[k].stiffness);
                        }
                    }
                    for (k, at) in bends.clone().zip(curved..).filter(|(k, _)| !broken.bends[first_bend + k]) {
                        packed.stiffen(at, bend(k) * fibre.bends[k].stiffness);
                    }
                }
            }
            first += fibre.vertices.len();
            curved += bends.count();
            first_edge += fibre.edges.len();
            first_bend += fibre.bends.len();
        }
    }

    /// Lets go what is past its yield limit; whether anything was.
    fn yields(&mut self, positions: &[DVec3]) -> bool {
        let Self { fibres, embedding, broken, yielded, turns, workspace, .. } = self;
        let yields = yielded.may() && yielded.follow(fibres, [&broken.bends, &broken.edges], turns, positions);
        if let Some(workspace) = workspace.as_mut().filter(|_| yields) {
            workspace.rest_as(fibres, embedding, yielded);
        }
        yields
    }

    /// Adds the pull of muscles [N] to the gradients by the edges.
    fn pull(fibres: &[FibreRest], broken: &Breakage, time: f64, rods: &mut PackedRods) {
        let (mut first, mut first_edge) = (0, 0);
        for fibre in fibres {
            if let Some((muscle, excited)) = fibre.activation.as_ref().and_then(|of| of.excitations(time)) {
                let [thickness, _] = fibre.thicknesses_at(time);
                for (k, &(_, drawn)) in fibre.edges.iter().enumerate().filter(|(k, _)| !broken.edges[first_edge + k]) {
                    let edge = rods.edge(first + k);
                    let pull = thickness(k) * muscle.pull(excited(k), edge.length / drawn);
                    rods.add(first + k, (pull * edge.tangent, DVec3::ZERO));
                }
            }
            first += fibre.vertices.len();
            first_edge += fibre.edges.len();
        }
    }

    /// Adds the forces [N] on particles at `positions` [m] to `forces`.
    pub(in crate::solver) fn evaluate_at(&mut self, positions: &[DVec3], forces: &mut [DVec3]) {
        dispatch!(self.level, simd => self.evaluate(simd, None, positions, forces));
    }

    #[inline(always)]
    fn evaluate<S: Simd>(&mut self, simd: S, driven: Option<f64>, positions: &[DVec3], forces: &mut [DVec3]) {
        let Self { fibres, embedding, broken, yielded, turns, workspace, .. } = self;
        let Workspace { rods, positions: blocks, curved } =
            workspace.get_or_insert_with(|| Workspace::new(fibres, embedding, (broken, yielded)));
        let FibreEmbedding { strip, vertices, turns: turning, .. } = &**embedding;
        strip.fill(simd, positions, blocks);
        for vertex in 0..rods.len() {
            let [at] = vertices.gather(simd, vertex, blocks);
            rods.put(vertex, at);
        }
        rods.compute_gradients(simd);
        if let Some(time) = driven {
            Self::pull(fibres, broken, time, rods);
        }
        let spins = curved.bend(simd, embedding, blocks, (turns, rods));
        let pulls = std::array::from_ref(rods.forces(simd));
        for block in 0..strip.len() {
            let mut sums = Vec3x::splat(f64x8::splat(simd, 0.0));
            vertices.scatter(simd, block, pulls, &mut sums);
            if !embedding.curved.is_empty() {
                turning.scatter(simd, block, spins, &mut sums);
            }
            strip.pass_on(block, sums, forces);
        }
    }
}

impl Force for FibreForce {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let positions = &state.positions;
        let driven = self.is_driven();
        if driven {
            self.follow(time, positions);
        }
        dispatch!(self.level, simd => self.evaluate(simd, driven.then_some(time), positions, forces));
        if !self.ends.is_empty() {
            self.add_twists(time, positions, forces);
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.activation -= self.drive_work();
        self.add_stored(time, &state.positions, energies);
    }

    fn is_internal(&self) -> bool {
        true
    }

    fn couplings(&self) -> Vec<Vec<u32>> {
        self.fibres.iter().flat_map(FibreRest::couplings).collect()
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        if self.is_driven() {
            let mut activity = std::mem::take(&mut self.activity);
            activity.book(self.now(time, &state.positions), &self.broken);
            self.activity = activity;
        }
        let yields = self.yields(&state.positions);
        let before = self.broken.breaks.len();
        let (mut first, mut first_bend, mut first_edge) = (0, 0, 0);
        for fibre in self.fibres.iter() {
            if fibre.limits.is_finite() {
                let x: Vec<DVec3> = fibre.vertices.iter().map(|vertex| vertex.gather(&state.positions)).collect();
                let tension = fibre.tensions(&x, time);
                let pulls = (0..fibre.edges.len()).filter(|k| !self.broken.edges[first_edge + k]).map(|k| {
                    let yielded = fibre.edges[k].0 * self.yielded.stretch(first_edge + k);
                    ((tension(k) - yielded) / fibre.limits.tension, k)
                });
                let turns = (0..fibre.bends.len()).filter(|k| !self.broken.bends[first_bend + k]).map(|k| {
                    let rest = self.yielded.binormal(first_bend + k);
                    let at = (time, self.turns[first_bend + k], rest);
                    (fibre.turn(&x, k, &state.positions, at) / fibre.limits.angle, k)
                });
                let (pull, turn) = (furthest(pulls), furthest(turns));
                match (pull, turn) {
                    ((by, k), (less, _)) if by > 1.0 && by >= less => {
                        self.broken.at_edge(fibre, [first_bend, first_edge], k, time);
                    }
                    (_, (by, k)) if by > 1.0 => self.broken.at_vertex(fibre, first_bend, k, time),
                    _ => {}
                }
                if let Some(workspace) = self.workspace.as_mut() {
                    let bends = &self.broken.bends[first_bend..first_bend + fibre.bends.len()];
                    workspace.rods.release(
                        first,
                        bends,
                        &self.broken.edges[first_edge..first_edge + fibre.edges.len()],
                    );
                }
            }
            first += fibre.vertices.len();
            first_bend += fibre.bends.len();
            first_edge += fibre.edges.len();
        }
        let breaks = self.broken.breaks.len() > before;
        if let Some(workspace) = self.workspace.as_mut().filter(|_| breaks) {
            workspace.curved.release(&self.embedding, &self.broken.bends);
        }
        yields || breaks
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        let before = before.iter().find_map(|force| force.downcast_ref::<Self>());
        self.activity.adopt(before.map(|before| &before.activity));
        if let Some(before) = before {
            self.broken = before.broken.carried([&before.fibres, &self.fibres]);
            self.yielded = before.yielded.carried([&before.fibres, &self.fibres]);
            self.workspace = Scratch::default();
        }
    }

    fn give(&mut self, to: &str, led: Option<Hand>) {
        if !self.fibres.iter().any(|fibre| fibre.activation.is_some()) {
            return;
        }
        let mut fibres = self.fibres.to_vec();
        for fibre in &mut fibres {
            fibre.give(to, led);
        }
        // A checkpoint of before keeps those that it has.
        if fibres != *self.fibres {
            self.fibres = fibres.into();
        }
    }

    fn drive_work(&self) -> f64 {
        self.activity.work
    }

    fn dissipated(&self) -> f64 {
        self.yielded.dissipated
    }

    fn remembered(&self, number: &mut dyn FnMut(f64)) {
        self.yielded.remembered(number);
    }

    fn name(&self) -> &'static str {
        "fibres"
    }

    fn breaks(&self) -> &[FibreBreak] {
        &self.broken.breaks
    }

    fn bytes(&self) -> usize {
        size_of_val(self)
            + size_of_val(&*self.turns)
            + size_of_val(&*self.ends)
            + self.broken.bytes()
            + self.yielded.bytes()
            + self.activity.bytes()
    }

    fn changes_until(&self) -> f64 {
        self.fibres.iter().map(FibreRest::changes_until).fold(0.0, f64::max)
    }

    fn driven_until(&self) -> f64 {
        self.changes_until()
    }

    fn clone_at_extreme(&self, greatest: bool) -> Box<dyn Force> {
        let fibres = self.fibres.iter().map(|fibre| fibre.at_extreme(greatest)).collect();
        Box::new(Self { fibres, ..self.clone() })
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
