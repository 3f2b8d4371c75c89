//! The work that is done on a world from outside over one outer step: by prescribed motions, and by forces such as
//! wind.

use super::body::Body;
use super::outside_body::OutsideBody;
use super::world::World;

/// What is held and pushed of a world at one time, so that the work of that can be told at the next.
#[derive(Clone, Debug)]
pub(crate) struct Outside {
    bodies: Vec<OutsideBody>,
    /// Height of every panel [m], and the force on it from below [N].
    panels: Vec<[f64; 2]>,
    /// Work that colliders and forces that book it themselves have done so far [J].
    booked: f64,
}

impl Outside {
    /// What is held of a world now.
    pub(crate) fn of(world: &World) -> Self {
        let panels = world.panels().iter().enumerate().map(|(index, panel)| [panel.height, world.panel_force(index)]);
        let bodies = world.bodies().iter().map(|body| OutsideBody::of(body, world.time()));
        let booked = world.bodies().iter().map(Body::booked_work).sum();
        Self { bodies: bodies.collect(), panels: panels.collect(), booked }
    }

    /// What of the work on bodies [J] cannot be told from both ends of a step that began at `from` [s], since pins move
    /// them otherwise in between than evenly; next to nothing where steps are short against what moves the pins.
    pub(crate) fn untold_until(&self, now: &Self, world: &World, from: f64) -> f64 {
        let bodies = self.bodies.iter().zip(&now.bodies).zip(world.bodies());
        bodies.map(|((before, now), body)| before.untold_until(now, body, [from, world.time()])).sum()
    }

    /// The work done [J] from then until `now`, by the mean of the forces at both ends: that on the bodies, and what
    /// driven panels and colliders did.
    pub(crate) fn work_until(&self, now: &Self, world: &World) -> f64 {
        let bodies = self.bodies.iter().zip(&now.bodies);
        let of_bodies: f64 = bodies.map(|(before, now)| before.work_until(now).work).sum();
        let panels = world.panels().iter().zip(self.panels.iter().zip(&now.panels));
        let driven = panels.filter(|(panel, _)| panel.driven.is_some());
        of_bodies + (now.booked - self.booked)
            - driven.map(|(_, (a, b))| 0.5 * (a[1] + b[1]) * (b[0] - a[0])).sum::<f64>()
    }
}
