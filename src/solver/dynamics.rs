//! What an integrator sees of a body: forces in, accelerations out.

use super::constraint::{Constraint, held};
use super::energy::Energies;
use super::forces::{AirDrag, ColliderContact, Contact, FibreForce, Force, Grab, Gravity, MatrixForce};
use super::linear_algebra::vectors::axpy;
use super::state::ParticleState;
use glam::{BVec3, DMat3, DVec3};

/// How often implicit steps were not what was asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fallbacks {
    /// Steps that were taken in two halves, since no solution was found for the whole.
    pub halved: u64,
    /// Steps, whole or halved, that leap-frog took over.
    pub handed_over: u64,
}

/// The forces and constraints of one body during one step. The grabs are forces like those of the body's list, and come
/// after them.
///
/// The forces of the last evaluation are kept; where an integrator says that they belong to the end of its step, the
/// next step starts from them without evaluating again.
pub struct Dynamics<'a> {
    pub(super) forces: &'a mut [Box<dyn Force>],
    pub(super) constraints: &'a [Constraint],
    pub(super) grabs: &'a mut [Grab],
    pub(super) net: &'a mut Vec<DVec3>,
    pub(super) current: &'a mut bool,
    pub(super) evaluations: &'a mut u64,
    pub(super) fallbacks: &'a mut Fallbacks,
    /// Where the particles are at rest [m], world.
    pub(super) rest: &'a [DVec3],
    /// A length of the particles' neighbourhood [m].
    pub(super) reach: f64,
    /// Greatest stable step of leap-frog [s].
    pub(super) explicit_dt: f64,
    /// Net force on a particle below which it counts as at rest [N].
    pub(super) rest_force: f64,
}

