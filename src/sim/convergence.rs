//! Orders of convergence: how errors fall with the step.

use crate::scene::IntegratorKind;

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

/// Slope of log(error) over log(step): the order of convergence, by least squares. None with fewer than two points.
pub fn convergence_order(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> = points.iter().map(|(dt, error)| (dt.ln(), error.ln())).collect();
    let n = logs.len() as f64;
    let (mean_x, mean_y) = (logs.iter().map(|p| p.0).sum::<f64>() / n, logs.iter().map(|p| p.1).sum::<f64>() / n);
    let square: f64 = logs.iter().map(|p| (p.0 - mean_x).powi(2)).sum();
    let product: f64 = logs.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum();
    (square > 0.0).then(|| product / square)
}
