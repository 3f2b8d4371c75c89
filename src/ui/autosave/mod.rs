//! Nothing is lost: changes are saved or given up only when that is asked for, a document outlives the program, and
//! what other programs do to its file is noticed.

mod ask;
mod offer;
mod question;
mod recorder;
mod requests;
mod state;
mod thread;

pub(crate) use ask::{About, ask};
pub(crate) use offer::RecoveryOffer;
pub(crate) use question::{Loss, Question, Reply};
pub(crate) use recorder::RecordingOffer;
pub(crate) use state::Autosave;
