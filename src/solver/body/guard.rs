//! What stops a body before numbers that mean nothing spread.

use super::divergence::Divergence;
use super::{Body, BodyParts};
use crate::solver::state::ParticleState;
use glam::DVec3;

impl Body {
    /// Stops the body before numbers that are no longer meaningful spread.
    pub(super) fn guard(&mut self, time: f64) {
        let ParticleState { velocities, .. } = &self.parts.state;
        let mean = velocities.iter().sum::<DVec3>() / velocities.len() as f64;
        let fastest = velocities.iter().map(|v| (*v - mean).length_squared()).fold(0.0, f64::max).sqrt();
        let finite = mean.is_finite() && fastest.is_finite();
        let fault = self.parts.forces.iter().find_map(|force| force.fault(&self.parts.state));
        let cause = match fault {
            _ if !finite => "a velocity is no longer a number".to_owned(),
            Some(fault) => fault.to_owned(),
            None if self.guarded && fastest * self.parts.resolved_dt() > self.parts.reach => {
                format!("a particle reached {fastest:.3e} m/s")
            }
            None => return,
        };
        let BodyParts { dt, stable_dt, step_parameter, limited_by, .. } = &self.parts;
        let or = limited_by.as_ref().map_or(String::new(), |parameter| format!(", or {parameter}, which sets it"));
        let remedy = if dt > stable_dt {
            format!("its time step {dt:.3e} s is beyond the stable {stable_dt:.3e} s: lower {step_parameter}{or}")
        } else if limited_by.is_some() {
            format!(
                "its stable step was {stable_dt:.3e} s at rest: lower {step_parameter}{or}, or soften what drives the body"
            )
        } else {
            format!("lower {step_parameter}, raise the damping, or soften what drives it")
        };
        self.stop(time, cause, remedy);
    }

    /// Stops it in its last good state.
    pub(in crate::solver) fn stop(&mut self, time: f64, cause: String, remedy: String) {
        self.parts.state.clone_from(&self.last_good);
        self.divergence = Some(Divergence { body: self.parts.name.clone(), time, cause, remedy });
    }
}
