//! What is asked before something could be lost, and how it is answered.

use crate::ui::next::Next;
use std::path::PathBuf;

/// What is asked before something could be lost.
pub(crate) enum Question {
    /// What becomes of the changes.
    Unsaved(Next),
    /// Whether a file is replaced.
    Replace {
        /// The file.
        path: PathBuf,
        /// Why it is asked.
        loss: Loss,
        /// What is gone on to after that.
        next: Option<Next>,
    },
    /// Whether the scene is taken as its file holds it.
    Reload {
        /// The file.
        path: PathBuf,
        /// Whether the person asked for it; otherwise another program changed the file.
        is_asked: bool,
        /// Whether changes would be lost.
        is_changed: bool,
    },
    /// Whether a scene that is opened may read models outside of its folder.
    Outside {
        /// The scene.
        path: PathBuf,
        /// The models.
        files: Vec<PathBuf>,
    },
    /// What becomes of documents that were left behind.
    Recover,
}

/// How a question is answered, other than by leaving everything as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reply {
    /// Saves, then goes on.
    Save,
    /// Goes on without the changes.
    Discard,
    /// Replaces the file.
    Replace,
    /// Saves to another file.
    SaveElsewhere,
    /// Takes what the file holds.
    Reload,
    /// Opens the scene and lets it read what it names.
    Allow,
    /// Opens a document that was left behind.
    Recover(usize),
    /// Removes one.
    Forget(usize),
    /// Writes a recording that was left behind to a file.
    SaveRecording(usize),
    /// Removes one.
    ForgetRecording(usize),
    /// Removes all of them.
    ForgetAll,
    /// Leaves everything as it is.
    Back,
}

/// Why a file is not simply written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Loss {
    /// Another program wrote it since it was read.
    Changed,
    /// It is another file than the document's.
    Other,
    /// A table is to be written there.
    Table,
}
