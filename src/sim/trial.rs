//! A scene under one integrator and one step.

use crate::scene::Scene;
use crate::solver::body::Body;
use crate::solver::energy::Energies;
use crate::solver::outside::Outside;
use crate::solver::panel::Panel;
use crate::solver::world::World;
use glam::DVec3;

/// A run has blown up once it has gained this many times the energy that it ever handled.
const BLOWN_UP: f64 = 100.0;

/// Share of the sizes of all energies that may be rounding.
const ROUND_OFF: f64 = 1e-9;

/// Share of the energy of a body that counts as at rest under which it is rounding.
const NOTHING: f64 = 1e-12;

/// Share of a body's weight times half its extent that it is taken to handle at least.
const WEIGHT: f64 = 0.01;

/// A run that has gained more than this share of the energy that it ever handled is not stable.
const GAINS: f64 = 1.0;

/// A scene under one integrator with exactly one step: no sub-stepping, no automatic choice, and no guard that stops a
/// body early.
#[derive(Clone)]
pub struct Trial {
    world: World,
    /// Potentials that count from anywhere, at the start [J]: gravity and gas of every body, and the heights of panels.
    start: Vec<f64>,
    /// The least that bodies are taken to handle [J].
    least: f64,
    outside: Outside,
    /// What was done from outside so far [J].
    work: f64,
    /// What of that cannot be told, since a step is too long for what moves the pins [J].
    untold: f64,
    /// The least that the energy less that work ever was [J].
    lowest: f64,
    /// The most energy that was handled so far [J], what was gained left out.
    handled: f64,
    /// The most that was gained so far [J].
    gained: f64,
    blew_up_at: Option<f64>,
    stable_dt: f64,
}

impl Trial {
    /// A start. `scene` is what `world` was made of, `stable_dt` [s] the greatest step that its integrator takes.
    pub(super) fn new(scene: &Scene, mut world: World, stable_dt: f64) -> Self {
        for index in 0..world.bodies().len() {
            if let Some(body) = world.body_mut(index) {
                body.set_guarded(false);
            }
        }
        let gravity = DVec3::from_array(scene.gravity).length();
        let (outside, least) = (Outside::of(&world), least(gravity, &world));
        let mut trial = Self {
            world,
            start: Vec::new(),
            least,
            outside,
            work: 0.0,
            untold: 0.0,
            lowest: 0.0,
            handled: 0.0,
            gained: 0.0,
            blew_up_at: None,
            stable_dt,
        };
        trial.start = trial.loose_potentials(&trial.energies());
        let Look { balance, handled, .. } = trial.look();
        (trial.lowest, trial.handled) = (balance, handled);
        trial
    }

    /// One step; nothing more happens once it has blown up.
    pub fn step(&mut self) {
        if self.blew_up_at.is_some() {
            return;
        }
        let from = self.world.time();
        self.world.advance_frame();
        let outside = Outside::of(&self.world);
        self.untold += self.outside.untold_until(&outside, &self.world, from);
        self.work += self.outside.work_until(&outside, &self.world);
        self.outside = outside;
        let Look { balance, handled, size } = self.look();
        self.lowest = self.lowest.min(balance);
        // What is lost to rounding, or may be work, is no gain; a motion that is no number has gained without end.
        let risen = balance - self.lowest - ROUND_OFF * size - self.untold;
        let gained = if balance.is_finite() { risen.max(0.0) } else { f64::INFINITY };
        self.handled = self.handled.max(handled - gained);
        self.gained = self.gained.max(gained);
        if self.gained() > BLOWN_UP || self.world.divergence().is_some() {
            self.blew_up_at = Some(self.world.time());
        }
    }

