//! Radial damping between neighbours: takes energy, keeps linear and angular momentum.
//!
//! On a lattice the near bonds of every particle have the same 18 offsets, so that they are taken for four particles of
//! a row at a time: positions and velocities are copied to rows along x, each with empty places beyond both ends, where
//! a neighbour along x is the number beside. An empty place has no weight in any bond.

use super::bricks::{Alignment, Bricks, Palette, brick_and_lane};
use super::force::{Force, StepLimit};
use crate::solver::energy::Energies;
use crate::solver::neighbourhood::Neighbourhood;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use crate::solver::wide::{LANES, Lanes4, Vec3x, Wide, vector_of};
use fearless_simd::{Level, Simd, dispatch, f64x4, prelude::*};
use glam::{DVec3, IVec3};
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Arc;

/// `f = g m om_ij (dv . n) n` on both ends of every near bond, equal and opposite along the line between them.
#[derive(Clone)]
pub(crate) struct PairDamping {
    rate: f64,
    /// Greatest sum of a particle's weights.
    greatest_weight_sum: f64,
    bonds: Arc<NearBonds>,
    level: Level,
    buffers: Scratch<DampingBuffers>,
}

#[derive(Default)]
struct DampingBuffers {
    /// x, y, z of positions [m] and velocities [m/s], and masses [kg], along the rows.
    along: [Vec<f64>; 7],
    /// Damping of every brick's particles over the rate [N s], components side by side.
    sums: Vec<[Lanes4; 3]>,
}

impl DampingBuffers {
    /// Makes room for the particles of these bonds. Empty places are never written and stay zero.
    fn fit(&mut self, bonds: &NearBonds) {
        for along in &mut self.along {
            along.resize(bonds.length, 0.0);
        }
        self.sums.resize(bonds.around.len(), [Lanes4::default(); 3]);
    }
}

/// Where the particles lie along the rows, and their bonds.
struct NearBonds {
    /// Places along the rows, empty ones among them.
    length: usize,
    /// Place of every particle along the rows.
    places: Vec<u32>,
    /// Place of every particle in its brick.
    in_bricks: Vec<u32>,
    /// Where the bricks at [`ROWS`] around every brick begin along the rows.
    around: Vec<[u32; ROWS.len()]>,
    /// Weights om_ij = om_ji of the 18 pairs of every brick's particles.
    weights: Palette<[Lanes4; BONDS]>,
}

/// Offsets of |o|² = 1 and 2, up to 1.5 spacings: these bonds damp as well as all would.
const BONDS: usize = 18;
/// (dy, dz) of the rows around a brick, the brick's own among them.
const ROWS: [(i32, i32); 9] = [(-1, -1), (0, -1), (1, -1), (-1, 0), (0, 0), (1, 0), (-1, 1), (0, 1), (1, 1)];
/// Number of the brick's own row.
const OWN_ROW: usize = 4;
/// dx of the bonds into every one of [`ROWS`].
const STEPS: [&[i32]; 9] = [&[0], &[-1, 0, 1], &[0], &[-1, 0, 1], &[-1, 1], &[-1, 0, 1], &[0], &[-1, 0, 1], &[0]];
const _: () = {
    let (mut count, mut row) = (0, 0);
    while row < ROWS.len() {
        let (y, z) = ROWS[row];
        let mut k = 0;
        while k < STEPS[row].len() {
            let norm_squared = STEPS[row][k] * STEPS[row][k] + y * y + z * z;
            assert!(norm_squared == 1 || norm_squared == 2, "no other bond is near");
            (count, k) = (count + 1, k + 1);
        }
        row += 1;
    }
    assert!(count == BONDS, "every near bond is there");
    assert!(ROWS[OWN_ROW].0 == 0 && ROWS[OWN_ROW].1 == 0);
};
/// A body of fewer particles stays on one thread.
const PARALLEL_FROM: usize = 2000;
/// Bricks, or a quarter of the particles, that a thread works on at a time.
const CHUNK: usize = 64;

impl PairDamping {
    /// Damping at `rate` g [1/s] over the bonds of up to 1.5 spacings.
    pub(crate) fn new(rate: f64, neighbourhood: &Neighbourhood) -> Self {
        Self::of(rate, None, neighbourhood)
    }

    /// [`Self::new`] at a rate [1/s] of every particle's own; two take the mean of theirs.
    pub(crate) fn varied(rates: &[f64], neighbourhood: &Neighbourhood) -> Self {
        Self::of(1.0, Some(rates), neighbourhood)
    }

