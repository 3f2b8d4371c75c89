//! The energy of a body from step to step: what a scheme gains without work from outside is an error.

use super::stage::Unconverged;
use crate::solver::dynamics::Dynamics;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// Share of the energy that is in motion and in what is strained by which the total may exceed its greatest so far.
const SLACK: f64 = 0.01;

/// The most that a body's energy [J] may be, by what it had at the start and what others did to it between steps.
#[derive(Clone, Default)]
pub(super) struct Balance {
    kept: Option<EnergyMark>,
}

#[derive(Clone, Copy)]
struct EnergyMark {
    /// After the last step.
    last: f64,
    highest: f64,
}

impl Balance {
    /// Sees the body before a step of `dt` [s]: what is not as the last step left it came from outside. Steps in which
    /// leap-frog is stable need not be watched.
    pub(super) fn start(&mut self, dynamics: &Dynamics<'_>, state: &ParticleState, time: f64, dt: f64) {
        if dt <= dynamics.explicit_dt {
            self.kept = None;
            return;
        }
        let now = dynamics.energies(time, state).total();
        let highest = self.kept.map_or(now, |kept| kept.highest + now - kept.last);
        self.kept = Some(EnergyMark { last: now, highest });
    }

    /// Whether in a step from `time` [s] nothing from outside can do work, as far as can be told before: held particles
    /// must not move either.
    pub(super) fn watches(&self, dynamics: &Dynamics<'_>, time: f64) -> bool {
        self.kept.is_some() && dynamics.forces.iter().all(|force| !force.does_work() && force.changes_until() <= time)
    }

    /// Sees the body after a step from `start` [m], which is there if the step is watched.
    ///
    /// # Errors
    /// The energy is more than it can be.
    pub(super) fn end(
        &mut self,
        dynamics: &Dynamics<'_>,
        state: &ParticleState,
        time: f64,
        start: Option<&[DVec3]>,
    ) -> Result<(), Unconverged> {
        let Some(kept) = self.kept else { return Ok(()) };
        let energies = dynamics.energies(time, state);
        let now = energies.total();
        if let Some(start) = start {
            let held = dynamics.held(state.len());
            let moved = |i: usize| DVec3::select(held[i], state.positions[i] - start[i], DVec3::ZERO) != DVec3::ZERO;
            // Gravity's and a gas's energy count from anywhere, and what drives have done is no energy of the body.
            let slack = SLACK * (now - energies.gravity - energies.pressure - energies.activation).abs();
            if now > kept.highest + slack && !(0..state.len()).any(moved) {
                return Err(Unconverged);
            }
        }
        self.kept = Some(EnergyMark { last: now, highest: kept.highest.max(now) });
        Ok(())
    }

    /// Takes the energy for what it is.
    pub(super) fn take_over(&mut self, dynamics: &Dynamics<'_>, state: &ParticleState, time: f64) {
        let Some(kept) = self.kept else { return };
        let now = dynamics.energies(time, state).total();
        self.kept = Some(EnergyMark { last: now, highest: kept.highest.max(now) });
    }
}
