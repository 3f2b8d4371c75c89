//! Rest data of the matter, brick by brick, for the stencil.

use super::Matter;
use super::lanes::{LANES, Lanes};
use super::layout::{Layout, NONE};
use rayon::prelude::*;
use std::array::from_fn;
use std::collections::HashMap;

/// Rest data of a brick that many bricks share: along the stencil's axes, zero where no particle is.
#[derive(Clone, Copy, Default)]
pub(super) struct Rest {
    /// `A^-1`: 00, 01, 02, 11, 12, 22.
    pub(super) inverse: [Lanes; 6],
    /// `B` [1/m].
    pub(super) weighted_sum: [Lanes; 3],
    /// `sum w` [1/m²].
    pub(super) weight_sum: Lanes,
}

/// How much matrix there is in and around a brick's particles.
#[derive(Clone, Copy, Default)]
pub(super) struct Share {
    /// `s V` [m³].
    pub(super) volume: Lanes,
    /// `sum w_ij s_j V` [m].
    pub(super) around: Lanes,
}

/// Rest data of the bricks, each once, and which of them a brick has.
pub(super) fn rests(matter: &Matter, layout: &Layout) -> (Vec<Rest>, Vec<u32>) {
    let rest = &matter.neighbourhood;
    let axes = layout.axes;
    let mut known: HashMap<[u64; 10 * LANES], u32> = HashMap::new();
    let (mut rests, mut rest_of) = (Vec::new(), Vec::with_capacity(layout.particles.len()));
    for particles in &layout.particles {
        let mut numbers = [Lanes::default(); 10];
        for (lane, &i) in particles.iter().enumerate().filter(|(_, i)| **i != NONE) {
            let i = i as usize;
            let [x, y, z] = (axes.transpose() * rest.inverse_moment[i] * axes).to_cols_array_2d();
            let sum = axes.transpose() * rest.weighted_sum[i];
            let all = [x[0], y[0], z[0], y[1], z[1], z[2], sum.x, sum.y, sum.z, rest.weight_sum[i]];
            for (number, value) in numbers.iter_mut().zip(all) {
                number.0[lane] = value;
            }
        }
        let key = from_fn(|k| numbers[k / LANES].0[k % LANES].to_bits());
        rest_of.push(*known.entry(key).or_insert_with(|| {
            let [inverse @ .., b0, b1, b2, weight_sum] = numbers;
            rests.push(Rest { inverse, weighted_sum: [b0, b1, b2], weight_sum });
            rests.len() as u32 - 1
        }));
    }
    (rests, rest_of)
}

/// Shares of matrix of the bricks.
pub(super) fn shares(matter: &Matter, layout: &Layout) -> Vec<Share> {
    let of_brick = |particles: &[u32; LANES]| {
        let mut share = Share::default();
        for (lane, &i) in particles.iter().enumerate().filter(|(_, i)| **i != NONE) {
            let around = matter.neighbourhood.bonds(i as usize);
            let around: f64 = around.map(|(j, bond)| bond.weight * matter.share[j]).sum();
            share.volume.0[lane] = matter.volume * matter.share[i as usize];
            share.around.0[lane] = matter.volume * around;
        }
        share
    };
    layout.particles.par_iter().map(of_brick).collect()
}
