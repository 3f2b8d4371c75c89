//! The files that were used, to be opened again.

use super::{Next, file_name};
use crate::io::RecentFiles;
use crate::ui::app::{App, Gravity};
use crate::ui::theme::GRID;
use egui::{Button, Context, RichText, Ui};
use std::path::{Path, PathBuf};

/// Under this name the list is remembered.
const KEY: &str = "recent";

/// Lists files by their names; gives the one that was chosen.
pub(in crate::ui) fn choose_recent(ui: &mut Ui, paths: &[PathBuf]) -> Option<PathBuf> {
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

impl App {
    /// Notes a file as used.
    pub(in crate::ui) fn note_recent(&mut self, path: &Path) {
        self.trust.recent.add(path);
    }

    /// Goes on with the files of the last time.
    pub(in crate::ui) fn recall_recent(&mut self, storage: &dyn eframe::Storage) {
        let Some(mut recent) = eframe::get_value::<RecentFiles>(storage, KEY) else { return };
        recent.drop_missing();
        if let Some(path) = &self.path {
            recent.add(path);
        }
        self.trust.recent = recent;
    }

    pub(in crate::ui) fn remember_recent(&self, storage: &mut dyn eframe::Storage) {
        eframe::set_value(storage, KEY, &self.trust.recent);
    }

    /// Opens a file of the list.
    pub(in crate::ui) fn open_recent(&mut self, ctx: &Context, path: PathBuf) {
        if path.is_file() {
            self.leave(ctx, Next::Open(path));
        } else {
            let said = format!("{} is no longer there; it was taken off the recent files", path.display());
            self.say(Gravity::Error, said);
            self.trust.recent.drop_missing();
        }
    }

    /// The menu of files that were used.
    pub(in crate::ui) fn recent_menu(&mut self, ui: &mut Ui) {
        ui.menu_button("Open recent", |ui| {
            if let Some(path) = choose_recent(ui, self.trust.recent()) {
                let ctx = ui.ctx().clone();
                self.open_recent(&ctx, path);
                ui.close();
            }
            if !self.trust.recent().is_empty() {
                ui.separator();
                if ui.button("Clear").on_hover_text("Forgets these files; the files themselves stay").clicked() {
                    self.trust.recent = RecentFiles::default();
                    ui.close();
                }
            }
        });
    }
}

/// Whether another file has the same name.
fn is_ambiguous(path: &Path, paths: &[PathBuf]) -> bool {
    paths.iter().filter(|other| other.file_name() == path.file_name()).count() > 1
}

fn folder_name(path: &Path) -> String {
    path.parent().map_or_else(String::new, file_name)
}
