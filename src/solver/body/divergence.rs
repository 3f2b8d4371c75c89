//! Why a body was stopped.

use thiserror::Error;

/// A body that was stopped because its motion could no longer be computed.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("body \"{body}\" diverged at {time:.6} s ({cause}) and was stopped in its last good state; {remedy}")]
pub struct Divergence {
    /// Name of the body.
    pub body: String,
    /// When [s].
    pub time: f64,
    /// What was seen.
    pub cause: String,
    /// Which parameter to change.
    pub remedy: String,
}
