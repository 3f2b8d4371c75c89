//! How far putting a scene together has come.

use std::fmt;

/// What is being worked on, for progress on long bakes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BakeStage {
    /// Filling the shape with particles.
    Sampling,
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
            Self::Sampling => f.write_str("filling the shape with particles"),
            Self::Neighbours => f.write_str("finding neighbours"),
            Self::Embedding => f.write_str("embedding the fibres"),
            Self::Skin { done, of } => write!(f, "embedding the skin, {done} of {of} points"),
            Self::StableStep => f.write_str("measuring the stable time step"),
        }
    }
}
