//! Files that grow line by line: whatever ends the program leaves all lines that were written until then.

use super::IoError;
use super::atomic::Draft;
use super::door::OpenFile;
use super::json::parse;
use super::json_out::write_line;
use super::read::open_file;
use serde::Serialize;
use serde_json::Value;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};

/// Longest file of this kind [bytes]: what would make it longer is not written.
const LIMIT: u64 = 256 << 20;

/// A file of one JSON value a line, to which lines are added.
#[derive(Debug)]
pub(crate) struct GrowingLines {
    path: PathBuf,
    /// The file, once it has begun and as long as all of it could be written.
    file: Option<OpenFile>,
    bytes: u64,
    /// How long it may become [bytes].
    limit: u64,
}

/// Whether all lines are in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kept {
    /// They are, as far as it has begun.
    Whole,
    /// It is as long as it may become [bytes]: those behind some line are not.
    UpTo(u64),
}

impl GrowingLines {
    /// At a path where nothing is written yet.
    pub(super) fn at(path: PathBuf) -> Self {
        Self::up_to(path, LIMIT)
    }

    /// The same, which may become so long [bytes].
    pub(crate) fn up_to(path: PathBuf, limit: u64) -> Self {
        Self { path, file: None, bytes: 0, limit }
    }

    /// Begins with these lines in the place of what was there, wholly or not at all.
    ///
    /// # Errors
    /// As every write; it has to begin anew then.
    pub(crate) fn begin(&mut self, lines: &[impl Serialize]) -> Result<Kept, IoError> {
        self.file = None;
        let mut bytes = self.whole(lines)?;
        let kept = cut(&mut bytes, self.limit);
        let begun = Draft::begin(&self.path).and_then(|mut draft| {
            draft.write_all(&bytes)?;
            draft.replace()
        });
        self.file = Some(begun.map_err(|error| IoError::of_writing(error).within(&self.path))?);
        // Nothing goes behind what is left out.
        self.bytes = if kept == Kept::Whole { bytes.len() as u64 } else { self.limit };
        Ok(kept)
    }

    /// Adds lines, unless the file would be longer than it may become.
    ///
    /// # Errors
    /// As every write; it has to begin anew then.
    pub(crate) fn add(&mut self, lines: &[impl Serialize]) -> Result<Kept, IoError> {
        let bytes = self.whole(lines)?;
        if self.bytes + bytes.len() as u64 > self.limit {
            self.bytes = self.limit;
            return Ok(Kept::UpTo(self.limit));
        }
        let Some(mut file) = self.file.take() else { return Ok(Kept::Whole) };
        file.write_all(&bytes).map_err(|error| IoError::of_writing(error).within(&self.path))?;
        self.bytes += bytes.len() as u64;
        self.file = Some(file);
        Ok(Kept::Whole)
    }

    fn whole(&self, lines: &[impl Serialize]) -> Result<Vec<u8>, IoError> {
        let mut bytes = Vec::new();
        let written: io::Result<()> = lines.iter().try_for_each(|line| write_line(&mut bytes, line));
        written.map_err(|error| IoError::of_writing(error).within(&self.path))?;
        Ok(bytes)
    }
}

/// Leaves as many whole lines as fit a length [bytes].
fn cut(bytes: &mut Vec<u8>, most: u64) -> Kept {
    if bytes.len() as u64 <= most {
        return Kept::Whole;
    }
    let end = bytes[..most as usize].iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
    bytes.truncate(end);
    Kept::UpTo(most)
}

/// The lines of such a file, up to the first that is not whole: the program may have ended in it. They are read as they
/// are asked for, since there may be many.
///
/// # Errors
/// A file that cannot be opened, or is longer than any of its kind.
pub(crate) fn read_growing(path: &Path) -> Result<impl Iterator<Item = Value> + use<>, IoError> {
    let limit = LIMIT + (1 << 20);
    let (file, bytes) = open_file(path).map_err(|error| error.within(path))?;
    if bytes > limit {
        return Err(IoError::TooLarge { bytes, limit }.within(path));
    }
    let mut file = BufReader::new(file.take(limit));
    Ok(std::iter::from_fn(move || {
        let mut line = Vec::new();
        file.read_until(b'\n', &mut line).ok()?;
        if line.ends_with(b"\n") { parse(std::str::from_utf8(&line).ok()?).ok() } else { None }
    })
    .fuse())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::door::{Fate, Step, judged};
    use std::fs;

    #[test]
    fn what_is_too_long_is_cut_behind_a_line() {
        for (most, left) in [(100, "ab\ncd\n"), (6, "ab\ncd\n"), (5, "ab\n"), (3, "ab\n"), (2, "")] {
            let mut bytes = b"ab\ncd\n".to_vec();
            assert_eq!(cut(&mut bytes, most) == Kept::Whole, most >= 6);
            assert_eq!(String::from_utf8_lossy(&bytes), left, "{most}");
        }
    }

    #[test]
    fn what_is_longer_than_it_may_be_is_whole_and_told() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("it.recording");
        let mut lines = GrowingLines::up_to(path.clone(), 20);
        assert_eq!(lines.begin(&["one"]).expect("written"), Kept::Whole);
        assert_eq!(lines.add(&["two"]).expect("written"), Kept::Whole);
        assert_eq!(lines.add(&["far too long"]).expect("left out"), Kept::UpTo(20));
        // What would fit stands behind what is missing.
        assert_eq!(lines.add(&["3"]).expect("left out"), Kept::UpTo(20));
        assert_eq!(read(&path), ["one", "two"]);
        assert_eq!(lines.begin(&["anew", "and far too long"]).expect("cut"), Kept::UpTo(20));
        assert_eq!(lines.add(&["4"]).expect("left out"), Kept::UpTo(20));
        assert_eq!(read(&path), ["anew"]);
        assert_eq!(lines.begin(&["again"]).expect("written"), Kept::Whole);
    }

    fn read(path: &Path) -> Vec<Value> {
        read_growing(path).expect("there").collect()
    }

    #[test]
    fn what_was_written_until_the_end_is_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("it.recording");
        let mut lines = GrowingLines::at(path.clone());
        lines.add(&["never"]).expect("nothing has begun");
        lines.begin(&["one"]).expect("written");
        lines.add(&["two", "three"]).expect("written");
        assert_eq!(read(&path), ["one", "two", "three"]);
        // Torn anywhere, the whole lines before that are left.
        let whole = fs::read(&path).expect("there");
        for end in 0..whole.len() {
            fs::write(&path, &whole[..end]).expect("written");
            let found = read(&path);
            assert_eq!(found.len(), whole[..end].split(|byte| *byte == b'\n').count() - 1);
        }
        lines.begin(&["anew"]).expect("written");
        assert_eq!(read(&path), ["anew"]);
        let full = |step| if step == Step::Write { Fate::Fails(io::ErrorKind::StorageFull) } else { Fate::Done };
        let error = judged(full, || lines.add(&["lost"])).expect_err("the disk is full").to_string();
        assert!(error.contains("it.recording"), "{error}");
        lines.add(&["behind it"]).expect("nothing is added behind a line that may be torn");
        assert_eq!(read(&path), ["anew"]);
        lines.begin(&["again"]).expect("there is room again");
        lines.add(&["and more"]).expect("written");
        assert_eq!(read(&path), ["again", "and more"]);
    }
}
