//! Reading a whole file, if it is one and of sensible size.

use super::IoError;
use super::json::parse;
use std::fs::{self, File, FileType};
use std::io::{self, Read};
use std::path::Path;

/// A regular file, opened, and its length [bytes].
///
/// # Errors
/// [`IoError::Missing`], [`IoError::NotAFile`] or [`IoError::Read`].
pub(super) fn open_file(path: &Path) -> Result<(File, u64), IoError> {
    let metadata = fs::metadata(path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => IoError::Missing,
        _ => IoError::Read(error),
    })?;
    // Asked before opening: opening a pipe would wait for somebody to write to it.
    if !metadata.is_file() {
        return Err(IoError::NotAFile(kind_of(metadata.file_type())));
    }
    Ok((File::open(path).map_err(IoError::Read)?, metadata.len()))
}

/// Length of a regular file [bytes]; none where there is no such file.
pub(super) fn length_of(path: &Path) -> Option<u64> {
    fs::metadata(path).ok().filter(fs::Metadata::is_file).map(|metadata| metadata.len())
}

/// The content of a regular file of at most `limit` bytes.
///
/// # Errors
/// [`IoError::Missing`], [`IoError::NotAFile`], [`IoError::TooLarge`] or [`IoError::Read`].
pub(super) fn read_bytes(path: &Path, limit: u64) -> Result<Vec<u8>, IoError> {
    let (file, length) = open_file(path)?;
    let too_large = |bytes| Err(IoError::TooLarge { bytes, limit });
    if length > limit {
        return too_large(length);
    }
    let mut bytes = Vec::with_capacity(length as usize);
    file.take(limit + 1).read_to_end(&mut bytes).map_err(IoError::Read)?;
    if bytes.len() as u64 > limit {
        return too_large(bytes.len() as u64);
    }
    Ok(bytes)
}

/// The text of a regular file of at most `limit` bytes.
///
/// # Errors
/// As [`read_bytes`], and [`IoError::NotUtf8`].
pub(super) fn read_text(path: &Path, limit: u64) -> Result<String, IoError> {
    let bytes = read_bytes(path, limit)?;
    String::from_utf8(bytes).map_err(|error| IoError::NotUtf8 { at: error.utf8_error().valid_up_to() })
}

/// JSON that this program wrote earlier.
///
/// # Errors
/// As [`read_text`], and [`IoError::Syntax`] where it is no JSON; within [`IoError::InFile`].
pub(crate) fn read_json(path: &Path) -> Result<serde_json::Value, IoError> {
    /// Longest such file [bytes].
    const LIMIT: u64 = 1 << 30;
    let read = || parse(&read_text(path, LIMIT)?);
    read().map_err(|error| error.within(path))
}

fn kind_of(file_type: FileType) -> &'static str {
    if file_type.is_dir() { "a folder" } else { "a pipe or device" }
}
