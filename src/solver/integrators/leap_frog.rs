//! Kick-drift-kick leap-frog (velocity Verlet).

use super::integrator::Integrator;
use crate::solver::dynamics::Dynamics;
use crate::solver::linear_algebra::vectors::axpy;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// `v += dt/2 a; x += dt v; v += dt/2 a`: order 2 and symplectic, one force evaluation a step.
///
/// Linear and angular momentum are kept to round-off by forces that keep them. Forces that depend on velocity are
/// evaluated with the half-step velocity, which lags and makes damping first order.
#[derive(Clone, Debug, Default)]
pub(crate) struct LeapFrog {
    accelerations: Vec<DVec3>,
}

impl Integrator for LeapFrog {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        dynamics.start(time, state);
        dynamics.accelerations(state, &mut self.accelerations);
        axpy(0.5 * dt, &self.accelerations, &mut state.velocities);
        axpy(dt, &state.velocities, &mut state.positions);
        dynamics.evaluate_end(time + dt, state);
        dynamics.accelerations(state, &mut self.accelerations);
        axpy(0.5 * dt, &self.accelerations, &mut state.velocities);
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
