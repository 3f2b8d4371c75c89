//! Result files: looked at before a run, written after it.

use super::CliError;
use super::error::printable;
use crate::io::{check_writable, resolved, write_atomically, write_json};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Looks whether the files that options name can be written and are all different, the scene included.
///
/// # Errors
/// The first that cannot be written or is named twice.
pub(super) fn check(scene: Option<&PathBuf>, targets: &[(&'static str, Option<&PathBuf>)]) -> Result<(), CliError> {
    let scene = scene.and_then(|path| resolved(path));
    let mut taken: Vec<(&'static str, PathBuf)> = scene.into_iter().map(|path| ("the scene", path)).collect();
    for (option, path) in targets {
        let Some(path) = path else { continue };
        let file = check_writable(path)?;
        if let Some((first, _)) = taken.iter().find(|(_, other)| *other == file) {
            return Err(CliError::SameFile { path: (*path).clone(), first, second: option });
        }
        taken.push((option, file));
    }
    Ok(())
}

/// Writes a report as indented JSON; gives the line that says so.
///
/// # Errors
/// As [`write_json`].
pub(super) fn write_report(path: &Path, report: &impl Serialize) -> Result<String, CliError> {
    write_json(path, report)?;
    Ok(wrote("report", path))
}

/// Writes bytes.
///
/// # Errors
/// As [`write_atomically`].
pub(super) fn write_bytes(path: &Path, bytes: &[u8]) -> Result<(), CliError> {
    Ok(write_atomically(path, |out| out.write_all(bytes))?)
}

/// That a file was written.
pub(super) fn wrote(what: &str, path: &Path) -> String {
    format!("{what} written to {}\n", printable(path))
}
