//! Backward Euler: Newton's method with conjugate gradients on Hessian-vector products.

use super::integrator::Integrator;
use crate::solver::dynamics::Dynamics;
use crate::solver::linear_algebra::conjugate_gradients::conjugate_gradients;
use crate::solver::linear_algebra::vectors::dot;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// `v' = v + dt a(x', v'); x' = x + dt v'`: order 1, stable at any step, takes energy.
///
/// Each Newton step solves `(M - dt² df/dx - dt df/dv) dv' = M (v - v') + dt f` by conjugate gradients preconditioned
/// with the masses, and is halved while it makes the residual larger.
#[derive(Clone, Debug, Default)]
pub(crate) struct BackwardEuler {
    accelerations: Vec<DVec3>,
    end: ParticleState,
    velocities: Vec<DVec3>,
    residual: Vec<DVec3>,
    change: Vec<DVec3>,
}

const MOST_NEWTON_STEPS: usize = 25;
const MOST_CG_STEPS: usize = 200;
const MOST_HALVINGS: usize = 6;

/// Share of the momentum scale to which the residual is brought; round-off ends it a little below.
const TOLERANCE: f64 = 1e-11;

impl BackwardEuler {
    /// Evaluates at the end of the step under `self.velocities`; gives the residual's norm over its scale.
    fn evaluate(&mut self, dynamics: &mut Dynamics<'_>, state: &ParticleState, end_time: f64, dt: f64) -> f64 {
        self.end.clone_from(state);
        for (i, &v) in self.velocities.iter().enumerate() {
            self.end.positions[i] += dt * v;
            self.end.velocities[i] = v;
        }
        dynamics.evaluate_end(end_time, &mut self.end);
        dynamics.accelerations(state, &mut self.accelerations);
        self.residual.clear();
        let mut scale = 0.0;
        for i in 0..state.len() {
            let (m, v, a) = (state.masses[i], state.velocities[i], self.accelerations[i]);
            self.residual.push(m * (v + dt * a - self.velocities[i]));
            scale += m * m * (v.length_squared() + (dt * a).length_squared());
        }
        dynamics.mask(&mut self.residual);
        if scale > 0.0 { (dot(&self.residual, &self.residual) / scale).sqrt() } else { 0.0 }
    }

    /// Solves for the change of velocity into `self.change`.
    fn solve(&mut self, dynamics: &mut Dynamics<'_>, end_time: f64, dt: f64, tolerance: f64) {
        let n = self.residual.len();
        let (end, masses) = (&self.end, &self.end.masses);
        let apply = |p: &[DVec3]| {
            let moved: Vec<DVec3> = p.iter().map(|&p| dt * p).collect();
            let mut stiffness = vec![DVec3::ZERO; n];
            dynamics.derivative(end_time, end, [&moved, p], &mut stiffness);
            let mut product: Vec<DVec3> = (0..n).map(|i| masses[i] * p[i] - dt * stiffness[i]).collect();
            dynamics.mask(&mut product);
            product
        };
        // Where it is not downhill any more, what has been found so far is used, or the plain explicit step.
        let most = MOST_CG_STEPS.min(6 * n + 6);
        conjugate_gradients(&self.residual, masses, tolerance, most, &mut self.change, apply);
    }
}

impl Integrator for BackwardEuler {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        let end_time = time + dt;
        self.velocities.clone_from(&state.velocities);
        let mut error = self.evaluate(dynamics, state, end_time, dt);
        for _ in 0..MOST_NEWTON_STEPS {
            if error <= TOLERANCE || !error.is_finite() {
                break;
            }
            self.solve(dynamics, end_time, dt, error.clamp(1e-8, 1e-3));
            let before = self.velocities.clone();
            let mut share = 1.0;
            let mut next = f64::INFINITY;
            for _ in 0..MOST_HALVINGS {
                for i in 0..state.len() {
                    self.velocities[i] = before[i] + share * self.change[i];
                }
                next = self.evaluate(dynamics, state, end_time, dt);
                if next < error {
                    break;
                }
                share *= 0.5;
            }
            // Round-off, or a kink of a contact: no step of any length does better.
            let stuck = next >= 0.999 * error;
            error = next;
            if stuck {
                break;
            }
        }
        std::mem::swap(&mut state.positions, &mut self.end.positions);
        std::mem::swap(&mut state.velocities, &mut self.end.velocities);
    }

    fn stable_step(&self, _omega: f64, _damping: f64) -> f64 {
        f64::INFINITY
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        // Its buffers carry nothing from step to step.
        Box::new(Self::default())
    }
}
