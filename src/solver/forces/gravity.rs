//! Weight.

use super::force::Force;
use crate::solver::drive::Drive;
use crate::solver::driven::Driven;
use crate::solver::energy::Energies;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// Uniform gravity.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Gravity {
    /// Acceleration [m/s²].
    pub acceleration: DVec3,
    driven: Driven,
}

impl Gravity {
    /// An acceleration [m/s²], times a drive if there is one.
    pub(crate) fn new(acceleration: DVec3, drive: Option<Drive>) -> Self {
        Self { acceleration, driven: Driven::by(drive) }
    }

    /// Acceleration [m/s²] at a time [s].
    pub(crate) fn at(&self, time: f64) -> DVec3 {
        self.driven.at(time) * self.acceleration
    }
}

/// Energy [J] of a body in a field of this acceleration [m/s²].
fn energy(acceleration: DVec3, state: &ParticleState) -> f64 {
    let moment: DVec3 = state.positions.iter().zip(&state.masses).map(|(&x, &m)| m * x).sum();
    -moment.dot(acceleration)
}

impl Force for Gravity {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        self.driven.begin(time, || energy(self.acceleration, state));
        let acceleration = self.at(time);
        for (force, &mass) in forces.iter_mut().zip(&state.masses) {
            *force += mass * acceleration;
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.gravity += self.driven.at(time) * energy(self.acceleration, state);
        energies.activation -= self.drive_work();
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        self.driven.book(time, || energy(self.acceleration, state));
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        let before = before.iter().find_map(|force| force.downcast_ref::<Self>());
        self.driven.adopt(before.map(|before| &before.driven));
    }

    fn drive_work(&self) -> f64 {
        self.driven.work()
    }

    fn changes_until(&self) -> f64 {
        self.driven.until()
    }

    fn driven_until(&self) -> f64 {
        self.changes_until()
    }

    fn name(&self) -> &'static str {
        "gravity"
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
