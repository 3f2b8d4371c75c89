//! Running a world: the clock-free [`Runner`] that the command line and the window share, what it reports, and the
//! [`Worker`] thread that paces it for a window.

mod columns;
mod command;
mod convergence;
mod journal;
#[cfg_attr(not(feature = "gui"), allow(dead_code, reason = "the window is who keeps journals"))]
mod journal_line;
mod not_finite;
mod performance;
pub(crate) mod recording;
mod report;
mod runner;
mod series;
mod side_by_side;
mod status;
mod study;
#[cfg_attr(not(feature = "gui"), allow(dead_code, reason = "the window is who takes motions"))]
mod taken;
mod trial;
mod worker;

pub(crate) use columns::body_labels;
pub use columns::{Column, ColumnKind};
pub use command::SimCommand;
pub use convergence::{Convergence, convergence_order};
pub use journal::{Asked, Journal, JournalEntry};
#[cfg(feature = "gui")]
pub(crate) use journal_line::JournalLine;
pub use not_finite::NotFinite;
#[cfg(feature = "gui")]
pub(crate) use recording::DEFAULT_MEMORY;
pub use report::{AccuracyReport, BodyReport, MeasureReport, Report};
pub use runner::Runner;
pub use series::TimeSeries;
pub use status::{ComparedRun, ComparedSample, DriveStatus, PinnedPoint, Published, RecordingStatus, Status, Stepping};
pub use study::Study;
pub use taken::MotionTaker;
#[cfg(feature = "gui")]
pub(crate) use taken::TakenMotion;
pub use trial::Trial;
#[cfg(feature = "gui")]
pub(crate) use worker::JournalTail;
pub use worker::{Rerun, TimeSeriesSet, Worker};
