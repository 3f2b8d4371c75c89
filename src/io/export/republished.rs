//! Files that say at their head how many frames there are, and where each of them lies, so that none can be added at
//! the end.
//!
//! Frames go to a file aside. Whenever a half of what was published has been added the whole is written anew, and once
//! more at the end: all that is copied is three times the file, and what a run that is killed leaves is whole, and two
//! thirds of its frames at least.

use crate::io::door::OpenFile;
use crate::io::{IoError, write_atomically};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A file that is written anew from time to time.
pub(super) struct Republished {
    path: PathBuf,
    /// Frames so far, in a file without a name, which is gone with the program.
    aside: OpenFile,
    /// Bytes of whole frames there.
    length: u64,
    frames: usize,
    published: usize,
}

impl Republished {
    /// Nothing yet.
    ///
    /// # Errors
    /// The folder takes no file.
    pub(super) fn create(path: PathBuf) -> Result<Self, IoError> {
        let folder = path.parent().unwrap_or(Path::new("."));
        let aside = OpenFile::aside(folder).map_err(|error| IoError::Write(error).within(&path))?;
        Ok(Self { path, aside, length: 0, frames: 0, published: 0 })
    }

    /// Where it is written.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Adds a frame; whether it is time to publish.
    ///
    /// # Errors
    /// The disk takes no more.
    pub(super) fn add(&mut self, frame: &[u8]) -> Result<bool, IoError> {
        self.aside.write_all(frame).map_err(|error| IoError::Write(error).within(&self.path))?;
        self.length += frame.len() as u64;
        self.frames += 1;
        Ok(2 * self.frames >= 3 * self.published.max(1) || self.published == 0)
    }

    /// Number of frames that were added.
    pub(super) fn frames(&self) -> usize {
        self.frames
    }

    /// Whether there are frames that have not been published.
    pub(super) fn is_behind(&self) -> bool {
        self.published < self.frames
    }

    /// Writes the file anew: `head`, all frames, `tail`.
    ///
    /// # Errors
    /// As [`write_atomically`].
    pub(super) fn publish(&mut self, head: &[u8], tail: &[u8]) -> Result<(), IoError> {
        let (aside, length) = (&mut self.aside, self.length);
        write_atomically(&self.path, |out| {
            out.write_all(head)?;
            aside.seek(SeekFrom::Start(0))?;
            let copied = io::copy(&mut (&mut *aside).take(length), &mut &mut *out).map(drop);
            aside.seek(SeekFrom::End(0))?;
            copied.and_then(|()| out.write_all(tail))
        })?;
        self.published = self.frames;
        Ok(())
    }
}
