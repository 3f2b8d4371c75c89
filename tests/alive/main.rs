//! Fibres that act and parameters that change in time.

#![allow(clippy::print_stdout, reason = "`--nocapture` shows the measured figures")]

mod bits;
mod blown;
#[path = "../physics/common.rs"]
#[allow(dead_code, reason = "the physics tests use the rest of it")]
mod common;
mod edits;
mod fibres;
mod follows;
mod follows_chosen;
mod follows_softly;
mod greeting;
mod moved;
mod pitfalls;
mod rig;
mod rules;
mod scenes;
mod steps;
mod thickening;
mod turning;
