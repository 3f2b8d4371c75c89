//! Viscosity and plasticity of the matrix, beside its elastic force: only bodies that have them pay for them.
//!
//! *Plasticity.* A particle that has yielded by `e_p` (symmetric, trace-free, in the rotated frame) stores `(e - e_p) :
//! sigma(e - e_p) / 2`. Beside the elastic energy of e that is `-2 mu e : e_p + mu e_p : e_p`, whose stress is `-2 mu
//! e_p`. It does not lie along the stretch `S = R^T F`, so that R's own change takes part: `P = R (sigma + [k]x)`, `k =
//! (tr S I - S)^-1 vee(S sigma - sigma S)`. Without k a torque is left.
//!
//! *Viscosity.* The rate of stretch is `S' = R^T F' - [om]x S` with `om = (tr S I - S)^-1 vee(R^T F')`, F' by the
//! velocities: nothing of it is left in a body that turns as it stands, however it is strained. The same is done with
//! the residuals, or bending of few layers would hardly be damped: `r_ij = d'_ij - om_s x d_ij`, `om_s = R om`, at `tau
//! = eta / mu` times their elastic penalties a and beta. With dissipation `V s (eta |dev S'|² + eta_v / 2 tr(S')² +
//! ...)` the forces are its gradient by the velocities; its double is the power that is lost, never below zero.
//!
//! Of each particle its neighbours feel `t_ij = w_ij (Q X_ji + al (v_ji - om x x_ji) + Y)`, added to i and taken from
//! j.
//!
//! # What to know of it
//!
//! The zero-energy penalty is elastic and does not yield. It carries 51, 25 and 14 % of the bending of bars of 3, 5 and
//! 7 layers: in bending the spring-back is 1.3 to 1.7 times that of theory. Pulled, pressed and sheared, matter yields
//! as it should.

use super::elasticity::corotated_strain;
use super::flow_rule::{
    PlasticStrain, Plasticity, Viscosity, crossing, deviator, double_dot, turn_compliance, turning_part, vee,
};
use super::reference::ReferenceConfiguration;
use crate::solver::energy::Energies;
use crate::solver::forces::force::{Force, StepLimit};
use crate::solver::linear_algebra::lanczos::greatest_eigenvalue;
use crate::solver::neighbourhood::outer;
use crate::solver::rotation::nearest_rotation;
use crate::solver::scratch::Scratch;
use crate::solver::stable_step::starting_vector;
use crate::solver::state::ParticleState;
use glam::{DMat3, DQuat, DVec3};
use rayon::prelude::*;

/// Particles that a thread computes at a time.
const CHUNK: usize = 64;

/// What a matrix does that is not elastic.
#[derive(Clone)]
pub(crate) struct Inelastic {
    pub(super) reference: ReferenceConfiguration,
    pub(super) law: InelasticLaw,
    /// Rotation of every particle at the last evaluation.
    rotations: Vec<DQuat>,
    /// What has yielded at every particle; empty where nothing does.
    plastic: Vec<PlasticStrain>,
    /// Energy that was lost [J], up to a time [s] that is not known before the first evaluation.
    dissipated: f64,
    booked: Option<f64>,
    /// Power that viscosity took at the last evaluation [W].
    power: f64,
    buffers: Scratch<Vec<Felt>>,
}

/// How it is not elastic.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct InelasticLaw {
    pub(crate) viscosity: Option<Viscosity>,
    pub(crate) plasticity: Option<Plasticity>,
}

/// What neighbours feel of a particle.
#[derive(Clone, Copy, Debug, Default)]
struct Felt {
    q: DMat3,
    /// `al om`.
    turning: DVec3,
    y: DVec3,
    al: f64,
    /// Power that is lost there [W].
    power: f64,
}

impl Inelastic {
    /// Beside the elastic force of a matrix over the same `reference`, of a body that starts turned by `orientation`.
    pub(super) fn new(reference: ReferenceConfiguration, law: InelasticLaw, orientation: DQuat) -> Self {
        let n = reference.positions.len();
        Self {
            rotations: vec![orientation; n],
            plastic: if law.plasticity.is_some() { vec![PlasticStrain::default(); n] } else { Vec::new() },
            dissipated: 0.0,
            booked: None,
            power: 0.0,
            buffers: Scratch::default(),
            reference,
            law,
        }
    }

    /// Whether it may yield.
    pub(crate) fn yields(&self) -> bool {
        self.law.plasticity.is_some()
    }

    /// Greatest equivalent plastic strain of a particle.
    pub(crate) fn greatest_plastic_strain(&self) -> f64 {
        self.plastic.iter().map(|of| of.equivalent).fold(0.0, f64::max)
    }

