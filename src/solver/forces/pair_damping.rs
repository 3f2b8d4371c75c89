//! Radial damping between neighbours: takes energy, keeps linear and angular momentum.
//!
//! On a lattice the near bonds of every particle have the same 18 offsets, so that they are taken for four particles of
//! a row at a time: positions and velocities are copied to rows along x, each with empty places beyond both ends, where
//! a neighbour along x is the number beside. An empty place has no share in any bond.

use super::{Force, StepLimit};
use crate::solver::energy::Energies;
use crate::solver::neighbourhood::Neighbourhood;
use crate::solver::scratch::Scratch;
use crate::solver::state::ParticleState;
use fearless_simd::{Level, Simd, dispatch, f64x4, prelude::*};
use glam::{DVec3, IVec3};
use rayon::prelude::*;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// `f = g m om_ij (dv . n) n` on both ends of every near bond, equal and opposite along the line between them.
#[derive(Clone)]
pub struct PairDamping {
    rate: f64,
    greatest_share: f64,
    rows: Arc<Rows>,
    level: Level,
    buffers: Scratch<Buffers>,
}

#[derive(Default)]
struct Buffers {
    /// x, y, z of positions [m] and velocities [m/s], and masses [kg], along the rows.
    along: [Vec<f64>; 7],
    /// Damping of every brick's particles over the rate [N s], components side by side.
    sums: Vec<[[f64; LANES]; 3]>,
}

impl Buffers {
    /// Makes room for these rows. Empty places are never written and stay zero.
    fn fit(&mut self, rows: &Rows) {
        for along in &mut self.along {
            along.resize(rows.length, 0.0);
        }
        self.sums.resize(rows.bricks.len(), [[0.0; LANES]; 3]);
    }
}

/// Where the particles lie in the rows, and their bonds.
struct Rows {
    /// Places along the rows, empty ones among them.
    length: usize,
    /// Place of every particle along the rows.
    places: Vec<u32>,
    /// Brick of every particle, times four, plus its place there.
    lanes: Vec<u32>,
    bricks: Vec<Brick>,
    /// Shares om_ij = om_ji of the 18 pairs of a brick's particles; many bricks have the same.
    shares: Vec<[[f64; LANES]; BONDS]>,
}

/// Four places side by side in a row.
struct Brick {
    /// Where the bricks at (dy, dz) begin along the rows, dy first, from (-1, -1) to (1, 1).
    around: [u32; 9],
    shares: u32,
}

/// Places of a brick.
const LANES: usize = 4;
const BRICK: i32 = 4;
/// Offsets of |o|² = 1 and 2, up to 1.5 spacings: these bonds damp as well as all would.
const BONDS: usize = 18;
/// dx of the offsets for every (dy, dz), in order of [`Brick::around`].
const STEPS: [&[i32]; 9] = [&[0], &[-1, 0, 1], &[0], &[-1, 0, 1], &[-1, 1], &[-1, 0, 1], &[0], &[-1, 0, 1], &[0]];
/// A body of fewer particles stays on one thread.
const PARALLEL_FROM: usize = 2000;
/// Bricks, or a quarter of the particles, that a thread works on at a time.
const CHUNK: usize = 64;

/// (dy, dz) of the rows around a brick, in order of [`Brick::around`].
fn row_offsets() -> [IVec3; 9] {
    let mut offsets = [IVec3::ZERO; 9];
    for (k, offset) in (0..).zip(&mut offsets) {
        *offset = IVec3::new(0, k % 3 - 1, k / 3 - 1);
    }
    offsets
}

