//! What is asked about a person's own patterns, as plain data.

use std::path::PathBuf;

/// What is asked about own patterns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum PatternQuestion {
    /// What a new one is called.
    Keep {
        /// Its name.
        title: String,
        /// What it does.
        does: String,
        /// Fibres that it takes.
        fibres: usize,
    },
    /// What one is called from now on.
    Rename {
        /// Its file.
        path: PathBuf,
        /// Its name.
        title: String,
    },
    /// Whether one is to be deleted.
    Delete {
        /// Its file.
        path: PathBuf,
        /// Its name.
        title: String,
    },
}
