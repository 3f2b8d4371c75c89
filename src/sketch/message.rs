//! What the sketch tells people: refusals and notes, each with its figure.

use super::view::View;
use crate::text::number::percent;
use std::fmt;

/// Which stroke of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The stroke that was drawn first.
    First,
    /// The stroke that was drawn second.
    Second,
}

impl fmt::Display for Which {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::First => "first",
            Self::Second => "second",
        })
    }
}

/// Why strokes do not become a fibre. The text is what people read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SketchError {
    /// The model's diagonal is not a usable length [m].
    #[error("The model's size is {0} m; strokes need a model between a nanometre and a million kilometres in size")]
    ModelSize(f64),
    /// Both strokes lie in one view.
    #[error("Both strokes were drawn in the {0} view. Draw the second one in another view")]
    SameView(View),
    /// A coordinate is infinite or not a number; `point` counts from 1.
    #[error("Point {point} of the {which} stroke is not a finite number. Redraw the {which} stroke")]
    NotFinite {
        /// Which stroke.
        which: Which,
        /// Number of the point, counted from 1.
        point: usize,
    },
    /// A coordinate is too large for its digits to resolve the model; `point` counts from 1.
    #[error("Point {point} of the {which} stroke lies more than 1e9 model sizes away. Redraw the {which} stroke")]
    TooFar {
        /// Which stroke.
        which: Which,
        /// Number of the point, counted from 1.
        point: usize,
    },
    /// A stroke without length.
    #[error("The {which} stroke is too short ({length} m long). Redraw the {which} stroke")]
    TooShort {
        /// Which stroke.
        which: Which,
        /// Its length [m].
        length: f64,
    },
    /// Neither stroke moves along the shared axis.
    #[error(
        "Both strokes run flat: {axis} covers only {} of the longer one, which cannot give depth. \
         Keep the {keep} stroke and draw the other one in the {instead} view instead",
        percent(*share),
        axis = extent(*axis)
    )]
    Degenerate {
        /// Index of the shared axis.
        axis: usize,
        /// Larger shared extent over the length of the longer stroke.
        share: f64,
        /// View of the stroke that is worth keeping.
        keep: View,
        /// View in which to draw the other one.
        instead: View,
    },
    /// One stroke moves along the shared axis and the other hardly does.
    #[error("The {which} stroke is flat {} and the other one is not. Redraw the {which} stroke", along(*axis))]
    Flat {
        /// The flat stroke.
        which: Which,
        /// Index of the shared axis.
        axis: usize,
    },
    /// The strokes cover too different ranges of the shared axis.
    #[error("Strokes overlap only {} {}. Stretch or redraw?", percent(*overlap), along(*axis))]
    Overlap {
        /// Shared range over the larger range.
        overlap: f64,
        /// Index of the shared axis.
        axis: usize,
    },
    /// Strokes that are to sweep a surface run side by side.
    #[error(
        "The strokes run side by side: what the first sweeps along the second has {} of the area that they could. Draw \
         the second one across the first",
        percent(*share)
    )]
    SideBySide {
        /// Area over the product of both lengths.
        share: f64,
    },
    /// The spacing of structure particles is not a positive length [m].
    #[error("Structure particles cannot be {0} m apart. Give a positive spacing")]
    Spacing(f64),
    /// A curve has fewer than two distinct or any non-finite points.
    #[error("The curve has no length that can be measured. Give two or more distinct, finite points")]
    Curve,
    /// No point of the fibre is embedded.
    #[error("Fibre discarded: {}", nothing_near(*nearest))]
    Discarded {
        /// Distance of the nearest material, in support radii h.
        nearest: f64,
    },
    /// There is material near the fibre, but nowhere enough to hold three structure particles in a row.
    #[error(
        "Fibre discarded: only {embedded} of {total} points lie in enough material, and no 3 in a row. Draw it deeper"
    )]
    Stranded {
        /// Embedded structure particles.
        embedded: usize,
        /// All structure particles.
        total: usize,
    },
}

