//! What is held and pushed of one body from outside, and the work that does from one time to the next.

use super::body::Body;
use super::constraint::{PrescribedMotion, held};
use glam::DVec3;

/// A body as far as it is held or pushed from outside, at one time.
#[derive(Clone, Debug, Default)]
pub(super) struct OutsideBody {
    held: Vec<HeldParticle>,
    /// Where forces from outside push on it: places [m], and those forces [N].
    pushed: Vec<[DVec3; 2]>,
}

/// A particle that is held along some axes; of the others all is zero.
#[derive(Clone, Copy, Debug)]
struct HeldParticle {
    mass: f64,
    position: DVec3,
    velocity: DVec3,
    force: DVec3,
}

impl OutsideBody {
    /// All of it at `time` [s].
    pub(super) fn of(body: &Body, time: f64) -> Self {
        Self { held: held_particles(body), pushed: pushed(body, time) }
    }

    /// What its pins hold.
    pub(super) fn held_of(body: &Body) -> Self {
        Self { held: held_particles(body), pushed: Vec::new() }
    }

    /// What forces from outside push on at `time` [s].
    pub(super) fn pushed_of(body: &Body, time: f64) -> Self {
        Self { held: Vec::new(), pushed: pushed(body, time) }
    }

    /// Work [J] from then until `now` by the mean of the forces at both ends: all that a held particle gained in motion and
    /// gave to what it is tied to, and what forces from outside pushed.
    pub(super) fn work_until(&self, now: &Self) -> f64 {
        let of_pins = self.held.iter().zip(&now.held).map(|(a, b)| {
            let gained = 0.5 * a.mass * (b.velocity.length_squared() - a.velocity.length_squared());
            gained - 0.5 * (a.force + b.force).dot(b.position - a.position)
        });
        let of_forces = self.pushed.iter().zip(&now.pushed).map(|([x, f], [y, g])| 0.5 * (*f + *g).dot(*y - *x));
        of_pins.sum::<f64>() + of_forces.sum::<f64>()
    }
}

/// Whether pins move some of a body; those that hold it where it is do no work.
pub(super) fn is_moved(body: &Body) -> bool {
    body.parts().constraints.iter().any(|constraint| constraint.motion != PrescribedMotion::Fixed)
}

fn held_particles(body: &Body) -> Vec<HeldParticle> {
    let (state, constraints) = (body.state(), &body.parts().constraints);
    let held = held(constraints, state.len());
    let held = held.into_iter().enumerate().filter(|(_, axes)| axes.any());
    let particle = |(i, axes)| {
        let part = |v: DVec3| DVec3::select(axes, v, DVec3::ZERO);
        HeldParticle {
            mass: state.masses[i],
            position: part(state.positions[i]),
            velocity: part(state.velocities[i]),
            force: part(body.net_force(i)),
        }
    };
    held.map(particle).collect()
}

fn pushed(body: &Body, time: f64) -> Vec<[DVec3; 2]> {
    let mut working = body.parts().forces.iter().filter(|force| force.does_work()).peekable();
    if working.peek().is_none() {
        return Vec::new();
    }
    let state = body.state();
    let mut sum = vec![DVec3::ZERO; state.len()];
    for force in working {
        force.clone_box().add_forces(time, state, &mut sum);
    }
    state.positions.iter().zip(sum).map(|(&x, force)| [x, force]).collect()
}
