//! Patterns: layouts of fibres, shown with what they do, fitted to the body and added to it as fibres.

mod ask;
mod keep;
mod own;
mod panel;
mod question;
mod state;
mod tiles;

pub(crate) use ask::ask;
pub(crate) use question::PatternQuestion;
pub(crate) use state::Patterns;
