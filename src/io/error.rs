//! What can go wrong with a file, each as one line that says what, where and what to do.

use crate::geometry::model_report::Refusal;
use crate::scene::{SceneError, one_line};
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// A file that cannot be read or written, or whose content cannot be used.
#[derive(Debug, Error)]
pub enum IoError {
    /// Any of the errors below, in a file.
    #[error("{}: {error}", one_line(&file.display().to_string()))]
    InFile {
        /// The file.
        file: PathBuf,
        /// What is wrong with it.
        error: Box<IoError>,
    },
    /// There is nothing at the path.
    #[error("there is no such file; check the path")]
    Missing,
    /// A folder, pipe or device where a file is needed.
    #[error("this is {0}, not a file; name a regular file")]
    NotAFile(&'static str),
    /// A file too large to be meant.
    #[error("the file has {bytes} bytes where at most {limit} are read; is it the right file?")]
    TooLarge {
        /// Size of the file.
        bytes: u64,
        /// Greatest size that is read.
        limit: u64,
    },
    /// JSON of so many small values that they take far more memory than the text.
    #[error(
        "its values would take about {megabytes} MB of memory where its {bytes} bytes are given {most} MB; is it the right file?"
    )]
    TooManyValues {
        /// Length of the text [bytes].
        bytes: usize,
        /// Memory that they would take [MiB].
        megabytes: u64,
        /// Most that is taken for such a text [MiB].
        most: u64,
    },
    /// Models of which the scene makes too many particles.
    #[error(
        "with the bodies before it the scene has about {particles:.1e} particles where {most:.0e} are allowed; give {what}"
    )]
    TooManyParticles {
        /// How many there would be.
        particles: f64,
        /// Greatest number.
        most: f64,
        /// What to change.
        what: &'static str,
    },
    /// What was read is no longer wanted.
    #[error("it was no longer wanted")]
    Cancelled,
    /// The system refused to read.
    #[error("the file cannot be read ({0}); check its permissions")]
    Read(#[source] io::Error),
    /// The system refused to write; what was there before is still there.
    #[error("the file cannot be written ({0}); check that its folder exists, has room and may be written to")]
    Write(#[source] io::Error),
    /// A number that is none, on its way into a file; what was there before is still there.
    #[error("{what} is {value}, which no file may hold, so nothing was written; if a run gave it, take smaller steps")]
    NotFinite {
        /// What the number is of.
        what: String,
        /// What it is instead of a number.
        value: String,
    },
    /// A file of lines, by its name.
    #[error("the name does not end like that of a file of lines; give .obj, .csv or .json")]
    UnknownLines,
    /// A file that a model names and that lies outside of the model's folder.
    #[error(
        "it names {}, which lies outside of its folder and cannot go along under that name; pack it with the model, or put \
         it beside it",
        one_line(&file.display().to_string())
    )]
    CompanionOutside {
        /// The file.
        file: PathBuf,
    },
    /// A motion that a format cannot hold.
    #[error(
        "--format {format}: {frames} frames of these bodies are more than the {most} that a file takes; choose fewer by \
         --frames, or a format without that limit, such as usd"
    )]
    TooLong {
        /// Name of the format.
        format: &'static str,
        /// Frames that were asked for.
        frames: u64,
        /// Most that it takes.
        most: u64,
    },
    /// More than the lengths of a GLB file can say.
    #[error("a GLB file of {bytes} bytes would be longer than the 4 GiB that its format allows; write less into it")]
    TooLargeForGlb {
        /// How many bytes it would have.
        bytes: u64,
    },
    /// The system refused to make or use a folder.
    #[error("the folder cannot be written to ({0}); name a folder that can be made or may be written to")]
    Folder(#[source] io::Error),
    /// Bytes that are no text.
    #[error("the file is not text in UTF-8 from byte {at} on; save it as UTF-8")]
    NotUtf8 {
        /// Offset of the first such byte.
        at: usize,
    },
    /// A file that is no model, by its name.
    #[error("the name does not end like that of a model; give an OBJ, STL, PLY, glTF or GLB file")]
    UnknownModel,
    /// A file that holds no skeleton, by its name.
    #[error(
        "the name does not end like that of a file with a skeleton; give a glTF or GLB file with a skin and an animation"
    )]
    UnknownSkeleton,
    /// A file that is no point cache, by its name.
    #[error("the name does not end like that of a point cache; give a PC2 or MDD file")]
    UnknownCache,
    /// A model that cannot be understood.
    #[error("the {format} file cannot be read ({problem}); {remedy}")]
    Model {
        /// Format, as its name ends.
        format: &'static str,
        /// What is wrong, and where.
        problem: String,
        /// What to do about it.
        remedy: String,
    },
    /// A model without an inside.
    #[error(transparent)]
    Refused(#[from] Refusal),
    /// Files that a scene names outside of where its own things lie.
    #[error(
        "it reads files outside of its folder: {}; let it by --outside if you trust it, or put them beside it, as `sinew collect \
         --outside` does",
        files.iter().map(|file| one_line(&file.display().to_string())).collect::<Vec<_>>().join(", ")
    )]
    Outside {
        /// The files.
        files: Vec<PathBuf>,
    },
    /// A file that a scene names.
    #[error("{pointer}: {error}")]
    Asset {
        /// RFC 6901 pointer to where the scene names it.
        pointer: String,
        /// What is wrong with it.
        error: Box<IoError>,
    },
    /// Text that is not JSON.
    #[error("line {line}, column {column}{}: {problem}; correct the JSON there", at_path(path))]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// RFC 6901 pointer to the value that was being read, as far as it is known.
        path: String,
        /// What is wrong there.
        problem: String,
    },
    /// A version of the format that this program does not read.
    #[error(transparent)]
    Version(SceneError),
    /// JSON of another shape than a scene has.
    #[error(transparent)]
    Type(SceneError),
    /// A pointer that leads to no field of a scene.
    #[error(transparent)]
    Pointer(SceneError),
    /// A value out of range or a reference to nothing.
    #[error(transparent)]
    Invalid(#[from] SceneError),
}

impl IoError {
    /// The same error with the file it is in.
    pub(crate) fn within(self, file: &Path) -> Self {
        Self::InFile { file: file.to_owned(), error: Box::new(self) }
    }

    /// What a writer gave: an error of its own, or one of the system's.
    pub(super) fn of_writing(error: io::Error) -> Self {
        match error.downcast::<Self>() {
            Ok(own) => own,
            Err(error) => Self::Write(error),
        }
    }

    /// The error without the file it is in.
    pub fn bare(&self) -> &Self {
        match self {
            Self::InFile { error, .. } | Self::Asset { error, .. } => error.bare(),
            other => other,
        }
    }
}

fn at_path(path: &str) -> String {
    if path.is_empty() { String::new() } else { format!(" (at {path})") }
}
