//! Running a world: the clock-free [`Runner`] that the command line and the window share, and what it reports.

mod compare;
mod report;
mod runner;

pub use compare::{Trial, order, reference};
pub use report::{BodyReport, EnergyReport, MeasureReport, Report};
pub use runner::Runner;
