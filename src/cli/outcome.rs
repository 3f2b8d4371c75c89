//! How a command ended.

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It has done its work.
    Done,
    /// It has done its work, but a body diverged.
    Diverged,
}
