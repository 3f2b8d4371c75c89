//! Folders that take one file a frame.

use super::{IoError, make_folder, write_atomically};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A folder that takes one file a frame, `frame_000000` and on.
#[derive(Clone, Debug)]
pub struct FrameFolder {
    folder: PathBuf,
    prefix: &'static str,
    extension: &'static str,
    first: u64,
    frames: u64,
}

impl FrameFolder {
    /// No frames yet, of files with this extension; makes the folder unless it is there.
    ///
    /// # Errors
    /// As `make_folder`.
    pub fn create(folder: &Path, extension: &'static str) -> Result<Self, IoError> {
        Self::numbered(folder, "frame", extension, 0)
    }

    /// As [`FrameFolder::create`], of files with names that begin so, the first of them of this number.
    ///
    /// # Errors
    /// As `make_folder`.
    pub(crate) fn numbered(
        folder: &Path,
        prefix: &'static str,
        extension: &'static str,
        first: u64,
    ) -> Result<Self, IoError> {
        make_folder(folder)?;
        Ok(Self { folder: folder.to_owned(), prefix, extension, first, frames: 0 })
    }

    /// Writes the next frame.
    ///
    /// # Errors
    /// As [`write_atomically`].
    pub fn push(&mut self, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), IoError> {
        let path = self.folder.join(format!("{}_{:06}.{}", self.prefix, self.first + self.frames, self.extension));
        write_atomically(&path, content)?;
        self.frames += 1;
        Ok(())
    }

    /// Frames written.
    pub fn frames(&self) -> u64 {
        self.frames
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// How many frames of a longer, earlier run lie in the folder behind those of this one.
    pub(crate) fn left_over(&self) -> usize {
        let index = |name: &str| {
            name.strip_prefix(self.prefix)?
                .strip_prefix('_')?
                .strip_suffix(self.extension)?
                .strip_suffix('.')?
                .parse::<u64>()
                .ok()
        };
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        entries
            .filter(|entry| {
                entry.file_name().to_str().and_then(index).is_some_and(|index| index >= self.first + self.frames)
            })
            .count()
    }
}