    /// Sees the energies as they are now.
    fn look(&self) -> Look {
        let moving = |panel: &Panel| 0.5 * panel.mass * panel.velocity * panel.velocity;
        let panels: f64 = self.falling().map(moving).sum();
        let all = self.energies();
        let anywhere = self.loose_potentials(&all);
        let changes = anywhere.iter().zip(&self.start).map(|(now, start)| (now - start).abs());
        let mut look =
            Look { balance: panels - self.work, handled: self.least + panels + changes.sum::<f64>(), size: panels };
        for energies in all {
            let own = Energies { gravity: 0.0, pressure: 0.0, activation: 0.0, ..energies };
            look.balance += energies.total();
            look.handled += own.values().iter().map(|energy| energy.abs()).sum::<f64>();
            look.size += energies.values().iter().map(|energy| energy.abs()).sum::<f64>();
        }
        let heights = &anywhere[2 * self.world.bodies().len()..];
        look.balance += heights.iter().sum::<f64>();
        look.size += heights.iter().map(|energy| energy.abs()).sum::<f64>();
        look
    }

    /// Potentials that count from anywhere [J]: gravity and gas of every body, then the heights of panels that fall.
    fn loose_potentials(&self, energies: &[Energies]) -> Vec<f64> {
        let gravity = self.world.gravity().y;
        let of_bodies = energies.iter().flat_map(|energies| [energies.gravity, energies.pressure]);
        of_bodies.chain(self.falling().map(|panel| -panel.mass * gravity * panel.height)).collect()
    }

    fn falling(&self) -> impl Iterator<Item = &Panel> {
        self.world.panels().iter().filter(|panel| panel.driven.is_none())
    }

    fn energies(&self) -> Vec<Energies> {
        let time = self.world.time();
        self.world.bodies().iter().map(|body| body.energies(time)).collect()
    }

    /// What the energy less the work from outside has risen by at the most, where nothing may be gained, over the most
    /// energy that the run ever handled: that of motion, and by how much potentials have changed.
    pub fn gained(&self) -> f64 {
        self.gained / self.handled.max(f64::MIN_POSITIVE)
    }

    /// Whether it neither blew up nor gained more energy than it ever handled.
    pub fn is_stable(&self) -> bool {
        self.blew_up_at.is_none() && self.gained() <= GAINS
    }

    /// The world as it stands.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// When it blew up [s].
    pub fn blew_up_at(&self) -> Option<f64> {
        self.blew_up_at
    }

    /// Greatest step that the integrator is estimated to take [s].
    pub fn stable_dt(&self) -> f64 {
        self.stable_dt
    }

    /// Force evaluations of all bodies.
    pub fn evaluations(&self) -> u64 {
        self.world.bodies().iter().map(Body::evaluations).sum()
    }

    /// Total energy [J].
    pub fn energy(&self) -> f64 {
        self.energies().iter().map(Energies::total).sum()
    }

    fn positions(&self) -> impl Iterator<Item = DVec3> {
        self.world.bodies().iter().flat_map(|body| body.state().positions.iter().copied())
    }

    /// Difference of the energies over the greatest that the reference handled.
    pub fn energy_error(&self, reference: &Self) -> f64 {
        (self.energy() - reference.energy()).abs() / reference.handled.max(f64::MIN_POSITIVE)
    }

    /// Root mean square distance of the particles from those of the reference [m].
    pub fn position_error(&self, reference: &Self) -> f64 {
        let (sum, count) = self
            .positions()
            .zip(reference.positions())
            .fold((0.0, 0_usize), |(sum, count), (a, b)| (sum + a.distance_squared(b), count + 1));
        (sum / count.max(1) as f64).sqrt()
    }
}

/// What is seen of a run at one time [J].
struct Look {
    /// All energies less the work that was done from outside.
    balance: f64,
    /// Energy of motion and all potentials, those that count from anywhere by their change since the start.
    handled: f64,
    /// Sizes of all energies, of which the balance has its rounding.
    size: f64,
}

/// What bodies are taken to handle at least [J], under a pull of so many m/s²: below it, what comes of contact with
/// what they lie on and of the rounding of their places is nothing.
fn least(gravity: f64, world: &World) -> f64 {
    let of = |body: &Body| {
        let state = body.state();
        let center = state.center();
        let extent = state.positions.iter().map(|x| x.distance(center)).fold(0.0, f64::max);
        let nothing = NOTHING * state.len() as f64 * body.parts().rest_scale.energy;
        WEIGHT * state.mass() * gravity * extent + nothing
    };
    world.bodies().iter().map(of).sum()
}
