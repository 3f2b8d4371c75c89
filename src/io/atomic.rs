//! Writes that happen wholly or not at all.

use super::IoError;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Writes a file through `content`, so that the path holds either what it held before or all that is new.
///
/// The new content goes to a temporary file in the same folder, is brought to the disk and then renamed over the old
/// one. A symbolic link is followed; an existing file keeps its permissions.
///
/// # Errors
/// [`IoError::Write`] within [`IoError::InFile`]: the folder is missing or read-only, the disk is full, the path is a
/// folder, or `content` failed. The old file is untouched then and no temporary file is left.
pub fn write_atomically(path: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), IoError> {
    replace(path, content).map_err(|error| IoError::Write(error).within(path))
}

fn replace(path: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    // Renaming over a link would replace the link and leave the file that it names as it was.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let old = fs::metadata(&target).ok();
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is not a regular file"));
    }
    let folder = match target.parent() {
        Some(folder) if folder.as_os_str().is_empty() => Path::new("."),
        Some(folder) => folder,
        None => return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is not the path of a file")),
    };
    let mut options = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // What the system gives any new file; temporary files are private otherwise.
        options.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut file = options.prefix(".sinew-").suffix(".tmp").tempfile_in(folder)?;
    let mut buffer = BufWriter::new(file.as_file_mut());
    content(&mut buffer)?;
    buffer.flush()?;
    drop(buffer);
    if let Some(old) = old {
        file.as_file().set_permissions(old.permissions())?;
    }
    file.as_file().sync_all()?;
    file.persist(&target).map_err(|error| error.error)?;
    // The rename itself is on the disk once the folder is. Not every system can open a folder: then it is on its own.
    if let Ok(folder) = File::open(folder) {
        folder.sync_all().ok();
    }
    Ok(())
}
