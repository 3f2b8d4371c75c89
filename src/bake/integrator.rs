//! From the name of an integrator to the integrator.

use crate::scene::IntegratorKind;
use crate::solver::integrators::{
    BackwardEuler, ExplicitEuler, Integrator, LeapFrog, Midpoint, Rk4, SymplecticEuler, Verlet,
};

/// What `stable_step` says of every integrator, in the order of [`IntegratorKind::ALL`].
pub(super) fn stable_steps(stable_step: impl Fn(&dyn Integrator) -> f64) -> Vec<f64> {
    IntegratorKind::ALL.map(|kind| stable_step(integrator(kind).as_ref())).to_vec()
}

/// The integrator of a kind, as it steps first.
pub(super) fn integrator(kind: IntegratorKind) -> Box<dyn Integrator> {
    match kind {
        IntegratorKind::LeapFrog => Box::new(LeapFrog::default()),
        IntegratorKind::ExplicitEuler => Box::new(ExplicitEuler::default()),
        IntegratorKind::Midpoint => Box::new(Midpoint::default()),
        IntegratorKind::Rk4 => Box::new(Rk4::default()),
        IntegratorKind::SymplecticEuler => Box::new(SymplecticEuler::default()),
        IntegratorKind::Verlet => Box::new(Verlet::default()),
        IntegratorKind::BackwardEuler => Box::new(BackwardEuler::default()),
    }
}
