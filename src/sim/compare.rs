//! The same scene under several integrators and steps: what the two-layer paper is for.

use crate::bake::{BakeError, bake};
use crate::scene::{Assets, Extra, IntegratorKind, Manual, Scene, TimeStep};
use crate::solver::body::Body;
use crate::solver::energy::Energies;
use crate::solver::world::World;
use glam::DVec3;

/// A run has blown up once its energy exceeds the first this many times.
const BLOWN_UP: f64 = 100.0;

/// The reference steps this much finer than the finest run, and than its own limit of stability.
const FINER: f64 = 4.0;

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
    /// The scene at the start, every body under `integrator` in steps of `dt` [s].
    ///
    /// # Errors
    /// A scene that cannot be put together.
    pub fn new(scene: &Scene, assets: &Assets, integrator: IntegratorKind, dt: f64) -> Result<Self, BakeError> {
        let mut scene = scene.clone();
        scene.time.step = TimeStep::Manual(Manual { dt, substeps_per_frame: 1, extra: Extra::new() });
        scene.measures.clear();
        scene.all_bodies_mut().for_each(|mut body| *body.integrator_mut() = integrator);
        let mut world = bake(&scene, assets)?.world;
        for index in 0..world.bodies().len() {
            if let Some(body) = world.body_mut(index) {
                body.set_guarded(false);
            }
        }
        let stable_dt = world.bodies().iter().map(|body| body.parts().stable_dt).fold(f64::INFINITY, f64::min);
        let first = first_energy(&scene, &world);
        Ok(Self { world, first, blew_up_at: None, stable_dt })
    }

    /// One step; nothing more happens once it has blown up.
    pub fn step(&mut self) {
        if self.blew_up_at.is_some() {
            return;
        }
        self.world.advance_frame();
        let energy: f64 = self.energies().map(|energies| stored(&energies)).sum();
        let fine = energy <= BLOWN_UP * self.first && self.world.divergence().is_none();
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

    /// Energy scale of the start [J], against which errors and growth are counted.
    pub fn first_energy(&self) -> f64 {
        self.first
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
    energies.total() - energies.gravity - energies.pressure
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

/// A run of classical Runge-Kutta to `seconds` [s] in steps finer than `finest` [s], against which others are held.
///
/// # Errors
/// A scene that cannot be put together.
pub fn reference(scene: &Scene, assets: &Assets, seconds: f64, finest: f64) -> Result<Trial, BakeError> {
    let stable = Trial::new(scene, assets, IntegratorKind::Rk4, finest)?.stable_dt();
    let steps = (seconds * FINER / finest.min(stable)).ceil().max(1.0);
    let mut trial = Trial::new(scene, assets, IntegratorKind::Rk4, seconds / steps)?;
    for _ in 0..steps as u64 {
        trial.step();
    }
    Ok(trial)
}

/// Slope of log(error) over log(step): the order of convergence, by least squares. None with fewer than two points.
pub fn convergence_order(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> = points.iter().map(|(dt, error)| (dt.ln(), error.ln())).collect();
    let n = logs.len() as f64;
    let (mean_x, mean_y) = (logs.iter().map(|p| p.0).sum::<f64>() / n, logs.iter().map(|p| p.1).sum::<f64>() / n);
    let square: f64 = logs.iter().map(|p| (p.0 - mean_x).powi(2)).sum();
    let product: f64 = logs.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum();
    (square > 0.0).then(|| product / square)
}
