//! A person's own patterns: kept in a folder, one file each.

use crate::io::{IoError, JsonFile, JsonFolder};
use crate::sketch::pattern::OwnPattern;
use std::path::{Path, PathBuf};

/// What is kept, as far as it is known.
#[derive(Default)]
pub(crate) struct OwnPatterns {
    /// Where; nowhere unless a folder was given.
    folder: Option<JsonFolder>,
    /// What was found there; none before it was looked at.
    found: Option<Result<Vec<JsonFile<OwnPattern>>, IoError>>,
}

impl OwnPatterns {
    /// Those in a folder, which is not looked at yet.
    pub(crate) fn of(folder: PathBuf) -> Self {
        Self { folder: Some(JsonFolder::new(folder)), found: None }
    }

    /// Looks at what is there, unless it is known.
    pub(crate) fn look(&mut self) {
        if let (Some(folder), None) = (&self.folder, &self.found) {
            self.found = Some(folder.list());
        }
    }

    /// Looks again at what is there: a file was written or removed.
    pub(crate) fn look_again(&mut self) {
        self.found = None;
        self.look();
    }

    /// The usable patterns with their files.
    pub(crate) fn patterns(&self) -> impl Iterator<Item = (&Path, &OwnPattern)> {
        let usable = |kept: &JsonFile<OwnPattern>| kept.content.is_ok();
        let found = self.found.iter().flatten().flatten().filter(move |kept| usable(kept));
        found.filter_map(|kept| Some((kept.path.as_path(), kept.content.as_ref().ok()?)))
    }

    /// What is wrong with the folder or with files in it.
    pub(crate) fn problems(&self) -> Vec<String> {
        match &self.found {
            Some(Err(error)) => vec![error.to_string()],
            Some(Ok(kept)) => kept.iter().filter_map(|kept| Some(kept.content.as_ref().err()?.to_string())).collect(),
            None => Vec::new(),
        }
    }

    /// The pattern in a file.
    pub(crate) fn get(&self, path: &Path) -> Option<&OwnPattern> {
        self.patterns().find(|(known, _)| *known == path).map(|(_, own)| own)
    }

    /// The folder to keep patterns in, if there is one.
    pub(crate) fn folder(&self) -> Option<&JsonFolder> {
        self.folder.as_ref()
    }
}
