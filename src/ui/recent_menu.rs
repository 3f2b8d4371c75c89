//! The files that were used, to be opened again.

use super::context::{Context, Request};
use super::theme::GRID;
use egui::{Button, RichText, Ui};
use std::path::{Path, PathBuf};

/// The menu of files that were used.
pub(super) fn recent_menu(ui: &mut Ui, recent: &[PathBuf], cx: &mut Context) {
    ui.menu_button("Open recent", |ui| {
        if let Some(path) = choose_recent(ui, recent) {
            cx.request(Request::OpenRecent(path));
            ui.close();
        }
        if !recent.is_empty() {
            ui.separator();
            if ui.button("Clear").on_hover_text("Forgets these files; the files themselves stay").clicked() {
                cx.request(Request::ForgetRecent);
                ui.close();
            }
        }
    });
}

/// Lists files by their names; gives the one that was chosen.
pub(super) fn choose_recent(ui: &mut Ui, paths: &[PathBuf]) -> Option<PathBuf> {
    let mut chosen = None;
    for path in paths {
        let mut button = Button::new(file_name(path)).frame_when_inactive(false);
        if is_ambiguous(path, paths) {
            button = button.right_text(RichText::new(folder_name(path)).weak());
        }
        if ui.add(button).on_hover_text(path.display().to_string()).clicked() {
            chosen = Some(path.clone());
        }
    }
    if paths.is_empty() {
        ui.add_space(0.5 * GRID);
        ui.label(RichText::new("Files that you open or save are listed here").weak());
    }
    chosen
}

/// Whether another file has the same name.
fn is_ambiguous(path: &Path, paths: &[PathBuf]) -> bool {
    paths.iter().filter(|other| other.file_name() == path.file_name()).count() > 1
}

fn folder_name(path: &Path) -> String {
    path.parent().map_or_else(String::new, file_name)
}

/// The name of a file, for sentences.
pub(super) fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}
