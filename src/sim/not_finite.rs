//! The last line of defence: what is no number is neither drawn nor written without a word.

use crate::scene::one_line;
use crate::solver::snapshot::Snapshot;
use thiserror::Error;

/// A body in a state that can be neither drawn nor written.
#[derive(Clone, Debug, PartialEq, Error)]
#[error(
    "body \"{}\": at {seconds:.6} s a point of it is no longer a finite number, so that it can be neither drawn nor \
     written; take a smaller step (/time/step/automatic/safety), or look what its model holds with `sinew check`",
    one_line(body)
)]
pub struct NotFinite {
    /// Name of the body.
    pub body: String,
    /// When [s].
    pub seconds: f64,
}

impl NotFinite {
    /// The first body of a state that cannot be drawn; none where all can.
    pub(crate) fn of(snapshot: &Snapshot) -> Option<Self> {
        snapshot.not_finite().map(|body| Self { body: body.to_owned(), seconds: snapshot.time })
    }
}
