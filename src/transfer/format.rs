//! The formats in which a run is written, in one table: the command line and the window offer what stands here.

use crate::io::MovingFormat;
use crate::io::export::MotionFormat;

/// A format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Shapes.
    Motion(MotionFormat),
    /// A moving picture.
    Picture(MovingFormat),
}

impl Format {
    /// All of them, by their names.
    pub(crate) fn all() -> impl Iterator<Item = (&'static str, Self)> {
        let motions = MotionFormat::ALL.into_iter().map(|(name, format)| (name, Self::Motion(format)));
        motions.chain(MovingFormat::ALL.into_iter().map(|(name, format)| (name, Self::Picture(format))))
    }

    /// The one of a name, whatever the case of its letters.
    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::all().find(|(known, _)| known.eq_ignore_ascii_case(name.trim())).map(|(_, format)| format)
    }

    /// What it is, in a few words.
    #[cfg(feature = "gui")]
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Motion(format) => format.title(),
            Self::Picture(_) => "A moving picture, as the result view shows it",
        }
    }
}
