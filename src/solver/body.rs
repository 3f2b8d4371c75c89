//! One body: a [`ParticleState`] with a list of forces, the grabs at its end, and an integrator that steps it.

mod apart;
pub(super) mod checkpoint;
mod colliders;
mod divergence;
mod given;
mod giving;
mod grabs;
mod guard;
mod hands;
mod parts;
mod rest;
mod tearing;
mod touching;

pub use divergence::Divergence;
pub use parts::{BodyParts, ElementLines, FibreLine, RestScale, SheetSurface, SurfacePoint};

use given::Given;

use super::dynamics::{Dynamics, Fallbacks, energies};
use super::eased_overlap::EasedOverlap;
use super::energy::Energies;
use super::forces::fibre::breaking::FibreBreak;
use super::forces::{Contact, Force, Grab, Inelastic, Plane};
use super::integrators::Integrator;
use super::scratch::Scratch;
use super::shared_drive::SharedDrive;
use super::skin::TornSkin;
use super::state::ParticleState;
use glam::DVec3;

/// The contact with the room among some forces.
fn room_contact(forces: &[Box<dyn Force>]) -> Option<&Contact> {
    forces.iter().find_map(|force| force.downcast_ref())
}

/// One body of a world.
#[derive(Clone)]
pub struct Body {
    parts: BodyParts,
    grabs: Vec<Grab>,
    /// Forces from other bodies and panels [N], the same over an outer step.
    external_forces: Vec<DVec3>,
    /// Elastic energy of contacts with other bodies and panels [J].
    contact_energy: f64,
    /// Force with which it pushes up each panel [N], of the last outer step.
    panel_pushes: Vec<f64>,
    net: Vec<DVec3>,
    current: bool,
    guarded: bool,
    /// Whether a program has added a force of its own.
    has_own_forces: bool,
    given: Given,
    steps: u64,
    evaluations: u64,
    fallbacks: Fallbacks,
    last_good: ParticleState,
    /// Where the particles were when the outer step began [m], of a body that meets others by its surface.
    began: Scratch<Vec<DVec3>>,
    divergence: Option<Divergence>,
    shared: Vec<SharedDrive>,
    /// The skin where seams are torn; none while all are whole.
    torn_skin: Option<TornSkin>,
}

impl Body {
    /// A body at the start.
    pub(crate) fn new(parts: BodyParts) -> Self {
        let n = parts.state.len();
        let mut body = Self {
            grabs: Vec::new(),
            external_forces: vec![DVec3::ZERO; n],
            contact_energy: 0.0,
            panel_pushes: Vec::new(),
            net: Vec::new(),
            current: false,
            guarded: true,
            has_own_forces: false,
            given: Given::default(),
            steps: 0,
            evaluations: 0,
            fallbacks: Fallbacks::default(),
            last_good: parts.state.clone(),
            began: Scratch::default(),
            divergence: None,
            shared: Vec::new(),
            torn_skin: None,
            parts,
        };
        body.update_net_forces(0.0);
        body
    }

    /// What it was put together from, with the present state.
    pub fn parts(&self) -> &BodyParts {
        &self.parts
    }

    /// Present state of the particles.
    pub fn state(&self) -> &ParticleState {
        &self.parts.state
    }

    /// Steps it from now on by `integrator`. The time step stays as it was chosen for the one before.
    pub fn set_integrator(&mut self, integrator: Box<dyn Integrator>) {
        self.parts.integrator = integrator;
        (self.parts.integrator_word, self.parts.integrator_reason) = ("other", None);
    }

    /// Steps it by `dt` [s] from now on, where `stable_dt` [s] is the greatest step that its integrator takes.
    pub(crate) fn set_step(&mut self, dt: f64, stable_dt: f64) {
        (self.parts.dt, self.parts.stable_dt, self.parts.limited_by) = (dt, stable_dt, None);
    }

    /// Adds a force. What it asks of the time step is not looked at: the step was chosen when the scene was baked. The
    /// balance of energy and work is no longer watched, as nothing is known of what the force gives.
    pub fn add_force(&mut self, force: Box<dyn Force>) {
        self.parts.forces.push(force);
        self.has_own_forces = true;
        self.current = false;
    }

    /// Whether a body is stopped as soon as a particle moves by more than its reach in a step, as it is unless told
    /// otherwise. Without that it is stopped only where the motion is no number or a force has no meaning.
    pub(crate) fn set_guarded(&mut self, guarded: bool) {
        self.guarded = guarded;
    }

