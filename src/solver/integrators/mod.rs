//! Integrators: one file an integrator. Any of them steps any body.

mod backward_euler;
mod explicit_euler;
mod integrator;
mod leap_frog;
mod midpoint;
mod rk4;
mod stability;
mod symplectic_euler;
mod verlet;

pub use backward_euler::BackwardEuler;
pub use explicit_euler::ExplicitEuler;
pub use integrator::Integrator;
pub use leap_frog::LeapFrog;
pub use midpoint::Midpoint;
pub use rk4::Rk4;
pub use symplectic_euler::SymplecticEuler;
pub use verlet::Verlet;
