//! The balance of a world is watched as it goes: of every body by itself, what others give it counted as from outside,
//! and of all together, where contact between them shows.
//!
//! The energies of a fibre solid take several times as long as its forces, so that they are looked at only after so
//! many evaluations that the time does not count, and at the end of a run. Nothing of the motion hangs on it, but that
//! one that has gained beyond all measure is stopped.

use super::World;
use super::watched::{Accuracy, Watch, Watched};
use crate::solver::account::BalanceSample;
use crate::solver::body::Body;
use crate::solver::energy::Energies;
use crate::solver::momentum::{Momenta, momenta};
use crate::solver::state::ParticleState;
use crate::solver::unbalanced::Unbalanced;
use glam::DVec3;

/// Looks take up at most this share of the time of a run.
const COST: f64 = 0.01;

/// Evaluations of the forces that a look at a fibre solid takes as long as.
const OF_A_SOLID: f64 = 6.0;

/// A look at so few particles, times the evaluations that it takes as long as, is not worth counting: as many
/// microseconds, a few, for each of a second's frames.
const FEW: f64 = 600.0;

/// Evaluations of the forces that one of an implicit step takes as long as, with what is solved besides.
const IMPLICIT: f64 = 6.0;

/// Share of a body's weight times half its extent that no gain is looked for under.
const WEIGHT: f64 = 0.01;

/// Share of the energy of a body that counts as at rest under which it is rounding.
const NOTHING: f64 = 1e-12;

impl World {
    /// Takes note of where a frame begins.
    pub(super) fn begin_watch(&mut self) {
        for body in &mut self.bodies {
            body.count_grabs();
        }
        if self.watch.bodies.len() != self.bodies.len() {
            self.start_watch();
        }
        let (time, seconds) = (self.time(), self.plan.frame_seconds);
        let mut all_alone = self.panels.is_empty();
        for (body, watched) in self.bodies.iter().zip(&mut self.watch.bodies) {
            let is_alone = body.is_watched() && body.is_alone(time, seconds);
            all_alone &= is_alone;
            watched.given = body.given().momenta;
            watched.drift.begin(is_alone.then(|| momenta(body.state())));
        }
        self.watch.drift.begin((all_alone && self.bodies.len() > 1).then(|| self.momenta()));
    }

    fn start_watch(&mut self) {
        let (time, pull) = (self.time(), self.gravity.acceleration.length());
        let watched = |body: &Body| {
            let (state, energies) = (body.state(), body.energies(time));
            let center = state.center();
            let extent = state.positions.iter().map(|x| x.distance(center)).fold(0.0, f64::max);
            let nothing = NOTHING * state.len() as f64 * body.parts().rest_scale.energy;
            let least = WEIGHT * state.mass() * pull * extent + nothing;
            Watched { from: [energies.gravity, energies.pressure], least, ..Watched::default() }
        };
        self.watch = Watch { bodies: self.bodies.iter().map(watched).collect(), ..Watch::default() };
        self.look();
    }

    /// Sees where a frame has ended.
    pub(super) fn end_watch(&mut self) {
        let (time, seconds) = (self.time(), self.plan.frame_seconds);
        let pull = self.gravity.at(time);
        for (body, watched) in self.bodies.iter().zip(&mut self.watch.bodies) {
            if !watched.drift.is_followed() {
                continue;
            }
            let is_alone = body.is_watched() && body.is_alone(time, seconds);
            let given = body.given().momenta;
            let [linear, angular] = [given[0] - watched.given[0], given[1] - watched.given[1]];
            let by_gravity = seconds * body.state().mass() * pull;
            let now = is_alone.then(|| momenta(body.state()));
            watched.drift.end(seconds, now, [linear + by_gravity, angular]);
        }
        if self.watch.drift.is_followed() {
            let all_alone = self.bodies.iter().all(|body| body.is_watched() && body.is_alone(time, seconds));
            let mass: f64 = self.bodies.iter().map(|body| body.state().mass()).sum();
            let linear = seconds * mass * pull;
            // The centre of all falls along a parabola: its mean over the frame.
            let moments = self.bodies.iter().map(|body| body.state().mass() * body.state().center());
            let [center, momentum] = [moments.sum::<DVec3>() / mass, self.momenta()[0]];
            let mean = center - 0.5 * seconds * momentum / mass + seconds * seconds / 6.0 * pull;
            let now = all_alone.then(|| self.momenta());
            self.watch.drift.end(seconds, now, [linear, mean.cross(linear)]);
        }
        let look = self.effort_of_a_look();
        if look <= FEW || COST * (self.effort() - self.watch.looked_at) >= look {
            self.look();
        }
    }

