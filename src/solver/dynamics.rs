//! What an integrator sees of a body: forces in, accelerations out.

use super::constraint::Constraint;
use super::forces::{FibreForce, Force, Grab};
use super::linear_algebra::vectors::axpy;
use super::state::ParticleState;
use glam::DVec3;

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

    /// The fibres of the body, if it has any.
    pub(super) fn fibres(&mut self) -> Option<&mut FibreForce> {
        self.forces.iter_mut().find_map(|force| force.downcast_mut())
    }

    /// [`Self::evaluate`] for all forces but those of fibres.
    pub(super) fn evaluate_without_fibres(&mut self, time: f64, state: &mut ParticleState) {
        self.evaluate_those(time, state, |force| force.downcast_ref::<FibreForce>().is_none());
    }

    /// Adds to the forces of the last evaluation what those of the next step are found from, `forces` [N] on the particles,
    /// and gives the number of that evaluation, for [`Self::starts_from`].
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

    /// Adds the first-order change of all forces [N] under a change of positions and one of velocities.
    pub fn derivative(&mut self, time: f64, state: &ParticleState, change: [&[DVec3]; 2], out: &mut [DVec3]) {
        for force in all_forces(self.forces, self.grabs) {
            force.add_derivative(time, state, change, out);
        }
    }

    /// Zeroes what a field has along held axes.
    pub fn mask(&self, field: &mut [DVec3]) {
        for constraint in self.constraints {
            constraint.mask(field);
        }
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
