//! What is held and pushed of one body from outside, and the work that does from one time to the next.

use super::body::Body;
use super::constraint::{PrescribedMotion, held};
use super::forces::Force;
use glam::DVec3;

/// Parts of a step between which it is looked where pins hold what they hold.
const SEEN_BETWEEN: u8 = 4;

/// A body as far as it is held or pushed from outside, at one time.
#[derive(Clone, Debug, Default)]
pub(super) struct OutsideBody {
    held: Vec<HeldParticle>,
    /// Whether the forces on what is held are of this very state, not of one on the way to it.
    is_current: bool,
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
    /// What of the force is of other bodies and panels [N].
    of_others: DVec3,
}

/// Work [J] that was done on a body from outside.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct WorkOnBody {
    /// All of it.
    pub(super) work: f64,
    /// What of that pins have passed on to other bodies and panels.
    pub(super) passed_on: f64,
}

impl WorkOnBody {
    /// Adds what was done on.
    pub(super) fn add(&mut self, more: Self) {
        self.work += more.work;
        self.passed_on += more.passed_on;
    }
}

impl OutsideBody {
    /// All of it at `time` [s].
    pub(super) fn of(body: &Body, time: f64) -> Self {
        Self { pushed: pushed(body, time), ..Self::held_of(body) }
    }

    /// What its pins hold.
    pub(super) fn held_of(body: &Body) -> Self {
        Self { held: held_particles(body), is_current: body.is_current(), pushed: Vec::new() }
    }

    /// What forces from outside push on at `time` [s].
    pub(super) fn pushed_of(body: &Body, time: f64) -> Self {
        Self { pushed: pushed(body, time), ..Self::default() }
    }

    /// Work [J] from then until `now`: all that a held particle gained in motion and gave to what it is tied to, and
    /// what forces from outside pushed. By the mean of the forces at both ends, or by those on the way where an
    /// integrator leaves these.
    pub(super) fn work_until(&self, now: &Self) -> WorkOnBody {
        let mut done = WorkOnBody::default();
        for (a, b) in self.held.iter().zip(&now.held) {
            let gained = 0.5 * a.mass * (b.velocity.length_squared() - a.velocity.length_squared());
            let between = |a: DVec3, b: DVec3| if now.is_current { 0.5 * (a + b) } else { b };
            let moved = b.position - a.position;
            done.work += gained - between(a.force, b.force).dot(moved);
            done.passed_on -= between(a.of_others, b.of_others).dot(moved);
        }
        done.work +=
            self.pushed.iter().zip(&now.pushed).map(|([x, f], [y, g])| 0.5 * (*f + *g).dot(*y - *x)).sum::<f64>();
        done
    }

    /// What of the work [J] on what pins hold cannot be told from both ends of a step, the times [s] of which are
    /// given, since they move it otherwise in between than evenly: the forces at the ends times how far off it is.
    pub(super) fn untold_until(&self, now: &Self, body: &Body, [from, to]: [f64; 2]) -> f64 {
        if !is_moved(body) {
            return 0.0;
        }
        let constraints = &body.parts().constraints;
        let axes = held(constraints, body.state().len());
        let mut off = vec![0.0_f64; self.held.len()];
        let mut between = body.state().clone();
        for k in 1..SEEN_BETWEEN {
            let share = f64::from(k) / f64::from(SEEN_BETWEEN);
            for constraint in constraints {
                constraint.apply(from + share * (to - from), &mut between);
            }
            let places = axes.iter().zip(&between.positions).filter(|(axes, _)| axes.any());
            let ends = self.held.iter().zip(&now.held);
            for ((off, (axes, place)), (a, b)) in off.iter_mut().zip(places).zip(ends) {
                let place = DVec3::select(*axes, *place, DVec3::ZERO);
                *off = off.max(place.distance(a.position.lerp(b.position, share)));
            }
        }
        let forces = self.held.iter().zip(&now.held).map(|(a, b)| a.force.length() + b.force.length());
        forces.zip(off).map(|(force, off)| force * off).sum()
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
            of_others: part(body.external_force(i)),
        }
    };
    held.map(particle).collect()
}

fn pushed(body: &Body, time: f64) -> Vec<[DVec3; 2]> {
    let books_itself = |force: &dyn Force| force.outside_work().is_some();
    let forces = body.parts().forces.iter();
    let mut working = forces.filter(|force| force.does_work() && !books_itself(&***force)).peekable();
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