impl PairDamping {
    /// Damping at `rate` g [1/s] over the bonds of up to 1.5 spacings.
    pub fn new(rate: f64, neighbourhood: &Neighbourhood) -> Self {
        let cells = &neighbourhood.lattice().cells;
        let near = |i: usize| {
            let bonds = neighbourhood.bonds(i).map(move |(j, bond)| (j, cells[j] - cells[i], bond.weight));
            bonds.filter(|(_, step, _)| step.length_squared() <= 2)
        };
        let sums: Vec<f64> = (0..cells.len()).map(|i| near(i).map(|(_, _, weight)| weight).sum()).collect();
        // The mean of both ends' shares, so that the pair agrees on it.
        let share =
            |i: usize, (j, step, weight): (usize, IVec3, f64)| (step, 0.5 * weight * (1.0 / sums[i] + 1.0 / sums[j]));
        let shares: Vec<HashMap<IVec3, f64>> =
            (0..cells.len()).map(|i| near(i).map(|bond| share(i, bond)).collect()).collect();
        let total = |i: usize| near(i).map(|bond| share(i, bond).1).sum::<f64>();
        let rows = Rows::new(cells, &shares);
        Self {
            rate,
            greatest_share: (0..cells.len()).map(total).fold(0.0, f64::max),
            level: Level::new(),
            buffers: Scratch::default(),
            rows: Arc::new(rows),
        }
    }
}

impl Rows {
    /// Lays out particles with these shares by offset.
    fn new(cells: &[IVec3], shares: &[HashMap<IVec3, f64>]) -> Self {
        let brick_of = |cell: IVec3| IVec3::new(cell.x.div_euclid(BRICK), cell.y, cell.z);
        let lane_of = |cell: IVec3| cell.x.rem_euclid(BRICK) as usize;
        let mut bricks: Vec<IVec3> =
            cells.iter().map(|&cell| brick_of(cell)).collect::<HashSet<_>>().into_iter().collect();
        bricks.sort_unstable_by_key(|brick| (brick.z, brick.y, brick.x));
        // Bricks 0 to 2 are empty: 1 stands for all far from any particle. Beyond the ends of a row lies an empty brick
        // each, one in common where they are the same place.
        let mut at: HashMap<IVec3, u32> = HashMap::new();
        let mut next = 3;
        for (k, &brick) in bricks.iter().enumerate() {
            let before = brick - IVec3::X;
            if (k == 0 || bricks[k - 1] != before) && !at.contains_key(&before) {
                at.insert(before, next);
                next += 1;
            }
            at.insert(brick, next);
            next += 1;
            if bricks.get(k + 1) != Some(&(brick + IVec3::X)) {
                at.insert(brick + IVec3::X, next);
                next += 1;
            }
        }
        let begin = |brick: IVec3| LANES as u32 * at.get(&brick).copied().unwrap_or(1);
        let number: HashMap<IVec3, u32> = (0..).zip(&bricks).map(|(k, &brick)| (brick, k)).collect();
        let mut of_brick = vec![[[0.0; LANES]; BONDS]; bricks.len()];
        let (mut places, mut lanes) = (Vec::new(), Vec::new());
        for (&cell, shares) in cells.iter().zip(shares) {
            let (brick, lane) = (brick_of(cell), lane_of(cell));
            places.push(begin(brick) + lane as u32);
            lanes.push(LANES as u32 * number[&brick] + lane as u32);
            let steps = row_offsets().into_iter().zip(STEPS);
            let steps = steps.flat_map(|(row, steps)| steps.iter().map(move |&dx| row + dx * IVec3::X));
            for (share, step) in of_brick[number[&brick] as usize].iter_mut().zip(steps) {
                share[lane] = shares.get(&step).copied().unwrap_or(0.0);
            }
        }
        let mut known: HashMap<Vec<u64>, u32> = HashMap::new();
        let mut distinct = Vec::new();
        let with_shares = |(&brick, shares): (&IVec3, [[f64; LANES]; BONDS])| Brick {
            around: row_offsets().map(|offset| begin(brick + offset)),
            shares: *known.entry(shares.iter().flatten().map(|share| share.to_bits()).collect()).or_insert_with(|| {
                distinct.push(shares);
                distinct.len() as u32 - 1
            }),
        };
        let bricks = bricks.iter().zip(of_brick).map(with_shares).collect();
        // One more, so that the last empty brick has one behind it, too.
        Self { length: LANES * (next as usize + 1), places, lanes, bricks, shares: distinct }
    }

