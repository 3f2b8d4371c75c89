//! What a person draws in one view.

use super::view::View;
use glam::DVec2;

/// A stroke as it was drawn in one view.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// View in which it was drawn.
    pub view: View,
    /// Points as drawn, (horizontal, vertical) in the view's plane [m].
    pub points: Vec<DVec2>,
}
