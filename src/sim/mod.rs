//! Running a world: the clock-free [`Runner`] that the command line and the window share, and what it reports.

mod report;
mod runner;

pub use report::{BodyReport, EnergyReport, MeasureReport, Report};
pub use runner::Runner;
