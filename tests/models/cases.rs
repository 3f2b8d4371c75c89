//! A file in, and what is right of it: a volume, a note, or the words of a refusal.

use sinew::geometry::{Model, Solid};
use sinew::io::{IoError, load_model};
use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

/// Corners of a cube of side 2 at the origin; 8 m³.
pub const CORNERS: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [2.0, 0.0, 0.0],
    [2.0, 2.0, 0.0],
    [0.0, 2.0, 0.0],
    [0.0, 0.0, 2.0],
    [2.0, 0.0, 2.0],
    [2.0, 2.0, 2.0],
    [0.0, 2.0, 2.0],
];

/// Its faces, outwards.
pub const QUADS: [[u32; 4]; 6] = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/// Two for each of them.
pub fn triangles() -> Vec<[u32; 3]> {
    QUADS.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
}

/// What is right.
#[derive(Clone, Debug)]
pub enum Right {
    /// Read, closed and with nothing to say: its volume [m³].
    Volume(f64),
    /// Read, with notes that have these words.
    Noted(f64, &'static [&'static str]),
    /// Refused in one line that has these words.
    Refused(&'static [&'static str]),
}

/// Words that no message has: those of a parser's own types, of a panic, of a place in somebody's machine.
pub const NEVER: [&str; 9] =
    ["Error", "panick", "unwrap", ".rs", "registry", "expected", "ParseFloat", "None", "Some("];

/// A folder to put files into.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    pub fn put(&self, name: &str, bytes: &[u8]) {
        fs::write(self.path(name), bytes).expect("written");
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn load(&self, name: &str) -> Result<Model, IoError> {
        load_model(&self.path(name))
    }

    pub fn model(&self, name: &str) -> Model {
        self.load(name).unwrap_or_else(|error| panic!("{error}"))
    }

    /// Reads a file and compares what comes of it.
    pub fn check(&self, case: &str, name: &str, bytes: &[u8], right: &Right) {
        self.put(name, bytes);
        let path = self.path(name);
        let read = self.load(name);
        let said = match &read {
            Ok(model) => {
                assert!(model.positions.iter().all(|position| position.is_finite()), "{case}");
                model.notes.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
            }
            Err(error) => error.to_string(),
        };
        let shown = said.replace(&path.display().to_string(), name);
        for word in NEVER {
            assert!(!shown.contains(word), "{case}: {shown}");
        }
        match (right, read) {
            (Right::Volume(volume), Ok(model)) => {
                let solid = Solid::new(&model).unwrap_or_else(|refusal| panic!("{case}: {refusal}"));
                assert!(solid.report.closed && said.is_empty(), "{case}: {said}");
                assert!((solid.volume / volume - 1.0).abs() < 1e-6, "{case}: {} m³", solid.volume);
            }
            (Right::Noted(volume, words), Ok(model)) => {
                let solid = Solid::new(&model).unwrap_or_else(|refusal| panic!("{case}: {refusal}"));
                assert!((solid.volume / volume - 1.0).abs() < 1e-6, "{case}: {} m³", solid.volume);
                assert!(words.iter().all(|word| said.contains(word)), "{case}: {said}");
                // What the file lacks is among what is found in it.
                assert!(solid.report.findings().iter().any(|finding| said.contains(&finding.text)), "{case}");
            }
            (Right::Refused(words), Err(_)) => {
                assert!(shown.starts_with(name) && shown.lines().count() == 1, "{case}: {shown}");
                assert!(words.iter().all(|word| shown.contains(word)), "{case}: {shown}");
            }
            (right, Ok(_)) => panic!("{case}: read, with {said:?}, where {right:?} is right"),
            (right, Err(_)) => panic!("{case}: {shown}, where {right:?} is right"),
        }
    }
}

/// UTF-16 with its byte order mark.
pub fn utf16(text: &str, unit: fn(u16) -> [u8; 2]) -> Vec<u8> {
    std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(unit).collect()
}

/// The same text in every way that a text file comes.
pub fn encodings(text: &str) -> Vec<(String, Vec<u8>)> {
    let ends = [("lf", "\n"), ("crlf", "\r\n"), ("cr", "\r")];
    let mut all = Vec::new();
    for (end, line_end) in ends {
        let text = text.replace('\n', line_end);
        all.push((end.to_owned(), text.clone().into_bytes()));
        all.push((format!("{end}, bom"), format!("\u{feff}{text}").into_bytes()));
        all.push((format!("{end}, utf-16 little"), utf16(&text, u16::to_le_bytes)));
        all.push((format!("{end}, utf-16 big"), utf16(&text, u16::to_be_bytes)));
        all.push((format!("{end}, no last line end"), text.trim_end().as_bytes().to_vec()));
    }
    all
}
