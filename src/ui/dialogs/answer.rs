//! What a dialog came to in a frame.

use crate::ui::action::Action;
use crate::ui::autosave::Reply;
use crate::ui::gallery::Example;
use crate::ui::loading::Loaded;
use crate::ui::preferences::Preferences;
use crate::ui::transfer::TransferAnswer;
use std::path::PathBuf;

/// What a dialog came to in a frame.
pub(crate) enum Answer {
    /// It stays open.
    None,
    /// It is closed.
    Closed,
    /// An action was chosen.
    Do(Action),
    /// A path was given.
    Path(PathBuf),
    /// A path was chosen in the desktop's dialog, which asks before a file is replaced.
    Picked(PathBuf),
    /// A file was chosen among those that were used.
    Recent(PathBuf),
    /// So much is to be computed ahead [s].
    Compute(f64),
    /// Preferences were changed; their dialog stays open.
    Preferred(Preferences),
    /// A question was answered.
    Reply(Reply),
    /// An example was chosen.
    Example(&'static Example),
    /// What was being read is there, or cannot be read.
    Loaded(Box<Loaded>),
    /// What was asked about a pattern is to be done.
    Pattern,
    /// What leaves the window or comes into it was answered about.
    Transfer(TransferAnswer),
}
