//! The force of all fibres of a body, evaluated together.

use super::breaking::{Breakage, FibreBreak};
use super::corner::{Corner, straight_energy};
use super::fibre_embedding::FibreEmbedding;
use super::material_turn::{material_spin, polar, turn_of_material};
use super::packed_rods::PackedRods;
use super::rest::FibreRest;
use super::soa::{SoaVectors, put, zeros};
use super::strip::BlockVectors;
use crate::solver::energy::Energies;
use crate::solver::forces::force::Force;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use crate::solver::wide::Vec3x;
use fearless_simd::{Level, Simd, dispatch, f64x8, prelude::*};
use glam::{DMat3, DQuat, DVec3};
use std::sync::Arc;

/// Stretching and bending of all fibres of a body.
#[derive(Clone)]
pub struct FibreForce {
    pub(super) fibres: Arc<[FibreRest]>,
    pub(super) embedding: Arc<FibreEmbedding>,
    level: Level,
    /// Last turn at every bend of every fibre, the warm start of the next.
    pub(super) turns: Vec<DQuat>,
    pub(super) broken: Breakage,
    /// Follows from all that is above.
    workspace: Scratch<Option<Workspace>>,
}

/// What an evaluation works on.
#[derive(Debug)]
struct Workspace {
    rods: PackedRods,
    /// Positions of the strip's particles [m].
    positions: Vec<BlockVectors>,
    /// What turns every curved bend's particles, by the components of `om_k Z_k` [N m].
    spins: [SoaVectors; 3],
}

impl Workspace {
    fn new(fibres: &[FibreRest], embedding: &FibreEmbedding, broken: &Breakage) -> Self {
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
        let spins = [0, 1, 2].map(|_| zeros(embedding.curved.len()));
        Self { rods, positions: vec![BlockVectors::default(); embedding.strip.len()], spins }
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
            broken: Breakage::none(&fibres),
            workspace: Scratch::default(),
            fibres,
        }
    }

    /// Adds the forces [N] on particles at `positions` [m] to `forces`.
    pub(in crate::solver) fn evaluate_at(&mut self, positions: &[DVec3], forces: &mut [DVec3]) {
        dispatch!(self.level, simd => self.evaluate(simd, positions, forces));
    }

    #[inline(always)]
    fn evaluate<S: Simd>(&mut self, simd: S, positions: &[DVec3], forces: &mut [DVec3]) {
        let Self { fibres, embedding, broken, turns, workspace, .. } = self;
        let Workspace { rods, positions: blocks, spins } =
            workspace.get_or_insert_with(|| Workspace::new(fibres, embedding, broken));
        let FibreEmbedding { strip, vertices, turns: turning, curved } = &**embedding;
        strip.fill(simd, positions, blocks);
        for vertex in 0..rods.len() {
            let [at] = vertices.gather(simd, vertex, blocks);
            rods.put(vertex, at);
        }
        rods.compute_gradients(simd);
        for (k, rest) in curved.iter().enumerate() {
            let corner = if broken.bends[rest.bend] { None } else { rods.corner(rest.corner) };
            let by_axis = if let Some(corner) = corner {
                let [x, y, z] = turning.gather(simd, k, blocks);
                let (r, stretch) = polar(DMat3::from_cols(x, y, z), &mut turns[rest.bend]);
                let gradient = 2.0 * rest.stiffness * (corner.binormal() - r * rest.binormal);
                rods.add(rest.corner, corner.curved_gradients(gradient));
                material_spin(r, stretch, rest.binormal, gradient)
            } else {
                [DVec3::ZERO; 3]
            };
            for (spin, value) in spins.iter_mut().zip(by_axis) {
                put(spin, k, value);
            }
        }
        let pulls = std::array::from_ref(rods.forces(simd));
        for block in 0..strip.len() {
            let mut sums = Vec3x::splat(f64x8::splat(simd, 0.0));
            vertices.scatter(simd, block, pulls, &mut sums);
            if !curved.is_empty() {
                turning.scatter(simd, block, spins, &mut sums);
            }
            strip.pass_on(block, sums, forces);
        }
    }
}

impl Force for FibreForce {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        self.evaluate_at(&state.positions, forces);
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
                    None => 4.0 * bend.stiffness * straight_energy(corner.cosine),
                    Some(curved) => {
                        let (r, _) = turn_of_material(&curved.turn, &state.positions, &mut turn.clone());
                        bend.stiffness * (corner.binormal() - r * curved.binormal).length_squared()
                    }
                };
            }
        }
    }

    fn couplings(&self) -> Vec<Vec<u32>> {
        self.fibres.iter().flat_map(FibreRest::couplings).collect()
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        let before = self.broken.breaks.len();
        let (mut first, mut first_bend, mut first_edge) = (0, 0, 0);
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
        self.broken.breaks.len() > before
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        if let Some(before) = before.iter().find_map(|force| force.downcast_ref::<Self>()) {
            self.broken = before.broken.carried([&before.fibres, &self.fibres]);
            self.workspace = Scratch::default();
        }
    }

    fn name(&self) -> &'static str {
        "fibres"
    }

    fn breaks(&self) -> &[FibreBreak] {
        &self.broken.breaks
    }

    fn bytes(&self) -> usize {
        size_of_val(self) + size_of_val(&*self.turns) + self.broken.bytes()
    }

    fn changes_until(&self) -> f64 {
        0.0
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

/// The greatest ratio of a load to its limit and where it is; zero where there is none.
fn furthest(ratios: impl Iterator<Item = (f64, usize)>) -> (f64, usize) {
    ratios.fold((0.0, 0), |most, ratio| if ratio.0 > most.0 { ratio } else { most })
}