    fn of(rate: f64, rates: Option<&[f64]>, neighbourhood: &Neighbourhood) -> Self {
        let cells = &neighbourhood.lattice().cells;
        let near = |i: usize| {
            let bonds = neighbourhood.bonds(i).map(move |(j, bond)| (j, cells[j] - cells[i], bond.weight));
            bonds.filter(|(_, step, _)| step.length_squared() <= 2)
        };
        let sums: Vec<f64> = (0..cells.len()).map(|i| near(i).map(|(_, _, weight)| weight).sum()).collect();
        // The mean of both ends' normalised weights, so that the pair agrees on it.
        let normalised = |i: usize, (j, step, weight): (usize, IVec3, f64)| {
            let weight = 0.5 * weight * (1.0 / sums[i] + 1.0 / sums[j]);
            (step, rates.map_or(weight, |rates| 0.5 * weight * (rates[i] + rates[j])))
        };
        let weights: Vec<HashMap<IVec3, f64>> =
            (0..cells.len()).map(|i| near(i).map(|bond| normalised(i, bond)).collect()).collect();
        let total = |i: usize| near(i).map(|bond| normalised(i, bond).1).sum::<f64>();
        Self {
            rate,
            greatest_weight_sum: (0..cells.len()).map(total).fold(0.0, f64::max),
            bonds: Arc::new(NearBonds::new(cells, &weights)),
            level: Level::new(),
            buffers: Scratch::default(),
        }
    }
}

impl NearBonds {
    /// The bonds of particles with these weights by offset.
    fn new(cells: &[IVec3], weights: &[HashMap<IVec3, f64>]) -> Self {
        let Bricks { positions: bricks, places: in_bricks, .. } = Bricks::new(cells, Alignment::plain(LANES));
        let (beginnings, length) = along_rows(&bricks);
        let begin = |brick: IVec3| beginnings.get(&brick).copied().unwrap_or(LANES as u32);
        let mut places = Vec::with_capacity(cells.len());
        let mut of_brick = vec![[Lanes4::default(); BONDS]; bricks.len()];
        for (&place, weights) in in_bricks.iter().zip(weights) {
            let (brick, lane) = brick_and_lane::<Lanes4>(place);
            places.push(begin(bricks[brick]) + lane as u32);
            let steps = ROWS.iter().zip(STEPS);
            let steps = steps.flat_map(|(&(y, z), steps)| steps.iter().map(move |&dx| IVec3::new(dx, y, z)));
            for (weight, step) in of_brick[brick].iter_mut().zip(steps) {
                weight.0[lane] = weights.get(&step).copied().unwrap_or(0.0);
            }
        }
        let around = bricks.iter().map(|&brick| ROWS.map(|(y, z)| begin(brick + IVec3::new(0, y, z)))).collect();
        Self { length, places, in_bricks, around, weights: Palette::new(of_brick.into_iter()) }
    }

    /// Damping over the rate of a brick's particles.
    #[inline(always)]
    fn sum<S: Simd>(&self, simd: S, along: &[Vec<f64>; 7], brick: usize) -> [Lanes4; 3] {
        let least = f64x4::splat(simd, f64::MIN_POSITIVE);
        let half = f64x4::splat(simd, 0.5);
        let [x, y, z, u, v, w, m] = along;
        let around = &self.around[brick];
        let own = around[OWN_ROW];
        let position = vectors_beside(simd, [window(x, own), window(y, own), window(z, own)], 0);
        let velocity = vectors_beside(simd, [window(u, own), window(v, own), window(w, own)], 0);
        let mass = beside(simd, window(m, own), 0);
        let mut weights = self.weights.of(brick).iter();
        let mut sum = Vec3x::splat(f64x4::splat(simd, 0.0));
        for (&begin, steps) in around.iter().zip(STEPS) {
            let positions = [window(x, begin), window(y, begin), window(z, begin)];
            let velocities = [window(u, begin), window(v, begin), window(w, begin)];
            let masses = window(m, begin);
            for (&dx, weight) in steps.iter().zip(&mut weights) {
                let offset = vectors_beside(simd, positions, dx) - position;
                let relative = vectors_beside(simd, velocities, dx) - velocity;
                let mean_mass = half * (beside(simd, masses, dx) + mass);
                let closing = relative.dot(offset);
                // Two particles at one place, or two empty places, have no line between them: 0 / least is no force.
                let length_squared = offset.dot(offset) + least;
                let factor = f64x4::load(simd, weight) * mean_mass * closing / length_squared;
                sum = offset.mul_add(factor, sum);
            }
        }
        sum.store()
    }

