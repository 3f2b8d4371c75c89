//! What a world has in all, and what it was given.

use super::World;
use crate::solver::body::Body;
use crate::solver::forces::ColliderContact;

impl World {
    /// Energy of all bodies, and of panels that fall [J].
    pub fn energy(&self) -> f64 {
        let time = self.time();
        self.bodies.iter().map(|body| body.energies(time).total()).sum::<f64>() + self.energy_of_panels()
    }

    /// Energy of the panels that fall [J], zero at the world's origin.
    pub(crate) fn energy_of_panels(&self) -> f64 {
        let gravity = self.gravity().y;
        let falling = self.panels.iter().filter(|panel| panel.driven.is_none());
        falling.map(|panel| panel.mass * (0.5 * panel.velocity.powi(2) - gravity * panel.height)).sum()
    }

    /// Work [J] that pins that move, driven panels, colliders and wind have done on the bodies so far; what is pulled by hand is not
    /// counted. It is that of the mean of the forces at both ends: of every step for pins under integrators that leave the
    /// forces there (leap-frog and its kin), of every outer step for panels, and of every frame for all else.
    pub fn work(&self) -> f64 {
        let done = self.work.done();
        done.on_bodies.iter().sum::<f64>() + done.by_panels + self.bodies.iter().map(by_colliders).sum::<f64>()
    }

    /// The part of [`Self::work`] that was done on a body, by its index: all but that of panels.
    pub fn work_on(&self, body: usize) -> f64 {
        let by_colliders = self.bodies.get(body).map_or(0.0, by_colliders);
        self.work.done().on_bodies.get(body).copied().unwrap_or_default() + by_colliders
    }
}

/// Work that colliders have done on a body [J], of every step.
fn by_colliders(body: &Body) -> f64 {
    body.collider_contact().map_or(0.0, ColliderContact::work)
}
