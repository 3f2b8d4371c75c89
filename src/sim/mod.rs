//! Running a world: the clock-free [`Runner`] that the command line and the window share, what it reports, and the
//! [`Worker`] thread that paces it for a window.

mod command;
mod report;
mod runner;
mod worker;

pub use command::SimCommand;
pub use report::{BodyReport, EnergyReport, MeasureReport, Report};
pub use runner::Runner;
pub use worker::{Published, Status, Worker};
