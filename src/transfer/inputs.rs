//! Files that are read and must not be written over.

use super::TransferError;
use crate::io::resolved;
use crate::scene::Scene;
use std::path::{Path, PathBuf};

/// Files that are read, whole, and what a message calls them: nothing is to be written over them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Inputs(Vec<(&'static str, PathBuf)>);

impl Inputs {
    /// The scene's file, and all models and motions that it names from `folder`.
    pub(crate) fn of(file: Option<&Path>, folder: &Path, scene: &Scene) -> Self {
        let inputs = Self::default().and("the scene", file);
        let mut scene = scene.clone();
        scene
            .model_paths_mut()
            .fold(inputs, |inputs, path| inputs.and("a model of the scene", Some(&folder.join(path))))
    }

    /// And another file.
    pub(crate) fn and(mut self, what: &'static str, path: Option<&Path>) -> Self {
        self.0.extend(path.and_then(resolved).map(|path| (what, path)));
        self
    }

    /// What is read of a file, which is given whole.
    pub(crate) fn name_of(&self, file: &Path) -> Option<&'static str> {
        self.0.iter().find(|(_, input)| input == file).map(|(what, _)| *what)
    }

    /// Looks whether any of the files that are to be written, called so, is one of these.
    ///
    /// # Errors
    /// [`TransferError::SameFile`] for the first that is.
    pub(crate) fn check_apart(&self, written: &'static str, files: &[PathBuf]) -> Result<(), TransferError> {
        for path in files {
            if let Some(first) = resolved(path).and_then(|file| self.name_of(&file)) {
                return Err(TransferError::SameFile { path: path.clone(), first, second: written });
            }
        }
        Ok(())
    }
}
