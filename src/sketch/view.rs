//! The three orthographic drawing views.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An orthographic drawing view. Horizontal runs right and vertical up on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum View {
    /// X horizontal, Y vertical.
    Front,
    /// Z horizontal, Y vertical.
    Side,
    /// X horizontal, Z vertical.
    Top,
}

impl View {
    /// Indices of the horizontal and vertical axes (0 = X, 1 = Y, 2 = Z).
    pub fn axes(self) -> [usize; 2] {
        match self {
            Self::Front => [0, 1],
            Self::Side => [2, 1],
            Self::Top => [0, 2],
        }
    }
}
