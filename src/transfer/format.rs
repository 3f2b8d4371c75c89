//! The formats in which a run is written, in one table: the command line and the window offer what stands here.

use super::pictures::MovingPicture;
use crate::io::export::MotionFormat;

/// A format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Shapes.
    Motion(MotionFormat),
    /// A moving picture.
    Picture(MovingPicture),
}

impl Format {
    /// All of them, by their names.
    pub(crate) fn all() -> impl Iterator<Item = (&'static str, Self)> {
        let motions = MotionFormat::ALL.into_iter().map(|(name, format)| (name, Self::Motion(format)));
        motions.chain(MovingPicture::ALL.into_iter().map(|(name, format)| (name, Self::Picture(format))))
    }

    /// The one of a name, whatever the case of its letters.
    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::all().find(|(known, _)| known.eq_ignore_ascii_case(name.trim())).map(|(_, format)| format)
    }
}
