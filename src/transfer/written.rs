//! What was written.

use std::path::PathBuf;

/// Files that were written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Written {
    /// What, as it is told.
    pub(crate) what: String,
    /// Where.
    pub(crate) path: PathBuf,
    /// How many files of an earlier, longer run lie behind the last.
    pub(crate) left_over: usize,
}
