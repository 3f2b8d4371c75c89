//! Moving pictures, whatever their format.

use super::IoError;
use super::apng::AnimatedPng;
use super::gif::AnimatedGif;
use std::path::{Path, PathBuf};

/// A format of moving pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MovingFormat {
    /// PNG, in all its colours; browsers play it.
    Apng,
    /// GIF, in 255 colours a picture, fifty pictures a second at most; what plays nothing else plays it.
    Gif,
}

impl MovingFormat {
    /// All of them, by their names.
    pub(crate) const ALL: [(&'static str, Self); 2] = [("apng", Self::Apng), ("gif", Self::Gif)];

    /// The file in a folder.
    pub(crate) fn file(self, folder: &Path) -> PathBuf {
        folder.join(match self {
            Self::Apng => "motion.apng",
            Self::Gif => "motion.gif",
        })
    }
}

/// What a picture is handed over as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PictureAs {
    /// A PNG file.
    Png,
    /// A GIF file that is shown for so long [s/100] on those before it.
    Gif(u16),
    /// Not at all: this frame is left out.
    Nothing,
}

/// A moving picture that is written, whole after every picture.
pub(crate) enum MovingPicture {
    /// As PNG.
    Apng(AnimatedPng),
    /// As GIF.
    Gif(AnimatedGif),
}

impl MovingPicture {
    /// No pictures yet, of frames that last so long [s].
    pub(crate) fn new(format: MovingFormat, path: PathBuf, seconds: f64) -> Self {
        match format {
            MovingFormat::Apng => Self::Apng(AnimatedPng::new(path, seconds)),
            MovingFormat::Gif => Self::Gif(AnimatedGif::new(path, seconds)),
        }
    }

    /// Goes on to the next frame: what its picture is to be handed over as.
    pub(crate) fn next_frame(&mut self) -> PictureAs {
        match self {
            Self::Apng(_) => PictureAs::Png,
            Self::Gif(animated) => animated.next_frame().map_or(PictureAs::Nothing, PictureAs::Gif),
        }
    }

    /// Adds the picture of that frame, a file of the kind that was asked for; all of them are of the same size.
    ///
    /// # Errors
    /// [`IoError::Write`] within [`IoError::InFile`].
    pub(crate) fn push(&mut self, file: &[u8]) -> Result<(), IoError> {
        match self {
            Self::Apng(animated) => animated.push(file),
            Self::Gif(animated) => animated.push(file),
        }
    }

    /// What was written, as it is told, and where; none before the first picture.
    pub(crate) fn written(&self) -> Option<(String, &Path)> {
        match self {
            Self::Apng(animated) if animated.pictures() > 0 => {
                Some((format!("a moving picture of {} frames", animated.pictures()), animated.path()))
            }
            Self::Gif(animated) if animated.pictures() > 0 => {
                let (pictures, frames) = (animated.pictures(), animated.frames());
                let of = if pictures < frames { format!("{pictures} of {frames}") } else { frames.to_string() };
                Some((format!("a moving picture of {of} frames"), animated.path()))
            }
            _ => None,
        }
    }
}
