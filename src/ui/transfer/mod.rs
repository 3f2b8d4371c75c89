//! What leaves the window for other programs and comes from them: motions, clips and pictures out, fibres as lines out
//! and in.
//!
//! How it works. What is asked beforehand is plain data ([`TransferQuestion`]) that a dialog shows. What is written is
//! written by a thread of its own from a copy of the motion that shares its frames with the recording, so that neither
//! the window nor the simulation waits; a line at the foot of the window tells how far it has come.

mod answer;
mod ask;
mod ask_clip;
mod ask_lines;
mod ask_motion;
mod choices;
mod job;
mod motion_preview;
mod question;
mod state;
mod strip;
mod work;

pub(crate) use answer::TransferAnswer;
pub(crate) use ask::ask;
pub(crate) use question::{ClipKind, TransferQuestion};
pub(crate) use state::Transfer;