    /// What of the strain of a particle has yielded, in the rotated frame.
    pub(super) fn plastic_strain(&self, i: usize) -> DMat3 {
        self.plastic.get(i).map_or(DMat3::ZERO, PlasticStrain::matrix)
    }

    /// Shear modulus [Pa] at a particle.
    fn mu(&self, i: usize) -> f64 {
        self.reference.elasticity.mu * self.reference.stiffening(i)
    }

    /// What neighbours feel of particle i.
    fn felt(&self, i: usize, rotation: &mut DQuat, state: &ParticleState) -> Felt {
        let ReferenceConfiguration { neighbourhood: rest, elasticity, volume, .. } = &self.reference;
        let (x, v) = (&state.positions, &state.velocities);
        let inverse = rest.inverse_moment[i];
        let (mut moment, mut rate) = (DMat3::ZERO, DMat3::ZERO);
        for (j, bond) in rest.bonds(i) {
            moment += outer(x[j] - x[i], bond.weighted_offset);
            rate += outer(v[j] - v[i], bond.weighted_offset);
        }
        let (f, rate) = (moment * inverse, rate * inverse);
        *rotation = nearest_rotation(f, *rotation);
        let r = DMat3::from_quat(*rotation);
        let g = r.transpose() * f;
        let stretch = 0.5 * (g + g.transpose());
        let compliance = turn_compliance(stretch);
        let volume_of_matrix = volume * self.reference.matrix_share(i);
        let mut sigma = DMat3::ZERO;
        if let Some(plastic) = self.plastic.get(i) {
            sigma -= 2.0 * self.mu(i) * plastic.matrix();
        }
        let Some(viscosity) = self.law.viscosity else {
            let p = r * (sigma + crossing(turning_part(stretch, sigma, compliance)));
            return Felt { q: volume_of_matrix * p * inverse, ..Felt::default() };
        };
        let turned = r.transpose() * rate;
        let om = compliance * vee(turned);
        let of_stretch = turned - crossing(om) * stretch;
        let of_stretch = 0.5 * (of_stretch + of_stretch.transpose());
        let viscous = viscosity.stress(of_stretch);
        sigma += viscous;
        // Residuals, their rates, and what of these is no turn.
        let om = r * om;
        let (mut sum, mut rate_sum, mut torque, mut square) = (DVec3::ZERO, DVec3::ZERO, DVec3::ZERO, 0.0);
        for ((j, bond), (_, offset)) in rest.bonds(i).zip(rest.offsets(i)) {
            let residual = x[j] - x[i] - f * offset;
            let slip = v[j] - v[i] - rate * offset - om.cross(residual);
            sum += bond.weight * residual;
            rate_sum += bond.weight * slip;
            torque += bond.weight * residual.cross(slip);
            square += bond.weight * slip.length_squared();
        }
        // The elastic penalties over mu, times eta.
        let [a, beta] = [elasticity.residual_penalty, elasticity.sum_penalty]
            .map(|penalty| viscosity.shear * penalty / elasticity.mu);
        let torque = a * torque + beta * sum.cross(rate_sum);
        let along = compliance * (r.transpose() * torque);
        let p = r * (sigma + crossing(turning_part(stretch, sigma, compliance)) - crossing(along));
        let al = volume_of_matrix * a;
        let y = volume_of_matrix * beta * rate_sum;
        let q = (volume_of_matrix * p - outer(y, rest.weighted_sum[i])) * inverse - al * (rate - crossing(om) * f);
        let power =
            volume_of_matrix * (double_dot(viscous, of_stretch) + a * square + beta * rate_sum.length_squared());
        Felt { q, turning: al * om, y, al, power }
    }

    /// Force on particle i [N].
    fn force(&self, i: usize, felt: &[Felt], state: &ParticleState) -> DVec3 {
        let rest = &self.reference.neighbourhood;
        let (x, v, own) = (&state.positions, &state.velocities, &felt[i]);
        let mut force = DVec3::ZERO;
        for (j, bond) in rest.bonds(i) {
            let other = &felt[j];
            let slip = (own.al + other.al) * (v[j] - v[i]) - (own.turning + other.turning).cross(x[j] - x[i]);
            force += (own.q + other.q) * bond.weighted_offset + bond.weight * (slip + own.y - other.y);
        }
        force
    }

    /// Strain of particle i in the rotated frame.
    fn strain(&self, i: usize, positions: &[DVec3]) -> DMat3 {
        let (f, _) = self.reference.deformation_gradient(i, positions);
        corotated_strain(f, DMat3::from_quat(nearest_rotation(f, self.rotations[i])))
    }

