//! What paths lead to.

use std::fs;
use std::path::{Path, PathBuf};

/// The file or folder that a path leads to, whole and with links followed, for comparing; none where nothing is.
pub(crate) fn resolved(path: &Path) -> Option<PathBuf> {
    fs::canonicalize(path).ok()
}

/// Those of the files that are not there.
pub(crate) fn missing_files(paths: impl IntoIterator<Item = PathBuf>) -> Vec<PathBuf> {
    paths.into_iter().filter(|path| !path.is_file()).collect()
}
