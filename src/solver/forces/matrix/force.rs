//! The force itself, evaluated in one of several ways.

use super::elasticity::Elasticity;
use super::evaluation::{Evaluation, EvaluationKind};
use super::inelastic::{Inelastic, InelasticLaw};
use super::pair_list::PairList;
use super::reference::ReferenceConfiguration;
use super::seams::{SeamBonds, SeamTear, Seams};
use super::stencil;
use super::thinning::MatrixThinning;
use crate::solver::driven_fractions::DrivenFractions;
use crate::solver::energy::Energies;
use crate::solver::forces::force::Force;
use crate::solver::neighbourhood::Neighbourhood;
use crate::solver::state::ParticleState;
use crate::solver::wide::{Lanes4, Short8};
use glam::{DMat3, DQuat, DVec3};
use rayon::prelude::*;
use std::sync::Arc;

/// Particles that a thread computes at a time, where each is taken by itself.
pub(super) const CHUNK: usize = 128;

/// A number of every particle.
type OfEach = Arc<[f64]>;

/// Elastic force of the matrix.
#[derive(Clone)]
pub struct MatrixForce {
    pub(super) reference: ReferenceConfiguration,
    evaluation: Box<dyn Evaluation>,
    seams: Option<Box<Parted>>,
}

/// A matrix with seams, in two parts.
#[derive(Clone)]
struct Parted {
    /// What is beside them.
    beside: Seams,
    /// All else, which the evaluation computes.
    others: ReferenceConfiguration,
}

impl MatrixForce {
    /// Elastic force over rest neighbourhoods of particles at `rest` [m] (model frame); `volume` is a particle's [m³],
    /// `matrix_fraction` the part of the material at every particle that is matrix, `orientation` the turn of the model
    /// frame in the world at the start.
    pub fn new(
        neighbourhood: Arc<Neighbourhood>,
        rest: Arc<[DVec3]>,
        elasticity: Elasticity,
        volume: f64,
        matrix_fraction: Arc<[f64]>,
        orientation: DQuat,
    ) -> Self {
        Self::varied(neighbourhood, rest, elasticity, volume, (matrix_fraction, None, None), orientation)
    }

    /// [`Self::new`] over a material that is stiffer by a factor at every particle, each of which counts as a share of
    /// the volume.
    pub(crate) fn varied(
        neighbourhood: Arc<Neighbourhood>,
        rest: Arc<[DVec3]>,
        elasticity: Elasticity,
        volume: f64,
        (matrix_fraction, stiffening, volume_shares): (OfEach, Option<OfEach>, Option<OfEach>),
        orientation: DQuat,
    ) -> Self {
        // The energy is in proportion to all three.
        let times = |all: Arc<[f64]>, by: &Option<Arc<[f64]>>| match by {
            None => all,
            Some(by) => all.iter().zip(by.iter()).map(|(share, by)| share * by).collect(),
        };
        let matrix_weight = times(times(matrix_fraction, &stiffening), &volume_shares);
        let positions = rest;
        Self::of(
            ReferenceConfiguration {
                neighbourhood,
                positions,
                elasticity,
                volume,
                matrix_weight,
                stiffening,
                volume_shares,
            },
            orientation,
        )
    }

    fn of(reference: ReferenceConfiguration, orientation: DQuat) -> Self {
        let evaluation = stencil::evaluation::<Lanes4>(&reference, orientation)
            .unwrap_or_else(|| Box::new(PairList::new(vec![orientation; reference.positions.len()])));
        Self { reference, evaluation, seams: None }
    }

    /// The same force in f32, on deviations from the body's rigid motion: up to 1.7 times as fast, and exact to some
    /// 1e-6 of the greatest force. For a force that has just been made; one without a stencil stays as it is.
    #[must_use]
    pub fn fast(self) -> Self {
        let orientation = if self.reference.positions.is_empty() { DQuat::IDENTITY } else { self.rotation(0) };
        match stencil::evaluation::<Short8>(&self.reference, orientation) {
            Some(evaluation) => Self { evaluation, ..self },
            None => self,
        }
    }

    /// The same force, computed from the pair list: slower, for comparison.
    #[must_use]
    pub fn with_pair_list(self) -> Self {
        let rotations = (0..self.reference.positions.len()).map(|i| self.rotation(i)).collect();
        Self { evaluation: Box::new(PairList::new(rotations)), ..self }
    }

    /// The same force, exact, which comes apart along seams; of a body that starts turned by `orientation`.
    #[must_use]
    pub(crate) fn with_seams(self, seams: Vec<SeamBonds>, orientation: DQuat) -> Self {
        if seams.iter().all(|seam| seam.pairs.is_empty()) {
            return self;
        }
        let beside = Seams::new(&self.reference, seams, orientation);
        let others = beside.others(&self.reference);
        let Self { evaluation, .. } = Self::of(others.clone(), orientation);
        Self { evaluation, seams: Some(Box::new(Parted { beside, others })), ..self }
    }

    /// What has become of each of its seams.
    pub(crate) fn tears(&self) -> &[SeamTear] {
        self.seams.as_ref().map_or(&[], |seams| seams.beside.tears())
    }

    /// Which bonds across its seams are torn, seam after seam as they were given.
    pub(in crate::solver) fn torn(&self) -> &[bool] {
        self.seams.as_ref().map_or(&[], |seams| seams.beside.torn())
    }