    /// Gives the whole body an impulse [N s], shared by mass; what is pinned takes none of it.
    pub fn strike(&mut self, impulse: DVec3) {
        if self.divergence.is_some() {
            return;
        }
        self.given.by_hand += self.change_velocities(vec![impulse / self.parts.state.mass(); self.parts.state.len()]);
        self.current = false;
    }

    /// Takes over the motion of `other`, the same body before an edit, at a time [s], with what has broken in it; false
    /// if the two do not have the same particles. What is newly pinned is held where it is.
    pub(super) fn adopt(&mut self, other: &Self, time: f64) -> bool {
        if self.parts.rest != other.parts.rest || other.divergence.is_some() {
            return false;
        }
        self.parts.state.positions.clone_from(&other.parts.state.positions);
        self.parts.state.velocities.clone_from(&other.parts.state.velocities);
        self.grabs.clone_from(&other.grabs);
        self.given = other.given;
        self.adopt_hands(other);
        for force in &mut self.parts.forces {
            force.adopt(&other.parts.forces);
        }
        for constraint in &mut self.parts.constraints {
            constraint.take_hold(&other.parts.constraints, time, &other.parts.state);
        }
        self.steps = other.steps;
        self.evaluations = other.evaluations;
        self.fallbacks = other.fallbacks;
        self.current = false;
        self.see_tears();
        true
    }

    /// Starts in a world whose time is not zero: nothing that was found at time zero holds.
    pub(super) fn start_late(&mut self) {
        for force in &mut self.parts.forces {
            force.adopt(&[]);
        }
        self.current = false;
    }

    /// The work that its drives have done on it so far [J].
    pub(super) fn drive_work(&self) -> f64 {
        self.parts.forces.iter().map(|force| force.drive_work()).sum()
    }

    /// Energy that its forces say they have lost for good so far, to yielding, viscosity and tearing [J].
    pub fn dissipated(&self) -> f64 {
        self.parts.forces.iter().map(|force| force.dissipated()).sum()
    }

    /// Greatest equivalent plastic strain of its matrix.
    pub(super) fn plastic_strain(&self) -> f64 {
        let matrices = self.parts.forces.iter().filter_map(|force| force.downcast_ref::<Inelastic>());
        matrices.map(Inelastic::greatest_plastic_strain).fold(0.0, f64::max)
    }

    /// The planes of the room that it touches.
    pub(super) fn planes(&self) -> &[Plane] {
        room_contact(&self.parts.forces).map_or(&[], |contact| &contact.planes)
    }

    /// How it is eased out of a plane of the room, if it is.
    pub(super) fn easing(&self, plane: usize) -> Option<&EasedOverlap> {
        room_contact(&self.parts.forces)?.easing(plane)
    }

    /// Eases it out of planes of the room, by their index, from a time [s].
    pub(super) fn ease_out(&mut self, eased: &[(usize, EasedOverlap)], time: f64) {
        let contacts = self.parts.forces.iter_mut().filter_map(|force| force.downcast_mut::<Contact>());
        for contact in contacts {
            if contact.eased[..] != *eased {
                contact.eased = eased.to_vec();
                self.current = false;
            }
        }
        self.update_net_forces(time);
    }

    /// Time steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Force evaluations made.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// How often implicit steps were halved or handed to leap-frog.
    pub fn fallbacks(&self) -> Fallbacks {
        self.fallbacks
    }

    /// Breaks of its fibres, those of one force in the order of time.
    pub fn breaks(&self) -> impl Iterator<Item = &FibreBreak> {
        self.parts.forces.iter().flat_map(|force| force.breaks())
    }

    /// Why the body was stopped, if it was.
    pub fn divergence(&self) -> Option<&Divergence> {
        self.divergence.as_ref()
    }

    /// Net force on every particle [N], what other bodies add included, before constraints take their part.
    pub fn net_force(&self, i: usize) -> DVec3 {
        self.net[i] + self.external_forces[i]
    }

    /// Force of other bodies and panels on a particle [N].
    pub(super) fn external_force(&self, i: usize) -> DVec3 {
        self.external_forces[i]
    }

    /// Forgets what other bodies and panels do to it, before that is found anew.
    pub(super) fn clear_external_forces(&mut self) {
        self.external_forces.fill(DVec3::ZERO);
        self.contact_energy = 0.0;
        self.panel_pushes.clear();
    }

