//! Documents that a program left behind without saving them.

use crate::io::RecoverableDocument;
use crate::scene::UNTITLED;

/// A recoverable document, offered to be opened or discarded.
#[derive(Clone, Debug)]
pub(crate) struct RecoveryOffer {
    /// The document.
    pub document: RecoverableDocument,
    /// Whether its file was written after it.
    pub is_older: bool,
}

impl RecoveryOffer {
    /// Offers a document.
    pub(crate) fn new(document: RecoverableDocument) -> Self {
        Self { is_older: document.is_older_than_its_file(), document }
    }

    /// Its name.
    pub(crate) fn name(&self) -> &str {
        if self.document.name.is_empty() { UNTITLED } else { &self.document.name }
    }
}
