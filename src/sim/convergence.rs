//! Orders of convergence: how errors fall with the step.

use crate::scene::IntegratorKind;

/// Errors below this share of the size of the bodies are round-off and say nothing of the order.
const ROUND_OFF: f64 = 1e-11;

/// Runs that an order is fitted to: those of the smallest steps, where it shows.
const FITTED: usize = 3;

/// Slope of log(error) over log(step) between two runs below which the finer one has met round-off: no order is that
/// low.
const FLAT: f64 = 0.4;

/// How the error of an integrator falls with its step.
#[derive(Clone, Debug, PartialEq)]
pub struct Convergence {
    /// The integrator.
    pub integrator: IntegratorKind,
    /// Steps [s] and root mean square position errors [m], steps ascending; runs that blew up are left out.
    pub points: Vec<(f64, f64)>,
    /// Slope of log(error) over log(step) at the smallest steps that are not at round-off; none with fewer than two of
    /// them.
    pub order: Option<f64>,
}

impl Convergence {
    /// Of errors over steps, in a scene of this size [m]: what is round-off there is left out.
    pub fn of(integrator: IntegratorKind, errors: impl IntoIterator<Item = (f64, f64)>, size: f64) -> Self {
        let mut points: Vec<(f64, f64)> = errors.into_iter().filter(|(_, error)| *error > ROUND_OFF * size).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let finer =
            points.windows(2).take_while(|pair| convergence_order(pair).is_none_or(|slope| slope < FLAT)).count();
        // Where all are flat, that is what there is to be seen.
        let fitted = if finer + 1 < points.len() { &points[finer..] } else { &points[..] };
        Self { integrator, order: convergence_order(&fitted[..fitted.len().min(FITTED)]), points }
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

#[cfg(test)]
mod tests {
    use super::*;

    fn order(errors: &[(f64, f64)]) -> Option<f64> {
        Convergence::of(IntegratorKind::Rk4, errors.iter().copied(), 1.0).order
    }

    #[test]
    fn the_smallest_steps_that_are_not_at_round_off_tell_the_order() {
        // A large step shows another order, and the smallest ones the rounding.
        let coarse = (0.4, 5e-3);
        let falling = [0.2, 0.1, 0.05].map(|dt: f64| (dt, 1e-2 * dt.powi(4)));
        let rounded = [(0.025, 6.0e-8), (0.0125, 6.1e-8)];
        let all: Vec<(f64, f64)> = [coarse].into_iter().chain(falling).chain(rounded).collect();
        assert!((order(&all).expect("an order") - 4.0).abs() < 1e-9, "{:?}", order(&all));
        assert!((order(&falling).expect("an order") - 4.0).abs() < 1e-9);
        assert!(order(&rounded).expect("a slope").abs() < 0.1, "nothing but rounding");
        assert_eq!(order(&[coarse]), None);
    }
}
