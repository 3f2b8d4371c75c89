//! Running a world: the clock-free [`Runner`] that the command line and the window share, what it reports, and the
//! [`Worker`] thread that paces it for a window.

mod command;
mod compare;
mod recording;
mod report;
mod runner;
mod series;
mod side_by_side;
mod status;
mod study;
mod worker;

pub use command::SimCommand;
pub use compare::{Trial, convergence_order, reference};
pub use recording::DEFAULT_MEMORY;
pub use report::{BodyReport, MeasureReport, Report};
pub use runner::Runner;
pub use series::{Column, ColumnKind, TimeSeries, body_labels};
pub use status::{ComparedRun, ComparedSample, Published, RecordingStatus, Status, Stepping};
pub use study::{Convergence, convergence_study};
pub use worker::{RecordedSeries, Worker};
