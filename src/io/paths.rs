//! What paths lead to.

use std::fs;
use std::path::{Path, PathBuf};

/// The file or folder that a path leads to, whole and with links followed, for comparing; none where nothing is. The
/// empty path is the present folder.
pub(crate) fn resolved(path: &Path) -> Option<PathBuf> {
    fs::canonicalize(if path.as_os_str().is_empty() { Path::new(".") } else { path }).ok()
}

/// Whether two paths lead to the same file or folder, or are the same.
#[cfg(feature = "gui")]
pub(crate) fn is_same(a: &Path, b: &Path) -> bool {
    a == b || resolved(a).is_some_and(|a| resolved(b) == Some(a))
}

/// Whether a path leads to anything.
pub(crate) fn is_there(path: &Path) -> bool {
    path.exists()
}

/// Those of the files that are not there.
pub(crate) fn missing_files(paths: impl IntoIterator<Item = PathBuf>) -> Vec<PathBuf> {
    paths.into_iter().filter(|path| !path.is_file()).collect()
}
