//! What is said of a result that is no number.

use std::fmt;

/// A result that is no number.
pub(super) struct NotFinite<'a>(pub(super) &'a str);

impl fmt::Display for NotFinite<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} is not a finite number; take a smaller step (/time/step/automatic/safety), or softer materials",
            self.0
        )
    }
}
