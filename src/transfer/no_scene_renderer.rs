//! In the place of scene_renderer.rs where the program is built without pictures.

use super::{Look, TransferError};
use crate::scene::Scene;
use crate::sim::Runner;
use crate::solver::snapshot::Snapshot;

/// Makes no pictures: the program was built without them.
pub(crate) enum SceneRenderer {}

impl SceneRenderer {
    /// Says so.
    ///
    /// # Errors
    /// [`TransferError::NoPictures`].
    pub(crate) fn open(_look: &Look, _scene: &Scene, _start: &Snapshot) -> Result<Self, TransferError> {
        Err(TransferError::NoPictures)
    }

    /// Never called.
    pub(crate) fn take_in(&mut self, _scene: &Scene, _snapshot: &Snapshot) {
        match *self {}
    }

    /// Never called.
    ///
    /// # Errors
    /// None.
    pub(crate) fn seen(&mut self, _runner: &Runner) -> Result<Snapshot, TransferError> {
        match *self {}
    }

    /// Never called.
    ///
    /// # Errors
    /// None.
    pub(crate) fn picture(&mut self, _scene: &Scene, _snapshot: &Snapshot) -> Result<ScenePicture, TransferError> {
        match *self {}
    }

    /// Never called.
    ///
    /// # Errors
    /// None.
    pub(super) fn gif(&mut self, _picture: &ScenePicture, _delay: u16) -> Result<Vec<u8>, TransferError> {
        match *self {}
    }
}

/// There is none.
pub(crate) enum ScenePicture {}

impl ScenePicture {
    /// Never called.
    ///
    /// # Errors
    /// None.
    pub(crate) fn png(&self) -> Result<Vec<u8>, TransferError> {
        match *self {}
    }
}
