//! Why a motion or lines cannot be written or read, each in one sentence.

use crate::io::IoError;
use crate::scene::one_line;
use crate::sim::NotFinite;
use std::path::PathBuf;
use thiserror::Error;

/// A motion that cannot be written.
#[derive(Debug, Error)]
pub(crate) enum TransferError {
    /// A file that cannot be written or read.
    #[error(transparent)]
    Io(#[from] IoError),
    /// A file that would be written over one that is read.
    #[error("{}: {first} and {second} are the same file; give {second} another name", one_line(&path.display().to_string()))]
    SameFile {
        /// The file.
        path: PathBuf,
        /// What is read.
        first: &'static str,
        /// What would be written.
        second: &'static str,
    },
    /// A fibre that cannot be written or read.
    #[error("{which}: {problem}")]
    Fibre {
        /// The fibre and where it stands.
        which: String,
        /// What is wrong with it, and what to do.
        problem: String,
    },
    /// A body that the scene does not have.
    #[error("no fibre solid is called {name:?}; the scene has {bodies}")]
    NoBody {
        /// What was asked for.
        name: String,
        /// Names of those that there are.
        bodies: String,
    },
    /// A title that several bodies have.
    #[error("several fibre solids are called {:?}: {ids}", one_line(name))]
    SeveralBodies {
        /// What was asked for.
        name: String,
        /// Their identifiers.
        ids: String,
    },
    /// A body in a state that can be neither drawn nor written.
    #[error(transparent)]
    NotFinite(#[from] NotFinite),
    /// A picture cannot be made.
    #[cfg(feature = "render")]
    #[error(transparent)]
    Render(#[from] crate::render::RenderError),
    /// A picture was asked of a program that was built without them.
    #[cfg(not(feature = "render"))]
    #[error("this program was built without pictures; build it with `cargo build --release --features render`")]
    NoPictures,
}
