//! Integrators: one file an integrator. Any of them steps any body.

mod backward_euler;
mod bdf2;
mod explicit_euler;
mod feynman;
mod fibres_implicit;
mod implicit_midpoint;
mod integrator;
mod leap_frog;
mod midpoint;
mod newmark;
mod rk4;
mod sdirk2;
mod stability;
mod symplectic_euler;
mod tr_bdf2;
mod verlet;

pub(crate) use backward_euler::BackwardEuler;
pub(crate) use bdf2::Bdf2;
pub(crate) use explicit_euler::ExplicitEuler;
pub(crate) use feynman::Feynman;
pub(crate) use fibres_implicit::{FibresImplicit, work_of_a_step};
pub(crate) use implicit_midpoint::ImplicitMidpoint;
pub use integrator::Integrator;
pub(crate) use leap_frog::LeapFrog;
pub(crate) use midpoint::Midpoint;
pub(crate) use newmark::Newmark;
pub(crate) use rk4::Rk4;
pub(crate) use sdirk2::Sdirk2;
pub(crate) use symplectic_euler::SymplecticEuler;
pub(crate) use tr_bdf2::TrBdf2;
pub(crate) use verlet::Verlet;