/// What was done to strokes or fibre without being asked, or looks doubtful. The text is what people read.
#[derive(Clone, Debug, PartialEq)]
pub enum SketchNote {
    /// Both strokes were cut to the range that they share.
    Clipped {
        /// Shared range over the larger range.
        overlap: f64,
        /// Index of the shared axis.
        axis: usize,
    },
    /// The second stroke was stretched onto the first's range, because that was asked for.
    Stretched {
        /// The first stroke's range over the second's.
        factor: f64,
        /// Index of the shared axis.
        axis: usize,
    },
    /// The second stroke was found to run the other way.
    Reversed,
    /// The strokes hardly fit one curve.
    PoorMatch {
        /// Root-mean cost, as a fraction of the model's diagonal.
        cost: f64,
    },
    /// The strokes fit one curve on the whole, but not everywhere.
    Strays {
        /// Largest distance of the curve, as a drawing view sees it, from its stroke, over the model's diagonal.
        deviation: f64,
        /// Index of the shared axis.
        axis: usize,
    },
    /// Structure particles outside the solid were left out.
    Trimmed {
        /// How many.
        trimmed: usize,
        /// Of how many.
        total: usize,
    },
    /// A gap in the solid cut the fibre.
    Split {
        /// Pieces that are left.
        pieces: usize,
    },
    /// Pieces too short to bend were left out.
    Dropped {
        /// How many pieces.
        pieces: usize,
        /// Structure particles in them.
        points: usize,
    },
}

impl fmt::Display for SketchNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Clipped { overlap, axis } => {
                let (overlap, along) = (percent(overlap), along(axis));
                write!(f, "Strokes overlap {overlap} {along}; the rest was clipped. Stretch instead?")
            }
            Self::Stretched { factor, axis } => {
                let (factor, along) = (percent(factor), along(axis));
                write!(f, "The second stroke was stretched to {factor} {along} to match the first")
            }
            Self::Reversed => f.write_str("The second stroke runs against the first and was reversed. Flip it back?"),
            Self::PoorMatch { cost } => {
                let off = 100.0 * cost;
                write!(f, "Strokes fit poorly: {off:.1} % of the model apart. Check the start dots, or redraw one")
            }
            Self::Strays { deviation, axis } => {
                let (off, along) = (100.0 * deviation, along(axis));
                write!(f, "The fibre strays {off:.1} % of the model from a stroke: their turns or ends differ {along}")
            }
            Self::Trimmed { trimmed, total } => {
                let verb = if trimmed == 1 { "was" } else { "were" };
                write!(f, "{trimmed} of {total} points outside the solid {verb} trimmed")
            }
            Self::Split { pieces } => write!(f, "The fibre leaves the solid on its way and was split into {pieces}"),
            Self::Dropped { pieces: 1, points } => {
                write!(f, "1 piece of {points} {} was dropped: a fibre needs 3", plural(points))
            }
            Self::Dropped { pieces, points } => {
                write!(f, "{pieces} pieces, {points} points in all, were dropped: a fibre needs 3 points in a row")
            }
        }
    }
}

/// "in height", "in width (X)" or "in depth (Z)".
fn along(axis: usize) -> &'static str {
    ["in width (X)", "in height", "in depth (Z)"][axis.min(2)]
}

fn extent(axis: usize) -> &'static str {
    ["width (X)", "height", "depth (Z)"][axis.min(2)]
}

fn plural(points: usize) -> &'static str {
    if points == 1 { "point" } else { "points" }
}

fn nothing_near(nearest: f64) -> String {
    if nearest.is_infinite() {
        "there is no material at all".into()
    } else if nearest > 1.0 {
        format!("nearest material {nearest:.1} h away")
    } else {
        format!("too little material around it (nearest {nearest:.1} h away). Draw it deeper")
    }
}
