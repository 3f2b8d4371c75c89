//! The comparison of integrators, while one is asked for.

use super::build::guarded;
use crate::scene::{Assets, IntegratorKind, Scene};
use crate::sim::side_by_side::SideBySide;
use crate::sim::status::ComparedRun;
use crate::solver::snapshot::Snapshot;

/// What is to be compared, and how that stands.
#[derive(Default)]
pub(super) struct Comparison {
    integrators: Vec<IntegratorKind>,
    /// Step of all [s].
    dt: f64,
    runs: Option<SideBySide>,
}

impl Comparison {
    /// Chooses what is compared from the next start on, in steps of `dt` [s]; without any integrator nothing is.
    pub(super) fn choose(&mut self, integrators: Vec<IntegratorKind>, dt: f64) {
        (self.integrators, self.dt) = (integrators, dt);
    }

    /// Starts what was chosen from the start of a scene, in place of what ran; nothing where nothing was.
    ///
    /// # Errors
    /// Why the scene cannot be put together.
    pub(super) fn start(&mut self, scene: &Scene, assets: &Assets) -> Result<(), String> {
        self.runs = None;
        if !self.integrators.is_empty() {
            let runs = guarded(|| SideBySide::new(scene, assets, &self.integrators, self.dt))?;
            self.runs = Some(runs.map_err(|error| error.to_string())?);
        }
        Ok(())
    }

    /// Whether runs are compared.
    pub(super) fn is_running(&self) -> bool {
        self.runs.is_some()
    }

    /// Brings all runs forward by so much [s].
    pub(super) fn advance(&mut self, seconds: f64) {
        if let Some(runs) = &mut self.runs {
            runs.advance(seconds);
        }
    }

    /// All runs in one picture, and how each stands; none where none are compared.
    pub(super) fn picture(&self) -> Option<(Snapshot, Vec<ComparedRun>)> {
        self.runs.as_ref().map(|runs| (runs.snapshot(), runs.compared()))
    }
}
