//! What a drag does in the drawing views.

/// The tool in hand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum DrawingTool {
    /// Draws a stroke of a fibre, wherever it begins.
    #[default]
    Draw,
    /// Draws a stroke of a sheet, wherever it begins.
    Sheet,
    /// Moves what is selected by its handles, and draws a box around what is to be selected elsewhere.
    Select,
}
