//! Files that grow line by line: whatever ends the program leaves all lines that were written until then.

use super::IoError;
use super::atomic::Draft;
use super::door::OpenFile;
use super::json::parse;
use super::json_out::write_line;
use super::read::read_bytes;
use serde::Serialize;
use serde_json::Value;
use std::io::{self, Write};
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
}

impl GrowingLines {
    /// At a path where nothing is written yet.
    pub(super) fn at(path: PathBuf) -> Self {
        Self { path, file: None, bytes: 0 }
    }

    /// Begins with these lines in the place of what was there, wholly or not at all.
    ///
    /// # Errors
    /// As every write; it has to begin anew then.
    pub(crate) fn begin(&mut self, lines: &[impl Serialize]) -> Result<(), IoError> {
        self.file = None;
        let mut bytes = self.whole(lines)?;
        cut(&mut bytes, LIMIT as usize);
        let begun = Draft::begin(&self.path).and_then(|mut draft| {
            draft.write_all(&bytes)?;
            draft.replace()
        });
        self.file = Some(begun.map_err(|error| IoError::of_writing(error).within(&self.path))?);
        self.bytes = bytes.len() as u64;
        Ok(())
    }

    /// Adds lines, unless the file is as long as it may become.
    ///
    /// # Errors
    /// As every write; it has to begin anew then.
    pub(crate) fn add(&mut self, lines: &[impl Serialize]) -> Result<(), IoError> {
        let bytes = self.whole(lines)?;
        if self.bytes + bytes.len() as u64 > LIMIT {
            self.bytes = LIMIT;
            return Ok(());
        }
        let Some(mut file) = self.file.take() else { return Ok(()) };
        file.write_all(&bytes).map_err(|error| IoError::of_writing(error).within(&self.path))?;
        self.bytes += bytes.len() as u64;
        self.file = Some(file);
        Ok(())
    }

    fn whole(&self, lines: &[impl Serialize]) -> Result<Vec<u8>, IoError> {
        let mut bytes = Vec::new();
        let written: io::Result<()> = lines.iter().try_for_each(|line| write_line(&mut bytes, line));
        written.map_err(|error| IoError::of_writing(error).within(&self.path))?;
        Ok(bytes)
    }
}

/// Leaves as many whole lines as fit a length [bytes].
fn cut(bytes: &mut Vec<u8>, most: usize) {
    if bytes.len() > most {
        let end = bytes[..most].iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
        bytes.truncate(end);
    }
}

/// The lines of such a file, up to the first that is not whole: the program may have ended in it.
///
/// # Errors
/// A file that cannot be read.
pub(crate) fn read_growing(path: &Path) -> Result<Vec<Value>, IoError> {
    let bytes = read_bytes(path, LIMIT + (1 << 20)).map_err(|error| error.within(path))?;
    let lines = bytes.split_inclusive(|&byte| byte == b'\n').filter(|line| line.ends_with(b"\n"));
    Ok(lines.map_while(|line| parse(std::str::from_utf8(line).ok()?).ok()).collect())
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
            cut(&mut bytes, most);
            assert_eq!(String::from_utf8_lossy(&bytes), left, "{most}");
        }
    }

    #[test]
    fn what_was_written_until_the_end_is_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("it.recording");
        let mut lines = GrowingLines::at(path.clone());
        lines.add(&["never"]).expect("nothing has begun");
        lines.begin(&["one"]).expect("written");
        lines.add(&["two", "three"]).expect("written");
        assert_eq!(read_growing(&path).expect("there"), ["one", "two", "three"]);
        // Torn anywhere, the whole lines before that are left.
        let whole = fs::read(&path).expect("there");
        for end in 0..whole.len() {
            fs::write(&path, &whole[..end]).expect("written");
            let found = read_growing(&path).expect("there");
            assert_eq!(found.len(), whole[..end].split(|byte| *byte == b'\n').count() - 1);
        }
        lines.begin(&["anew"]).expect("written");
        assert_eq!(read_growing(&path).expect("there"), ["anew"]);
        let full = |step| if step == Step::Write { Fate::Fails(io::ErrorKind::StorageFull) } else { Fate::Done };
        let error = judged(full, || lines.add(&["lost"])).expect_err("the disk is full").to_string();
        assert!(error.contains("it.recording"), "{error}");
        lines.add(&["behind it"]).expect("nothing is added behind a line that may be torn");
        assert_eq!(read_growing(&path).expect("there"), ["anew"]);
        lines.begin(&["again"]).expect("there is room again");
        lines.add(&["and more"]).expect("written");
        assert_eq!(read_growing(&path).expect("there"), ["again", "and more"]);
    }
}
