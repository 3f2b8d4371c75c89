//! What a world has in all, and what it was given.

use super::World;
use crate::solver::body::Body;

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

    /// Work [J] that pins that move, driven panels, colliders and wind have done on the bodies so far; what is pulled
    /// by hand is not counted. It is that of the mean of the forces at both ends: of every step for pins and colliders,
    /// of every outer step for panels, of every step for wind. Integrators that leave no forces at the end of a step
    /// have their last ones counted for pins.
    pub fn work(&self) -> f64 {
        let done = self.work.done();
        let on_bodies = done.on_bodies.iter().map(|done| done.work).sum::<f64>();
        on_bodies + done.by_panels + self.bodies.iter().map(Body::booked_work).sum::<f64>()
    }

    /// The part of [`Self::work`] that was done on a body, by its index: all but that of panels.
    pub fn work_on(&self, body: usize) -> f64 {
        let booked = self.bodies.get(body).map_or(0.0, Body::booked_work);
        self.work.done().on_bodies.get(body).map_or(0.0, |done| done.work) + booked
    }

    /// Memory that the world takes [bytes], about.
    pub fn bytes(&self) -> usize {
        self.bodies.iter().map(Body::bytes).sum()
    }
}
