//! Orders of convergence: errors over steps, against a run that is far finer.

use super::compare::{Trial, convergence_order, reference};
use crate::bake::BakeError;
use crate::scene::{Assets, IntegratorKind, Scene};

/// Errors below this share of the size of the bodies are round-off and say nothing of the order.
const ROUND_OFF: f64 = 1e-11;

/// How the error of an integrator falls with its step.
#[derive(Clone, Debug, PartialEq)]
pub struct Convergence {
    /// The integrator.
    pub integrator: IntegratorKind,
    /// Steps [s] and root mean square position errors [m], steps ascending; runs that blew up are left out.
    pub points: Vec<(f64, f64)>,
    /// Slope of log(error) over log(step); none with fewer than two points.
    pub order: Option<f64>,
}

impl Convergence {
    /// Of errors over steps, in a scene of this size [m]: what is round-off there is left out.
    pub fn of(integrator: IntegratorKind, errors: impl IntoIterator<Item = (f64, f64)>, size: f64) -> Self {
        let mut points: Vec<(f64, f64)> = errors.into_iter().filter(|(_, error)| *error > ROUND_OFF * size).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { integrator, order: convergence_order(&points), points }
    }
}

/// Runs the scene for `seconds` [s] under every integrator with `halvings` steps: `seconds` over `coarsest` steps, over
/// twice as many, and so on, so that every run ends at the same time.
///
/// # Errors
/// A scene that cannot be put together.
pub fn convergence_study(
    scene: &Scene,
    assets: &Assets,
    integrators: &[IntegratorKind],
    seconds: f64,
    coarsest: u32,
    halvings: u32,
) -> Result<Vec<Convergence>, BakeError> {
    let counts: Vec<u32> = (0..halvings.max(1)).rev().map(|k| coarsest.max(1) << k).collect();
    let exact = reference(scene, assets, seconds, seconds / f64::from(counts[0]))?;
    let particles = exact.world().bodies().iter().flat_map(|body| &body.state().positions);
    let size = particles.map(|x| x.length()).fold(0.0, f64::max);
    let errors = |integrator| {
        let mut found = Vec::new();
        for &count in &counts {
            let dt = seconds / f64::from(count);
            let mut trial = Trial::new(scene, assets, integrator, dt)?;
            for _ in 0..count {
                trial.step();
            }
            if trial.blew_up_at().is_none() {
                found.push((dt, trial.position_error(&exact)));
            }
        }
        Ok(Convergence::of(integrator, found, size))
    };
    integrators.iter().map(|&integrator| errors(integrator)).collect()
}
