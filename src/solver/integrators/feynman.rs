//! Positions at whole steps, velocities at half steps.

use super::integrator::Integrator;
use crate::solver::dynamics::Dynamics;
use crate::solver::linear_algebra::vectors::axpy;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// `v(t + dt/2) = v(t - dt/2) + dt a(t); x(t + dt) = x(t) + dt v(t + dt/2)`, begun by `v(dt/2) = v(0) + dt/2 a(0)`: the
/// scheme of the Feynman Lectures, vol. I, sec. 9-6. Order 2 and symplectic, one force evaluation a step.
///
/// The velocities that it goes on from are those of half steps and its own. What is shown between is carried on to the
/// whole step by half a kick. A particle that was struck, or whose step changes, begins anew from what it shows. Forces
/// that depend on velocity see that of the half step before, as under leap-frog: the two differ by rounding alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct Feynman {
    accelerations: Vec<DVec3>,
    /// The step that the rest belongs to [s].
    dt: f64,
    /// Velocities half a step before the present state [m/s], and what they were shown as.
    half: Vec<DVec3>,
    shown: Vec<DVec3>,
}

impl Integrator for Feynman {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        dynamics.start(time, state);
        dynamics.accelerations(state, &mut self.accelerations);
        let goes_on = self.dt == dt && self.half.len() == state.len();
        for (i, &a) in self.accelerations.iter().enumerate() {
            let v = &mut state.velocities[i];
            *v = if goes_on && self.shown[i] == *v { self.half[i] + dt * a } else { *v + 0.5 * dt * a };
        }
        axpy(dt, &state.velocities, &mut state.positions);
        dynamics.evaluate_end(time + dt, state);
        dynamics.accelerations(state, &mut self.accelerations);
        self.dt = dt;
        self.half.clone_from(&state.velocities);
        axpy(0.5 * dt, &self.accelerations, &mut state.velocities);
        self.shown.clone_from(&state.velocities);
    }

    fn stable_step(&self, omega: f64, damping: f64) -> f64 {
        // The roots of z² - (2 - c dt - w² dt²) z + (1 - c dt) stay within the unit circle up to w² dt² + 2 c dt = 4.
        4.0 / (damping + damping.hypot(2.0 * omega))
    }

    fn bytes(&self) -> usize {
        size_of_val(self) + size_of_val(&*self.half) + size_of_val(&*self.shown)
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        // The accelerations carry nothing from step to step.
        let Self { dt, half, shown, .. } = self;
        Box::new(Self { accelerations: Vec::new(), dt: *dt, half: half.clone(), shown: shown.clone() })
    }
}
