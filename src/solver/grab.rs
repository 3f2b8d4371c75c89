//! Pulling a body by a point: a damped spring of no rest length from the point to where the pointer is.

use super::body::Body;
use super::embedding::Stencil;
use super::state::ParticleState;
use glam::DVec3;

/// A pull on one embedded point.
#[derive(Clone, Debug, PartialEq)]
pub struct Grab {
    /// The point that is pulled.
    pub point: Stencil,
    /// Where it is pulled to [m], world.
    pub target: DVec3,
    /// Spring stiffness [N/m].
    pub stiffness: f64,
    /// Damping of the point's velocity [N s/m].
    pub damping: f64,
}

/// Angular frequency [rad/s] with which a freely floating body follows the pointer, whatever its mass.
const FOLLOW: f64 = 25.0;

impl Grab {
    /// A pull on a body: by the paper's spring of a two-layer body, or [`Grab::scaled`] for others.
    pub fn on(body: &Body, point: Stencil, target: DVec3) -> Self {
        match &body.parts().layers {
            Some(layers) => Self { point, target, stiffness: layers.drag[0], damping: layers.drag[1] },
            None => Self::scaled(point, target, body.state(), body.parts().dt),
        }
    }

    /// A pull that moves every body alike: stiffness and damping scale with its `mass` [kg], and stay below what a step
    /// of `dt` [s] can take at the point.
    pub fn scaled(point: Stencil, target: DVec3, state: &ParticleState, dt: f64) -> Self {
        let mass = state.mass();
        // Mass that a force on the point has to move at first: 1 / sum phi² / m.
        let yielding: f64 = point.weights.iter().map(|&(k, phi)| phi * phi / state.masses[k as usize]).sum();
        let at_point = 1.0 / yielding;
        Self {
            point,
            target,
            stiffness: (mass * FOLLOW * FOLLOW).min(0.2 * at_point / (dt * dt)),
            damping: (mass * FOLLOW).min(0.2 * at_point / dt),
        }
    }

    /// Adds the pull [N] to the particles' forces.
    pub(super) fn add_forces(&self, state: &ParticleState, forces: &mut [DVec3]) {
        let (x, v) = (self.point.gather(&state.positions), self.point.gather(&state.velocities));
        self.point.scatter(self.stiffness * (self.target - x) - self.damping * v, forces);
    }

    /// Adds the first-order change of the pull [N] under a change of positions and one of velocities.
    pub(super) fn add_derivative(&self, [dx, dv]: [&[DVec3]; 2], out: &mut [DVec3]) {
        self.point.scatter(-self.stiffness * self.point.gather(dx) - self.damping * self.point.gather(dv), out);
    }
}
