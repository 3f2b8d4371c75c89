//! The same scene under several integrators and steps: what the two-layer paper is for.

use super::convergence::Convergence;
use super::trial::Trial;
use crate::bake::{BakeError, BakeStage, Baked, bake_with_progress};
use crate::scene::{Assets, IntegratorKind, Scene, TimeStep};
use crate::solver::Swing;
use crate::solver::implicit::first_mode;
use std::ops::ControlFlow;

/// The reference steps this much finer than the finest run, and than its own limit of stability.
const FINER: f64 = 4.0;

/// A scene put together once, from which trials under any integrator and step start.
pub struct Study {
    scene: Scene,
    baked: Baked,
}

impl Study {
    /// Puts the scene together.
    ///
    /// # Errors
    /// A scene that cannot be put together.
    pub fn new(scene: &Scene, assets: &Assets) -> Result<Self, BakeError> {
        Self::with_progress(scene, assets, &mut |_, _| ControlFlow::Continue(()))
    }

    /// [`Self::new`], and `progress` hears what is being worked on.
    ///
    /// # Errors
    /// A scene that cannot be put together; [`BakeError::Cancelled`] where `progress` broke off.
    pub(super) fn with_progress(
        scene: &Scene,
        assets: &Assets,
        progress: &mut dyn FnMut(&str, BakeStage) -> ControlFlow<()>,
    ) -> Result<Self, BakeError> {
        // Trials choose their own step, so that one that no automatic choice would take is no obstacle.
        let mut scene = scene.clone();
        scene.time.step = TimeStep::manual(scene.time.frame_seconds(), 1);
        let baked = bake_with_progress(&scene, assets, progress)?;
        Ok(Self::of(scene, baked))
    }

    /// Of what a scene has been put together to.
    pub fn of(scene: Scene, baked: Baked) -> Self {
        Self { scene, baked }
    }

    /// Greatest step [s] that `integrator` is estimated to take.
    pub fn stable_step(&self, integrator: IntegratorKind) -> f64 {
        self.baked.stable_step(integrator)
    }

    /// Slowest swing of the first body around its rest, if something holds it: angular frequency [rad/s], without
    /// damping, gravity and contact.
    pub fn first_mode(&self) -> Option<f64> {
        first_mode(self.baked.world.bodies().first()?.parts())
    }

    /// What `integrator` makes of an undamped swing of `omega` [rad/s] in steps of `dt` [s]; none where it no longer
    /// swings.
    pub fn swing(&self, integrator: IntegratorKind, omega: f64, dt: f64) -> Option<Swing> {
        Baked::swing_under(integrator, omega, dt)
    }

    /// The scene at the start, every body under `integrator` in steps of `dt` [s].
    pub fn trial(&self, integrator: IntegratorKind, dt: f64) -> Trial {
        let world = self.baked.single_stepped(integrator, dt);
        Trial::new(&self.scene, world, self.stable_step(integrator))
    }

    /// A run of classical Runge-Kutta to `seconds` [s] in steps finer than `finest` [s], against which others are held.
    pub fn reference(&self, seconds: f64, finest: f64) -> Trial {
        let stable = self.stable_step(IntegratorKind::Rk4);
        let steps = (seconds * FINER / finest.min(stable)).ceil().max(1.0);
        let mut trial = self.trial(IntegratorKind::Rk4, seconds / steps);
        for _ in 0..steps as u64 {
            trial.step();
        }
        trial
    }

    /// Runs the scene for `seconds` [s] under every integrator with `halvings` steps: `seconds` over `coarsest` steps,
    /// over twice as many, and so on, so that every run ends at the same time.
    pub fn convergence(
        &self,
        integrators: &[IntegratorKind],
        seconds: f64,
        coarsest: u32,
        halvings: u32,
    ) -> Vec<Convergence> {
        let counts: Vec<u32> = (0..halvings.max(1)).rev().map(|k| coarsest.max(1) << k).collect();
        let exact = self.reference(seconds, seconds / f64::from(counts[0]));
        let particles = exact.world().bodies().iter().flat_map(|body| &body.state().positions);
        let size = particles.map(|x| x.length()).fold(0.0, f64::max);
        let of = |&integrator: &IntegratorKind| {
            let error = |&count: &u32| {
                let dt = seconds / f64::from(count);
                let mut trial = self.trial(integrator, dt);
                for _ in 0..count {
                    trial.step();
                }
                trial.blew_up_at().is_none().then(|| (dt, trial.position_error(&exact)))
            };
            Convergence::of(integrator, counts.iter().filter_map(error), size)
        };
        integrators.iter().map(of).collect()
    }
}