    /// Evaluations of the forces that a look takes as long as, times particles.
    fn effort_of_a_look(&self) -> f64 {
        let of = |body: &Body| {
            let each = if body.parts().layers.is_some() { 1.0 } else { OF_A_SOLID };
            each * body.state().len() as f64
        };
        self.bodies.iter().map(of).sum()
    }

    /// Linear momentum and angular momentum about the origin of all bodies.
    fn momenta(&self) -> Momenta {
        let states = || self.bodies.iter().map(Body::state);
        [states().map(ParticleState::linear_momentum).sum(), states().map(ParticleState::angular_momentum).sum()]
    }

    /// Evaluations of the forces so far, times particles.
    fn effort(&self) -> f64 {
        let of = |body: &Body| {
            let each = if body.parts().stable_dt.is_finite() { 1.0 } else { IMPLICIT };
            each * body.evaluations() as f64 * body.state().len() as f64
        };
        self.bodies.iter().map(of).sum()
    }

    /// Looks at the balance of energy and work now. It is done from time to time as frames go by; whoever ends a run
    /// does it once more.
    pub fn look(&mut self) {
        if self.watch.bodies.len() != self.bodies.len() {
            return;
        }
        let _look = tracing::info_span!("look").entered();
        self.watch.looked_at = self.effort();
        let time = self.time();
        let mut of_all =
            BalanceSample { time, balance: self.energy_of_panels() - self.work(), handled: 0.0, sizes: 0.0 };
        let is_whole = self.bodies.iter().all(Body::is_watched);
        for index in 0..self.bodies.len() {
            let (body, watched) = (&self.bodies[index], &mut self.watch.bodies[index]);
            if !body.is_watched() {
                continue;
            }
            let energies = body.energies(time);
            let given = body.given();
            let [gravity, pressure] = [energies.gravity - watched.from[0], energies.pressure - watched.from[1]];
            let own = Energies { gravity, pressure, activation: 0.0, ..energies };
            let handled = watched.least + own.values().iter().map(|energy| energy.abs()).sum::<f64>();
            let sizes = energies.values().iter().map(|energy| energy.abs()).sum();
            of_all.balance += energies.total() - given.by_hand;
            of_all.handled += handled;
            of_all.sizes += sizes;
            let work = self.work.on_itself(index) + body.booked_work() + given.by_others + given.by_hand;
            let balance = energies.total() - body.contact_with_others() - work;
            watched.account.look(BalanceSample { time, balance, handled, sizes });
            if watched.account.is_unbalanced(0.0) && !watched.is_told {
                watched.is_told = true;
                self.watch.found.push(Unbalanced::of_body(body, time, &watched.account));
            }
            if watched.account.is_beyond(0.0) {
                let (cause, remedy) = Unbalanced::of_body(body, time, &watched.account).as_stop();
                self.bodies[index].stop(time, cause, remedy);
            }
        }
        let meets = self.bodies.len() > 1 || !self.panels.is_empty();
        if is_whole && meets && self.divergence().is_none() {
            self.look_at_all(of_all);
        }
    }

    fn look_at_all(&mut self, now: BalanceSample) {
        self.watch.whole.look(now);
        let Some(body) = self.bodies.first() else { return };
        // What bodies gain by themselves is said of them.
        let own: f64 = self.watch.bodies.iter().map(|watched| watched.account.excess()[0]).sum();
        if self.watch.whole.is_unbalanced(own) && !self.watch.is_told_of_whole {
            self.watch.is_told_of_whole = true;
            self.watch.found.push(Unbalanced::of_contact(body, now.time, &self.watch.whole));
        }
        if self.watch.whole.is_beyond(own) {
            let (cause, remedy) = Unbalanced::of_contact(body, now.time, &self.watch.whole).as_stop();
            for body in &mut self.bodies {
                body.stop(now.time, cause.clone(), remedy.clone());
            }
        }
    }

    /// What was found to have gained energy that nothing gave it, in the order of time.
    pub fn unbalanced(&self) -> &[Unbalanced] {
        &self.watch.found
    }

    /// How accurate the motion of a body, by its index, has been; none before it has moved.
    pub fn accuracy_of(&self, body: usize) -> Option<Accuracy> {
        let watched = self.watch.bodies.get(body)?;
        self.bodies.get(body)?.is_watched().then(|| Accuracy::of(&watched.account, &watched.drift))
    }

    /// How accurate the motion of all has been, contact between bodies and with panels included; none before they have
    /// moved, and where there is but one body and no panel.
    pub fn accuracy(&self) -> Option<Accuracy> {
        let meets = self.bodies.len() > 1 || !self.panels.is_empty();
        let is_watched = !self.watch.bodies.is_empty() && self.bodies.iter().all(Body::is_watched);
        (meets && is_watched).then(|| Accuracy::of(&self.watch.whole, &self.watch.drift))
    }
}
