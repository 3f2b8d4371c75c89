//! Drives that parts of a body share.

use super::drive::Drive;
use std::sync::Arc;

/// A drive that parts of a body share.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SharedDrive {
    /// Identifier of the scene.
    pub(crate) id: Arc<str>,
    /// It, with the hand that leads it.
    pub(crate) drive: Drive,
}
