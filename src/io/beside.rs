//! Files that are put beside a scene because it names them.

use super::read::read_bytes;
use super::{IoError, write_atomically};
use std::path::Path;

/// Puts a file of this name and content into a folder, under another name where that is taken by something else. One
/// that is there already is left alone. Returns the name.
///
/// # Errors
/// [`IoError::InFile`] with [`IoError::Write`], or [`IoError::Read`] of a folder that cannot be looked into.
pub(crate) fn put_beside(folder: &Path, name: &str, content: &[u8]) -> Result<String, IoError> {
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let mut number = 1;
    loop {
        let tried = if number == 1 { name.to_owned() } else { format!("{stem}-{number}.{ending}") };
        let path = folder.join(&tried);
        match read_bytes(&path, content.len() as u64) {
            Ok(there) if there == content => return Ok(tried),
            Err(IoError::Missing) => {
                write_atomically(&path, |out| out.write_all(content))?;
                return Ok(tried);
            }
            Ok(_) | Err(IoError::NotAFile(_) | IoError::TooLarge { .. }) => number += 1,
            Err(error) => return Err(error.within(&path)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_is_there_is_never_written_over() {
        let folder = tempfile::tempdir().expect("a folder");
        let put = |content: &[u8]| put_beside(folder.path(), "a.glb", content).expect("written");
        assert_eq!([put(b"one"), put(b"one"), put(b"other"), put(b"other")], ["a.glb", "a.glb", "a-2.glb", "a-2.glb"]);
        assert_eq!(fs::read(folder.path().join("a.glb")).expect("there"), b"one");
    }

    #[test]
    fn what_is_no_folder_is_an_error() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("file");
        fs::write(&file, "no folder").expect("written");
        let error = put_beside(&file, "a.glb", b"one").expect_err("nothing can be put there").to_string();
        assert!(error.contains("file"), "{error}");
    }
}
