//! Whether a file was changed by another program since it was read.

use super::IoError;
use super::read::read_bytes;
use super::scene::MAX_SCENE_BYTES;
use std::fs;
use std::hash::{DefaultHasher, Hasher};
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Times of change within this of when they were read may hide a later change: file systems tick as coarsely as this.
const COARSE: Duration = Duration::from_secs(2);

/// A file as it was at one moment. Take it before the file is read, and by what was written when it was saved.
#[derive(Clone, Debug)]
pub(crate) struct FileStamp {
    path: PathBuf,
    hash: u64,
    /// Length and time of change, if they can be relied on to differ for another content.
    look: Option<(u64, SystemTime)>,
}

/// What became of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileState {
    /// It holds what it held.
    Same,
    /// It holds something else, or can no longer be read.
    Changed,
    /// It is no longer there.
    Missing,
}

impl FileStamp {
    /// The file as it is now.
    ///
    /// # Errors
    /// [`IoError::InFile`] with what keeps it from being read, as for a scene.
    pub(crate) fn of(path: &Path) -> Result<Self, IoError> {
        // Before the content: a change in between is found later then.
        let look = fs::metadata(path).and_then(|metadata| Ok((metadata.len(), metadata.modified()?))).ok();
        let now = SystemTime::now();
        let is_old = |&(_, changed): &(u64, SystemTime)| now.duration_since(changed).is_ok_and(|age| age > COARSE);
        let hash = hash_at(path).map_err(|error| error.within(path))?;
        Ok(Self { path: path.to_owned(), hash, look: look.filter(is_old) })
    }

    /// A file as it is after this was written to it, whatever another program writes there from then on.
    pub(crate) fn of_written(path: &Path, content: &[u8]) -> Self {
        // The time of change is not asked for: another write may have come in between.
        Self { path: path.to_owned(), hash: hash_of(content), look: None }
    }

    /// Where the file is.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// What became of the file since. A file that was written again with the same content is the same; its content is
    /// looked at only where its length or time of change leave a doubt.
    pub(crate) fn state(&self) -> FileState {
        let look = match fs::metadata(&self.path) {
            Ok(metadata) => metadata.modified().ok().map(|changed| (metadata.len(), changed)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => return FileState::Missing,
            Err(_) => return FileState::Changed,
        };
        if look.is_some() && look == self.look {
            return FileState::Same;
        }
        match hash_at(&self.path) {
            Ok(hash) if hash == self.hash => FileState::Same,
            Err(IoError::Missing) => FileState::Missing,
            _ => FileState::Changed,
        }
    }
}

fn hash_at(path: &Path) -> Result<u64, IoError> {
    read_bytes(path, MAX_SCENE_BYTES).map(|content| hash_of(&content))
}

/// A number that differs for another content, within one run of the program.
fn hash_of(content: &[u8]) -> u64 {
    let mut hasher = DefaultHasher::new();
    hasher.write(content);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs::File;

    fn aged(path: &Path, text: &str, seconds: u64) {
        fs::write(path, text).expect("written");
        let file = File::options().write(true).open(path).expect("opened");
        file.set_modified(SystemTime::now() - Duration::from_secs(seconds)).expect("a time of change");
    }

    #[test]
    fn a_change_is_found_however_it_was_made() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("scene.json");
        for age in [0, 100] {
            aged(&path, "one", age);
            let stamp = FileStamp::of(&path).expect("a file");
            assert_eq!(stamp.state(), FileState::Same);
            // Of the same length; just now, so that the time of change may be the same too.
            fs::write(&path, "two").expect("written");
            assert_eq!(stamp.state(), FileState::Changed, "{age} s");
            fs::write(&path, "one").expect("written");
            assert_eq!(stamp.state(), FileState::Same, "written again as it was");
            fs::write(&path, "three").expect("written");
            assert_eq!(stamp.state(), FileState::Changed);
            assert_eq!(FileStamp::of(&path).expect("a file").state(), FileState::Same);
            fs::remove_file(&path).expect("removed");
            assert_eq!(stamp.state(), FileState::Missing);
        }
        fs::create_dir(&path).expect("made");
        assert!(FileStamp::of(&path).is_err());
        assert!(FileStamp::of(&folder.path().join("none.json")).is_err());
    }

    #[test]
    fn what_another_program_writes_right_after_a_save_is_a_change() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("scene.json");
        let written = FileStamp::of_written(&path, b"ours");
        fs::write(&path, "ours").expect("written");
        assert_eq!(written.state(), FileState::Same);
        aged(&path, "that", 100);
        assert_eq!(written.state(), FileState::Changed, "of the same length, before it was looked at once");
    }

    #[test]
    fn a_fresh_file_is_not_taken_by_its_time_of_change() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("scene.json");
        fs::write(&path, "one").expect("written");
        let stamp = FileStamp::of(&path).expect("a file");
        let changed = fs::metadata(&path).and_then(|metadata| metadata.modified()).expect("a time");
        fs::write(&path, "two").expect("written");
        File::options().write(true).open(&path).and_then(|file| file.set_modified(changed)).expect("a time of change");
        assert_eq!(stamp.state(), FileState::Changed, "in one tick of the clock");
    }
}
