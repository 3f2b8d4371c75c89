//! The sound files of `tests/corpus`, and folders for what is made of them.

use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Where Linux has files in memory: what is made there by the million costs no disk anything.
const IN_MEMORY: &str = "/dev/shm";

fn new_folder() -> TempDir {
    tempfile::tempdir_in(IN_MEMORY).or_else(|_| tempfile::tempdir()).expect("a folder")
}

/// Works in a folder that is gone afterwards.
pub fn in_new_folder<T>(work: impl FnOnce(&Path) -> T) -> T {
    work(new_folder().path())
}

thread_local! {
    static OWN: TempDir = new_folder();
}

/// Works in a folder of this name that the thread has for its own, which stays from work to work: whoever leaves files
/// there takes them away.
pub fn in_own_folder<T>(name: &str, work: impl FnOnce(&Path) -> T) -> T {
    let folder = OWN.with(|own| own.path().join(name));
    if !folder.is_dir() {
        fs::create_dir(&folder).expect("made");
    }
    work(&folder)
}

/// Files of one folder of the corpus, in the order of their names.
pub fn corpus(kind: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus").join(kind);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    assert!(!paths.is_empty(), "{kind}");
    paths.into_iter().map(|path| (path.clone(), fs::read(&path).expect("a file"))).collect()
}
