//! In the place of scene_renderer.rs where the program is built without pictures.

use super::CliError;
use super::picture::Look;
use crate::scene::Scene;
use crate::solver::snapshot::Snapshot;

/// Makes no pictures: the program was built without them.
pub(super) enum SceneRenderer {}

impl SceneRenderer {
    /// Says so.
    ///
    /// # Errors
    /// [`CliError::NoPictures`].
    pub(super) fn open(_look: &Look, _scene: &Scene, _start: &Snapshot) -> Result<Self, CliError> {
        Err(CliError::NoPictures)
    }

    /// Never called.
    pub(super) fn take_in(&mut self, _scene: &Scene, _snapshot: &Snapshot) {
        match *self {}
    }

    /// Never called.
    ///
    /// # Errors
    /// None.
    pub(super) fn picture(&mut self, _scene: &Scene, _snapshot: &Snapshot) -> Result<ScenePicture, CliError> {
        match *self {}
    }

    /// Never called.
    ///
    /// # Errors
    /// None.
    pub(super) fn gif(&mut self, _picture: &ScenePicture, _delay: u16) -> Result<Vec<u8>, CliError> {
        match *self {}
    }
}

/// There is none.
pub(super) enum ScenePicture {}

impl ScenePicture {
    /// Never called.
    ///
    /// # Errors
    /// None.
    pub(super) fn png(&self) -> Result<Vec<u8>, CliError> {
        match *self {}
    }
}
