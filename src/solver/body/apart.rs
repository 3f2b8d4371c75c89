//! The forces on a body one by one, to find the one in which two runs differ.

use super::Body;
use crate::solver::forces::Force;
use glam::DVec3;

impl Body {
    /// What each force does to every particle of the present state at a time [s], by the force's name [N]; what other
    /// bodies and panels do comes last. Nothing of the body changes.
    pub(crate) fn forces_apart(&self, time: f64) -> Vec<(&'static str, Vec<DVec3>)> {
        let state = self.state();
        let alone = |force: &dyn Force| {
            let mut forces = vec![DVec3::ZERO; state.len()];
            force.clone_box().add_forces(time, state, &mut forces);
            (force.name(), forces)
        };
        let own = self.parts.forces.iter().map(|force| alone(&**force));
        let grabs = self.grabs.iter().map(|grab| alone(grab));
        own.chain(grabs).chain([("other bodies and panels", self.external_forces.clone())]).collect()
    }
}
