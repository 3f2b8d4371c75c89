//! Symplectic (semi-implicit) Euler.

use super::integrator::Integrator;
use crate::solver::dynamics::Dynamics;
use crate::solver::linear_algebra::vectors::axpy;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// `v += dt a(x, v); x += dt v` with the new velocity: order 1, symplectic, one force evaluation a step.
#[derive(Clone, Debug, Default)]
pub(crate) struct SymplecticEuler {
    accelerations: Vec<DVec3>,
}

impl Integrator for SymplecticEuler {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        dynamics.start(time, state);
        dynamics.accelerations(state, &mut self.accelerations);
        axpy(dt, &self.accelerations, &mut state.velocities);
        axpy(dt, &state.velocities, &mut state.positions);
        dynamics.constrain(time + dt, state);
    }

    fn stable_step(&self, omega: f64, damping: f64) -> f64 {
        // The roots of z² - (2 - c dt - w² dt²) z + (1 - c dt) stay within the unit circle up to w² dt² + 2 c dt = 4.
        4.0 / (damping + damping.hypot(2.0 * omega))
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        // Its buffers carry nothing from step to step.
        Box::new(Self::default())
    }
}
