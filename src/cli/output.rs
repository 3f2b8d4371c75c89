//! Result files: looked at before a run, written after it.

use super::CliError;
use super::error::printable;
use super::prepare::folder_of;
use crate::io::{check_writable, write_atomically, write_json};
use crate::scene::Scene;
use crate::transfer::Inputs;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The scene's file, and the models that it names.
pub(super) fn inputs(file: Option<&Path>, scene: &Scene) -> Inputs {
    Inputs::of(file, folder_of(file), scene)
}

/// Looks whether the files that options name can be written and are all different, and different from those that are
/// read.
///
/// # Errors
/// The first that cannot be written or is named twice.
pub(super) fn check(inputs: &Inputs, targets: &[(&'static str, Option<&PathBuf>)]) -> Result<(), CliError> {
    let mut taken: Vec<(&'static str, PathBuf)> = Vec::new();
    for (option, path) in targets {
        let Some(path) = path else { continue };
        let file = check_writable(path)?;
        let same = || taken.iter().find(|(_, other)| *other == file).map(|(first, _)| *first);
        if let Some(first) = inputs.name_of(&file).or_else(same) {
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
