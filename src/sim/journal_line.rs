//! A journal as it is kept while it grows: line by line, each of which stands for itself.

use super::journal::{Journal, JournalEntry};
use crate::scene::Scene;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A line of a journal that is kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum JournalLine {
    /// A motion starts: nothing of what stood before counts.
    Begin {
        /// Version of the program.
        program: String,
        /// The scene.
        scene: Box<Scene>,
    },
    /// Something was asked.
    Asked(JournalEntry),
    /// A frame came to this.
    Frame(String),
    /// Back to where so much had been asked and so many frames computed.
    Back {
        /// How much had been asked.
        asked: usize,
        /// How many frames had been computed.
        frames: usize,
    },
}

impl Journal {
    /// What the lines come to; none before a motion starts.
    pub(crate) fn of_lines(lines: impl IntoIterator<Item = JournalLine>) -> Option<Self> {
        let mut journal: Option<Self> = None;
        for line in lines {
            match (line, &mut journal) {
                (JournalLine::Begin { program, scene }, _) => {
                    journal = Some(Self { program, ..Self::new(Arc::new(*scene)) });
                }
                (JournalLine::Asked(entry), Some(journal)) => journal.asked.push(entry),
                (JournalLine::Frame(hash), Some(journal)) => journal.hashes.push(hash),
                (JournalLine::Back { asked, frames }, Some(journal)) => {
                    journal.asked.truncate(asked);
                    journal.hashes.truncate(frames);
                }
                (_, None) => {}
            }
        }
        journal
    }

    /// The lines that have come since the last time.
    pub(crate) fn news(&mut self) -> Vec<JournalLine> {
        let mut lines = Vec::new();
        let told = self.told;
        if !told.has_begun {
            let (program, scene) = (self.program.clone(), Box::new((*self.scene).clone()));
            lines.push(JournalLine::Begin { program, scene });
        } else if told.goes_back {
            lines.push(JournalLine::Back { asked: told.asked, frames: told.frames });
        }
        lines.extend(self.asked[told.asked..].iter().cloned().map(JournalLine::Asked));
        lines.extend(self.hashes[told.frames..].iter().cloned().map(JournalLine::Frame));
        self.told.all(self.asked.len(), self.hashes.len());
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sim::journal::Asked;

    /// What a reader makes of all lines so far.
    fn read(lines: &[JournalLine]) -> Journal {
        let text: Vec<String> = lines.iter().map(|line| serde_json::to_string(line).expect("JSON")).collect();
        let lines = text.iter().map(|line| serde_json::from_str(line).expect("a line"));
        Journal::of_lines(lines).expect("a motion started")
    }

    #[test]
    fn lines_come_to_the_journal_however_it_went() {
        let mut journal = Journal::new(Arc::new(Scene::new("first")));
        let mut lines = journal.news();
        assert_eq!(read(&lines), journal);
        assert!(journal.news().is_empty(), "nothing has come");
        let hash = |k: usize| format!("{k:016x}");
        for k in 0..40 {
            journal.push(Asked::MoveGrab([k as f64, 0.0, 0.0]));
            if k % 3 == 0 {
                lines.extend(journal.news());
            }
            // The last of those between two frames counts.
            journal.push(Asked::MoveGrab([k as f64, 1.0, 0.0]));
            if k % 4 != 1 {
                journal.hashes.push(hash(k));
            }
            if k % 11 == 10 {
                journal.go_back(journal.frames() - 4);
                journal.push(Asked::Release);
            }
            if k % 5 == 0 {
                lines.extend(journal.news());
                assert_eq!(read(&lines), journal, "{k}");
            }
        }
        lines.extend(journal.news());
        assert_eq!(read(&lines), journal);
        assert!(lines.len() < 200, "each is told once: {}", lines.len());
        // Torn anywhere, it is what had been by then.
        for end in 1..lines.len() {
            read(&lines[..end]);
        }
        assert_eq!(Journal::of_lines(lines[1..].iter().cloned()), None);
        // Another motion starts, and one that is told from its start once more.
        journal = Journal::new(Arc::new(Scene::new("second")));
        journal.hashes.push(hash(1));
        lines.extend(journal.news());
        assert_eq!(read(&lines), journal);
        journal.tell_anew();
        assert_eq!(read(&journal.news()), journal);
    }
}
