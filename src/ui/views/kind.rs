//! What views are for, and what people call them.

use crate::render::Facing;
use crate::sketch::View;
use serde::{Deserialize, Serialize};

/// What a view is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum PaneKind {
    /// Strokes are drawn into the model at rest.
    Drawing(View),
    /// The simulation is watched and pulled.
    Result,
}

impl PaneKind {
    /// What people call it.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Drawing(view) => view_name(view),
            Self::Result => "Result",
        }
    }
}

/// What people call a drawing view.
pub(super) fn view_name(view: View) -> &'static str {
    match view {
        View::Front => "Front",
        View::Side => "Side",
        View::Top => "Top",
    }
}

/// From where a drawing view looks.
pub(super) fn facing(view: View) -> Facing {
    match view {
        View::Front => Facing::Front,
        View::Side => Facing::Side,
        View::Top => Facing::Top,
    }
}
