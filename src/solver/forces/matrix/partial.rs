//! The matrix at some particles alone, pair by pair, and not at the others.

use super::mean_rotation::mean_rotation;
use super::pair_list::{CHUNK, PairListPasses, ParticleStress};
use super::reference::ReferenceConfiguration;
use crate::solver::neighbourhood::Neighbourhood;
use crate::solver::scratch::Scratch;
use fearless_simd::{Level, dispatch};
use glam::{DMat3, DQuat, DVec3};
use rayon::prelude::*;
use std::sync::Arc;

/// Particles at which the matrix is computed, and those that feel them.
#[derive(Clone)]
pub(super) struct PartialMatrix {
    /// In ascending order.
    particles: Arc<[u32]>,
    felt: Arc<[Receiver]>,
    /// Last rotations of the particles, the warm starts of the next.
    pub(super) rotations: Vec<DQuat>,
    level: Level,
    buffers: Scratch<Buffers>,
}

/// A particle that feels some of those.
struct Receiver {
    particle: u32,
    /// Its own place among them, if it is one.
    own: Option<u32>,
    /// Their places, each with that of the bond from there to here in its list.
    from: Vec<(u32, u32)>,
}

#[derive(Default)]
struct Buffers {
    deviations: Vec<[f64; 4]>,
    stresses: Vec<(ParticleStress, DVec3)>,
    forces: Vec<DVec3>,
}

impl PartialMatrix {
    /// That of some particles, of a body that starts turned by `orientation`.
    pub(super) fn new(neighbourhood: &Neighbourhood, particles: &[u32], orientation: DQuat) -> Self {
        let mut felt: Vec<Receiver> = Vec::new();
        let mut index: Vec<Option<u32>> = vec![None; neighbourhood.len()];
        let mut receiver = |felt: &mut Vec<Receiver>, particle: u32| {
            *index[particle as usize].get_or_insert_with(|| {
                felt.push(Receiver { particle, own: None, from: Vec::new() });
                felt.len() as u32 - 1
            }) as usize
        };
        for (place, &i) in (0..).zip(particles) {
            let own = receiver(&mut felt, i);
            felt[own].own = Some(place);
            for (bond, (j, _)) in neighbourhood.range(i as usize).zip(neighbourhood.bonds(i as usize)) {
                let other = receiver(&mut felt, j as u32);
                felt[other].from.push((place, bond as u32));
            }
        }
        Self {
            particles: particles.into(),
            felt: felt.into(),
            rotations: vec![orientation; particles.len()],
            level: Level::new(),
            buffers: Scratch::default(),
        }
    }

    /// The particles, in ascending order.
    pub(super) fn particles(&self) -> &[u32] {
        &self.particles
    }

    /// Their forces [N], where each counts by the matrix weight of its place and number. `reference` has the bonds that
    /// there were at first, whatever they weigh by now.
    pub(super) fn add_forces(
        &mut self,
        reference: &ReferenceConfiguration,
        weight: impl Fn(usize, u32) -> f64 + Sync,
        positions: &[DVec3],
        forces: &mut [DVec3],
    ) {
        let Self { particles, felt, rotations, level, buffers } = self;
        let Buffers { deviations, stresses, forces: sums } = &mut **buffers;
        let body_turn = DMat3::from_quat(mean_rotation(rotations.iter().copied()));
        deviations.resize(positions.len(), [0.0; 4]);
        let rest = &reference.positions;
        for i in felt.iter().map(|of| of.particle as usize) {
            // Differences to particle 0 first: they are exact far from the origin, too.
            let u = (positions[i] - positions[0]) - body_turn * (rest[i] - rest[0]);
            deviations[i] = [u.x, u.y, u.z, 0.0];
        }
        let passes = PairListPasses { reference, body_turn, deviations };
        let level = *level;
        let stress_of = |(place, (&i, rotation)): (usize, (&u32, &mut DQuat))| {
            let weight = weight(place, i);
            dispatch!(level, simd => passes.stress(simd, i as usize, weight, rotation))
        };
        let each = particles.par_iter().zip(rotations.par_iter_mut()).enumerate().with_min_len(CHUNK);
        each.map(stress_of).collect_into_vec(stresses);
        let on = |of: &Receiver| {
            let here = passes.deviation(of.particle as usize);
            let own = of.own.map_or(DVec3::ZERO, |place| stresses[place as usize].1);
            of.from.iter().fold(own, |sum, &(place, bond)| {
                let there = passes.deviation(particles[place as usize] as usize);
                let bond = reference.neighbourhood.bond(bond as usize);
                sum - stresses[place as usize].0.pull(bond.weight, bond.weighted_offset, here - there)
            })
        };
        felt.par_iter().with_min_len(CHUNK).map(on).collect_into_vec(sums);
        for (of, sum) in felt.iter().zip(sums) {
            forces[of.particle as usize] += *sum;
        }
    }
}
