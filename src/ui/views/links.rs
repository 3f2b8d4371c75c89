//! What the views have to do with each other.

use crate::render::Camera;
use crate::sketch::View;
use egui::Rect;

/// How the drawing views lie, what one of them has done that the other follows, and what all of them are fitted to.
#[derive(Default)]
pub(super) struct Links {
    /// The drawing views, and where they lay in the last frame.
    pub drawing: Vec<(View, Rect)>,
    /// A drawing view whose camera was moved in this frame.
    pub moved: Option<(View, Camera)>,
    /// A drawing view that is to show another side.
    pub turned: Option<(View, View)>,
    /// Whether views are fitted to the selected fibre rather than to everything.
    pub fits_selected: bool,
}
