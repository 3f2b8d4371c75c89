//! Weight.

use super::force::Force;
use crate::solver::drive::{Drive, DriveWork};
use crate::solver::energy::Energies;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// Uniform gravity.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Gravity {
    /// Acceleration [m/s²].
    pub acceleration: DVec3,
    /// What it is multiplied by, if anything.
    drive: Option<Drive>,
    work: DriveWork,
}

impl Gravity {
    /// An acceleration [m/s²], times a drive if there is one.
    pub(crate) fn new(acceleration: DVec3, drive: Option<Drive>) -> Self {
        Self { acceleration, drive, work: DriveWork::default() }
    }

    /// Acceleration [m/s²] at a time [s].
    pub(crate) fn at(&self, time: f64) -> DVec3 {
        self.drive.as_ref().map_or(self.acceleration, |drive| drive.at(time).0 * self.acceleration)
    }

    /// Energy [J] in the field that is not driven.
    fn energy(&self, state: &ParticleState) -> f64 {
        let moment: DVec3 = state.positions.iter().zip(&state.masses).map(|(&x, &m)| m * x).sum();
        -moment.dot(self.acceleration)
    }
}

impl Force for Gravity {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        if let Some(drive) = &self.drive {
            let mut work = self.work;
            work.begin(drive.at(time).0, || self.energy(state));
            self.work = work;
        }
        let acceleration = self.at(time);
        for (force, &mass) in forces.iter_mut().zip(&state.masses) {
            *force += mass * acceleration;
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.gravity += self.drive.as_ref().map_or(1.0, |drive| drive.at(time).0) * self.energy(state);
        energies.activation -= self.work.done;
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        if let Some(drive) = &self.drive {
            let (value, energy) = (drive.at(time).0, self.energy(state));
            self.work.book(value, energy);
        }
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        if let Some(before) = before.iter().find_map(|force| force.downcast_ref::<Self>()) {
            self.work.adopt(&before.work);
        }
    }

    fn changes_until(&self) -> f64 {
        self.drive.as_ref().map_or(0.0, Drive::until)
    }

    fn driven_until(&self) -> f64 {
        self.changes_until()
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
