//! The work that is done on a world from outside over one outer step: by prescribed motions, and by forces such as wind.

use super::body::Body;
use super::forces::ColliderContact;
use super::world::World;
use glam::DVec3;

/// What is held and pushed of a world at one time, so that the work of that can be told at the next.
#[derive(Clone, Debug)]
pub(crate) struct Outside {
    bodies: Vec<Vec<HeldParticle>>,
    /// Of bodies that forces from outside push on: places [m], and those forces [N].
    pushed: Vec<Vec<[DVec3; 2]>>,
    /// Height of every panel [m], and the force on it from below [N].
    panels: Vec<[f64; 2]>,
    /// Work that colliders have done so far [J].
    by_colliders: f64,
}

/// A particle that is held along some axes; of the others all is zero.
#[derive(Clone, Copy, Debug)]
struct HeldParticle {
    mass: f64,
    position: DVec3,
    velocity: DVec3,
    force: DVec3,
}

impl Outside {
    /// What is held of a world now.
    pub(crate) fn of(world: &World) -> Self {
        let panels = world.panels().iter().enumerate().map(|(index, panel)| [panel.height, world.lift(index)]);
        let pushed = world.bodies().iter().map(|body| pushed(body, world.time()));
        let by_colliders = world.bodies().iter().filter_map(Body::collider_contact).map(ColliderContact::work).sum();
        let bodies = world.bodies().iter().map(held).collect();
        Self { bodies, pushed: pushed.collect(), panels: panels.collect(), by_colliders }
    }

    /// The work done [J] from then until `now`, by the mean of the forces at both ends: all that a held particle gained in
    /// motion and gave to what it is tied to, what forces from outside pushed, and what driven panels and
    /// colliders did.
    pub(crate) fn work_until(&self, now: &Self, world: &World) -> f64 {
        let particles = self.bodies.iter().zip(&now.bodies).flat_map(|(before, now)| before.iter().zip(now));
        let of_pins: f64 = particles
            .map(|(a, b)| {
                let gained = 0.5 * a.mass * (b.velocity.length_squared() - a.velocity.length_squared());
                gained - 0.5 * (a.force + b.force).dot(b.position - a.position)
            })
            .sum();
        let panels = world.panels().iter().zip(self.panels.iter().zip(&now.panels));
        let driven = panels.filter(|(panel, _)| panel.driven.is_some());
        let pushed = self.pushed.iter().zip(&now.pushed).flat_map(|(before, now)| before.iter().zip(now));
        let of_forces: f64 = pushed.map(|([x, f], [y, g])| 0.5 * (*f + *g).dot(*y - *x)).sum();
        let of_colliders = now.by_colliders - self.by_colliders;
        of_pins + of_forces + of_colliders - driven.map(|(_, (a, b))| 0.5 * (a[1] + b[1]) * (b[0] - a[0])).sum::<f64>()
    }
}

fn held(body: &Body) -> Vec<HeldParticle> {
    let (state, constraints) = (body.state(), &body.parts().constraints);
    let held = super::constraint::held(constraints, state.len());
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
