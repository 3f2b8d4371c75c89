//! The one door through which files are changed: made, written, brought to the disk, renamed, removed. A test can stand
//! in it and let any step fail as disks, systems and power cuts do.

use std::cell::RefCell;
use std::fs::{self, File, Permissions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use tempfile::NamedTempFile;

/// A step by which a file or a folder is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// A file is made.
    Make,
    /// Bytes are written.
    Write,
    /// A file gets the permissions of the one that it replaces.
    Permit,
    /// A file is brought to the disk.
    Sync,
    /// A file takes the place of another.
    Rename,
    /// A file is removed.
    Remove,
    /// A folder is made.
    Folder,
}

/// What becomes of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It is done.
    Done,
    /// It fails and nothing is done.
    Fails(io::ErrorKind),
    /// Of what is written so many bytes are; any other step is done.
    Short(usize),
    /// The program ends before it: nothing is done from here on, and nothing tidied up.
    Ends,
}

/// Who stands in the door, and whether the program has ended for whom it is judged.
struct Judge {
    judge: Mutex<Box<dyn FnMut(Step) -> Fate + Send>>,
    ended: AtomicBool,
}

thread_local! {
    static JUDGE: RefCell<Option<Arc<Judge>>> = const { RefCell::new(None) };
}

/// Does some work on this thread, each of whose steps becomes what `judge` says, as it does on threads that take the
/// door over from it. For tests.
pub fn judged<T>(judge: impl FnMut(Step) -> Fate + Send + 'static, work: impl FnOnce() -> T) -> T {
    Door(Some(Arc::new(Judge { judge: Mutex::new(Box::new(judge)), ended: AtomicBool::new(false) }))).over(work)
}

/// The door as it is on one thread, for another that goes on with its work.
pub(crate) struct Door(Option<Arc<Judge>>);

impl Door {
    /// That of this thread.
    pub(crate) fn here() -> Self {
        Self(JUDGE.with_borrow(Clone::clone))
    }

    /// Does some work on this thread through it.
    pub(crate) fn over<T>(self, work: impl FnOnce() -> T) -> T {
        /// Leaves the door as it was, however the work ends.
        struct Before(Option<Arc<Judge>>);
        impl Drop for Before {
            fn drop(&mut self) {
                JUDGE.replace(self.0.take());
            }
        }
        let _before = Before(JUDGE.replace(self.0));
        work()
    }
}

/// Asks for a step; gives how many bytes are written at most.
fn pass(step: Step) -> io::Result<usize> {
    let Some(judge) = JUDGE.with_borrow(Clone::clone) else { return Ok(usize::MAX) };
    let ended = || Err(io::Error::other("the program has ended"));
    if judge.ended.load(Ordering::SeqCst) {
        return ended();
    }
    let fate = (judge.judge.lock().unwrap_or_else(PoisonError::into_inner))(step);
    match fate {
        Fate::Done => Ok(usize::MAX),
        Fate::Fails(kind) => Err(kind.into()),
        Fate::Short(most) => Ok(most.max(1)),
        Fate::Ends => {
            judge.ended.store(true, Ordering::SeqCst);
            ended()
        }
    }
}

/// A file that is written on.
#[derive(Debug)]
pub(super) struct OpenFile(File);

impl OpenFile {
    /// One without a name, that goes with whoever holds it.
    pub(super) fn aside(folder: &Path) -> io::Result<Self> {
        pass(Step::Make)?;
        tempfile::tempfile_in(folder).map(Self)
    }

    /// Brings what was written to the disk.
    pub(super) fn sync(&self) -> io::Result<()> {
        pass(Step::Sync)?;
        self.0.sync_data()
    }
}

impl Write for OpenFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let most = pass(Step::Write)?;
        self.0.write(&bytes[..bytes.len().min(most)])
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

impl Read for OpenFile {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        self.0.read(bytes)
    }
}

impl Seek for OpenFile {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.0.seek(to)
    }
}

/// A file under a name of its own, which is removed with it unless it is given another or kept.
#[derive(Debug)]
pub(super) struct TemporaryFile(Option<NamedTempFile>);

impl TemporaryFile {
    /// A new one whose name begins and ends so.
    pub(super) fn make(folder: &Path, prefix: &str, suffix: &str, is_private: bool) -> io::Result<Self> {
        pass(Step::Make)?;
        let mut options = tempfile::Builder::new();
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // What the system gives any new file; temporary files are private otherwise.
            options.permissions(Permissions::from_mode(if is_private { 0o600 } else { 0o666 }));
        }
        #[cfg(not(unix))]
        let _ = is_private;
        options.prefix(prefix).suffix(suffix).tempfile_in(folder).map(|file| Self(Some(file)))
    }

    fn file(&self) -> io::Result<&NamedTempFile> {
        self.0.as_ref().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    /// Whether it is still there under its name, locked, as far as the file system has locks.
    pub(super) fn is_held(&self) -> bool {
        self.file().is_ok_and(|file| file.as_file().lock().is_err() || file.path().exists())
    }

    /// Takes over permissions, is brought to the disk, and takes the place of what is at a path.
    pub(super) fn put(mut self, path: &Path, permissions: Option<Permissions>) -> io::Result<OpenFile> {
        if let Some(permissions) = permissions {
            pass(Step::Permit)?;
            self.file()?.as_file().set_permissions(permissions)?;
        }
        pass(Step::Sync)?;
        self.file()?.as_file().sync_all()?;
        pass(Step::Rename)?;
        let Some(file) = self.0.take() else { return Err(io::ErrorKind::NotFound.into()) };
        file.persist(path).map(OpenFile).map_err(|error| {
            self.0 = Some(error.file);
            error.error
        })
    }

    /// Stays under its name; gives the file and where it is.
    pub(super) fn keep(mut self) -> io::Result<(File, PathBuf)> {
        let Some(file) = self.0.take() else { return Err(io::ErrorKind::NotFound.into()) };
        Ok(file.keep()?)
    }

    /// Removes it.
    pub(super) fn close(mut self) -> io::Result<()> {
        pass(Step::Remove)?;
        self.0.take().map_or(Ok(()), NamedTempFile::close)
    }
}

impl Write for TemporaryFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let most = pass(Step::Write)?;
        let Some(file) = &mut self.0 else { return Err(io::ErrorKind::NotFound.into()) };
        file.write(&bytes[..bytes.len().min(most)])
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.as_mut().map_or(Ok(()), Write::flush)
    }
}

impl Drop for TemporaryFile {
    fn drop(&mut self) {
        // What cannot be removed is swept away later.
        if let Some(file) = &mut self.0
            && pass(Step::Remove).is_err()
        {
            file.disable_cleanup(true);
        }
    }
}

/// Removes a file.
pub(super) fn remove(path: &Path) -> io::Result<()> {
    pass(Step::Remove)?;
    fs::remove_file(path)
}

/// Makes a folder, and those above it.
pub(super) fn make_folders(path: &Path) -> io::Result<()> {
    if path.is_dir() {
        return Ok(());
    }
    pass(Step::Folder)?;
    fs::create_dir_all(path)
}
