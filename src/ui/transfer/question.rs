//! What is asked about what leaves the window or comes into it, as plain data.

use crate::export::{BodySize, Space};
use crate::scene::Fibre;
use crate::sim::TakenMotion;
use crate::transfer::{Format, LineSpace, Program};
use std::path::PathBuf;
use std::sync::mpsc::Receiver;

/// A place that is asked for: typed, or picked in the desktop's own dialog while that is open.
#[derive(Default)]
pub(crate) struct PlaceField {
    /// What is typed.
    pub(super) text: String,
    /// The desktop's dialog.
    pub(super) browsing: Option<Receiver<Option<PathBuf>>>,
}

impl PlaceField {
    /// One that begins with a path.
    pub(super) fn of(path: &std::path::Path) -> Self {
        Self { text: path.display().to_string(), browsing: None }
    }

    /// The path; none where nothing is typed.
    pub(super) fn path(&self) -> Option<PathBuf> {
        let text = self.text.trim();
        (!text.is_empty()).then(|| text.into())
    }
}

/// What is known of the bodies that would be written.
pub(crate) enum Known {
    /// It was asked for.
    Asked(Receiver<Option<TakenMotion>>),
    /// Sizes of the bodies, and how long a frame is [s].
    Bodies(Vec<BodySize>, f64),
    /// The scene is not put together.
    Nothing,
}

/// Which frames are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    /// Those that the timeline keeps.
    Kept,
    /// Those of a run from the start of the scene.
    Anew,
}

/// What is asked before a motion is written.
pub(crate) struct MotionQuestion {
    /// In which formats.
    pub(super) formats: Vec<Format>,
    /// For which program; none for a unit and axes of one's own.
    pub(super) program: Option<Program>,
    /// That unit and these axes.
    pub(super) space: Space,
    /// Where the frames are from.
    pub(super) source: Source,
    /// The first and the last frame, once they were chosen.
    pub(super) range: Option<[u64; 2]>,
    /// Every so many frames.
    pub(super) step: u64,
    /// Size of pictures [pixels].
    pub(super) size: [u32; 2],
    /// Sizes of pictures that are offered.
    pub(super) sizes: Vec<[u32; 2]>,
    /// The folder.
    pub(super) folder: PlaceField,
    /// What is known of the bodies.
    pub(super) known: Known,
    /// Folder, formats, first, last and step that were looked at last, and how many files there would be replaced.
    pub(super) replaced: Option<(Looked, usize)>,
}

/// What the files in a folder were counted for.
pub(crate) type Looked = (String, Vec<Format>, [u64; 3]);

/// What a clip shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ClipKind {
    /// The frames that the timeline keeps.
    Motion,
    /// What is shown now, once around.
    Turntable,
}

/// What is asked before a clip is saved.
pub(crate) struct ClipQuestion {
    /// What it shows.
    pub(super) kind: ClipKind,
    /// Size of its pictures [pixels].
    pub(super) size: [u32; 2],
    /// Sizes that are offered.
    pub(super) sizes: Vec<[u32; 2]>,
    /// The file.
    pub(super) file: PlaceField,
}

/// What is asked before fibres go out or come in as lines.
pub(crate) struct LinesQuestion {
    /// The body that lines become fibres of: identifier and title; none where fibres go out.
    pub(super) into: Option<(String, String)>,
    /// Fibres that go out, by their identifiers, and the body that they are of; empty where lines come in.
    pub(super) fibres: Vec<String>,
    /// The file.
    pub(super) file: PlaceField,
    /// Frame, unit and axes of the lines.
    pub(super) at: LineSpace,
    /// What is being done.
    pub(super) work: Option<Receiver<Result<LinesDone, String>>>,
    /// Why it could not be done.
    pub(super) problem: Option<String>,
}

/// What became of lines.
pub(crate) enum LinesDone {
    /// They were read as these fibres of the body of this identifier.
    Read(String, Vec<Fibre>),
    /// So many were written to a file.
    Written(usize, PathBuf),
}

/// What is asked.
pub(crate) enum TransferQuestion {
    /// About a motion.
    Motion(Box<MotionQuestion>),
    /// About a clip.
    Clip(ClipQuestion),
    /// About lines.
    Lines(Box<LinesQuestion>),
}
