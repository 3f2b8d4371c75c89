//! Integrators: one file an integrator. Any of them steps any body.

mod backward_euler;
mod explicit_euler;
mod fibres_implicit;
mod integrator;
mod leap_frog;
mod midpoint;
mod rk4;
mod stability;
mod symplectic_euler;
mod verlet;

pub(crate) use backward_euler::BackwardEuler;
pub(crate) use explicit_euler::ExplicitEuler;
pub(crate) use fibres_implicit::{FibresImplicit, work_of_a_step};
pub use integrator::Integrator;
pub(crate) use leap_frog::LeapFrog;
pub(crate) use midpoint::Midpoint;
pub(crate) use rk4::Rk4;
pub(crate) use symplectic_euler::SymplecticEuler;
pub(crate) use verlet::Verlet;
