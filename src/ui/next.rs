//! What a person goes on to from the document that is open.

use super::autosave::RecoveryOffer;
use super::gallery::Example;
use std::path::PathBuf;

/// What a person goes on to when nothing is lost by it.
#[derive(Clone, Debug)]
pub(super) enum Next {
    /// The built-in scene.
    New,
    /// A floor and nothing on it.
    Empty,
    /// A file.
    Open(PathBuf),
    /// A scene that ships.
    Example(&'static Example),
    /// A document that was left behind.
    Recover(RecoveryOffer),
    /// The end of the program.
    Quit,
}