    /// Damping over the rate of a brick's particles.
    #[inline(always)]
    fn sum<S: Simd>(&self, simd: S, along: &[Vec<f64>; 7], brick: &Brick) -> [[f64; LANES]; 3] {
        let least = f64x4::splat(simd, f64::MIN_POSITIVE);
        let half = f64x4::splat(simd, 0.5);
        let zero = f64x4::splat(simd, 0.0);
        let mut here = [zero; 7];
        for (here, along) in here.iter_mut().zip(along) {
            *here = beside(simd, window(along, brick.around[4]), 0);
        }
        let mut shares = self.shares[brick.shares as usize].iter();
        let mut sum = [zero; 3];
        for (&begin, steps) in brick.around.iter().zip(STEPS) {
            let [x, y, z, u, v, w, m] = along;
            let (x, y, z) = (window(x, begin), window(y, begin), window(z, begin));
            let (u, v, w, m) = (window(u, begin), window(v, begin), window(w, begin), window(m, begin));
            for (&dx, share) in steps.iter().zip(&mut shares) {
                let x = beside(simd, x, dx) - here[0];
                let y = beside(simd, y, dx) - here[1];
                let z = beside(simd, z, dx) - here[2];
                let u = beside(simd, u, dx) - here[3];
                let v = beside(simd, v, dx) - here[4];
                let w = beside(simd, w, dx) - here[5];
                let mass = half * (beside(simd, m, dx) + here[6]);
                let closing = w.mul_add(z, v.mul_add(y, u * x));
                // Two particles at one place, or two empty places, have no line between them: 0 / least is no force.
                let length_squared = z.mul_add(z, y.mul_add(y, x * x)) + least;
                let factor = f64x4::simd_from(simd, *share) * mass * closing / length_squared;
                sum[0] = x.mul_add(factor, sum[0]);
                sum[1] = y.mul_add(factor, sum[1]);
                sum[2] = z.mul_add(factor, sum[2]);
            }
        }
        [sum[0].into(), sum[1].into(), sum[2].into()]
    }

    #[inline(always)]
    fn sums<S: Simd>(&self, simd: S, along: &[Vec<f64>; 7], first: usize, sums: &mut [[[f64; LANES]; 3]]) {
        for (sum, brick) in sums.iter_mut().zip(&self.bricks[first..]) {
            *sum = self.sum(simd, along, brick);
        }
    }
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
    let at = (BRICK + dx) as usize;
    f64x4::from_slice(simd, &window[at..at + LANES])
}

impl Force for PairDamping {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let Self { rows, buffers, level, rate, .. } = self;
        buffers.fit(rows);
        let Buffers { along, sums } = &mut **buffers;
        let [x, y, z, u, v, w, m] = &mut *along;
        for (i, &place) in rows.places.iter().enumerate() {
            let place = place as usize;
            [x[place], y[place], z[place]] = state.positions[i].to_array();
            [u[place], v[place], w[place]] = state.velocities[i].to_array();
            m[place] = state.masses[i];
        }
        let along = &*along;
        let work = |(chunk, sums): (usize, &mut [[[f64; LANES]; 3]])| {
            dispatch!(*level, simd => rows.sums(simd, along, chunk * CHUNK, sums));
        };
        if state.len() < PARALLEL_FROM {
            sums.chunks_mut(CHUNK).enumerate().for_each(work);
        } else {
            sums.par_chunks_mut(CHUNK).enumerate().for_each(work);
        }
        for (force, &lane) in forces.iter_mut().zip(&rows.lanes) {
            let (brick, lane) = (lane as usize / LANES, lane as usize % LANES);
            let [x, y, z] = &sums[brick];
            *force += *rate * DVec3::new(x[lane], y[lane], z[lane]);
        }
    }

    fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}

    fn step_limit(&self, _state: &ParticleState) -> StepLimit {
        // Gershgorin: no row of the damping matrix sums to more than twice the particle's own entry.
        StepLimit { damping_rate: 2.0 * self.rate * self.greatest_share, ..StepLimit::default() }
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