    /// Adds a force [N] of another body or panel on a particle, to act over the present outer step.
    pub(super) fn add_external_force(&mut self, i: usize, force: DVec3) {
        self.external_forces[i] += force;
    }

    /// Adds the body's share of the energy [J] of a contact with another body or panel.
    pub(super) fn add_contact_energy(&mut self, energy: f64) {
        self.contact_energy += energy;
    }

    /// Whether the net forces are those of the present state.
    pub(super) fn is_current(&self) -> bool {
        self.current
    }

    /// Gives the forces from other bodies as an impulse over `dt` [s].
    pub(super) fn kick(&mut self, dt: f64) {
        if self.divergence.is_some() || self.external_forces.iter().all(|force| *force == DVec3::ZERO) {
            return;
        }
        let masses = &self.parts.state.masses;
        let change = self.external_forces.iter().zip(masses).map(|(&force, &mass)| force * (dt / mass)).collect();
        self.given.by_others += self.change_velocities(change);
    }

    /// Takes note of where the particles are as an outer step begins.
    pub(super) fn begin_outer_step(&mut self) {
        if self.parts.contact_surface.is_some() {
            Vec::clone_from(&mut self.began, &self.parts.state.positions);
        }
    }

    /// How far a particle has moved since then [m].
    pub(super) fn moved(&self, i: usize) -> DVec3 {
        self.began.get(i).map_or(DVec3::ZERO, |&began| self.parts.state.positions[i] - began)
    }

    /// Remembers the present state as good.
    pub(super) fn save_last_good(&mut self) {
        if self.divergence.is_none() {
            self.last_good.clone_from(&self.parts.state);
        }
    }

    /// Takes `count` steps from `time` [s]; `after_step` sees the body after each, and the time [s]. False where
    /// `stop`, asked before each, ended it.
    pub(super) fn advance(
        &mut self,
        time: f64,
        count: u32,
        stop: &dyn Fn() -> bool,
        after_step: &mut dyn FnMut(&Self, f64),
    ) -> bool {
        for k in 0..count {
            if self.divergence.is_some() {
                return true;
            }
            if stop() {
                return false;
            }
            let dt = self.parts.dt;
            let start = time + f64::from(k) * dt;
            self.begin_at_colliders(start);
            let (mut dynamics, state, integrator) = self.dynamics();
            integrator.step(&mut dynamics, state, start, dt);
            let end = start + dt;
            let BodyParts { forces, layers, state, .. } = &mut self.parts;
            let granted = |plane: usize| room_contact(forces)?.easing(plane).map(|easing| easing.at(end).0);
            let granted = |plane| granted(plane).unwrap_or(0.0);
            if layers.as_ref().is_some_and(|layers| layers.put_back(state, granted)) {
                self.current = false;
            }
            self.put_back_from_colliders(end);
            for force in &mut self.parts.forces {
                if force.end_step(end, &self.parts.state) {
                    self.current = false;
                }
            }
            self.steps += 1;
            self.guard(end);
            after_step(self, end);
        }
        true
    }

    /// What an integrator sees of the body, the state that it steps, and the integrator.
    fn dynamics(&mut self) -> (Dynamics<'_>, &mut ParticleState, &mut dyn Integrator) {
        let parts = &mut self.parts;
        let dynamics = Dynamics {
            forces: &mut parts.forces,
            constraints: &parts.constraints,
            grabs: &mut self.grabs,
            net: &mut self.net,
            current: &mut self.current,
            evaluations: &mut self.evaluations,
            fallbacks: &mut self.fallbacks,
            rest: &parts.rest,
            reach: parts.reach,
            explicit_dt: parts.explicit_dt,
            rest_force: parts.rest_scale.force,
        };
        (dynamics, &mut parts.state, &mut *parts.integrator)
    }

    /// Makes the net forces those of the present state, so that reactions can be read.
    pub(super) fn update_net_forces(&mut self, time: f64) {
        if self.current || self.divergence.is_some() {
            return;
        }
        let (mut dynamics, state, _) = self.dynamics();
        dynamics.evaluate_end(time, state);
    }

    /// Energies of the present state.
    pub fn energies(&self, time: f64) -> Energies {
        let mut energies = energies(&self.parts.forces, &self.grabs, time, &self.parts.state);
        energies.contact += self.contact_energy;
        energies
    }
}
