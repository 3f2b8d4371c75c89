//! Places at which what is selected is taken hold of.

/// A place to take hold of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Handle {
    /// Moves along an axis.
    Axis(usize),
    /// Moves in the plane of the view.
    Middle,
    /// Turns about the line of sight.
    Ring,
    /// Scales.
    Corner,
    /// A vertex that is edited.
    Vertex(usize),
}
