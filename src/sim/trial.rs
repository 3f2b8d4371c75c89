//! A scene under one integrator and one step.

use crate::scene::Scene;
use crate::solver::body::Body;
use crate::solver::energy::Energies;
use crate::solver::world::World;
use glam::DVec3;

/// A run has blown up once its energy exceeds the first this many times.
const BLOWN_UP: f64 = 100.0;

/// A scene under one integrator with exactly one step: no sub-stepping, no automatic choice, and no guard that stops a
/// body early.
#[derive(Clone)]
pub struct Trial {
    world: World,
    first: f64,
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
        let first = first_energy(scene, &world);
        Self { world, first, blew_up_at: None, stable_dt }
    }

    /// One step; nothing more happens once it has blown up.
    pub fn step(&mut self) {
        if self.blew_up_at.is_some() {
            return;
        }
        self.world.advance_frame();
        let sum = |of: fn(&Energies) -> f64| self.energies().map(|energies| of(&energies)).sum::<f64>();
        // What drives have put in may be there, too.
        let most = BLOWN_UP * (self.first - sum(|energies| energies.activation).min(0.0));
        let fine = sum(stored) <= most && self.world.divergence().is_none();
        // A comparison with NaN is false, so that a motion that is no number has blown up too.
        if !fine {
            self.blew_up_at = Some(self.world.time());
        }
    }

    fn energies(&self) -> impl Iterator<Item = Energies> {
        let time = self.world.time();
        self.world.bodies().iter().map(move |body| body.energies(time))
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

    /// Difference of the energies over the energy of the start.
    pub fn energy_error(&self, reference: &Self) -> f64 {
        (self.energy() - reference.energy()).abs() / self.first
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

/// What grows when a run blows up [J].
fn stored(energies: &Energies) -> f64 {
    energies.total() - energies.gravity - energies.pressure - energies.activation
}

/// The energy that a scene has to spend at the start [J]: motion, strain, contact, gas (nRT) and the height of its
/// bodies above the floor, or above themselves where there is none.
fn first_energy(scene: &Scene, world: &World) -> f64 {
    let gravity = DVec3::from_array(scene.gravity);
    let gas: f64 = scene.two_layer.iter().filter(|body| body.shape.dimension() > 1).map(|body| body.pressure).sum();
    let bodies = world.bodies().iter().map(|body| {
        let state = body.state();
        let center = state.center();
        let extent = state.positions.iter().map(|x| x.distance(center)).fold(0.0, f64::max);
        let height = scene.room.floor.map_or(extent, |floor| (center.y - floor).max(extent));
        stored(&body.energies(0.0)) + state.mass() * gravity.length() * height
    });
    let first = bodies.sum::<f64>() + gas;
    if first > 0.0 { first } else { 1.0 }
}
