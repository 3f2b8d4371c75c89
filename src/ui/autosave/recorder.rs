//! The recording of the session, kept as it grows, and those that were left behind.

use crate::io::{GrowingLines, IoError, LeftRecording, Origin, RecoveryFile, write_json};
use crate::scene::{Scene, UNTITLED};
use crate::sim::{Journal, JournalLine, JournalTail};
use crate::ui::placed::placed;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// What stands before the lines of the journal: where the scene names its models from.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Place {
    file: Option<PathBuf>,
    folder: PathBuf,
    shipped: bool,
}

/// A line of the file.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Line {
    Place(Place),
    #[serde(untagged)]
    Journal(JournalLine),
}

/// Keeps the journal of the motion as it grows.
pub(super) struct Recorder {
    tail: JournalTail,
    /// Where the document belongs whose motion begins next.
    origin: Origin,
    lines: Option<GrowingLines>,
}

impl Recorder {
    pub(super) fn new(tail: JournalTail, origin: Origin) -> Self {
        Self { tail, origin, lines: None }
    }

    /// Another document is open from now on.
    pub(super) fn of(&mut self, origin: Origin) {
        self.origin = origin;
    }

    /// The place where it is kept is another one.
    pub(super) fn moved(&mut self) {
        self.lines = None;
        self.tail.tell_anew();
    }

    /// Writes what has come.
    ///
    /// # Errors
    /// As every write; all is written anew the next time.
    pub(super) fn keep(&mut self, place: &RecoveryFile) -> Result<(), IoError> {
        let news = self.tail.news();
        if news.is_empty() {
            return Ok(());
        }
        let begins = matches!(news[0], JournalLine::Begin { .. });
        let lines = self.lines.get_or_insert_with(|| place.recording());
        let written = if begins {
            let whole = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
            let here = Path::new(".");
            let folder = if self.origin.folder.as_os_str().is_empty() { here } else { &self.origin.folder };
            let place = Place {
                file: self.origin.file.as_deref().map(whole),
                folder: whole(folder),
                shipped: self.origin.shipped,
            };
            let journal = news.into_iter().map(Line::Journal);
            lines.begin(&std::iter::once(Line::Place(place)).chain(journal).collect::<Vec<_>>())
        } else {
            lines.add(&news.into_iter().map(Line::Journal).collect::<Vec<_>>())
        };
        if written.is_err() {
            self.tail.tell_anew();
        }
        written
    }
}

/// A recording that was left behind, offered to be saved or discarded.
#[derive(Clone, Debug)]
pub(crate) struct RecordingOffer {
    /// The file.
    left: LeftRecording,
    /// The scene's name.
    name: String,
    /// Frames that were computed.
    pub(crate) frames: u64,
}

impl RecordingOffer {
    /// Offers a recording; none where it cannot be read. One of a motion that never went on is removed.
    pub(super) fn new(left: LeftRecording) -> Option<Self> {
        match read(&left).ok()? {
            Some((_, journal)) if journal.frames() > 0 => {
                Some(Self { name: journal.scene.name.clone(), frames: journal.frames(), left })
            }
            Some(_) => {
                // Where it stays, it is met again.
                left.discard().ok();
                None
            }
            // Perhaps a later version of the program can read it.
            None => None,
        }
    }

    /// The scene's name.
    pub(crate) fn name(&self) -> &str {
        if self.name.is_empty() { UNTITLED } else { &self.name }
    }

    /// When it was written last.
    pub(crate) fn written(&self) -> SystemTime {
        self.left.written
    }

    /// Where it goes unless another place is chosen: beside the scene's file.
    pub(crate) fn usual_place(&self) -> PathBuf {
        let file = read(&self.left).ok().flatten().and_then(|(place, _)| place.file);
        file.map_or_else(|| "recovered.journal.json".into(), |file| file.with_extension("recovered.journal.json"))
    }

    /// Writes it as a journal that can be replayed, whose models are found from its own folder.
    ///
    /// # Errors
    /// What cannot be read or written.
    pub(crate) fn save(&self, path: &Path) -> Result<(), IoError> {
        let Some((place, journal)) = read(&self.left)? else { return Err(IoError::Missing) };
        let to = path.parent().unwrap_or(Path::new(""));
        let journal = journal.with_scenes(|scene: &Scene| placed(scene, &place.folder, place.shipped, to))?;
        write_json(path, &journal)
    }

    /// Forgets it.
    ///
    /// # Errors
    /// A file that cannot be removed.
    pub(super) fn discard(&self) -> Result<(), IoError> {
        self.left.discard()
    }
}

/// What a recording holds, as far as it was written; none where no motion had started.
fn read(left: &LeftRecording) -> Result<Option<(Place, Journal)>, IoError> {
    let mut place = Place::default();
    let mut lines = Vec::new();
    for line in left.lines()? {
        match serde_json::from_value(line) {
            Ok(Line::Place(of)) => place = of,
            Ok(Line::Journal(line)) => lines.push(line),
            Err(_) => break,
        }
    }
    Ok(Journal::of_lines(lines).map(|journal| (place, journal)))
}
