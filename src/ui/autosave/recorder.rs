//! The recording of the session, kept as it grows, and those that were left behind.

use crate::io::{
    GrowingLines, IoError, Kept, LeftRecording, Origin, RecoveryFile, Stages, left_recordings, write_json,
};
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

/// How far reading has come is told every so many lines.
const EVERY: usize = 1000;

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
    /// Whether that is of a motion that is still to begin.
    awaits: bool,
    /// Whether the place that was written is another one.
    is_placed_anew: bool,
    lines: Option<GrowingLines>,
    /// Whether they hold all that has come.
    kept: Kept,
}

impl Recorder {
    pub(super) fn new(tail: JournalTail, origin: Origin) -> Self {
        Self { tail, origin, awaits: true, is_placed_anew: false, lines: None, kept: Kept::Whole }
    }

    /// Another document is open from now on.
    pub(super) fn of(&mut self, origin: Origin) {
        (self.origin, self.awaits, self.is_placed_anew) = (origin, true, false);
    }

    /// The document whose motion goes on belongs elsewhere now, or its models do.
    pub(super) fn placed(&mut self, origin: Origin) {
        self.origin = origin;
        self.is_placed_anew = !self.awaits;
    }

    /// All is written anew to a file that may become so long [bytes].
    #[cfg(test)]
    pub(super) fn bound(&mut self, path: PathBuf, limit: u64) {
        self.lines = Some(GrowingLines::up_to(path, limit));
        self.tail.tell_anew();
    }

    /// Where the document belongs, as a line.
    fn place(&self) -> Line {
        let whole = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let here = Path::new(".");
        let folder = if self.origin.folder.as_os_str().is_empty() { here } else { &self.origin.folder };
        let file = self.origin.file.as_deref().map(whole);
        Line::Place(Place { file, folder: whole(folder), shipped: self.origin.shipped })
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
    pub(super) fn keep(&mut self, place: &RecoveryFile) -> Result<Kept, IoError> {
        let news = self.tail.news();
        let begins = matches!(news.first(), Some(JournalLine::Begin { .. }));
        self.awaits &= !begins;
        // The last place that is written is the one that counts.
        let anew = std::mem::take(&mut self.is_placed_anew);
        let placed = (begins || anew).then(|| self.place());
        let news: Vec<Line> = placed.into_iter().chain(news.into_iter().map(Line::Journal)).collect();
        if news.is_empty() {
            return Ok(self.kept);
        }
        let lines = self.lines.get_or_insert_with(|| place.recording());
        let written = if begins { lines.begin(&news) } else { lines.add(&news) };
        match &written {
            Ok(kept) => self.kept = *kept,
            Err(_) => self.tail.tell_anew(),
        }
        written
    }
}

/// A recording that was left behind, offered to be saved or discarded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct RecordingOffer {
    /// The file.
    left: LeftRecording,
    /// The scene's file.
    file: Option<PathBuf>,
    /// The scene's name.
    name: String,
    /// Frames that were computed.
    pub(crate) frames: u64,
}

/// The recordings that were left in a folder. They may be long: that takes as long as reading them does.
pub(super) fn recordings_in(folder: &Path) -> Vec<RecordingOffer> {
    left_recordings(folder).into_iter().filter_map(RecordingOffer::new).collect()
}

impl RecordingOffer {
    /// Offers a recording; none where it cannot be read. One of a motion that never went on is removed.
    fn new(left: LeftRecording) -> Option<Self> {
        let (mut file, mut scene, mut frames) = (None, None, 0);
        for line in lines(&left).ok()? {
            match line {
                Line::Place(place) => file = place.file,
                Line::Journal(JournalLine::Begin { scene: of, .. }) => (scene, frames) = (Some(of.name), 0),
                Line::Journal(JournalLine::Frame(_)) => frames += 1,
                Line::Journal(JournalLine::Back { frames: to, .. }) => frames = frames.min(to as u64),
                Line::Journal(JournalLine::Asked(_)) => {}
            }
        }
        // Without a start perhaps a later version of the program can read it.
        let name = scene?;
        if frames == 0 {
            // Where it stays, it is met again.
            left.discard().ok();
            return None;
        }
        Some(Self { left, file, name, frames })
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
        let ending = "recovered.journal.json";
        self.file.as_ref().map_or_else(|| ending.into(), |file| file.with_extension(ending))
    }

    /// Writes it as a journal that can be replayed, whose models are found from its own folder.
    ///
    /// # Errors
    /// What cannot be read or written, and [`IoError::Cancelled`].
    pub(crate) fn save(&self, path: &Path, progress: &mut Stages<'_>) -> Result<(), IoError> {
        let Some((place, journal)) = read(&self.left, self.frames, progress)? else { return Err(IoError::Missing) };
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

/// The lines of a recording, as far as they were written and make sense.
fn lines(left: &LeftRecording) -> Result<impl Iterator<Item = Line>, IoError> {
    Ok(left.lines()?.map_while(|line| serde_json::from_value(line).ok()))
}

/// What a recording of about so many frames holds, as far as it was written; none where no motion had started.
/// `progress` hears how far it has come.
fn read(left: &LeftRecording, frames: u64, progress: &mut Stages<'_>) -> Result<Option<(Place, Journal)>, IoError> {
    let (mut place, mut found, mut told) = (Place::default(), Vec::new(), 0);
    for line in lines(left)? {
        match line {
            Line::Place(of) => place = of,
            Line::Journal(line) => {
                told += u64::from(matches!(line, JournalLine::Frame(_)));
                found.push(line);
            }
        }
        if found.len().is_multiple_of(EVERY)
            && progress(&format!("reading the recording, frame {told} of {frames}")).is_break()
        {
            return Err(IoError::Cancelled);
        }
    }
    Ok(Journal::of_lines(found).map(|journal| (place, journal)))
}
