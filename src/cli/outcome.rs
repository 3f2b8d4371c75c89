//! How a command ended.

use super::interruption::Signal;

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It has done its work.
    Done,
    /// It has done its work, but a body diverged.
    Diverged,
    /// It has done its work, but came to something else than what it was held against.
    Differs,
    /// It was interrupted; what it had done until then is written.
    Interrupted(Signal),
}
