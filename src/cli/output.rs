//! Result files: looked at before a run, written after it.

use super::CliError;
use super::error::printable;
use super::prepare::folder_of;
use crate::io::{check_writable, resolved, write_atomically, write_json};
use crate::scene::{AnyBody, Scene};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Files that a command reads, whole, and what a message calls them: nothing is to be written over them.
#[derive(Clone, Debug, Default)]
pub(super) struct Inputs(Vec<(&'static str, PathBuf)>);

impl Inputs {
    /// The scene's file.
    pub(super) fn of_file(scene: Option<&Path>) -> Self {
        Self::default().and("the scene", scene)
    }

    /// The scene's file, and the models that it names.
    pub(super) fn of(file: Option<&Path>, scene: &Scene) -> Self {
        let folder = folder_of(file);
        let models = scene.all_bodies().filter_map(AnyBody::model).map(|model| folder.join(model.path));
        models.fold(Self::of_file(file), |inputs, model| inputs.and("a model of the scene", Some(&model)))
    }

    /// And another file, which an option names.
    pub(super) fn and(mut self, what: &'static str, path: Option<&Path>) -> Self {
        self.0.extend(path.and_then(resolved).map(|path| (what, path)));
        self
    }

    /// Looks whether any of the files that an option leads to is one of these.
    ///
    /// # Errors
    /// [`CliError::SameFile`] for the first that is.
    pub(super) fn check_apart(&self, option: &'static str, files: &[PathBuf]) -> Result<(), CliError> {
        for path in files {
            let Some(file) = resolved(path) else { continue };
            if let Some((first, _)) = self.0.iter().find(|(_, input)| *input == file) {
                return Err(CliError::SameFile { path: path.clone(), first, second: option });
            }
        }
        Ok(())
    }
}

/// Looks whether the files that options name can be written and are all different, and different from those that are read.
///
/// # Errors
/// The first that cannot be written or is named twice.
pub(super) fn check(inputs: &Inputs, targets: &[(&'static str, Option<&PathBuf>)]) -> Result<(), CliError> {
    let Inputs(mut taken) = inputs.clone();
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
