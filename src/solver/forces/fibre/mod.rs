//! Fibres: rods that bend and stretch (sec. 4.1), riding on the material particles.
//!
//! Per edge `l_f (EA / 2 l0) (|e| - l0)²`; per inner vertex `l_f (EI / L0) |kb - R_s kb0|²` with the curvature binormal
//! of eq. 6, `L0` the rest lengths of both edges and `R_s` the turn of the material around the vertex. The gradients
//! are exact: the paper's own (the centre vertex's, with half reactions on its neighbours) is 28 to 56 % off and makes
//! torque. A straight rest shape needs no `R_s`: `l_f (4 EI / L0) (1 - c) / (1 + c)`, c the cosine of the turn.
//!
//! Eq. 7 is half of Bergou's energy, so that EI is the paper's `K_b / 2`. The energy of eq. 6 is unbounded where a
//! fibre folds back on itself; below `c = -1/2` it continues linearly in c.

mod band;
pub mod breaking;
mod corner;
mod lines;
mod rest;
mod strip;
mod tension;

pub use corner::curvature_binormal;
pub use rest::{Bend, CurvedRest, FibreRest};

use super::Force;
use crate::solver::embedding::TurnWeights;
use crate::solver::energy::Energies;
use crate::solver::neighbourhood::outer;
use crate::solver::rotation::{nearest_rotation, turn_stiffness};
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use crate::solver::wide::Vec3x;
use band::{Band, Points};
use breaking::{Breakage, FibreBreak};
use corner::{Corner, straight_energy};
use fearless_simd::{Level, Simd, dispatch, f64x8, prelude::*};
use glam::{DMat3, DQuat, DVec3};
use lines::{Columns, Lines, put};
use std::sync::Arc;
use strip::{Strip, Window};

/// Stretching and bending of all fibres of a body.
#[derive(Clone)]
pub struct FibreForce {
    fibres: Arc<[FibreRest]>,
    packed: Arc<Packed>,
    level: Level,
    /// Last turn at every bend of every fibre, the warm start of the next.
    turns: Vec<DQuat>,
    broken: Breakage,
    /// Follows from all that is above.
    work: Scratch<Option<Work>>,
}

/// What an evaluation works on.
#[derive(Debug)]
struct Work {
    lines: Lines,
    /// Positions of the strip's particles [m].
    positions: Vec<Window>,
    /// What turns every curved bend's particles, by the components of `om_k Z_k` [N m].
    spins: [Columns; 3],
}

impl Work {
    fn new(fibres: &[FibreRest], packed: &Packed, broken: &Breakage) -> Self {
        let mut lines = Lines::new(fibres);
        let (mut first, mut first_bend, mut first_edge) = (0, 0, 0);
        for fibre in fibres {
            let (bends, edges) = (fibre.bends.len(), fibre.edges.len());
            let broken = [&broken.bends[first_bend..][..bends], &broken.edges[first_edge..][..edges]];
            lines.lose(first, broken[0], broken[1]);
            first += fibre.vertices.len();
            first_bend += bends;
            first_edge += edges;
        }
        let spins = || [0, 1, 2].map(|_| vec![0.0; packed.curved.len()]);
        Self { lines, positions: vec![Window::default(); packed.strip.len()], spins: [spins(), spins(), spins()] }
    }
}

/// The weights of all fibres of a body.
struct Packed {
    strip: Strip,
    /// Of every vertex, fibre after fibre.
    vertices: Band<1>,
    /// Of every curved bend, by the components of `om_k Z_k`.
    turns: Band<3>,
    curved: Vec<CurvedBend>,
}

/// A bend whose rest shape is curved.
struct CurvedBend {
    /// Its number among all bends, and that of its corner in the lines.
    bend: usize,
    corner: usize,
    stiffness: f64,
    binormal: DVec3,
}

impl Packed {
    fn new(fibres: &[FibreRest]) -> Self {
        let (mut strip, mut vertices, mut turns) = (Strip::default(), Points::default(), Points::default());
        let mut curved = Vec::new();
        let (mut first_bend, mut first) = (0, 0);
        for fibre in fibres {
            let places = strip.add(fibre.particles());
            for vertex in &fibre.vertices {
                vertices.add(&places, vertex.weights.iter().map(|&(particle, phi)| (particle, [phi])));
            }
            for (k, bend) in fibre.bends.iter().enumerate() {
                if let Some(CurvedRest { binormal, turn }) = &bend.curved {
                    let (bend, stiffness) = (first_bend + k, bend.stiffness);
                    curved.push(CurvedBend { bend, corner: first + k, stiffness, binormal: *binormal });
                    turns.add(&places, turn.weights.iter().map(|&(particle, z)| (particle, z.to_array())));
                }
            }
            first_bend += fibre.bends.len();
            first += fibre.vertices.len();
        }
        Self { vertices: vertices.band(strip.len()), turns: turns.band(strip.len()), strip, curved }
    }
}

impl FibreForce {
    /// Forces of `fibres`; `orientation` is the turn of the model frame in the world at the start.
    pub fn new(fibres: Arc<[FibreRest]>, orientation: DQuat) -> Self {
        let bends = fibres.iter().map(|fibre| fibre.bends.len()).sum();
        Self {
            packed: Arc::new(Packed::new(&fibres)),
            level: Level::new(),
            turns: vec![orientation; bends],
            broken: Breakage::none(&fibres),
            work: Scratch::default(),
            fibres,
        }
    }

