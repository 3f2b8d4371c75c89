//! The files that were opened last.

use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Paths of files, the one that was used last first: at most [`RecentFiles::MOST`], each once. As JSON an array of
/// paths.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "Vec<PathBuf>", into = "Vec<PathBuf>")]
pub struct RecentFiles(Vec<PathBuf>);

impl RecentFiles {
    /// Most files that are remembered.
    pub const MOST: usize = 10;

    /// Puts a file first.
    pub fn add(&mut self, path: &Path) {
        // One file is one entry, from wherever it was named.
        let path = path.canonicalize().or_else(|_| std::path::absolute(path)).unwrap_or_else(|_| path.to_owned());
        self.0.retain(|old| *old != path);
        self.0.insert(0, path);
        self.0.truncate(Self::MOST);
    }

    /// Forgets files that are no longer there.
    pub fn drop_missing(&mut self) {
        self.0.retain(|path| path.is_file());
    }

    /// The files, the one that was used last first.
    pub fn paths(&self) -> &[PathBuf] {
        &self.0
    }
}

impl From<Vec<PathBuf>> for RecentFiles {
    /// What was stored may have been edited: repeats and what is too much are left out.
    fn from(paths: Vec<PathBuf>) -> Self {
        let mut kept = Vec::new();
        for path in paths {
            if kept.len() < Self::MOST && !kept.contains(&path) {
                kept.push(path);
            }
        }
        Self(kept)
    }
}

impl From<RecentFiles> for Vec<PathBuf> {
    fn from(recent: RecentFiles) -> Self {
        recent.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn the_last_ten_are_kept_each_once() {
        let folder = tempfile::tempdir().expect("a folder");
        let root = folder.path().canonicalize().expect("a folder");
        let path = |k: usize| root.join(format!("{k}.json"));
        let mut recent = RecentFiles::default();
        for k in 0..12 {
            fs::write(path(k), "").expect("written");
            recent.add(&path(k));
        }
        assert!(recent.paths().iter().eq((2..12).rev().map(path).collect::<Vec<_>>().iter()));
        // The same file by another name moves to the front.
        fs::create_dir(root.join("inner")).expect("made");
        recent.add(&root.join("inner").join("..").join("5.json"));
        assert_eq!((recent.paths().len(), &recent.paths()[0]), (10, &path(5)));
        assert_eq!(recent.paths().iter().filter(|other| **other == path(5)).count(), 1);
        fs::remove_file(path(5)).expect("removed");
        fs::remove_file(path(7)).expect("removed");
        recent.drop_missing();
        assert!(recent.paths().iter().eq([11, 10, 9, 8, 6, 4, 3, 2].map(path).iter()));
        recent.add(&path(5));
        assert_eq!(recent.paths()[0], path(5), "a file that is not there yet has a place too");
    }

    #[test]
    fn stored_lists_are_read_whatever_they_hold() {
        let mut recent = RecentFiles::default();
        recent.add(Path::new("/a.json"));
        recent.add(Path::new("/b.json"));
        let text = serde_json::to_string(&recent).expect("paths are text");
        assert_eq!(serde_json::from_str::<RecentFiles>(&text).expect("a list"), recent);
        let long: Vec<String> = (0..30).map(|k| format!("/{}.json", k / 2)).collect();
        let text = serde_json::to_string(&long).expect("text");
        let read: RecentFiles = serde_json::from_str(&text).expect("a list");
        assert!(
            read.paths().iter().eq((0..10).map(|k| PathBuf::from(format!("/{k}.json"))).collect::<Vec<_>>().iter())
        );
    }
}
