//! The changed document, kept where it is found again when the program ended without asking.
//!
//! How it works. Each open document has a file of its own in a folder for them, written anew from time to time and
//! removed when the document is saved or closed. A second file beside it is locked for as long as the document is
//! open: the system lets go of the lock whatever ends the program. What is not locked at the next start can be
//! recovered, and another window's document is not taken for it.

use super::atomic::sweep;
use super::door::{self, TemporaryFile};
use super::growing::{GrowingLines, read_growing};
use super::json::parse;
use super::json_out::write_line;
use super::read::read_text;
use super::scene::{MAX_SCENE_BYTES, checked_scene, typed};
use super::{IoError, make_folder, write_atomically};
use crate::scene::{Scene, SceneError};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf, absolute};
use std::time::{Duration, SystemTime};

/// How the names of the files begin, and how that of a document and that of its lock end.
const PREFIX: &str = "recovery-";
const DOCUMENT: &str = "json";
const LOCK: &str = "lock";
/// How the name of the recording of a session ends, whose document may be kept beside it.
const RECORDING: &str = "recording";

/// Where a document belongs.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Origin {
    /// The file that it was read from or saved to; none for one that never was.
    pub file: Option<PathBuf>,
    /// The folder from which it names its models.
    pub folder: PathBuf,
    /// Whether the file may hold something else than what the document grew from.
    pub doubtful: bool,
    /// Whether its models are those that come with the program and lie in no folder.
    pub shipped: bool,
}

/// The place of one open document among those that can be recovered. Dropped without [`Self::clear`], as by a panic, it
/// leaves what was written there.
#[derive(Debug)]
pub struct RecoveryFile {
    document: PathBuf,
    lock: PathBuf,
    /// Locked for as long as it is open.
    _held: File,
}

/// A document that a program left behind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecoverableDocument {
    /// Its name.
    pub name: String,
    /// Where it belongs.
    pub origin: Origin,
    /// When it was written.
    pub written: SystemTime,
    document: PathBuf,
}

/// What is written.
#[derive(Serialize)]
struct WrittenContent<'a> {
    original: Option<&'a str>,
    folder: Option<&'a str>,
    doubtful: bool,
    shipped: bool,
    /// Since 1970 [ms].
    written: u64,
    scene: &'a Scene,
}

/// What is read: the scene is looked at in a second step, with its own errors.
#[derive(Deserialize)]
struct ReadContent {
    original: Option<PathBuf>,
    folder: Option<PathBuf>,
    #[serde(default)]
    doubtful: bool,
    #[serde(default)]
    shipped: bool,
    written: u64,
    scene: Value,
}

impl RecoveryFile {
    /// Takes a place for a document in a folder, which is made if it is missing.
    ///
    /// # Errors
    /// The folder cannot be made or written to.
    pub fn open(folder: &Path) -> Result<Self, IoError> {
        make_folder(folder)?;
        let (held, lock) = taken(folder).map_err(|error| IoError::Folder(error).within(folder))?;
        let document = lock.with_extension(DOCUMENT);
        sweep(&document);
        Ok(Self { document, lock, _held: held })
    }

    /// Keeps the document as it is now, in the place of what was kept before.
    ///
    /// # Errors
    /// A scene that could not be loaded again, or a file that cannot be written.
    pub fn write(&self, origin: &Origin, scene: &Scene) -> Result<(), IoError> {
        scene.validate().map_err(|error| IoError::Invalid(error).within(&self.document))?;
        // The next start may be in another folder.
        let file = origin.file.as_deref().and_then(|file| absolute(file).ok());
        let here = Path::new(".");
        let folder = absolute(if origin.folder.as_os_str().is_empty() { here } else { &origin.folder }).ok();
        let kept = WrittenContent {
            original: file.as_deref().and_then(Path::to_str),
            folder: folder.as_deref().and_then(Path::to_str),
            doubtful: origin.doubtful,
            shipped: origin.shipped,
            written: SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default().as_millis() as u64,
            scene,
        };
        write_atomically(&self.document, |out| write_line(out, &kept))
    }

    /// Where the recording of the session is kept as it grows.
    #[cfg_attr(not(feature = "gui"), allow(dead_code, reason = "the window is who keeps recordings"))]
    pub(crate) fn recording(&self) -> GrowingLines {
        GrowingLines::at(self.lock.with_extension(RECORDING))
    }

    /// Whether a document is kept just now.
    #[cfg_attr(not(feature = "gui"), allow(dead_code, reason = "the window is who keeps recordings"))]
    pub(crate) fn has_document(&self) -> bool {
        self.document.exists()
    }

    /// Forgets the recording of the session.
    ///
    /// # Errors
    /// The file cannot be removed.
    #[cfg_attr(not(feature = "gui"), allow(dead_code, reason = "the window is who keeps recordings"))]
    pub(crate) fn clear_recording(&self) -> Result<(), IoError> {
        removed(&self.lock.with_extension(RECORDING))
    }

    /// Whether its folder still holds it.
    pub fn is_there(&self) -> bool {
        self.lock.exists()
    }

    /// Forgets what was kept: the document was saved, or closed without its changes.
    ///
    /// # Errors
    /// The file cannot be removed.
    pub fn clear(&self) -> Result<(), IoError> {
        removed(&self.document)
    }
}

