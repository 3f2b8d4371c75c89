//! Springs whose rest lengths a drive changes, and the work that this does.

use crate::solver::drive::Drive;
use crate::solver::hand::Hand;
use glam::DVec3;
use std::sync::Arc;

/// Springs that want to be shorter by a share of their rest length times a drive.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ActiveSprings {
    /// Identifier of the scene.
    id: Arc<str>,
    /// Which of the body's springs.
    springs: Arc<[u32]>,
    /// Share by which each is shorter where the drive is 1.
    contract: f64,
    drive: Drive,
    /// The drive's work up to the last booking [J].
    done: f64,
    /// The contraction there, and `sum k L0 L` of the springs [J].
    booked: Option<[f64; 2]>,
}

/// What a spring is without its drive: particles at its ends, stiffness [N/m] and rest length [m].
pub(crate) type Passive = ([usize; 2], f64, f64);

impl ActiveSprings {
    /// `springs` of a body, shorter by `contract` times a drive.
    pub(crate) fn new(id: &str, springs: Vec<u32>, contract: f64, drive: Drive) -> Self {
        Self { id: id.into(), springs: springs.into(), contract, drive, done: 0.0, booked: None }
    }

    /// Share by which they want to be shorter at a time [s].
    fn contraction(&self, time: f64) -> f64 {
        self.contract * self.drive.at(time).0
    }

    /// Rest lengths at a time [s] in place of the passive ones [m].
    pub(crate) fn put_in(&self, time: f64, passive: &[f64], lengths: &mut [f64]) {
        let left = 1.0 - self.contraction(time);
        for &spring in self.springs.iter() {
            lengths[spring as usize] = left * passive[spring as usize];
        }
    }

    /// Books the work of the step that ended at a time [s] in these positions [m]: half of what the change of the rest
    /// lengths does to the energy in the shape before and half of what it does in that after it.
    pub(crate) fn book(&mut self, time: f64, positions: &[DVec3], passive: impl Fn(u32) -> Passive) {
        // With c the contraction, E = sum k (L - L0 (1 - c))² / 2 changes by c' - c times this, and by the squares of
        // L0.
        let (mut tension, mut squares) = (0.0, 0.0);
        for &spring in self.springs.iter() {
            let ([a, b], stiffness, rest) = passive(spring);
            tension += stiffness * rest * positions[a].distance(positions[b]);
            squares += stiffness * rest * rest;
        }
        let now = [self.contraction(time), tension];
        if !now[1].is_finite() {
            return;
        }
        if let Some(before) = self.booked {
            let left = [before, now].map(|[contraction, _]| 1.0 - contraction);
            self.done += 0.5 * (before[1] + now[1]) * (now[0] - before[0])
                + 0.5 * squares * (left[1] * left[1] - left[0] * left[0]);
        }
        self.booked = Some(now);
    }

    /// Whether the booking has begun.
    pub(crate) fn is_booked(&self) -> bool {
        self.booked.is_some()
    }

    /// The drive's work so far [J].
    pub(crate) fn work(&self) -> f64 {
        self.done
    }

    /// Begins to book anew and goes on with the work of the one of its name among those before.
    pub(crate) fn adopt(&mut self, before: &[Self]) {
        self.booked = None;
        self.done = before.iter().find(|one| one.id == self.id).map_or(0.0, |one| one.done);
    }

    /// Has a hand lead a shared drive, or none.
    pub(crate) fn give(&mut self, to: &str, led: Option<Hand>) {
        self.drive.give(to, led);
    }

    /// Until when [s] it changes.
    pub(crate) fn until(&self) -> f64 {
        self.drive.until()
    }

    /// As short as they ever get, or as long.
    pub(crate) fn at_extreme(&self, shortest: bool) -> Self {
        let value = if shortest == (self.contract > 0.0) { self.drive.greatest() } else { self.drive.least() };
        Self { drive: Drive::Constant(value), booked: None, done: 0.0, ..self.clone() }
    }
}
