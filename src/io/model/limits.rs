//! How large a model may be.

/// Model files larger than this are refused [bytes].
pub(crate) const MAX_MODEL_BYTES: u64 = 1 << 30;

/// Faces and vertices of a model, at most.
pub(super) const MOST: usize = 20_000_000;
