//! What can go wrong on the command line, each as one line that says what, where and what to do.

use crate::bake::BakeError;
use crate::io::IoError;
use crate::scene::{SceneError, one_line};
use crate::sim::NotFinite;
use crate::transfer::TransferError;
use rayon::ThreadPoolBuildError;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// A command that cannot do its work.
#[derive(Debug, Error)]
pub enum CliError {
    /// A file or a value that was set cannot be used.
    #[error(transparent)]
    Io(#[from] IoError),
    /// A value that an option gave cannot be used.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A scene that cannot be put together.
    #[error("{scene}: {source}")]
    Bake {
        /// Where the scene is from.
        scene: String,
        /// What is wrong with it.
        source: BakeError,
    },
    /// A journal whose motion cannot be made again.
    #[error("{}: {problem}", printable(path))]
    Journal {
        /// Where it is.
        path: PathBuf,
        /// Why.
        problem: String,
    },
    /// Frames a second asked of a scene whose frames follow from its time step.
    #[error(
        "--fps: the scene steps by hand (/time/step/manual), so a frame lasts dt x substeps_per_frame = {frame} s; \
         set /time/step/manual/dt and /time/step/manual/substeps_per_frame instead"
    )]
    ManualFrames {
        /// Length of a frame [s].
        frame: f64,
    },
    /// Scenes that a command needs are not where it looks.
    #[error(
        "{}: there is no {}; run this in the project's folder, or give the folder of its scenes by --scenes DIR",
        printable(folder),
        missing.iter().map(|path| printable(path)).collect::<Vec<_>>().join(" and no ")
    )]
    NoScenes {
        /// Folder that was looked in.
        folder: PathBuf,
        /// Files that are missing.
        missing: Vec<PathBuf>,
    },
    /// A body in a state that can be neither drawn nor written.
    #[error(transparent)]
    NotFinite(#[from] NotFinite),
    /// Options of pictures where none are made.
    #[error("--view, --size, --x-ray, --particles and --theme say how pictures look; give --png DIR to make some")]
    NoPicturesAsked,
    /// Options of files where none are written.
    #[error(
        "--format, --frames, --step, --for, --scale and --up say what is written of a run; give --out DIR for its files to go to"
    )]
    NoFilesAsked,
    /// Frames that a run does not have.
    #[error(
        "--frames {first}..{last}: the run has the frames 0 to {most}; choose among them, or give a longer time by --seconds"
    )]
    FramesBeyond {
        /// First that was asked for.
        first: u64,
        /// Last that was asked for.
        last: u64,
        /// Last that there is.
        most: u64,
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
    #[error("no fibre solid is called {name:?}; name one by --body: the scene has {bodies}")]
    NoBody {
        /// What was asked for.
        name: String,
        /// Names of those that there are.
        bodies: String,
    },
    /// A title that several bodies have.
    #[error("several fibre solids are called {:?}; name one by its identifier: {ids}", one_line(name))]
    SeveralBodies {
        /// What was asked for.
        name: String,
        /// Their identifiers.
        ids: String,
    },
    /// Two files that would be one.
    #[error("{}: {first} and {second} are the same file; give {second} another name", printable(path))]
    SameFile {
        /// The file.
        path: PathBuf,
        /// What it is first.
        first: &'static str,
        /// What it would also be.
        second: &'static str,
    },
    /// A combination of values that a sweep cannot run.
    #[error("{values}: {source}")]
    Row {
        /// Pointers and values of the combination.
        values: String,
        /// What is wrong with it.
        source: Box<CliError>,
    },
    /// A sweep over one value twice.
    #[error("--vary {pointer}: this value is varied twice; give all its values in one list")]
    VariedTwice {
        /// Pointer to the value.
        pointer: String,
    },
    /// A sweep of too many combinations.
    #[error("--vary: {rows} combinations, where at most {limit} are run; give fewer values")]
    TooManyRows {
        /// Number of combinations.
        rows: u128,
        /// Greatest number.
        limit: u128,
    },
    /// A sweep that draws values, without a number of draws.
    #[error("--vary {pointer}: how many values are to be drawn? Give --samples N")]
    NoSamples {
        /// Pointer to the value.
        pointer: String,
    },
    /// A number of draws where nothing is drawn.
    #[error("--samples: no --vary draws its values; write one as in 0.1..0.9/random")]
    NothingDrawn,
    /// A file that is no report of a run that could be made again.
    #[error(
        "--from: {path}: it is no report of a run that says how it was made; write one with simulate --report FILE"
    )]
    NotARun {
        /// The file.
        path: String,
    },
    /// A body that is not there to be filled in layers.
    #[error("--body {given}: there is no such fibre solid to fill in layers; known: {known}")]
    NotRefined {
        /// What was asked for.
        given: String,
        /// The fibre solids that there are.
        known: String,
    },
    /// A scene without a measure.
    #[error("{scene}: it measures nothing, so nothing can be compared; add to /measures what should be looked at")]
    NothingMeasured {
        /// The scene.
        scene: String,
    },
    /// A report that a sweep cannot go on from.
    #[error("--resume: {path}: {what}; name another --report, or run without --resume")]
    CannotResume {
        /// The report.
        path: String,
        /// What is wrong with it.
        what: String,
    },
    /// A plot of something that there is not.
    #[error("{option} {given}: there is no such thing to plot; known: {known}")]
    NotToBePlotted {
        /// The option.
        option: &'static str,
        /// What was asked for.
        given: String,
        /// What there is.
        known: String,
    },
    /// Threads could not be started.
    #[error("--threads: the threads cannot be started ({0}); ask for fewer")]
    Threads(#[from] ThreadPoolBuildError),
    /// Rows of a series that cannot be formatted.
    #[error("--series: a row cannot be written ({0})")]
    Series(#[from] csv::Error),
    /// A picture cannot be made.
    #[cfg(feature = "render")]
    #[error(transparent)]
    Render(#[from] crate::render::RenderError),
    /// A picture was asked of a program that was built without them.
    #[cfg(not(feature = "render"))]
    #[error("this program was built without pictures; build it with `cargo build --release --features render`")]
    NoPictures,
    /// Standard output takes nothing.
    #[error("standard output cannot be written to ({0}); check where it goes")]
    Output(#[source] io::Error),
}

impl From<TransferError> for CliError {
    fn from(error: TransferError) -> Self {
        match error {
            TransferError::Io(error) => Self::Io(error),
            TransferError::SameFile { path, first, second } => Self::SameFile { path, first, second },
            TransferError::Fibre { which, problem } => Self::Fibre { which, problem },
            TransferError::NoBody { name, bodies } => Self::NoBody { name, bodies },
            TransferError::SeveralBodies { name, ids } => Self::SeveralBodies { name, ids },
            TransferError::NotFinite(lost) => Self::NotFinite(lost),
            #[cfg(feature = "render")]
            TransferError::Render(error) => Self::Render(error),
            #[cfg(not(feature = "render"))]
            TransferError::NoPictures => Self::NoPictures,
        }
    }
}

#[cfg(feature = "render")]
impl CliError {
    /// Whether a graphics driver is what is missing.
    pub(super) fn is_no_driver(&self) -> bool {
        matches!(self, Self::Render(crate::render::RenderError::NoDriver(_)))
    }
}

/// A path on one line.
pub(super) fn printable(path: &Path) -> String {
    one_line(&path.display().to_string())
}
