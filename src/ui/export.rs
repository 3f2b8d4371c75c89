//! The time series of the running scene as a table for other programs.

use super::autosave::{Loss, Question};
use super::context::{Context, Request, Severity};
use super::dialogs::{Dialog, PathPurpose};
use super::placed::placed;
use crate::io::{is_same, is_there, write_atomically, write_json};
use crate::scene::Scene;
use std::path::{Path, PathBuf};

/// Where the table goes unless another place is chosen.
fn export_path(cx: &Context) -> PathBuf {
    cx.document.path.as_ref().map_or_else(|| "readings.csv".into(), |path| path.with_extension("csv"))
}

/// Asks for the file that the table goes to.
pub(super) fn ask_where_to_export(cx: &mut Context) {
    let dialog = Dialog::path(PathPurpose::Export, Some(&export_path(cx)));
    cx.request(Request::Open(dialog));
}

/// Writes the table, after asking where that would lose what a file holds.
pub(super) fn export_to(cx: &mut Context, path: PathBuf) {
    if is_there(&path) {
        cx.request(Request::Open(Dialog::Question(Question::Replace { path, loss: Loss::Table, next: None })));
    } else {
        export(cx, &path);
    }
}

/// Writes every row that is kept as a table.
pub(super) fn export(cx: &mut Context, path: &Path) {
    if cx.document.path.as_deref().is_some_and(|scene| is_same(scene, path)) {
        cx.say(Severity::Error, format!("{}: that is the scene's own file; choose another name", path.display()));
        return;
    }
    // The solver is not to wait while the table is made.
    let series = cx.simulation.time_series(|recorded| recorded.world.clone());
    let (rows, dropped) = (series.len(), series.dropped());
    let written = series
        .to_csv()
        .map_err(|error| error.to_string())
        .and_then(|bytes| write_atomically(path, |out| out.write_all(&bytes)).map_err(|error| error.to_string()));
    match written {
        Ok(()) if dropped > 0 => {
            let text =
                format!("Wrote the last {rows} frames to {}; {dropped} before them are no longer kept", path.display());
            cx.say(Severity::Warning, text);
        }
        Ok(()) => cx.say(Severity::Note, format!("Wrote {rows} frames to {}", path.display())),
        Err(problem) => cx.say(Severity::Error, problem),
    }
}

/// Writes the journal of the motion beside the scene, whose models it is read again with.
pub(super) fn save_journal(cx: &mut Context) {
    let Some(scene) = cx.document.path.clone() else { return };
    let path = scene.with_extension("journal.json");
    let to = scene.parent().unwrap_or(Path::new("")).to_owned();
    let (is_example, from) = (cx.document.is_example, cx.document.folder.clone());
    let journal = cx.simulation.journal().with_scenes(|scene: &Scene| placed(scene, &from, is_example, &to));
    match journal.and_then(|journal| write_json(&path, &journal).map(|()| journal)) {
        Ok(journal) => {
            let text =
                format!("Wrote {} frames as {}; `sinew replay` makes them again", journal.frames(), path.display());
            cx.say(Severity::Note, text);
        }
        Err(error) => cx.say(Severity::Error, error.to_string()),
    }
}