impl Dynamics<'_> {
    /// Makes the forces at the start of a step available, evaluating them only if the last step did not leave them.
    pub fn start(&mut self, time: f64, state: &mut ParticleState) {
        if !*self.current {
            self.evaluate(time, state);
        }
        *self.current = false;
    }

    /// Brings `state` onto the constraints at `time` [s] and evaluates all forces there.
    pub fn evaluate(&mut self, time: f64, state: &mut ParticleState) {
        self.evaluate_those(time, state, |_| true);
    }

    fn evaluate_those(&mut self, time: f64, state: &mut ParticleState, which: impl Fn(&dyn Force) -> bool) {
        for constraint in self.constraints {
            constraint.apply(time, state);
        }
        self.net.clear();
        self.net.resize(state.len(), DVec3::ZERO);
        for force in all_forces(self.forces, self.grabs).filter(|force| which(*force)) {
            force.add_forces(time, state, self.net);
        }
        *self.current = false;
        *self.evaluations += 1;
    }

    /// Evaluates at the end of a step; the next step will start from the result.
    pub fn evaluate_end(&mut self, time: f64, state: &mut ParticleState) {
        self.evaluate(time, state);
        *self.current = true;
    }

    /// Evaluates at the state that a step has left, unless the forces are those already.
    pub(super) fn make_current(&mut self, time: f64, state: &mut ParticleState) {
        if !*self.current {
            self.evaluate_end(time, state);
        }
    }

    /// Forgets whose forces these are, since the state is another.
    pub(super) fn make_outdated(&mut self) {
        *self.current = false;
    }

    /// Energies of a state, by the last evaluation, which was there.
    pub(super) fn energies(&self, time: f64, state: &ParticleState) -> Energies {
        energies(self.forces, self.grabs, time, state)
    }

    /// Acceleration [m/s²] of the centre of mass by the last evaluation, nothing of it along held axes.
    pub(super) fn acceleration_of_the_whole(&self, state: &ParticleState) -> DVec3 {
        let mut free = self.net.clone();
        self.mask(&mut free);
        free.iter().sum::<DVec3>() / state.mass()
    }

    /// The fibres of the body, if it has any.
    pub(super) fn fibres(&mut self) -> Option<&mut FibreForce> {
        self.forces.iter_mut().find_map(|force| force.downcast_mut())
    }

    /// [`Self::evaluate`] for all forces but those of fibres.
    pub(super) fn evaluate_without_fibres(&mut self, time: f64, state: &mut ParticleState) {
        self.evaluate_those(time, state, |force| force.downcast_ref::<FibreForce>().is_none());
    }

    /// Adds to the forces of the last evaluation what those of the next step are found from, `forces` [N] on the
    /// particles, and gives the number of that evaluation, for [`Self::starts_from`].
    pub(super) fn end_with(&mut self, forces: &[DVec3]) -> u64 {
        axpy(1.0, forces, self.net);
        *self.current = true;
        *self.evaluations
    }

    /// Whether the forces are those of this evaluation, and the present state's.
    pub(super) fn starts_from(&self, evaluation: u64) -> bool {
        *self.current && *self.evaluations == evaluation
    }

    /// Force on a particle by the last evaluation [N].
    pub(super) fn net(&self, i: usize) -> DVec3 {
        self.net[i]
    }

    /// Accelerations [m/s²] by the last evaluation, zero along held axes.
    pub fn accelerations(&self, state: &ParticleState, out: &mut Vec<DVec3>) {
        out.clear();
        out.extend(self.net.iter().zip(&state.masses).map(|(&net, &mass)| net / mass));
        for constraint in self.constraints {
            constraint.mask(out);
        }
    }

    /// Zeroes what a field has along held axes.
    pub fn mask(&self, field: &mut [DVec3]) {
        for constraint in self.constraints {
            constraint.mask(field);
        }
    }

    /// The force of its matrix, if it has one.
    pub(super) fn matrix(&self) -> Option<&MatrixForce> {
        self.forces.iter().find_map(|force| force.downcast_ref())
    }

    /// The contact with the room, if there is any.
    fn contact(&self) -> Option<&Contact> {
        self.forces.iter().find_map(|force| force.downcast_ref())
    }

    /// The contact with colliders, if there are any.
    fn colliders(&self) -> Option<&ColliderContact> {
        self.forces.iter().find_map(|force| force.downcast_ref())
    }

    /// Particles that touch the room or a collider at a time [s], with what they touch: the planes of the room by their
    /// index, then the colliders.
    pub(super) fn touching(&self, time: f64, positions: &[DVec3]) -> Vec<(u32, u32)> {
        let mut touching = self.contact().map_or_else(Vec::new, |contact| contact.touching(time, positions));
        if let Some(contact) = self.colliders() {
            let planes = self.planes();
            touching.extend(contact.touching(time, positions).into_iter().map(|(i, of)| (i, planes + of)));
        }
        touching
    }

    /// Whether there is anything that it may touch.
    pub(super) fn may_touch(&self) -> bool {
        self.contact().is_some() || self.colliders().is_some()
    }

    fn planes(&self) -> u32 {
        self.contact().map_or(0, |contact| contact.planes.len() as u32)
    }

    /// How what a particle touches, by its number among all, resists it [N/m].
    pub(super) fn resistance(&self, what: u32, time: f64, particle: u32, moving: [DVec3; 2], h: f64) -> DMat3 {
        let collider = what.checked_sub(self.planes());
        match (collider, self.contact(), self.colliders()) {
            (Some(index), _, Some(colliders)) => colliders.resistance(index as usize, time, particle, moving, h),
            (None, Some(contact), _) => contact.resistance(what as usize, time, particle, moving, h),
            _ => DMat3::ZERO,
        }
    }

    /// Unit vector out of what a particle at `x` [m] touches, by its number among all.
    pub(super) fn normal(&self, what: u32, time: f64, x: DVec3) -> Option<DVec3> {
        match what.checked_sub(self.planes()) {
            Some(index) => self.colliders()?.normal(index as usize, time, x),
            None => Some(self.contact()?.planes[what as usize].normal),
        }
    }

    /// Gravity at a time [s], in m/s².
    pub(super) fn gravity(&self, time: f64) -> DVec3 {
        self.forces.iter().filter_map(|force| force.downcast_ref::<Gravity>()).map(|gravity| gravity.at(time)).sum()
    }

    /// Axes along which each of `n` particles is held.
    pub(super) fn held(&self, n: usize) -> Vec<BVec3> {
        held(self.constraints, n)
    }

    /// Whether nothing that it could hold on to acts on it: moved as a whole, it feels the same forces.
    pub(super) fn floats(&self, time: f64, state: &ParticleState) -> bool {
        let is_own = |force: &dyn Force| {
            force.downcast_ref::<Contact>().is_some_and(|contact| !contact.is_touched(time, &state.positions))
                || force
                    .downcast_ref::<ColliderContact>()
                    .is_some_and(|of| of.touching(time, &state.positions).is_empty())
                || force.is_internal()
                || force.downcast_ref::<Gravity>().is_some()
                || force.downcast_ref::<AirDrag>().is_some()
        };
        self.constraints.is_empty() && self.grabs.is_empty() && self.forces.iter().all(|force| is_own(&**force))
    }

    /// Brings `state` onto the constraints at `time` [s].
    pub fn constrain(&self, time: f64, state: &mut ParticleState) {
        for constraint in self.constraints {
            constraint.apply(time, state);
        }
    }
}

fn all_forces<'a>(forces: &'a mut [Box<dyn Force>], grabs: &'a mut [Grab]) -> impl Iterator<Item = &'a mut dyn Force> {
    let grabs = grabs.iter_mut().map(|grab| grab as &mut dyn Force);
    forces.iter_mut().map(|force| &mut **force).chain(grabs)
}

/// Energies of a body in a state to which its forces were last evaluated.
pub(super) fn energies(forces: &[Box<dyn Force>], grabs: &[Grab], time: f64, state: &ParticleState) -> Energies {
    let mut energies = Energies { kinetic: state.kinetic_energy(), ..Energies::default() };
    let grabs = grabs.iter().map(|grab| grab as &dyn Force);
    for force in forces.iter().map(|force| &**force).chain(grabs) {
        force.add_energy(time, state, &mut energies);
    }
    energies
}
