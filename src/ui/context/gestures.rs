//! Numbers of gestures: the changes of one are one step of undo.

/// Counts the gestures of a person's hand.
#[derive(Debug, Default)]
pub(crate) struct Gestures(u64);

/// The step of undo that a change belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// One of its own, as of a click.
    Own,
    /// That of the gesture that goes on, as of a slider that is dragged: it ends as the pointer is released.
    Present,
    /// That of the gesture with this number.
    Of(u64),
}

impl Gestures {
    /// The gesture that goes on.
    pub(crate) fn present(&self) -> u64 {
        self.0
    }

    /// Begins another one; gives its number.
    pub(crate) fn begin(&mut self) -> u64 {
        self.0 += 1;
        self.0
    }
}
