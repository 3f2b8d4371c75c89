//! A person's own patterns: kept in a folder, one file each.

use super::{Chosen, Fit};
use crate::edit::fibre_ops;
use crate::io::{IoError, JsonFile, JsonFolder};
use crate::sketch::pattern::{OwnPattern, Polyline};
use crate::ui::app::{App, Gravity};
use crate::ui::dialogs::Dialog;
use crate::ui::theme::GRID;
use egui::{Key, TextEdit, Ui};
use std::path::{Path, PathBuf};

/// Longest name and line of a pattern [letters].
const TITLE_LENGTH: usize = 40;
const LINE_LENGTH: usize = 120;

/// What is kept, as far as it is known.
#[derive(Default)]
pub(super) struct Own {
    /// Where; nowhere unless a folder was given.
    folder: Option<JsonFolder>,
    /// What was found there; none before it was looked at.
    found: Option<Result<Vec<JsonFile<OwnPattern>>, IoError>>,
}

impl Own {
    pub(super) fn of(folder: PathBuf) -> Self {
        Self { folder: Some(JsonFolder::new(folder)), found: None }
    }

    /// Looks at what is there, unless it is known.
    pub(super) fn look(&mut self) {
        if let (Some(folder), None) = (&self.folder, &self.found) {
            self.found = Some(folder.list());
        }
    }

    /// The usable patterns with their files.
    pub(super) fn patterns(&self) -> impl Iterator<Item = (&Path, &OwnPattern)> {
        let usable = |kept: &JsonFile<OwnPattern>| kept.content.is_ok();
        let found = self.found.iter().flatten().flatten().filter(move |kept| usable(kept));
        found.filter_map(|kept| Some((kept.path.as_path(), kept.content.as_ref().ok()?)))
    }

    /// What is wrong with the folder or with files in it.
    pub(super) fn problems(&self) -> Vec<String> {
        match &self.found {
            Some(Err(error)) => vec![error.to_string()],
            Some(Ok(kept)) => kept.iter().filter_map(|kept| Some(kept.content.as_ref().err()?.to_string())).collect(),
            None => Vec::new(),
        }
    }

    /// The pattern in a file.
    pub(super) fn get(&self, path: &Path) -> Option<&OwnPattern> {
        self.patterns().find(|(known, _)| *known == path).map(|(_, own)| own)
    }

    /// Whether there is a folder to keep patterns in.
    pub(super) fn has_place(&self) -> bool {
        self.folder.is_some()
    }
}

/// What is asked about own patterns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Question {
    /// What a new one is called.
    Keep {
        /// Its name.
        title: String,
        /// What it does.
        does: String,
        /// Fibres that it takes.
        fibres: usize,
    },
    /// What one is called from now on.
    Rename {
        /// Its file.
        path: PathBuf,
        /// Its name.
        title: String,
    },
    /// Whether one is to be deleted.
    Delete {
        /// Its file.
        path: PathBuf,
        /// Its name.
        title: String,
    },
}

/// Asks; whether it is to be done, once that is clear.
pub fn ask(ui: &mut Ui, question: &mut Question) -> Option<bool> {
    ui.set_width(360.0);
    let (verb, tooltip) = match question {
        Question::Keep { title, does, fibres } => {
            ui.heading("Save as pattern");
            let fibres = if *fibres == 1 { "The fibre is".to_owned() } else { format!("{fibres} fibres are") };
            ui.label(format!("{fibres} kept as shares of the body's box, to be fitted to others."));
            line(ui, "Name", "What it is called", title, TITLE_LENGTH);
            line(ui, "What it does", "A line for the gallery; may be left empty", does, LINE_LENGTH);
            ("Save pattern", "Keeps it under Yours")
        }
        Question::Rename { title, .. } => {
            ui.heading("Rename pattern");
            line(ui, "Name", "What it is called", title, TITLE_LENGTH);
            ("Rename", "Gives it this name")
        }
        Question::Delete { title, .. } => {
            ui.heading("Delete this pattern?");
            ui.label(format!(
                "{title} is removed from your patterns for good. Fibres that it made stay in their scenes."
            ));
            ("Delete pattern", "Removes its file")
        }
    };
    ui.add_space(GRID);
    let (named, may_enter) = match question {
        Question::Keep { title, .. } | Question::Rename { title, .. } => (!title.trim().is_empty(), true),
        // Nothing is deleted by a key that was still held down.
        Question::Delete { .. } => (true, false),
    };
    let entered = named && may_enter && ui.input(|input| input.key_pressed(Key::Enter));
    let mut answer = entered.then_some(true);
    ui.horizontal(|ui| {
        if ui.add_enabled(named, egui::Button::new(verb)).on_hover_text(tooltip).clicked() {
            answer = Some(true);
        }
        if ui.button("Cancel").on_hover_text("Leaves everything as it is").clicked() {
            answer = Some(false);
        }
    });
    answer
}

