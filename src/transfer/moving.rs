//! Moving pictures, whatever their format.

use crate::io::{AnimatedPng, IoError};
use std::path::{Path, PathBuf};

/// A format of moving pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MovingFormat {
    /// PNG, in all its colours; browsers play it.
    Apng,
}

impl MovingFormat {
    /// All of them, by their names.
    pub(crate) const ALL: [(&'static str, Self); 1] = [("apng", Self::Apng)];

    /// The file in a folder.
    pub(crate) fn file(self, folder: &Path) -> PathBuf {
        folder.join(match self {
            Self::Apng => "motion.apng",
        })
    }
}

/// A moving picture that is written, whole after every picture.
pub(super) enum MovingPicture {
    /// As PNG.
    Apng(AnimatedPng),
}

impl MovingPicture {
    /// No pictures yet, of frames that last so long [s].
    pub(super) fn new(format: MovingFormat, path: PathBuf, seconds: f64) -> Self {
        match format {
            MovingFormat::Apng => Self::Apng(AnimatedPng::new(path, seconds)),
        }
    }

    /// Adds a picture, a PNG file; all of them are of the same size and kind.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(super) fn push(&mut self, png: &[u8]) -> Result<(), IoError> {
        match self {
            Self::Apng(animated) => animated.push(png),
        }
    }

    /// What was written, as it is told, and where; none before the first picture.
    pub(super) fn written(&self) -> Option<(String, &Path)> {
        match self {
            Self::Apng(animated) => (animated.pictures() > 0)
                .then(|| (format!("a moving picture of {} frames", animated.pictures()), animated.path())),
        }
    }
}
