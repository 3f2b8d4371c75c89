//! The comparison of integrators, while one is asked for.

use super::build::{Tell, unless_stopped};
use crate::scene::{Assets, IntegratorKind, Scene};
use crate::sim::side_by_side::SideBySide;
use crate::sim::status::ComparedRun;
use crate::solver::snapshot::Snapshot;

/// What is to be compared, and how that stands.
#[derive(Default)]
pub(super) struct ComparedRuns {
    integrators: Vec<IntegratorKind>,
    /// Step of all [s].
    dt: f64,
    runs: Option<SideBySide>,
}

/// Puts what was chosen together, from the start of a scene; none where `progress` broke off.
///
/// # Errors
/// Why the scene cannot be put together.
pub(super) fn side_by_side(
    scene: &Scene,
    assets: &Assets,
    (integrators, dt): &(Vec<IntegratorKind>, f64),
    progress: &mut Tell<'_>,
) -> Result<Option<SideBySide>, String> {
    unless_stopped(|| Ok(SideBySide::new(scene, assets, integrators, *dt, progress)))
}

impl ComparedRuns {
    /// Chooses what is compared from the next start on, in steps of `dt` [s]; without any integrator nothing is.
    pub(super) fn choose(&mut self, integrators: Vec<IntegratorKind>, dt: f64) {
        (self.integrators, self.dt) = (integrators, dt);
    }

    /// Ends what ran, and gives what was chosen to be started in its place; none where nothing was.
    pub(super) fn replace(&mut self) -> Option<(Vec<IntegratorKind>, f64)> {
        self.runs = None;
        (!self.integrators.is_empty()).then(|| (self.integrators.clone(), self.dt))
    }

    /// Runs what was put together.
    pub(super) fn start(&mut self, runs: SideBySide) {
        self.runs = Some(runs);
    }

    /// Whether runs are compared.
    pub(super) fn is_running(&self) -> bool {
        self.runs.is_some()
    }

    /// Brings all runs forward by so much [s]; false where `stop` ended that on the way, from where it goes on next
    /// time.
    pub(super) fn advance_unless(&mut self, seconds: f64, stop: &dyn Fn() -> bool) -> bool {
        self.runs.as_mut().is_none_or(|runs| runs.advance_unless(seconds, stop))
    }

    /// All runs in one picture, and how each stands; none where none are compared.
    pub(super) fn picture(&self) -> Option<(Snapshot, Vec<ComparedRun>)> {
        self.runs.as_ref().map(|runs| (runs.snapshot(), runs.compared()))
    }
}
