//! What a model becomes.

/// What a model becomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Layers {
    /// A fibre solid.
    Filled,
    /// A two-layer body.
    Two,
}
