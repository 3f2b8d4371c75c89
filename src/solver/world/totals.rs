//! What a world has in all, and what it was given.

use super::World;

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

    /// Work [J] that pins that move, driven panels and wind have done on the bodies so far; what is pulled by hand is not
    /// counted. It is that of the mean of the forces at both ends: of every step for pins under integrators that leave the
    /// forces there (leap-frog and its kin), of every outer step for panels, and of every frame for all else.
    pub fn work(&self) -> f64 {
        let done = self.work.done();
        done.on_bodies.iter().sum::<f64>() + done.by_panels
    }

    /// The part of [`Self::work`] that was done on a body, by its index: all but that of panels.
    pub fn work_on(&self, body: usize) -> f64 {
        self.work.done().on_bodies.get(body).copied().unwrap_or_default()
    }
}
