//! Why a model cannot be read.

use crate::io::IoError;
use std::fmt::Display;

/// How much is missing, for a message.
pub(super) fn missing(bytes: usize) -> String {
    if bytes == 1 { "1 byte is missing".to_owned() } else { format!("{bytes} bytes are missing") }
}

/// What helps where nothing better is known.
const EXPORT_AGAIN: &str = "export it again, or in another format";

/// Why a file cannot be understood.
#[derive(Debug)]
pub(super) enum Failure {
    /// What it holds makes no sense.
    Content {
        /// What is wrong, and where.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// A file that it refers to.
    Other(IoError),
}

impl Failure {
    pub(super) fn new(problem: impl Display) -> Self {
        Self::with(problem, EXPORT_AGAIN)
    }

    /// Where something else helps than to export the file again.
    pub(super) fn with(problem: impl Display, remedy: impl Display) -> Self {
        Self::Content { problem: problem.to_string(), remedy: remedy.to_string() }
    }

    /// The same failure with another remedy.
    pub(super) fn remedied(self, remedy: &str) -> Self {
        match self {
            Self::Content { problem, .. } => Self::with(problem, remedy),
            other @ Self::Other(_) => other,
        }
    }

    /// In a line of a text file, with its text.
    pub(super) fn in_line(line: usize, text: &str, problem: impl Display) -> Self {
        Self::new(format_args!("line {line}, `{text}`: {problem}"))
    }
}
