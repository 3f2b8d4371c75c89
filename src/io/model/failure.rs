//! Why a model cannot be read.

use crate::io::IoError;
use std::fmt::Display;

/// Why a file cannot be understood.
#[derive(Debug)]
pub(super) enum Failure {
    /// What it holds makes no sense.
    Content(String),
    /// A file that it refers to.
    Other(IoError),
}

impl Failure {
    pub(super) fn new(problem: impl Display) -> Self {
        Self::Content(problem.to_string())
    }
}
