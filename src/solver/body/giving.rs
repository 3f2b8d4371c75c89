//! What a body is given by others and by hand, and what its balance is told from besides its own energies.

use super::given::Given;
use super::{Body, room_contact};
use crate::solver::forces::{ColliderContact, Contact, Force, Gravity, Plane};
use glam::DVec3;

impl Body {
    /// What it was given so far.
    pub(in crate::solver) fn given(&self) -> &Given {
        &self.given
    }

    /// Adds to the velocities [m/s] what the constraints leave of a change; the work that does [J].
    pub(super) fn change_velocities(&mut self, mut change: Vec<DVec3>) -> f64 {
        for constraint in &self.parts.constraints {
            constraint.mask(&mut change);
        }
        let state = &mut self.parts.state;
        let center = state.center();
        let (mut work, mut momenta) = (0.0, [DVec3::ZERO; 2]);
        for (i, change) in change.into_iter().enumerate() {
            let impulse = state.masses[i] * change;
            work += impulse.dot(state.velocities[i] + 0.5 * change);
            momenta[0] += impulse;
            momenta[1] += (state.positions[i] - center).cross(impulse);
            state.velocities[i] += change;
        }
        for (sum, given) in self.given.momenta.iter_mut().zip(momenta) {
            *sum += given;
        }
        work
    }

    fn energy_of_grabs(&self) -> f64 {
        let pulled = |x: DVec3, target: DVec3| x.distance_squared(target);
        let positions = &self.parts.state.positions;
        self.grabs.iter().map(|grab| 0.5 * grab.stiffness * pulled(grab.point.gather(positions), grab.target)).sum()
    }

    /// Told before the grabs are changed.
    pub(super) fn note_grabs(&mut self) {
        let energy = self.energy_of_grabs();
        self.given.grabs_before.get_or_insert(energy);
    }

    /// Counts what changes of the grabs have given, before anything moves again.
    pub(in crate::solver) fn count_grabs(&mut self) {
        if let Some(before) = self.given.grabs_before.take() {
            self.given.by_hand += self.energy_of_grabs() - before;
        }
    }

    /// Work that colliders and forces from outside have booked themselves [J].
    pub(in crate::solver) fn booked_work(&self) -> f64 {
        let by_forces = self.parts.forces.iter().filter_map(|force| force.outside_work()).sum::<f64>();
        by_forces + self.collider_contact().map_or(0.0, ColliderContact::work)
    }

    /// Sum of the energies [J] but the share of contacts with other bodies and panels.
    pub(in crate::solver) fn contact_with_others(&self) -> f64 {
        self.contact_energy
    }

    /// Whether its balance can be told: nothing is known of what a program's own force gives, and one that is to go on
    /// whatever happens is not watched.
    pub(in crate::solver) fn is_watched(&self) -> bool {
        self.guarded && !self.has_own_forces && self.divergence.is_none()
    }

    /// Whether for the next `seconds` nothing acts on it from outside but steady gravity, other bodies and panels.
    pub(in crate::solver) fn is_alone(&self, time: f64, seconds: f64) -> bool {
        let is_inner = |force: &dyn Force| {
            force.is_internal()
                || force.downcast_ref::<Gravity>().is_some_and(|gravity| gravity.changes_until() <= time)
                || force.downcast_ref::<Contact>().is_some()
        };
        self.parts.constraints.is_empty()
            && self.grabs.is_empty()
            && self.parts.forces.iter().all(|force| is_inner(&**force))
            && !self.may_reach_the_room(time, seconds)
    }

    fn may_reach_the_room(&self, time: f64, seconds: f64) -> bool {
        let Some(contact) = room_contact(&self.parts.forces) else { return false };
        let state = &self.parts.state;
        let fastest = state.velocities.iter().map(|v| v.length()).fold(0.0, f64::max);
        let way = 2.0 * fastest * seconds + contact.law.radius;
        let near = |plane: &Plane| state.positions.iter().any(|x| (*x - plane.point).dot(plane.normal) < way);
        contact.end() > time || contact.planes.iter().any(near)
    }
}
