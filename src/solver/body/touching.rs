//! What a body panel_pushes on.

use super::{Body, room_contact};
use glam::DVec3;

impl Body {
    /// Remembers the force with which it panel_pushes up the next panel [N].
    pub(in crate::solver) fn add_panel_push(&mut self, push: f64) {
        self.panel_pushes.push(push);
    }

    /// Force with which it panel_pushes up a panel [N]; zero where there is none.
    pub(in crate::solver) fn panel_push(&self, panel: usize) -> f64 {
        self.panel_pushes.get(panel).copied().unwrap_or_default()
    }

    /// Force of the room, of panels and of other bodies on a particle at the present time [s], in newtons.
    pub(in crate::solver) fn contact_force(&self, i: usize, time: f64) -> DVec3 {
        let of_room = room_contact(&self.parts.forces).map(|contact| contact.force_on(time, &self.parts.state, i));
        self.external_forces[i] + of_room.unwrap_or_default()
    }
}
