//! A scene under one integrator and one step.

use crate::scene::Scene;
use crate::solver::body::Body;
use crate::solver::energy::Energies;
use crate::solver::outside::Outside;
use crate::solver::world::World;
use glam::DVec3;

/// A run has blown up once it has gained this many times the energy that it was ever given.
const BLOWN_UP: f64 = 100.0;

/// Share of the sizes of all energies that may be rounding.
const ROUND_OFF: f64 = 1e-9;

/// Share of the energy of a body that counts as at rest under which it is rounding.
const NOTHING: f64 = 1e-12;

/// A run that has gained more than this share of the energy that it was ever given is not stable.
const GAINS: f64 = 1.0;

/// A scene under one integrator with exactly one step: no sub-stepping, no automatic choice, and no guard that stops a
/// body early.
#[derive(Clone)]
pub struct Trial {
    world: World,
    /// Energy that may be spent from the start on [J].
    spendable: f64,
    /// Sum of all energies at the start [J].
    first: f64,
    outside: Outside,
    /// What was done from outside so far, and the most that this and drives ever had [J].
    work: [f64; 2],
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
        let outside = Outside::of(&world);
        let spendable = spendable(scene, &world);
        let mut trial =
            Self { world, spendable, first: 0.0, outside, work: [0.0; 2], gained: 0.0, blew_up_at: None, stable_dt };
        trial.first = trial.balance().0;
        trial
    }

    /// One step; nothing more happens once it has blown up.
    pub fn step(&mut self) {
        if self.blew_up_at.is_some() {
            return;
        }
        self.world.advance_frame();
        let outside = Outside::of(&self.world);
        self.work[0] += self.outside.work_until(&outside, &self.world);
        let driven: f64 = -self.energies().map(|energies| energies.activation).sum::<f64>();
        self.work[1] = self.work[1].max(self.work[0] + driven);
        self.outside = outside;
        let (energy, size) = self.balance();
        // What is lost to rounding is no gain.
        let gained = (energy - self.first - self.work[0] - ROUND_OFF * size).max(0.0) / self.handled();
        let fine = gained <= BLOWN_UP && self.world.divergence().is_none();
        // A comparison with NaN is false, so that a motion that is no number has blown up too.
        if !fine {
            self.blew_up_at = Some(self.world.time());
        }
        self.gained = self.gained.max(gained);
    }

    /// The greatest energy that the run was given so far [J]: what there was to be spent, and what was done from
    /// outside.
    fn handled(&self) -> f64 {
        (self.spendable + self.work[1]).max(f64::MIN_POSITIVE)
    }

    /// Sum of all energies and of those of panels that fall [J], and of their sizes.
    fn balance(&self) -> (f64, f64) {
        let all = self.energies().flat_map(|energies| energies.values());
        let panels = self.world.panels().iter().filter(|panel| panel.driven.is_none());
        let gravity = self.world.gravity().y;
        let panels = panels.flat_map(|panel| {
            let moving = 0.5 * panel.mass * panel.velocity * panel.velocity;
            [moving, -panel.mass * gravity * panel.height]
        });
        all.chain(panels).fold((0.0, 0.0), |(sum, size), energy| (sum + energy, size + energy.abs()))
    }

    fn energies(&self) -> impl Iterator<Item = Energies> {
        let time = self.world.time();
        self.world.bodies().iter().map(move |body| body.energies(time))
    }

    /// By how much of the energy that the run was ever given it gained at the most, where nothing may be gained.
    pub fn gained(&self) -> f64 {
        self.gained
    }

    /// Whether it neither blew up nor gained more energy than it was ever given.
    pub fn is_stable(&self) -> bool {
        self.blew_up_at.is_none() && self.gained <= GAINS
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
        self.energies().map(|energies| energies.total()).sum()
    }

    fn positions(&self) -> impl Iterator<Item = DVec3> {
        self.world.bodies().iter().flat_map(|body| body.state().positions.iter().copied())
    }

    /// Difference of the energies over the greatest that the reference was given.
    pub fn energy_error(&self, reference: &Self) -> f64 {
        (self.energy() - reference.energy()).abs() / reference.handled()
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

/// The energy that a scene has to spend at the start [J]: motion, strain, contact, gas (nRT), the height of its bodies
/// and panels above the floor, or of bodies above themselves where there is none.
fn spendable(scene: &Scene, world: &World) -> f64 {
    let gravity = DVec3::from_array(scene.gravity);
    let gas: f64 = scene.two_layer.iter().filter(|body| body.shape.dimension() > 1).map(|body| body.pressure).sum();
    let bodies = world.bodies().iter().map(|body| {
        let state = body.state();
        let center = state.center();
        let extent = state.positions.iter().map(|x| x.distance(center)).fold(0.0, f64::max);
        let height = scene.room.floor.map_or(extent, |floor| (center.y - floor).max(extent));
        let energies = body.energies(0.0);
        let stored = energies.total() - energies.gravity - energies.pressure;
        // A body at rest of which nothing is asked has nothing but the rounding of its places.
        let nothing = NOTHING * state.len() as f64 * body.parts().rest_scale.energy;
        stored + state.mass() * gravity.length() * height + nothing
    });
    let floor = scene.room.floor.unwrap_or(0.0);
    let panels = world.panels().iter().filter(|panel| panel.driven.is_none());
    let panels = panels.map(|panel| panel.mass * gravity.length() * (panel.height - floor).abs());
    bodies.sum::<f64>() + panels.sum::<f64>() + gas
}
