//! What every format does with the frames of a motion.

use crate::export::Frame;
use crate::io::IoError;
use std::ops::RangeInclusive;
use std::path::PathBuf;

/// The frames that are to be written, by their numbers.
pub(super) type Planned = RangeInclusive<u64>;

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

    /// What was written, as it is told, and where.
    fn written(&self) -> Vec<(String, PathBuf)>;

    /// How many files of an earlier, longer run lie behind the last of this one.
    fn left_over(&self) -> usize {
        0
    }
}
