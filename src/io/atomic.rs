//! Writes that happen wholly or not at all.
//!
//! A program that is killed while it writes leaves its temporary file behind. Each is locked for as long as it is
//! written, and the system lets go of the lock whatever ends the program: what is not locked is nobody's and is swept
//! away by the next save in that folder.

use super::IoError;
use super::door::{self, OpenFile, TemporaryFile};
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Writes a file through `content`, so that the path holds either what it held before or all that is new.
///
/// The new content goes to a temporary file in the same folder, is brought to the disk and then renamed over the old
/// one. A symbolic link is followed, one that leads nowhere refused; an existing file keeps its permissions.
///
/// # Errors
/// [`IoError::Write`] within [`IoError::InFile`]: the folder is missing or read-only, the disk is full, the path is a
/// folder, or `content` failed; [`IoError::NotFinite`] within it where `content` met a number that is none. The old
/// file is untouched then and no temporary file is left.
pub fn write_atomically(path: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), IoError> {
    let _write = tracing::info_span!("write", file = %path.display()).entered();
    replace(path, content).map_err(|error| IoError::of_writing(error).within(path))
}

/// Looks whether [`write_atomically`] could write to a path, before the work whose result is to go there is begun.
/// Leaves nothing behind, nor what writers left there when they were killed. Returns the file that would be written,
/// whole and with links followed, for comparing.
///
/// # Errors
/// [`IoError::Write`] within [`IoError::InFile`], as writing would give it.
pub(crate) fn check_writable(path: &Path) -> Result<PathBuf, IoError> {
    let probe = || {
        let target = WriteTarget::of(path)?;
        sweep_folder(target.folder());
        target.temporary_file()?.close()?;
        let name = target.path.file_name().unwrap_or_default();
        Ok(fs::canonicalize(target.folder())?.join(name))
    };
    probe().map_err(|error| IoError::Write(error).within(path))
}

/// Removes temporary files in the folder of a path that writers left behind when they were killed. Those that are being
/// written stay. What cannot be removed stays too: that is no reason to refuse a save.
pub(super) fn sweep(path: &Path) {
    if let Ok(target) = WriteTarget::of(path) {
        sweep_folder(target.folder());
    }
}

/// As [`sweep`], of a folder.
fn sweep_folder(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        let is_ours = name.starts_with(PREFIX) && name.ends_with(SUFFIX);
        if !is_ours || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        let file = OpenOptions::new().read(true).write(true).open(entry.path());
        if let Ok(file) = file
            && file.try_lock().is_ok()
        {
            // Under the lock: a writer that has just made this file finds it gone when it has the lock itself.
            door::remove(&entry.path()).ok();
        }
    }
}

/// Makes a folder, and those above it that are missing, unless it is there; one that is there is rid of what writers
/// left behind when they were killed.
///
/// # Errors
/// [`IoError::Folder`] within [`IoError::InFile`]: it cannot be made or written to, or the path is a file.
pub(crate) fn make_folder(path: &Path) -> Result<(), IoError> {
    let make = || {
        door::make_folders(path)?;
        sweep_folder(path);
        // Locked, as all of ours: another that sweeps at this moment leaves it alone.
        WriteTarget { path: path.join("probe"), old: None }.temporary_file()?.close()
    };
    make().map_err(|error| IoError::Folder(error).within(path))
}

/// How the names of temporary files begin and end.
const PREFIX: &str = ".sinew-";
const SUFFIX: &str = ".tmp";

/// Removes a file that nothing names any more. What cannot be removed stays: it does no harm.
pub(super) fn remove_orphan(path: &Path) {
    door::remove(path).ok();
}

/// Where a file is going to be.
struct WriteTarget {
    path: PathBuf,
    old: Option<Metadata>,
}

impl WriteTarget {
    fn of(path: &Path) -> io::Result<Self> {
        // Renaming over a link would replace the link and leave the file that it names as it was, or unmade.
        let path = match fs::canonicalize(path) {
            Ok(path) => path,
            Err(_) if fs::symlink_metadata(path).is_ok_and(|found| found.is_symlink()) => {
                let text = "it is a link to a file that is not there; make that file or remove the link";
                return Err(io::Error::new(io::ErrorKind::InvalidInput, text));
            }
            Err(_) => path.to_owned(),
        };
        let old = fs::metadata(&path).ok();
        if old.as_ref().is_some_and(|old| !old.is_file()) {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is not a regular file"));
        }
        if path.file_name().is_none() {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is not the path of a file"));
        }
        Ok(Self { path, old })
    }

    fn folder(&self) -> &Path {
        match self.path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        }
    }

    fn temporary_file(&self) -> io::Result<TemporaryFile> {
        loop {
            let file = TemporaryFile::make(self.folder(), PREFIX, SUFFIX, false)?;
            // Not every file system has locks: there, nothing is swept away either.
            if file.is_held() {
                return Ok(file);
            }
            // Somebody swept it away before it was locked.
        }
    }
}

fn replace(path: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut draft = Draft::begin(path)?;
    content(&mut draft)?;
    draft.replace().map(drop)
}

/// A file that is being written beside the one that it is to replace. Dropped, it is gone.
#[must_use = "it is written for the file that it replaces"]
pub(super) struct Draft {
    target: WriteTarget,
    file: BufWriter<TemporaryFile>,
}

impl Draft {
    pub(super) fn begin(path: &Path) -> io::Result<Self> {
        let target = WriteTarget::of(path)?;
        let file = BufWriter::new(target.temporary_file()?);
        Ok(Self { target, file })
    }

    /// Brings what was written to the disk and renames it over what was there. Gives the file, to be written on.
    pub(super) fn replace(self) -> io::Result<OpenFile> {
        let file = self.file.into_inner().map_err(io::IntoInnerError::into_error)?;
        let file = file.put(&self.target.path, self.target.old.as_ref().map(Metadata::permissions))?;
        // The rename itself is on the disk once the folder is. Not every system can open a folder: then it is on its
        // own.
        if let Ok(folder) = File::open(self.target.folder()) {
            folder.sync_all().ok();
        }
        Ok(file)
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}
