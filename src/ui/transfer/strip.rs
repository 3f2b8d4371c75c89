//! The line at the foot of the window that tells of what is written beside it.

use super::job::Job;
use crate::text::number::duration;
use crate::transfer::Written;
use crate::ui::context::Context;
use crate::ui::theme::{self, GRID};
use egui::{Label, Panel, ProgressBar, RichText, Ui};
use std::path::{Path, PathBuf};

/// Width of the bar [points].
const BAR: f32 = 160.0;
/// The line is looked at again so often while something is written [s].
const AGAIN: f32 = 0.2;

/// What is told of what has ended.
pub(super) struct Ended {
    /// In a sentence.
    pub(super) text: String,
    /// Whether it failed.
    pub(super) failed: bool,
    /// The folder of what was written; none where nothing was.
    pub(super) folder: Option<PathBuf>,
}

impl Ended {
    /// Of work that was to write there.
    pub(super) fn of(written: &[Written], problem: Option<String>, is_cancelled: bool) -> Self {
        let each = |one: &Written| {
            let behind = match one.left_over {
                0 => String::new(),
                more => format!(" ({more} more files of an earlier, longer run lie behind them)"),
            };
            format!("{} written to {}{behind}", one.what, one.path.display())
        };
        let told: Vec<String> = written.iter().map(each).collect();
        let told = told.join("; ");
        let folder = written.first().map(|first| folder_of(&first.path));
        let text = match (problem, is_cancelled, told.is_empty()) {
            (Some(problem), _, true) => problem,
            (Some(problem), _, false) => format!("{problem}; until then: {told}"),
            (None, true, true) => "Cancelled; nothing was written".to_owned(),
            (None, true, false) => format!("Cancelled; until then: {told}"),
            (None, false, _) => capital(&told),
        };
        Self { text, failed: false, folder }
    }

    /// As what failed.
    pub(super) fn failed(mut self, failed: bool) -> Self {
        self.failed = failed;
        self
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// What was asked of the line.
pub(super) enum Asked {
    /// The work is to end.
    Cancel,
    /// The folder of what was written is to be shown.
    Show(PathBuf),
    /// The line is no longer needed.
    Close,
}

/// Shows the line, where there is something to tell; gives what was asked of it.
pub(super) fn strip(ui: &mut Ui, job: Option<&Job>, ended: Option<&Ended>, cx: &Context) -> Option<Asked> {
    if job.is_none() && ended.is_none() {
        return None;
    }
    let shown = Panel::bottom("transfer").frame(theme::panel(ui)).show(ui, |ui| {
        ui.add_space(0.5 * GRID);
        let asked = ui.horizontal(|ui| match (job, ended) {
            (Some(job), _) => running(ui, job),
            (None, Some(ended)) => told(ui, ended, cx),
            (None, None) => None,
        });
        ui.add_space(0.5 * GRID);
        asked.inner
    });
    shown.inner
}

fn running(ui: &mut Ui, job: &Job) -> Option<Asked> {
    ui.ctx().request_repaint_after_secs(AGAIN);
    let (done, all) = (job.done(), job.all);
    let share = done as f32 / all as f32;
    ui.label(job.name);
    ui.add(ProgressBar::new(share).desired_width(BAR).desired_height(12.0));
    let left = match job.seconds_left() {
        _ if job.is_cancelled() => "ending with the frame at hand…".to_owned(),
        Some(left) if done < all => format!("about {} left", duration(left.max(1.0))),
        Some(_) => "writing the end…".to_owned(),
        None => "beginning…".to_owned(),
    };
    ui.label(RichText::new(format!("{done} of {all} {}, {left}", job.pieces)).weak());
    let cancel = ui.add_enabled(!job.is_cancelled(), egui::Button::new("Cancel export"));
    cancel.on_hover_text("Ends it; what is written until then stays, whole").clicked().then_some(Asked::Cancel)
}

fn told(ui: &mut Ui, ended: &Ended, cx: &Context) -> Option<Asked> {
    let mut asked = None;
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        if ui.button("Close").on_hover_text("Takes this line away").clicked() {
            asked = Some(Asked::Close);
        }
        if let Some(folder) = &ended.folder
            && ui.button("Show in folder").on_hover_text(folder.display().to_string()).clicked()
        {
            asked = Some(Asked::Show(folder.clone()));
        }
        ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
            let text = cx.scene().with_names(&ended.text);
            let shown = RichText::new(&text);
            let shown = if ended.failed { shown.color(cx.tone.error()) } else { shown };
            ui.add(Label::new(shown).truncate()).on_hover_text(text);
        });
    });
    asked
}

/// The folder that a file lies in; a folder itself.
fn folder_of(path: &Path) -> PathBuf {
    if path.extension().is_none() { path.to_owned() } else { path.parent().unwrap_or(path).to_owned() }
}
