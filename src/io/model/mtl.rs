//! MTL: of the materials of an OBJ file, their diffuse colours. A model without its colours is still a model: what is
//! wrong with one is told and no more.

use super::limits::MAX_MODEL_BYTES;
use super::text::{Lines, decoded, number, shown, without_mark, words};
use crate::io::colours::linear;
use crate::io::read::read_bytes;
use std::collections::HashMap;
use std::path::Path;

/// What `mtllib` has brought so far.
#[derive(Default)]
pub(super) struct Materials {
    diffuse: HashMap<String, Option<[f32; 4]>>,
    /// Colours that cannot be shown.
    pub(super) notes: Vec<String>,
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

    fn load_one(&mut self, folder: &Path, name: &str) -> bool {
        // A path of the machine that it was exported on leads nowhere; the file is often beside the model.
        let last = name.rsplit(['/', '\\']).next().unwrap_or(name);
        let bytes = [name, last].into_iter().find_map(|name| read_bytes(&folder.join(name), MAX_MODEL_BYTES).ok());
        if let Some(bytes) = &bytes {
            self.read(bytes, last);
        }
        bytes.is_some()
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
                    material = decoded(line[b"newmtl".len()..].trim_ascii());
                    self.diffuse.insert(material.clone(), None);
                }
                b"Kd" => {
                    let mut value = || words.next().and_then(number).filter(|value| value.is_finite());
                    if let (Some(red), Some(green), Some(blue)) = (value(), value(), value()) {
                        self.diffuse.insert(material.clone(), Some(linear([red, green, blue])));
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
