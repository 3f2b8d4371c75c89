//! The same scene under several integrators, in step and side by side.

use super::status::{ComparedRun, ComparedSample};
use super::study::Study;
use super::trial::Trial;
use crate::bake::{BakeError, BakeStage};
use crate::scene::{Assets, IntegratorKind, Scene};
use crate::solver::snapshot::Snapshot;
use glam::DVec3;
use std::ops::ControlFlow;

/// Room between the runs, as a share of the scene's width.
const GAP: f64 = 0.35;

/// Runs that are advanced together, each with exactly the same step.
pub(super) struct SideBySide {
    runs: Vec<Run>,
    /// From one run's place to the next one's [m].
    pitch: DVec3,
    /// nRT of the gas in the first two-layer body [J].
    gas: f64,
    time: f64,
}

struct Run {
    integrator: IntegratorKind,
    trial: Trial,
    /// The last state before it blew up.
    shown: Snapshot,
}

impl SideBySide {
    /// Every integrator at the start, in steps of `dt` [s]; `progress` hears what is being worked on.
    ///
    /// # Errors
    /// A scene that cannot be put together; [`BakeError::Cancelled`] where `progress` broke off.
    pub(super) fn new(
        scene: &Scene,
        assets: &Assets,
        integrators: &[IntegratorKind],
        dt: f64,
        progress: &mut dyn FnMut(&str, BakeStage) -> ControlFlow<()>,
    ) -> Result<Self, BakeError> {
        let study = Study::with_progress(scene, assets, progress)?;
        let run = |&integrator: &IntegratorKind| {
            let trial = study.trial(integrator, dt);
            let shown = Snapshot::of_particles(trial.world());
            Run { integrator, trial, shown }
        };
        let runs: Vec<Run> = integrators.iter().map(run).collect();
        let points = || runs.iter().flat_map(|run| &run.shown.bodies).flat_map(|body| &body.particles);
        let (low, high) = points()
            .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| (low.min(*point), high.max(*point)));
        let width = (high - low).max(DVec3::ZERO);
        let pitch = DVec3::X * (1.0 + GAP) * if width.x > 0.0 { width.x } else { 1.0 };
        let gas = scene.two_layer.first().map_or(0.0, |body| body.pressure);
        Ok(Self { runs, pitch, gas, time: 0.0 })
    }

    /// Brings every run forward by so much [s], in whole steps. Where `stop` ends that on the way it gives false, and
    /// all goes on from there the next time.
    pub(super) fn advance_unless(&mut self, seconds: f64, stop: &dyn Fn() -> bool) -> bool {
        let end = self.time + seconds;
        for run in &mut self.runs {
            // Half a step of leeway: the sums of both clocks round differently.
            let dt = run.trial.world().plan().frame_seconds;
            while run.trial.blew_up_at().is_none() && run.trial.world().time() + 0.5 * dt < end {
                if stop() {
                    return false;
                }
                run.trial.step();
            }
            if run.trial.blew_up_at().is_none() {
                run.shown = Snapshot::of_particles(run.trial.world());
            }
        }
        self.time = end;
        true
    }

    /// How every run stands.
    pub(super) fn compared(&self) -> Vec<ComparedRun> {
        let compared = |run: &Run| ComparedRun {
            integrator: run.integrator,
            stable_dt: run.trial.stable_dt(),
            blew_up_at: run.trial.blew_up_at(),
            gained: (!run.trial.is_stable()).then(|| run.trial.gained()),
            bodies: run.shown.bodies.len(),
            sample: self.sample(&run.trial),
        };
        self.runs.iter().map(compared).collect()
    }

    fn sample(&self, trial: &Trial) -> ComparedSample {
        let bodies = trial.world().bodies();
        let momentum: DVec3 = bodies
            .iter()
            .map(|body| {
                let state = body.state();
                state.velocities.iter().zip(&state.masses).map(|(v, m)| *v * *m).sum::<DVec3>()
            })
            .sum();
        let volume = bodies.iter().find_map(|body| {
            let surface = body.parts().layers.as_ref()?.outer_surface.as_ref()?;
            Some(surface.volume(&body.state().positions))
        });
        ComparedSample {
            time: trial.world().time(),
            energy: trial.energy(),
            momentum: momentum.length(),
            volume,
            pressure: volume.map(|volume| self.gas / volume),
        }
    }

    /// All runs in one picture, beside each other.
    pub(super) fn snapshot(&self) -> Snapshot {
        let middle = 0.5 * (self.runs.len() as f64 - 1.0);
        let bodies = self.runs.iter().enumerate().flat_map(|(place, run)| {
            let offset = self.pitch * (place as f64 - middle);
            run.shown.bodies.iter().map(move |body| body.moved(offset))
        });
        Snapshot { time: self.time, bodies: bodies.collect(), ..Snapshot::default() }
    }
}