    /// Yields at every particle over `dt` [s]; the energy that is lost [J].
    fn yield_over(&mut self, law: &Plasticity, positions: &[DVec3], dt: f64) -> f64 {
        let this = &*self;
        let after: Vec<(PlasticStrain, f64)> = (0..positions.len())
            .into_par_iter()
            .with_min_len(CHUNK)
            .map(|i| {
                let mut plastic = this.plastic[i];
                let density = plastic.yields(this.strain(i, positions), this.mu(i), law, dt);
                (plastic, density * this.reference.volume * this.reference.matrix_share(i))
            })
            .collect();
        let lost = after.iter().map(|(_, lost)| lost).sum();
        self.plastic.iter_mut().zip(after).for_each(|(plastic, (now, _))| *plastic = now);
        lost
    }

    /// Equivalent stress [Pa] of what of the strain is elastic, at every particle.
    pub(crate) fn von_mises_stresses(&self, positions: &[DVec3]) -> Vec<f64> {
        let at = |i: usize| {
            let elastic = deviator(self.strain(i, positions)) - self.plastic_strain(i);
            3.0 * self.mu(i) * (double_dot(elastic, elastic) / 1.5).sqrt()
        };
        (0..positions.len()).into_par_iter().with_min_len(CHUNK).map(at).collect()
    }
}

impl Force for Inelastic {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        self.booked.get_or_insert(time);
        let mut felt = std::mem::take(&mut *self.buffers);
        let mut rotations = std::mem::take(&mut self.rotations);
        felt.resize(rotations.len(), Felt::default());
        let this = &*self;
        felt.par_iter_mut().zip(&mut rotations).enumerate().with_min_len(CHUNK).for_each(|(i, (felt, rotation))| {
            *felt = this.felt(i, rotation, state);
        });
        forces.par_iter_mut().enumerate().with_min_len(CHUNK).for_each(|(i, force)| {
            *force += this.force(i, &felt, state);
        });
        self.power = felt.iter().map(|felt| felt.power).sum();
        self.rotations = rotations;
        *self.buffers = felt;
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        if self.plastic.is_empty() {
            return;
        }
        let of = |i: usize| {
            let plastic = self.plastic[i].matrix();
            let density = double_dot(plastic, plastic) - 2.0 * double_dot(self.strain(i, &state.positions), plastic);
            self.mu(i) * density * self.reference.volume * self.reference.matrix_share(i)
        };
        let each: Vec<f64> = (0..state.len()).into_par_iter().with_min_len(CHUNK).map(of).collect();
        energies.matrix += each.iter().sum::<f64>();
    }

    fn is_internal(&self) -> bool {
        true
    }

    fn step_limit(&self, state: &ParticleState) -> StepLimit {
        if self.law.viscosity.is_none() {
            return StepLimit::default();
        }
        // Forces of viscosity are linear in the velocities, whatever has yielded.
        let mut probe = state.clone();
        let mut force = Self { plastic: Vec::new(), ..self.clone() };
        let damping = |w: &[DVec3]| {
            for ((velocity, w), mass) in probe.velocities.iter_mut().zip(w).zip(&probe.masses) {
                *velocity = *w / mass.sqrt();
            }
            let mut forces = vec![DVec3::ZERO; probe.masses.len()];
            force.add_forces(0.0, &probe, &mut forces);
            forces.iter().zip(&probe.masses).map(|(force, mass)| -*force / mass.sqrt()).collect()
        };
        let greatest = greatest_eigenvalue(starting_vector(state.len()), damping, &mut || false);
        let damping_rate = greatest.unwrap_or_default().max(0.0);
        StepLimit { damping_rate, ..StepLimit::default() }
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        let dt = time - self.booked.replace(time).unwrap_or(time);
        self.dissipated += self.power * dt;
        let Some(law) = self.law.plasticity else { return false };
        let lost = self.yield_over(&law, &state.positions, dt);
        self.dissipated += lost;
        lost > 0.0
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        self.booked = None;
        let Some(before) = before.iter().find_map(|force| force.downcast_ref::<Self>()) else { return };
        self.dissipated = before.dissipated;
        if self.plastic.len() == before.plastic.len() {
            self.plastic.clone_from(&before.plastic);
        }
    }

    fn dissipated(&self) -> f64 {
        self.dissipated
    }

    fn remembered(&self, number: &mut dyn FnMut(f64)) {
        for plastic in &self.plastic {
            let m = plastic.matrix();
            [m.x_axis.x, m.y_axis.y, m.z_axis.z, m.x_axis.y, m.y_axis.z, m.z_axis.x, plastic.equivalent]
                .into_iter()
                .for_each(&mut *number);
        }
    }

    fn name(&self) -> &'static str {
        "inelastic"
    }

    fn bytes(&self) -> usize {
        size_of_val(self) + size_of_val(&*self.rotations) + size_of_val(&*self.plastic)
    }

    fn changes_until(&self) -> f64 {
        // What creeps may go on when all else has come to rest.
        if self.law.plasticity.is_some_and(|law| law.creep_time > 0.0) { f64::INFINITY } else { 0.0 }
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
