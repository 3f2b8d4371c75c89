//! The last line of defence: what is no number goes nowhere without an error.

use super::TransferError;
use crate::sim::NotFinite;
use crate::solver::snapshot::Snapshot;

/// Looks whether a state can be drawn and written.
///
/// # Errors
/// [`TransferError::NotFinite`] for one that cannot.
pub(crate) fn check_finite(snapshot: &Snapshot) -> Result<(), TransferError> {
    NotFinite::of(snapshot).map_or(Ok(()), |lost| Err(lost.into()))
}