/// A line of text with its name; the first one has the keys.
fn line(ui: &mut Ui, label: &str, tooltip: &str, text: &mut String, length: usize) {
    let name = ui.label(label);
    let typed = ui.add(TextEdit::singleline(text).desired_width(f32::INFINITY).char_limit(length));
    let typed = typed.labelled_by(name.id).on_hover_text(tooltip);
    if ui.memory(|memory| memory.focused().is_none()) {
        typed.request_focus();
    }
}

impl App {
    /// Keeps a person's own patterns in this folder; nowhere unless one is given.
    #[must_use]
    pub fn with_pattern_folder(mut self, folder: PathBuf) -> Self {
        self.patterns.own = Own::of(folder);
        self
    }

    /// The fibres that would be kept: the selected ones, or all.
    fn kept_lines(&self) -> Result<Vec<Polyline>, String> {
        let Some(body) = self.active_body() else { return Ok(Vec::new()) };
        let selected = self.selected_fibres();
        let fibres = if selected.is_empty() { body.fibres.iter().collect() } else { selected };
        let sampling = self.sampling();
        let course = |fibre| fibre_ops::vertices(fibre, sampling).map_err(|error| error.to_string());
        fibres.into_iter().map(course).collect()
    }

    /// Asks what the pattern of the selected fibres is called.
    pub(super) fn ask_to_keep(&mut self) {
        if !self.patterns.own.has_place() {
            self.say(
                Gravity::Error,
                "There is no folder to keep patterns in: this system names none for programs' data",
            );
            return;
        }
        match self.kept_lines() {
            Ok(lines) => {
                let question = Question::Keep { title: String::new(), does: String::new(), fibres: lines.len() };
                self.dialog = Some(Dialog::Pattern(question));
            }
            Err(problem) => self.say(Gravity::Error, problem),
        }
    }

    /// Does what was asked about.
    pub(in crate::ui) fn pattern_answered(&mut self, question: &Question) {
        let Some(folder) = self.patterns.own.folder.clone() else { return };
        let (done, said) = match question {
            Question::Keep { title, does, .. } => (
                self.keep_pattern(&folder, title.trim(), does.trim()),
                format!("{} is kept under Patterns, Yours", title.trim()),
            ),
            Question::Rename { path, title } => (
                folder.set_text(path, "title", title.trim()).map_err(|error| error.to_string()),
                format!("The pattern is called {} now", title.trim()),
            ),
            Question::Delete { path, title } => {
                (folder.remove(path).map_err(|error| error.to_string()), format!("{title} was deleted"))
            }
        };
        self.patterns.own.found = None;
        self.patterns.own.look();
        match done {
            Ok(()) => self.say(Gravity::Note, said),
            Err(problem) => self.say(Gravity::Error, problem),
        }
        if let Some(Chosen::Own(path)) = &self.patterns.chosen
            && self.patterns.own.get(path).is_none()
        {
            self.patterns.chosen = None;
        }
    }

    fn keep_pattern(&mut self, folder: &JsonFolder, title: &str, does: &str) -> Result<(), String> {
        let lines = self.kept_lines()?;
        let [min, max] = self.body_box().ok_or("The body is not there yet: save the pattern again in a moment")?;
        let own = OwnPattern::new(title, does, &lines, min, max).map_err(|error| error.to_string())?;
        folder.add(title, &own).map_err(|error| error.to_string())?;
        self.show_patterns();
        self.patterns.chosen = None;
        self.patterns.fit = Fit::Whole;
        Ok(())
    }
}
