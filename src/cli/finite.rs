//! The last line of defence: what is no number goes nowhere without an error.

use super::CliError;
use crate::solver::snapshot::Snapshot;
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

/// Looks whether a state can be drawn and written.
///
/// # Errors
/// [`CliError::NotFinite`] for one that cannot.
pub(super) fn check_finite(snapshot: &Snapshot) -> Result<(), CliError> {
    match snapshot.not_finite() {
        Some(body) => Err(CliError::NotFinite { body: body.to_owned(), seconds: snapshot.time }),
        None => Ok(()),
    }
}
