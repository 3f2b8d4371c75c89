//! What the pointer may do in a view besides clicking.

/// What dragging does there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Allowed {
    /// What is selected has handles to be taken hold of.
    pub handles: bool,
    /// Elsewhere a drag draws a box around what is to be selected.
    pub boxes: bool,
}
