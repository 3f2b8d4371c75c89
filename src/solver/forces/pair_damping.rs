//! Radial damping between neighbours: takes energy, keeps linear and angular momentum.

use super::{Force, StepLimit};
use crate::solver::energy::Energies;
use crate::solver::neighbourhood::Neighbourhood;
use crate::solver::state::ParticleState;
use glam::DVec3;
use rayon::prelude::*;
use std::sync::Arc;

/// `f = g m om_ij (dv . n) n` on both ends of every near bond, equal and opposite along the line between them.
#[derive(Clone)]
pub struct PairDamping {
    rate: f64,
    starts: Arc<[u32]>,
    /// Neighbour and its share om_ij = om_ji of the pair.
    bonds: Arc<[(u32, f64)]>,
    greatest_share: f64,
}

/// Bonds longer than this many spacings are left out: on a lattice 18 remain, which damp as well as all.
const REACH: f64 = 1.5;

impl PairDamping {
    /// Damping at `rate` g [1/s] over the bonds of up to 1.5 `spacing` [m].
    pub fn new(rate: f64, neighbourhood: &Neighbourhood, spacing: f64) -> Self {
        let near = |i: usize| {
            neighbourhood
                .bonds(i)
                .zip(neighbourhood.offsets(i))
                .filter(move |(_, (_, offset))| offset.length() <= REACH * spacing)
                .map(|((j, bond), _)| (j, bond.weight))
        };
        let n = neighbourhood.len();
        let sums: Vec<f64> = (0..n).map(|i| near(i).map(|(_, weight)| weight).sum()).collect();
        let mut starts = vec![0];
        let mut bonds = Vec::new();
        let mut greatest_share: f64 = 0.0;
        for i in 0..n {
            let mut total = 0.0;
            for (j, weight) in near(i) {
                // The mean of both ends' shares, so that the pair agrees on it.
                let share = 0.5 * weight * (1.0 / sums[i] + 1.0 / sums[j]);
                total += share;
                bonds.push((j as u32, share));
            }
            greatest_share = greatest_share.max(total);
            starts.push(bonds.len() as u32);
        }
        Self { rate, starts: starts.into(), bonds: bonds.into(), greatest_share }
    }
}

impl Force for PairDamping {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let ParticleState { positions, velocities, masses } = state;
        forces.par_iter_mut().with_min_len(1024).enumerate().for_each(|(i, force)| {
            let range = self.starts[i] as usize..self.starts[i + 1] as usize;
            let mut sum = DVec3::ZERO;
            for &(j, share) in &self.bonds[range] {
                let j = j as usize;
                let x = positions[j] - positions[i];
                let mass = 0.5 * (masses[i] + masses[j]);
                let length_squared = x.length_squared();
                if length_squared > 0.0 {
                    sum += x * (share * mass * (velocities[j] - velocities[i]).dot(x) / length_squared);
                }
            }
            *force += self.rate * sum;
        });
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
