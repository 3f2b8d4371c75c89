//! What the matrix loses where fibres get thicker, and has again where they get thinner (eq. 18).
//!
//! The energy of the matrix is in proportion to its share at every particle. So [`super::MatrixForce`] goes on with the
//! shares that there are where all drives are 0, as fast as ever, and the difference is a force of its own on the
//! particles around the fibres that change: `E = sum_i (s_i(t) - s_i(0)) V psi_i`, by pairs, with the same `psi_i`.
//!
//! What drives do to the shares is work: of a step half of what the change adds to the energy where the step began, and
//! half of what it adds where it ended.

use super::pair_list::CHUNK;
use super::partial::PartialMatrix;
use super::reference::ReferenceConfiguration;
use crate::solver::driven_fractions::DrivenFractions;
use crate::solver::energy::Energies;
use crate::solver::forces::force::Force;
use crate::solver::hand::Hand;
use crate::solver::state::ParticleState;
use glam::{DQuat, DVec3};
use rayon::prelude::*;
use std::sync::Arc;

/// The change of the matrix around fibres whose volume fraction is driven.
#[derive(Clone)]
pub(crate) struct MatrixThinning {
    reference: ReferenceConfiguration,
    fractions: Arc<DrivenFractions>,
    /// Fractions where all drives are 0, which the matrix force itself has.
    drawn: Arc<[f64]>,
    matrix: PartialMatrix,
    /// Work done up to the last booking [J].
    work: f64,
    booked: Option<Booked>,
}

/// What there was at the last booking.
#[derive(Clone)]
struct Booked {
    /// [s]
    time: f64,
    fractions: Vec<f64>,
    /// Energy of every particle's matrix where all of it is there [J].
    energies: Vec<f64>,
}

impl MatrixThinning {
    pub(super) fn new(reference: ReferenceConfiguration, fractions: DrivenFractions, orientation: DQuat) -> Self {
        Self {
            drawn: fractions.at(None).into(),
            matrix: PartialMatrix::new(&reference.neighbourhood, &fractions.particles, orientation),
            fractions: Arc::new(fractions),
            reference,
            work: 0.0,
            booked: None,
        }
    }

    /// How much more of the material is matrix than where all drives are 0, where these are the fractions of fibre; in
    /// shares of V, times the stiffening.
    fn gains(&self, fractions: &[f64]) -> Vec<f64> {
        let changes = self.fractions.particles.iter().zip(self.drawn.iter().zip(fractions));
        changes.map(|(&i, (drawn, fraction))| self.reference.weight(i as usize) * (drawn - fraction)).collect()
    }

    /// Energies [J] of the matrix of every particle, elastic and zero-energy, where all of it is there.
    fn whole_energies(&self, positions: &[DVec3]) -> Vec<(f64, f64)> {
        let of = |(&i, &rotation): (&u32, &DQuat)| {
            let (elastic, zero_energy) = self.reference.densities(i as usize, positions, rotation);
            (self.reference.volume * elastic, self.reference.volume * zero_energy)
        };
        self.fractions.particles.par_iter().zip(&self.matrix.rotations).with_min_len(CHUNK).map(of).collect()
    }

    fn now(&self, time: f64, positions: &[DVec3]) -> Booked {
        let energies = self.whole_energies(positions).into_iter().map(|(elastic, zero)| elastic + zero).collect();
        Booked { time, fractions: self.fractions.at(Some(time)), energies }
    }

    /// Fibre fractions at the end of the last step, put where they belong among those of all particles.
    pub(in crate::solver) fn put_fractions(&self, all: &mut [f64]) {
        let now = self.fractions.at(Some(self.booked.as_ref().map_or(0.0, |booked| booked.time)));
        for (&i, fraction) in self.fractions.particles.iter().zip(now) {
            all[i as usize] = fraction;
        }
    }
}

impl Force for MatrixThinning {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let positions = &state.positions;
        if self.booked.is_none() {
            self.booked = Some(self.now(time, positions));
        }
        let gains = self.gains(&self.fractions.at(Some(time)));
        self.matrix.add_forces(&self.reference, |place, _| gains[place], positions, forces);
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.activation -= self.work;
        let gains = self.gains(&self.fractions.at(Some(time)));
        for (gain, (elastic, zero_energy)) in gains.into_iter().zip(self.whole_energies(&state.positions)) {
            energies.matrix += gain * elastic;
            energies.zero_energy += gain * zero_energy;
        }
    }

    fn is_internal(&self) -> bool {
        true
    }

    fn couplings(&self) -> Vec<Vec<u32>> {
        // The matrix has told of them.
        Vec::new()
    }

    fn changes_until(&self) -> f64 {
        self.fractions.until()
    }

    fn driven_until(&self) -> f64 {
        self.changes_until()
    }

    fn drive_work(&self) -> f64 {
        self.work
    }

    fn give(&mut self, to: &str, led: Option<Hand>) {
        let mut fractions = (*self.fractions).clone();
        fractions.give(to, led);
        // A checkpoint of before keeps those that it has.
        if fractions != *self.fractions {
            self.fractions = Arc::new(fractions);
        }
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        let now = self.now(time, &state.positions);
        if let Some(before) = &self.booked {
            let energies = before.energies.iter().zip(&now.energies).map(|(was, is)| was + is);
            let gains = self.gains(&before.fractions).into_iter().zip(self.gains(&now.fractions));
            let work: f64 = gains.zip(energies).map(|((was, is), energy)| 0.5 * (is - was) * energy).sum();
            self.work += work;
        }
        self.booked = Some(now);
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        self.booked = None;
        self.work = before.iter().find_map(|force| force.downcast_ref::<Self>()).map_or(0.0, |before| before.work);
    }

    fn name(&self) -> &'static str {
        "thinning"
    }

    fn bytes(&self) -> usize {
        let booked = self.booked.as_ref().map_or(0, |of| size_of_val(&*of.fractions) + size_of_val(&*of.energies));
        size_of_val(self) + size_of_val(&*self.matrix.rotations) + booked
    }

    fn clone_at_extreme(&self, greatest: bool) -> Box<dyn Force> {
        Box::new(Self { fractions: Arc::new(self.fractions.at_extreme(greatest)), ..self.clone() })
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
