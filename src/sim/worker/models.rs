//! Models that came into the document since it was opened.
//!
//! Why not within the commands. An edit may take the place of one that was sent before it, and what waits between them;
//! the models of a document only ever become more, so that the newest ones serve every edit of it.

use super::shared::lock;
use crate::scene::Assets;
use std::sync::{Arc, Mutex};

/// The newest models of the document; none where they are those that it was opened with.
#[derive(Clone, Default)]
pub(super) struct NewestModels(Arc<Mutex<Option<Arc<Assets>>>>);

impl NewestModels {
    /// The document has these now.
    pub(super) fn set(&self, models: Option<Arc<Assets>>) {
        *lock(&self.0) = models;
    }

    /// What it has now.
    pub(super) fn get(&self) -> Option<Arc<Assets>> {
        lock(&self.0).clone()
    }
}
