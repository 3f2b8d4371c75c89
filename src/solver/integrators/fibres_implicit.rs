//! Fibres implicitly, everything else by leap-frog.

use super::integrator::Integrator;
use super::leap_frog::LeapFrog;
use crate::solver::dynamics::Dynamics;
use crate::solver::forces::FibreForce;
use crate::solver::forces::fibre::implicit::{FibreStep, ImplicitFibres, Unconverged};
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::sync::Arc;

/// Share of a step at which the fibres' forces are taken: one half is the midpoint, which lets stiff motions ring, one
/// is backward Euler, which takes most energy from them.
const SHARE: f64 = 0.6;

/// A step is halved so often before leap-frog takes it in steps of its own.
const MOST_HALVINGS: u32 = 3;

/// Share of the stable step that leap-frog then takes.
const SAFETY: f64 = 0.5;

/// What a product of two blocks and a material particle take in time, beside each other, and how many passes a step
/// mostly takes.
const PRODUCT: f64 = 5.0;
const PARTICLE: f64 = 80.0;
const PASSES: f64 = 2.5;

/// About how many times the work of one of leap-frog's a step with these fibres takes.
pub(crate) fn work_of_a_step(fibres: &FibreForce, state: &ParticleState) -> f64 {
    let inverse_masses: Vec<DVec3> = state.masses.iter().map(|mass| DVec3::splat(1.0 / mass)).collect();
    let products = ImplicitFibres::new(fibres, &inverse_masses).products();
    1.0 + PASSES * PRODUCT * products as f64 / (PARTICLE * state.len() as f64)
}

/// Leap-frog with the forces of fibres, f, found together with where they bring the particles:
/// `v += dt/2 a(x) - (s - 1/2) dt f_before / m; x' = x + dt (v + s dt f / m); v += dt f / m` and
/// `v += dt/2 a(x') + (s - 1/2) dt f / m`, where a is due to all other forces and f are the fibres' forces at the share
/// s = 0.6 of the way. Stiff fibres in a soft matrix so allow the matrix's own step.
///
/// The velocities in between differ from the motion's by a multiple of f; those at the end are of second order. Linear
/// momentum is kept to round-off, and forces that depend on velocity see `(x' - x) / dt`, which is zero at rest.
#[derive(Clone, Default)]
pub(crate) struct FibresImplicit {
    fibres: Option<Carried>,
    leap_frog: LeapFrog,
}

/// What a step goes on from.
#[derive(Clone)]
struct Carried {
    implicit: ImplicitFibres,
    /// Of every particle, zero along held axes [1/kg].
    inverse_masses: Arc<[DVec3]>,
    /// Forces of the fibres on the particles in the last step [N].
    forces: Vec<DVec3>,
    /// The evaluation that ended it; any other since then has not seen these forces.
    evaluation: u64,
}

impl Carried {
    fn new(dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64) -> Option<Self> {
        let mut inverse_masses: Vec<DVec3> = state.masses.iter().map(|mass| DVec3::splat(1.0 / mass)).collect();
        dynamics.mask(&mut inverse_masses);
        dynamics.constrain(time, state);
        // Drives and twist are leap-frog's.
        let fibres = dynamics.fibres().filter(|fibres| fibres.takes_implicit_steps())?;
        let mut forces = vec![DVec3::ZERO; state.len()];
        fibres.evaluate_at(&state.positions, &mut forces);
        let implicit = ImplicitFibres::new(fibres, &inverse_masses);
        Some(Self { implicit, inverse_masses: inverse_masses.into(), forces, evaluation: 0 })
    }

    /// One step, or none at all where it is too long.
    fn step(
        &mut self,
        dynamics: &mut Dynamics<'_>,
        state: &mut ParticleState,
        time: f64,
        dt: f64,
    ) -> Result<(), Unconverged> {
        // The fibres' forces are among those of the step before, and not among others.
        let among = if dynamics.starts_from(self.evaluation) {
            1.0
        } else {
            dynamics.evaluate_without_fibres(time, state);
            self.evaluation = 0;
            0.0
        };
        let before = &self.forces;
        let mut end = state.clone();
        for (i, inverse_mass) in self.inverse_masses.iter().enumerate() {
            let others = dynamics.net(i) - among * before[i];
            end.velocities[i] += dt * *inverse_mass * (0.5 * others - (SHARE - 0.5) * before[i]);
            end.positions[i] += dt * end.velocities[i];
        }
        dynamics.constrain(time + dt, &mut end);
        let mut forces = vec![DVec3::ZERO; state.len()];
        if let Some(fibres) = dynamics.fibres() {
            let step = FibreStep { from: &state.positions, to: &end.positions, share: SHARE, dt };
            self.implicit.step(fibres, step, &mut forces)?;
        }
        let kick = |i: usize| dt * self.inverse_masses[i] * forces[i];
        for i in 0..state.len() {
            end.positions[i] += SHARE * dt * kick(i);
            end.velocities[i] += SHARE * kick(i);
        }
        dynamics.evaluate_without_fibres(time + dt, &mut end);
        for i in 0..state.len() {
            // What is left of the fibres' kick, and what their share is off the middle.
            let ahead = 0.5 * kick(i);
            end.velocities[i] += 0.5 * dt * self.inverse_masses[i] * dynamics.net(i) + ahead;
        }
        self.evaluation = dynamics.end_with(&forces);
        self.forces = forces;
        std::mem::swap(&mut state.positions, &mut end.positions);
        std::mem::swap(&mut state.velocities, &mut end.velocities);
        Ok(())
    }
}

impl FibresImplicit {
    fn advance(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, [time, dt]: [f64; 2], halvings: u32) {
        if self.fibres.is_none() {
            self.fibres = Carried::new(dynamics, state, time);
        }
        let Some(fibres) = &mut self.fibres else {
            self.leap_frog.step(dynamics, state, time, dt);
            return;
        };
        if fibres.step(dynamics, state, time, dt).is_ok() {
            return;
        }
        if halvings < MOST_HALVINGS {
            dynamics.fallbacks.halved += 1;
            let half = 0.5 * dt;
            self.advance(dynamics, state, [time, half], halvings + 1);
            self.advance(dynamics, state, [time + half, half], halvings + 1);
            return;
        }
        dynamics.fallbacks.handed_over += 1;
        dynamics.evaluate_end(time, state);
        let count = (dt / (SAFETY * dynamics.explicit_dt)).ceil().max(1.0);
        for k in 0..count as u64 {
            let part = dt / count;
            self.leap_frog.step(dynamics, state, time + k as f64 * part, part);
        }
        self.fibres = None;
    }
}

impl Integrator for FibresImplicit {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        self.advance(dynamics, state, [time, dt], 0);
    }

    fn stable_step(&self, omega: f64, damping: f64) -> f64 {
        self.leap_frog.stable_step(omega, damping)
    }

    fn takes_fibres(&self) -> bool {
        true
    }

    fn bytes(&self) -> usize {
        let fibres = self.fibres.as_ref().map_or(0, |fibres| fibres.implicit.bytes() + size_of_val(&*fibres.forces));
        size_of_val(self) + fibres
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        Box::new(self.clone())
    }
}
