//! MTL: of the materials of an OBJ file, their diffuse colours. A model without its colours is still a model: what is
//! wrong with one is told and no more.

use super::limits::{MAX_MODEL_BYTES, TOLD};
use super::text::{Lines, named, number, shown, without_mark, words};
use crate::io::colours::linear;
use crate::io::paths::resolved;
use crate::io::read::read_bytes;
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

/// Names of libraries that are looked for, at most.
pub(super) const MOST_LIBRARIES: usize = 1000;

/// What `mtllib` has brought so far.
#[derive(Default)]
pub(super) struct Materials {
    diffuse: HashMap<String, Option<[f32; 4]>>,
    /// Colours that cannot be shown: the first ones, and how many more.
    notes: Vec<String>,
    more: usize,
    /// Names of libraries that were looked for, and the files that were found: once read, one has no more to say.
    names: HashSet<String>,
    files: HashSet<PathBuf>,
}

impl Materials {
    /// Reads the libraries that a line names: one with spaces in its name, or several; those that are not there give no
    /// colours.
    pub(super) fn load(&mut self, folder: &Path, names: &str) {
        if !self.load_one(folder, names) {
            for name in names.split_whitespace() {
                self.load_one(folder, name);
            }
        }
    }

    /// Whether there is nothing more to look for.
    fn load_one(&mut self, folder: &Path, name: &str) -> bool {
        if self.names.len() >= MOST_LIBRARIES || !self.names.insert(name.to_owned()) {
            return true;
        }
        // A path of the machine that it was exported on leads nowhere; the file is often beside the model.
        let last = name.rsplit(['/', '\\']).next().unwrap_or(name);
        [name, last].into_iter().any(|name| {
            let path = folder.join(name);
            if resolved(&path).is_some_and(|file| !self.files.insert(file)) {
                return true;
            }
            let bytes = read_bytes(&path, MAX_MODEL_BYTES);
            bytes.map(|bytes| self.read(&bytes, last)).is_ok()
        })
    }

    /// What is to be said of them.
    pub(super) fn told(self) -> impl Iterator<Item = String> {
        let unread = (self.names.len() >= MOST_LIBRARIES)
            .then(|| format!("of more than {MOST_LIBRARIES} names of libraries of materials the first ones count"));
        let more = (self.more > 0).then(|| format!("{} more lines of materials are no colours either", self.more));
        self.notes.into_iter().chain(more).chain(unread)
    }

    /// Whether there is a material of that name.
    pub(super) fn knows(&self, name: &str) -> bool {
        self.diffuse.contains_key(name)
    }

    /// The diffuse colour of a material, if it has one.
    pub(super) fn colour(&self, name: &str) -> Option<[f32; 4]> {
        self.diffuse.get(name).copied().flatten()
    }

    fn read(&mut self, bytes: &[u8], file: &str) {
        let text = without_mark(bytes);
        let mut material = String::new();
        for (line_number, line) in Lines::new(&text) {
            let mut words = words(line);
            match words.next().unwrap_or_default() {
                b"newmtl" => {
                    let line = line.trim_ascii();
                    material = named(line[b"newmtl".len()..].trim_ascii());
                    self.diffuse.insert(material.clone(), None);
                }
                b"Kd" => {
                    let mut value = || words.next().and_then(number).filter(|value| value.is_finite());
                    if let (Some(red), Some(green), Some(blue)) = (value(), value(), value()) {
                        self.diffuse.insert(material.clone(), Some(linear([red, green, blue])));
                    } else if self.notes.len() >= TOLD {
                        self.more += 1;
                    } else {
                        self.notes.push(format!(
                            "{file}, line {line_number}: `{}` is not red, green and blue: material `{material}` is shown \
                             without its colour",
                            shown(line)
                        ));
                    }
                }
                _ => {}
            }
        }
    }
}
