//! How a question about what leaves the window is answered.

use super::question::LinesDone;

/// What a question came to in a frame.
pub(crate) enum TransferAnswer {
    /// It is closed.
    Closed,
    /// It is to be begun with.
    Begin,
    /// It was done.
    Done(LinesDone),
}
