//! Why a fibre cannot be edited as asked.

use crate::sketch::{SketchError, View};
use thiserror::Error;

/// An edit of a fibre that cannot be made. The text is what people read; vertices count from 1 in it.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FibreEditError {
    /// A vertex that is not there.
    #[error("There is no vertex {}: the fibre has {count}", index + 1)]
    NoVertex {
        /// Index that was asked for, from 0.
        index: usize,
        /// Vertices of the fibre.
        count: usize,
    },
    /// An edge that is not there.
    #[error("There is no edge {}: the fibre has {count}", index + 1)]
    NoEdge {
        /// Index that was asked for, from 0.
        index: usize,
        /// Edges of the fibre.
        count: usize,
    },
    /// A place on an edge that is not between its ends.
    #[error("A new vertex lies between the ends of its edge, from 0 to 1 of the way, not at {0}")]
    Share(f64),
    /// Fewer vertices than bend.
    #[error("{0} vertices would be left, and a fibre needs 3 to bend. Delete the whole fibre instead")]
    TooFew(usize),
    /// More vertices than are allowed.
    #[error("{wanted} vertices are more than the {limit} that a fibre may have. Give a larger spacing")]
    TooMany {
        /// Vertices that were asked for.
        wanted: f64,
        /// Greatest number.
        limit: usize,
    },
    /// A number of vertices that make no fibre.
    #[error("A fibre of {0} vertices cannot bend. Give 3 or more")]
    Count(usize),
    /// A spacing that is no length.
    #[error("{0} m is no distance between vertices. Give a length above 0")]
    Spacing(f64),
    /// Two neighbours in one place.
    #[error("Vertex {} would lie on the one before it. Keep them apart, or delete one of them", index + 1)]
    Repeats {
        /// Index of the second of the two, from 0.
        index: usize,
    },
    /// A position that is infinite or not a number.
    #[error("Vertex {} would be nowhere: its position is no finite number", index + 1)]
    NotFinite {
        /// Its index, from 0.
        index: usize,
    },
    /// An axis or normal that points nowhere.
    #[error("The direction ({}, {}, {}) points nowhere. Give one of any length but zero", .0[0], .0[1], .0[2])]
    NoDirection([f64; 3]),
    /// A scaling that leaves nothing, or more than there is room for.
    #[error("Scaled by {0} nothing would be left. Give a factor above 0")]
    NoSize(f64),
    /// A cut that leaves a half that cannot bend.
    #[error(
        "Cut at vertex {}, one half would have {left} vertices, and 3 are needed to bend. Cut nearer to the middle",
        index + 1
    )]
    Stub {
        /// Index of the vertex, from 0.
        index: usize,
        /// Vertices of the smaller half.
        left: usize,
    },
    /// Strokes asked of a fibre that has none.
    #[error("The fibre is not drawn by strokes but given by its vertices. Draw a new one in two views")]
    NoStrokes,
    /// A stroke in a view in which the fibre was not drawn.
    #[error(
        "The fibre was drawn in the {} and {} views, not in the {drawn} view. Redraw it in one of the two",
        views[0], views[1]
    )]
    OtherView {
        /// View of the new stroke.
        drawn: View,
        /// Views of the fibre's strokes.
        views: [View; 2],
    },
    /// A surface without faces.
    #[error("There is no surface to snap to")]
    NoSurface,
    /// Strokes that give no curve.
    #[error(transparent)]
    Sketch(#[from] SketchError),
}
