//! Strokes to curves: a pair of strokes in two orthogonal views becomes one curve in space.

mod view;

pub use view::View;
