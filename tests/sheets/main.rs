//! Sheets: forces against energies, figures of plates and sandwiches, steps, and what is said of those that do not fit.

#![allow(clippy::print_stdout, reason = "`--nocapture` shows the measured figures")]

mod acting;
mod bars;
mod bending;
#[path = "../physics/common.rs"]
#[allow(dead_code, reason = "the physics tests use the rest of it")]
mod common;
mod gradients;
mod rules;
mod statics;
mod steps;