    #[inline(always)]
    fn sums<S: Simd>(&self, simd: S, along: &[Vec<f64>; 7], first: usize, sums: &mut [[Lanes4; 3]]) {
        for (k, sum) in sums.iter_mut().enumerate() {
            *sum = self.sum(simd, along, first + k);
        }
    }
}

/// Where bricks begin along the rows, those among them that are empty too, and the number of places there.
///
/// Bricks 0 to 2 are empty: 1 stands for all far from any particle. Beyond the ends of a row lies an empty brick each,
/// one in common where they are the same place.
fn along_rows(bricks: &[IVec3]) -> (HashMap<IVec3, u32>, usize) {
    let mut beginnings: HashMap<IVec3, u32> = HashMap::new();
    let mut next = 3 * LANES as u32;
    let mut add = |brick: IVec3, beginnings: &mut HashMap<IVec3, u32>| {
        beginnings.insert(brick, next);
        next += LANES as u32;
    };
    for (k, &brick) in bricks.iter().enumerate() {
        let before = brick - IVec3::X;
        if (k == 0 || bricks[k - 1] != before) && !beginnings.contains_key(&before) {
            add(before, &mut beginnings);
        }
        add(brick, &mut beginnings);
        if bricks.get(k + 1) != Some(&(brick + IVec3::X)) {
            add(brick + IVec3::X, &mut beginnings);
        }
    }
    // One more, so that the last empty brick has one behind it, too.
    (beginnings, next as usize + LANES)
}

/// A brick with the ones before and behind it in its row.
#[inline(always)]
fn window(along: &[f64], begin: u32) -> &[f64; 3 * LANES] {
    let begin = begin as usize - LANES;
    along[begin..].first_chunk().expect("an empty brick lies beyond every end")
}

/// The places `dx` beside those of a window's brick.
#[inline(always)]
fn beside<S: Simd>(simd: S, window: &[f64; 3 * LANES], dx: i32) -> f64x4<S> {
    let at = LANES.saturating_add_signed(dx as isize);
    f64x4::from_slice(simd, &window[at..at + LANES])
}

/// The same of the three components of vectors.
#[inline(always)]
fn vectors_beside<S: Simd>(simd: S, [x, y, z]: [&[f64; 3 * LANES]; 3], dx: i32) -> Vec3x<f64x4<S>> {
    Vec3x([beside(simd, x, dx), beside(simd, y, dx), beside(simd, z, dx)])
}

impl Force for PairDamping {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let Self { bonds, buffers, level, rate, .. } = self;
        buffers.fit(bonds);
        let DampingBuffers { along, sums } = &mut **buffers;
        let [x, y, z, u, v, w, m] = &mut *along;
        for (i, &place) in bonds.places.iter().enumerate() {
            let place = place as usize;
            [x[place], y[place], z[place]] = state.positions[i].to_array();
            [u[place], v[place], w[place]] = state.velocities[i].to_array();
            m[place] = state.masses[i];
        }
        let along = &*along;
        let work = |(chunk, sums): (usize, &mut [[Lanes4; 3]])| {
            dispatch!(*level, simd => bonds.sums(simd, along, chunk * CHUNK, sums));
        };
        if state.len() < PARALLEL_FROM {
            sums.chunks_mut(CHUNK).enumerate().for_each(work);
        } else {
            sums.par_chunks_mut(CHUNK).enumerate().for_each(work);
        }
        for (force, &place) in forces.iter_mut().zip(&bonds.in_bricks) {
            let (brick, lane) = brick_and_lane::<Lanes4>(place);
            *force += *rate * vector_of(&sums[brick], lane);
        }
    }

    fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}

    fn is_internal(&self) -> bool {
        true
    }

    fn step_limit(&self, _state: &ParticleState) -> StepLimit {
        // Gershgorin: no row of the damping matrix sums to more than twice the particle's own entry.
        StepLimit { damping_rate: 2.0 * self.rate * self.greatest_weight_sum, ..StepLimit::default() }
    }

    fn changes_until(&self) -> f64 {
        0.0
    }

    fn name(&self) -> &'static str {
        "pair damping"
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