    #[inline(always)]
    fn evaluate<S: Simd>(&mut self, simd: S, positions: &[DVec3], forces: &mut [DVec3]) {
        let Self { fibres, packed, broken, turns, work, .. } = self;
        let Work { lines, positions: windows, spins } = work.get_or_insert_with(|| Work::new(fibres, packed, broken));
        let Packed { strip, vertices, turns: turning, curved } = &**packed;
        strip.fill(simd, positions, windows);
        for vertex in 0..lines.len() {
            let [at] = vertices.gather(simd, vertex, windows);
            lines.put(vertex, at);
        }
        lines.slopes(simd);
        for (k, rest) in curved.iter().enumerate() {
            let corner = if broken.bends[rest.bend] { None } else { lines.corner(rest.corner) };
            let by_axis = if let Some(corner) = corner {
                let [x, y, z] = turning.gather(simd, k, windows);
                let (r, stretch) = polar(DMat3::from_cols(x, y, z), &mut turns[rest.bend]);
                let slope = 2.0 * rest.stiffness * (corner.binormal() - r * rest.binormal);
                let moment = -rest.binormal.cross(r.transpose() * slope);
                let p = turn_stiffness(stretch).inverse() * moment;
                lines.add(rest.corner, corner.curved_slopes(slope));
                // `-R (p x Z)`, by the components of Z.
                [r * DVec3::X.cross(p), r * DVec3::Y.cross(p), r * DVec3::Z.cross(p)]
            } else {
                [DVec3::ZERO; 3]
            };
            for (spin, value) in spins.iter_mut().zip(by_axis) {
                put(spin, k, value);
            }
        }
        let pulls = std::array::from_ref(lines.forces(simd));
        for window in 0..strip.len() {
            let mut sums = Vec3x::splat(f64x8::splat(simd, 0.0));
            vertices.scatter(simd, window, pulls, &mut sums);
            if !curved.is_empty() {
                turning.scatter(simd, window, spins, &mut sums);
            }
            strip.pass_on(window, sums, forces);
        }
    }
}

impl Force for FibreForce {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        dispatch!(self.level, simd => self.evaluate(simd, &state.positions, forces));
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
                        let (r, _) = turned(&curved.turn, &state.positions, &mut turn.clone());
                        bend.stiffness * (corner.binormal() - r * curved.binormal).length_squared()
                    }
                };
            }
        }
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
                if let Some(work) = self.work.as_mut() {
                    let bends = &self.broken.bends[first_bend..first_bend + fibre.bends.len()];
                    work.lines.lose(first, bends, &self.broken.edges[first_edge..first_edge + fibre.edges.len()]);
                }
            }
            first += fibre.vertices.len();
            first_bend += fibre.bends.len();
            first_edge += fibre.edges.len();
        }
        self.broken.breaks.len() > before
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        if let Some(before) = before.iter().find_map(|force| force.fibres()) {
            self.broken = before.broken.carried([&before.fibres, &self.fibres]);
            self.work = Scratch::default();
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

    fn fibres(&self) -> Option<&FibreForce> {
        Some(self)
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
    /// The particles that it rides on, each with every vertex that it is around.
    fn particles(&self) -> impl Iterator<Item = (usize, u32)> {
        let vertices = self.vertices.iter().enumerate();
        let curved = self.bends.iter().enumerate().filter_map(|(k, bend)| Some((k + 1, bend.curved.as_ref()?)));
        let vertices = vertices.flat_map(|(k, vertex)| vertex.weights.iter().map(move |&(particle, _)| (k, particle)));
        vertices.chain(curved.flat_map(|(k, rest)| rest.turn.weights.iter().map(move |&(particle, _)| (k, particle))))
    }

    /// Force [N] that edge `k` carries between vertices at `x`; negative where it is pressed.
    fn tension(&self, x: &[DVec3], k: usize) -> f64 {
        let (stiffness, rest_length) = self.edges[k];
        stiffness * (x[k + 1].distance(x[k]) - rest_length)
    }

    /// Turn [rad] of bend `k` away from its rest shape, `2 atan(|kb - R_s kb0| / 2)`: the turning angle of eq. 6 itself
    /// where the rest shape is straight.
    fn turn(&self, x: &[DVec3], k: usize, positions: &[DVec3], warm_start: DQuat) -> f64 {
        let Some(corner) = Corner::at(x, k) else { return 0.0 };
        let across = corner.before.tangent.cross(corner.after.tangent);
        let Some(curved) = &self.bends[k].curved else { return across.length().atan2(corner.cosine) };
        // Not the binormal that is continued beyond a fold: that one falls again as the fibre closes.
        let binormal = 2.0 * across / (1.0 + corner.cosine).max(f64::EPSILON);
        let (r, _) = turned(&curved.turn, positions, &mut warm_start.clone());
        2.0 * (0.5 * (binormal - r * curved.binormal).length()).atan()
    }
}

/// Turn of the material around a vertex and its stretch `R^T A`.
fn turned(stencil: &TurnWeights, positions: &[DVec3], turn: &mut DQuat) -> (DMat3, DMat3) {
    // The weights sum to zero: taken against one particle, the sum stays exact far from the origin.
    let origin = stencil.weights.first().map_or(DVec3::ZERO, |&(k, _)| positions[k as usize]);
    let mut gradient = DMat3::ZERO;
    for &(k, z) in &stencil.weights {
        gradient += outer(positions[k as usize] - origin, z);
    }
    polar(gradient, turn)
}

/// Rotation of a deformation gradient A, near the last one, and its stretch `R^T A`.
fn polar(gradient: DMat3, turn: &mut DQuat) -> (DMat3, DMat3) {
    *turn = nearest_rotation(gradient, *turn);
    let r = DMat3::from_quat(*turn);
    (r, r.transpose() * gradient)
}
