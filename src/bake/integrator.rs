//! From the name of an integrator to the integrator.

use crate::scene::IntegratorKind;
use crate::solver::integrators::{
    BackwardEuler, ExplicitEuler, Integrator, LeapFrog, Midpoint, Rk4, SymplecticEuler, Verlet,
};

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
