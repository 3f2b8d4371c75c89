//! What a body does at colliders.

use super::Body;
use crate::solver::constraint::held;
use crate::solver::eased_overlap::EasedOverlap;
use crate::solver::forces::{ColliderContact, Force};

fn contact_among(forces: &mut [Box<dyn Force>]) -> Option<&mut ColliderContact> {
    forces.iter_mut().find_map(|force| force.downcast_mut())
}

impl Body {
    /// The colliders that it touches, and how; none of a body in a world without any.
    pub(crate) fn collider_contact(&self) -> Option<&ColliderContact> {
        self.parts.forces.iter().find_map(|force| force.downcast_ref())
    }

    /// Eases it out of colliders, one of each or none, from a time [s].
    pub(in crate::solver) fn ease_out_of_colliders(&mut self, eased: Vec<Option<EasedOverlap>>, time: f64) {
        if contact_among(&mut self.parts.forces).is_some_and(|contact| contact.ease_out(eased)) {
            self.current = false;
        }
        self.update_net_forces(time);
    }

    /// Notes where a step begins.
    pub(super) fn begin_at_colliders(&mut self, time: f64) {
        if let Some(contact) = contact_among(&mut self.parts.forces) {
            contact.begin_step(time, &self.parts.state);
        }
    }

    /// Puts back what went through a collider in the step that ends at a time [s].
    pub(super) fn put_back_from_colliders(&mut self, time: f64) {
        let (constraints, state) = (&self.parts.constraints, &mut self.parts.state);
        let n = state.len();
        let put_back = |contact: &mut ColliderContact| contact.put_back(time, state, || held(constraints, n));
        if contact_among(&mut self.parts.forces).is_some_and(put_back) {
            self.current = false;
        }
    }
}