    /// What goes on in the same matrix that is not elastic, of a body that starts turned by `orientation`.
    pub(crate) fn inelastic(&self, law: InelasticLaw, orientation: DQuat) -> Inelastic {
        Inelastic::new(self.reference.clone(), law, orientation)
    }

    /// What fibres of driven volume fractions do to the same matrix, of a body that starts turned by `orientation`.
    pub(crate) fn thinning(&self, fractions: DrivenFractions, orientation: DQuat) -> MatrixThinning {
        MatrixThinning::new(self.reference.clone(), fractions, orientation)
    }

    /// Fibre fraction `l_i` of every particle.
    pub fn fibre_fractions(&self) -> Vec<f64> {
        let of = |i: usize| 1.0 - self.reference.matrix_share(i) / self.reference.volume_share(i);
        (0..self.reference.positions.len()).map(of).collect()
    }

    /// Volume of a particle within at rest [m³]; one at the surface stands for a share of it.
    pub(crate) fn particle_volume(&self) -> f64 {
        self.reference.volume
    }

    /// Volume that every particle counts as [m³].
    pub fn volumes(&self) -> Vec<f64> {
        let of = |i: usize| self.reference.volume * self.reference.volume_share(i);
        (0..self.reference.positions.len()).map(of).collect()
    }

    /// Memory of the rest data, which copies share [bytes].
    pub(in crate::solver) fn shared_bytes(&self) -> usize {
        let ReferenceConfiguration { neighbourhood, positions, matrix_weight, .. } = &self.reference;
        neighbourhood.bytes() + size_of_val(&**positions) + size_of_val(&**matrix_weight)
    }

    /// Whether it is computed by a stencil, not from the pair list.
    pub fn is_stencil(&self) -> bool {
        self.evaluation() != EvaluationKind::PairList
    }

    /// The way in which it is computed.
    pub fn evaluation(&self) -> EvaluationKind {
        self.evaluation.kind()
    }

    /// Rotation of particle i at the last evaluation.
    pub(in crate::solver) fn rotation(&self, i: usize) -> DQuat {
        let beside = self.seams.as_ref().and_then(|seams| seams.beside.rotation(i));
        beside.unwrap_or_else(|| self.evaluation.rotation(i))
    }

    /// Deformation gradient F of particle i.
    pub(super) fn deformation_gradient(&self, i: usize, positions: &[DVec3]) -> DMat3 {
        let beside = self.seams.as_ref().and_then(|seams| seams.beside.reference_of(i));
        beside.unwrap_or(&self.reference).deformation_gradient(i, positions).0
    }

    /// Elastic and zero-energy energy of particle i [J].
    fn energy(&self, i: usize, positions: &[DVec3]) -> (f64, f64) {
        let beside = self.seams.as_ref().and_then(|seams| seams.beside.energy(i, positions));
        beside.unwrap_or_else(|| self.reference.energy(i, positions, self.evaluation.rotation(i)))
    }
}

impl Force for MatrixForce {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        match &mut self.seams {
            None => self.evaluation.add_forces(&self.reference, state, forces),
            Some(seams) => {
                let Parted { beside, others } = &mut **seams;
                self.evaluation.add_forces(others, state, forces);
                beside.add_forces(&state.positions, forces);
            }
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        // Collected in order, then summed in order: the same bits on any number of threads.
        let each: Vec<(f64, f64)> =
            (0..state.len()).into_par_iter().with_min_len(CHUNK).map(|i| self.energy(i, &state.positions)).collect();
        for (matrix, zero_energy) in each {
            energies.matrix += matrix;
            energies.zero_energy += zero_energy;
        }
    }

    fn is_internal(&self) -> bool {
        true
    }

    fn couplings(&self) -> Vec<Vec<u32>> {
        // The energy at a particle hangs on its neighbours, and so do they on each other.
        let neighbourhood = &self.reference.neighbourhood;
        let around = |i: usize| neighbourhood.bonds(i).map(|(j, _)| j as u32).chain([i as u32]).collect();
        (0..neighbourhood.len()).map(around).collect()
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        self.seams.as_mut().is_some_and(|seams| seams.beside.end_step(time, state))
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        let before = before.iter().find_map(|force| force.downcast_ref::<Self>());
        let before = before.and_then(|before| before.seams.as_ref());
        if let (Some(now), Some(before)) = (&mut self.seams, before) {
            now.beside.adopt(&before.beside);
        }
    }

    fn dissipated(&self) -> f64 {
        self.seams.as_ref().map_or(0.0, |seams| seams.beside.released)
    }

    fn remembered(&self, number: &mut dyn FnMut(f64)) {
        let torn = self.torn().iter().enumerate().filter(|(_, torn)| **torn);
        torn.for_each(|(bond, _)| number(bond as f64));
    }

    fn name(&self) -> &'static str {
        "matrix"
    }

    fn bytes(&self) -> usize {
        let beside = self.seams.as_ref().map_or(0, |seams| seams.beside.bytes());
        size_of_val(self) + self.evaluation.bytes() + beside
    }

    fn clone_at_extreme(&self, greatest: bool) -> Box<dyn Force> {
        let mut copy = self.clone();
        if let Some(seams) = copy.seams.as_mut().filter(|_| !greatest) {
            seams.beside = seams.beside.all_torn();
        }
        Box::new(copy)
    }

    fn changes_until(&self) -> f64 {
        0.0
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
