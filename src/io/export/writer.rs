//! What every format does with the frames of a motion.

use crate::export::Frame;
use crate::io::frames::numbered_files;
use crate::io::{FrameFolder, IoError};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

/// The frames that are to be written, by their numbers.
pub(super) type Planned = RangeInclusive<u64>;

/// The files of a sequence, one a frame, as far as they are there already.
pub(super) fn frame_files(folder: &Path, prefix: &str, extension: &str, frames: &Planned) -> Vec<PathBuf> {
    let there = numbered_files(folder, prefix, extension).filter(|(number, _)| frames.contains(number));
    there.map(|(_, path)| path).collect()
}

/// What is told of a sequence that has any files.
pub(super) fn told(files: &FrameFolder, what: String) -> Vec<(String, PathBuf)> {
    if files.frames() == 0 { Vec::new() } else { vec![(what, files.folder().to_owned())] }
}

/// Files of a motion in one format.
pub(super) trait MotionWriter: Send {
    /// Writes the next frame.
    ///
    /// # Errors
    /// A file that cannot be written; what was written of the frames before stays whole.
    fn push(&mut self, frame: &Frame) -> Result<(), IoError>;

    /// Writes what is left to be written once there are no more frames.
    ///
    /// # Errors
    /// As [`MotionWriter::push`].
    fn finish(&mut self) -> Result<(), IoError> {
        Ok(())
    }

    /// What was written, as it is told, and where; nothing before the first frame.
    fn written(&self) -> Vec<(String, PathBuf)>;

    /// How many files of an earlier, longer run lie behind the last of this one.
    fn left_over(&self) -> usize {
        0
    }
}