impl Drop for RecoveryFile {
    fn drop(&mut self) {
        // What cannot be removed is found free of its lock, and removed, at the next start.
        door::remove(&self.lock).ok();
    }
}

/// Documents that were left behind in a folder, the newest first; none of a folder that is not there. Those that are
/// open in another window are not among them, nor are files that cannot be read.
pub fn recoverable_documents(folder: &Path) -> Vec<RecoverableDocument> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if !entry.file_name().to_string_lossy().starts_with(PREFIX) {
            continue;
        }
        match path.extension().and_then(|extension| extension.to_str()) {
            Some(DOCUMENT) if !is_open(&path.with_extension(LOCK)) => found.extend(looked_at(&path)),
            Some(LOCK) if !path.with_extension(DOCUMENT).exists() => drop_free(&path),
            _ => {}
        }
    }
    found.sort_by(|a, b| b.written.cmp(&a.written).then_with(|| a.document.cmp(&b.document)));
    found
}

/// The recording of a session that a program left behind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftRecording {
    /// When it was written last.
    pub written: SystemTime,
    path: PathBuf,
}

/// Recordings that were left behind in a folder, the newest first, whether or not their documents were.
pub fn left_recordings(folder: &Path) -> Vec<LeftRecording> {
    let mut found: Vec<LeftRecording> = fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .filter(|entry| entry.file_name().to_string_lossy().starts_with(PREFIX))
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|ending| ending == RECORDING))
        .filter(|path| !is_open(&path.with_extension(LOCK)))
        .filter_map(|path| {
            let written = fs::metadata(&path).and_then(|found| found.modified()).ok()?;
            Some(LeftRecording { written, path })
        })
        .collect();
    found.sort_by(|a, b| b.written.cmp(&a.written).then_with(|| a.path.cmp(&b.path)));
    found
}

impl LeftRecording {
    /// Its lines, as far as they were written.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn lines(&self) -> Result<impl Iterator<Item = Value> + use<>, IoError> {
        read_growing(&self.path)
    }

    /// Forgets it.
    ///
    /// # Errors
    /// The file cannot be removed.
    pub fn discard(&self) -> Result<(), IoError> {
        drop_free(&self.path.with_extension(LOCK));
        removed(&self.path)
    }
}

impl RecoverableDocument {
    /// The document.
    ///
    /// # Errors
    /// As loading a scene: the file may have been damaged or come from a newer program.
    pub fn load(&self) -> Result<Scene, IoError> {
        let whole = || {
            let found = read(&self.document)?;
            checked_scene(&found.scene)
        };
        whole().map_err(|error| error.within(&self.document))
    }

    /// Whether the file where it belongs was written after it was kept, by another program or from another window.
    pub fn is_older_than_its_file(&self) -> bool {
        let changed =
            self.origin.file.as_deref().and_then(|file| fs::metadata(file).and_then(|data| data.modified()).ok());
        changed.is_some_and(|changed| changed > self.written)
    }

    /// Forgets it: it was recovered and is kept under another place, or is not wanted.
    ///
    /// # Errors
    /// The file cannot be removed.
    pub fn discard(&self) -> Result<(), IoError> {
        drop_free(&self.document.with_extension(LOCK));
        removed(&self.document)
    }
}

/// A new locked file of a name of its own.
fn taken(folder: &Path) -> io::Result<(File, PathBuf)> {
    let suffix = format!(".{LOCK}");
    loop {
        let made = TemporaryFile::make(folder, PREFIX, &suffix, true)?;
        // Not every file system has locks: there, a document open in another window is offered too.
        if made.is_held() {
            return made.keep();
        }
        // Somebody took it for one that was left behind, before it was locked.
    }
}

fn is_open(lock: &Path) -> bool {
    File::open(lock).is_ok_and(|file| matches!(file.try_lock(), Err(fs::TryLockError::WouldBlock)))
}

/// Removes a lock that nobody holds.
fn drop_free(lock: &Path) {
    if let Ok(file) = File::open(lock)
        && file.try_lock().is_ok()
    {
        door::remove(lock).ok();
    }
}

fn removed(path: &Path) -> Result<(), IoError> {
    match door::remove(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(IoError::Write(error).within(path)),
        _ => Ok(()),
    }
}

fn looked_at(document: &Path) -> Option<RecoverableDocument> {
    let found = read(document).ok()?;
    Some(RecoverableDocument {
        name: found.scene.get("name").and_then(Value::as_str).unwrap_or_default().to_owned(),
        origin: Origin {
            file: found.original,
            folder: found.folder.unwrap_or_default(),
            doubtful: found.doubtful,
            shipped: found.shipped,
        },
        written: SystemTime::UNIX_EPOCH + Duration::from_millis(found.written),
        document: document.to_owned(),
    })
}

fn read(document: &Path) -> Result<ReadContent, IoError> {
    let text = read_text(document, MAX_SCENE_BYTES)?;
    typed(&parse(&text)?).map_err(|why| {
        IoError::Type(SceneError {
            path: String::new(),
            value: "this".to_owned(),
            problem: format!("is no document that was kept ({why})"),
            remedy: "remove the file".to_owned(),
        })
    })
}
