//! What is seen of a world as its balance is watched.

use crate::solver::account::{Account, HARD_BOUND};
use crate::solver::momentum::{Drift, Momenta};
use crate::solver::unbalanced::Unbalanced;

/// What is watched.
#[derive(Clone, Debug, Default)]
pub(super) struct Watch {
    pub(super) bodies: Vec<Watched>,
    pub(super) whole: Account,
    pub(super) drift: Drift,
    /// Evaluations of the forces, times particles, at the last look.
    pub(super) looked_at: f64,
    /// What was found, in the order of time.
    pub(super) found: Vec<Unbalanced>,
    pub(super) is_told_of_whole: bool,
}

/// One body of it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Watched {
    pub(super) account: Account,
    pub(super) drift: Drift,
    /// What others had given it at the beginning of the frame.
    pub(super) given: Momenta,
    /// Energy of gravity and of the gas at the first look [J].
    pub(super) from: [f64; 2],
    /// Energy below which nothing is looked for [J].
    pub(super) least: f64,
    pub(super) is_told: bool,
}

impl Watch {
    /// Memory that it takes beside itself [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.bodies) + size_of_val(&*self.found)
    }
}

/// How accurate a run of a body, or of a world, has been so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accuracy {
    /// Change of the energy less the work from outside since the start [J]: what was dissipated, and what was gained.
    pub change: f64,
    /// The most that this has risen over a time, beyond what an integrator that keeps energy may show [J].
    pub gained: f64,
    /// The greatest energy handled, by which the gain is judged [J].
    pub handled: f64,
    /// Linear momentum [kg m/s] and angular momentum [kg m²/s] that came from nowhere, while nothing but steady
    /// gravity, other bodies and panels acted; none where that never was.
    pub drift: Option<[f64; 2]>,
    /// For how long that was followed [s].
    pub followed: f64,
}

impl Accuracy {
    pub(super) fn of(account: &Account, drift: &Drift) -> Self {
        let (drifted, followed) = drift.size().unzip();
        let followed = followed.unwrap_or_default();
        Self { change: account.change(), gained: account.gained, handled: account.handled, drift: drifted, followed }
    }
}

/// A body that has gained this many times the energy that it ever handled is stopped.
pub const MOST_GAINED: f64 = HARD_BOUND;
