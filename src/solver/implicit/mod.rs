//! The whole body implicit: what every implicit integrator steps by.
//!
//! Every stage of such a step asks for the x at which `M ((x - xb) / h - vb) / h = f(x, (x - xb) / h, t)`, with a step
//! h and a base (xb, vb) of its own ([`Stage`]). It is found by chord steps: the matrix
//!
//! ```text
//! A = M / h² + K + D / h,      K = -df/dx,  D = -df/dv,
//! ```
//!
//! is that of one state, factored once for a body and a step, and turned with the particles where they have a matrix
//! that turns, `T A^-1 T^T`. What it is wrong by is left to Anderson's acceleration. K and D are found by moving
//! particles and asking the forces, so that no formula of a force stands here again.
//!
//! - `sparsity`: whose forces hang on whose motion, and which particles may be moved at once;
//! - `stiffness`: K and D by such moves;
//! - `cholesky`: the sparse factor;
//! - `chord`: which matrix is in use, when it is made anew, and the chord step;
//! - `anderson`: the acceleration;
//! - `solver`: a stage, solved or given up;
//! - `balance`: what a step must not have gained;
//! - `stepper`: what becomes of a step with a stage that was given up.
//!
//! The same matrix tells a body's slowest swing (`first_mode`).

mod anderson;
mod balance;
mod cholesky;
mod chord;
mod first_mode;
mod solver;
mod sparsity;
mod stage;
mod stepper;
mod stiffness;

pub(crate) use first_mode::first_mode;
pub(super) use solver::StageSolver;
pub(super) use stage::{Stage, Unconverged};
pub(super) use stepper::Stepper;
