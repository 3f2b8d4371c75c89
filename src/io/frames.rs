//! Folders that take one file a frame.

use super::{IoError, make_folder, write_atomically};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The files of frames that lie in a folder, with their numbers.
pub(crate) fn numbered_files(folder: &Path, prefix: &str, extension: &str) -> impl Iterator<Item = (u64, PathBuf)> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.filter_map(move |entry| {
        let name = entry.file_name();
        let digits = name.to_str()?.strip_prefix(prefix)?.strip_prefix('_')?;
        let number = digits.strip_suffix(extension)?.strip_suffix('.')?.parse().ok()?;
        Some((number, entry.path()))
    })
}

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
        let end = self.first + self.frames;
        numbered_files(&self.folder, self.prefix, self.extension).filter(|(number, _)| *number >= end).count()
    }
}
