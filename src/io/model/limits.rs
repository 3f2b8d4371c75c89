//! How large a model may be.

/// Model files larger than this are refused [bytes].
pub(crate) const MAX_MODEL_BYTES: u64 = 1 << 30;

/// Faces and vertices of a model, at most.
pub(super) const MOST: usize = 20_000_000;

/// Parts of a model, at most: each has a name and a material of its own.
pub(super) const MOST_PARTS: usize = 200_000;

/// Vertices that a file may make others of, or show again, beside what its size allows.
pub(super) const REPEATED: usize = 500_000;

/// Characters of a name, at most: it goes to everything that is called so.
pub(super) const LONGEST_NAME: usize = 200;

/// Faults of one kind that are told one by one.
pub(super) const TOLD: usize = 20;
