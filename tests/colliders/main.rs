//! Rigid things that bodies touch: scenes in, positions, forces and energies out.

#![allow(clippy::print_stdout, reason = "`--nocapture` shows the measured figures")]

#[path = "../physics/common.rs"]
#[allow(dead_code, reason = "the physics tests use the rest of it")]
mod common;
mod fast;
mod moved;
mod resting;
mod rules;
mod same;
