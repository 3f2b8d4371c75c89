//! How far putting a scene together has come, and whether it is to go on.

use super::error::BakeError;
use std::fmt;

/// Hears the name of a body and what is being worked on. What comes of it ends the work where it is no longer wanted:
/// [`BakeError::Cancelled`].
pub(super) type Tell<'a> = dyn FnMut(&str, BakeStage) -> Result<(), BakeError> + 'a;

/// Does a piece of work of a stage that asks again and again whether it is still wanted, and gives none where it is
/// not.
///
/// # Errors
/// [`BakeError::Cancelled`] there.
pub(super) fn unless_stopped<T>(
    progress: &mut Tell<'_>,
    (name, stage): (&str, BakeStage),
    work: impl FnOnce(&mut dyn FnMut() -> bool) -> Option<T>,
) -> Result<T, BakeError> {
    progress(name, stage)?;
    work(&mut || progress(name, stage).is_err()).ok_or(BakeError::Cancelled)
}

/// What is being worked on, for progress on long bakes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BakeStage {
    /// Filling the shape with particles.
    Sampling {
        /// Lattices that were tried.
        done: usize,
        /// Lattices in all, at most.
        of: usize,
    },
    /// Finding neighbours.
    Neighbours,
    /// Embedding fibres.
    Embedding,
    /// Embedding the skin.
    Skin {
        /// Points that are done.
        done: usize,
        /// Points in all.
        of: usize,
    },
    /// Measuring the stable time step.
    StableStep,
}

impl fmt::Display for BakeStage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sampling { done, of } => {
                write!(f, "filling the shape with particles, {} %", 100 * done / of.max(&1))
            }
            Self::Neighbours => f.write_str("finding neighbours"),
            Self::Embedding => f.write_str("embedding the fibres"),
            Self::Skin { done, of } => write!(f, "embedding the skin, {done} of {of} points"),
            Self::StableStep => f.write_str("measuring the stable time step"),
        }
    }
}
