//! What is remembered from one start to the next.

use super::App;
use crate::io::RecentFiles;
use crate::ui::navigation::Navigation;
use crate::ui::theme::Tone;
use crate::ui::timeline::RememberedTimeline;
use crate::ui::views::Pane;
use egui_tiles::Tree;
use serde::{Deserialize, Serialize};

/// Under these names things are remembered.
const WINDOW: &str = "window";
const RECENT: &str = "recent";

/// How the window is left; its views are lent to be written, and owned when they were read.
#[derive(Serialize, Deserialize)]
struct Remembered<V> {
    views: V,
    light: bool,
    coach: bool,
    #[serde(default)]
    timeline: RememberedTimeline,
    #[serde(default)]
    plots: bool,
    #[serde(default)]
    navigation: Navigation,
}

impl App {
    /// Goes on with the views, colours and files of the last time.
    pub fn recall(&mut self, ctx: &egui::Context, storage: &dyn eframe::Storage) {
        if let Some(mut recent) = eframe::get_value::<RecentFiles>(storage, RECENT) {
            recent.drop_missing();
            if let Some(path) = &self.cx.document.path {
                recent.add(path);
            }
            self.recent = recent;
        }
        let Some(last) = eframe::get_value::<Remembered<Tree<Pane>>>(storage, WINDOW) else { return };
        // egui remembers the size of the interface itself.
        self.suits_the_screen = true;
        self.views.recall(last.views, last.coach);
        self.timeline.recall(last.timeline, &self.cx);
        self.time_series.open = last.plots;
        self.cx.navigation = last.navigation;
        if last.light != (self.cx.tone == Tone::Light) {
            self.cx.tone = self.cx.tone.other();
            self.cx.tone.apply(ctx);
        }
    }

    /// Remembers the views, colours and files for the next time.
    pub(super) fn remember(&self, storage: &mut dyn eframe::Storage) {
        let now = Remembered {
            views: self.views.panes(),
            light: self.cx.tone == Tone::Light,
            coach: self.views.coach(),
            timeline: self.timeline.to_remember(),
            plots: self.time_series.open,
            navigation: self.cx.navigation,
        };
        eframe::set_value(storage, WINDOW, &now);
        eframe::set_value(storage, RECENT, &self.recent);
    }
}
