//! How the person wants the window, as it stands and as it changes.

use super::App;
use crate::ui::preferences::{Preferences, first_size};

impl App {
    /// How the window is now.
    pub(super) fn preferences(&self, ctx: &egui::Context) -> Preferences {
        Preferences {
            navigation: self.cx.navigation,
            tone: self.cx.tone,
            size: (100.0 * ctx.zoom_factor()).round() as u16,
            memory: self.timeline.memory(),
        }
    }

    /// Makes the window what is wanted.
    pub(super) fn prefer(&mut self, ctx: &egui::Context, wanted: Preferences) {
        let now = self.preferences(ctx);
        self.cx.navigation = wanted.navigation;
        if wanted.tone != now.tone {
            self.cx.tone = wanted.tone;
            self.cx.tone.apply(ctx);
        }
        if wanted.size != now.size {
            ctx.set_zoom_factor(f32::from(wanted.size) / 100.0);
        }
        if wanted.memory != now.memory {
            self.timeline.choose_memory(wanted.memory, &self.cx);
        }
    }

    /// At the very first start, once it is known how large the screen is, makes the interface large enough for it.
    pub(super) fn suit_the_screen(&mut self, ctx: &egui::Context) {
        if self.suits_the_screen {
            return;
        }
        let Some(screen) = ctx.input(|input| input.viewport().monitor_size) else { return };
        self.suits_the_screen = true;
        // The screen is told in points of the present size.
        let size = first_size(screen.y * ctx.zoom_factor());
        if size > 100 {
            ctx.set_zoom_factor(f32::from(size) / 100.0);
        }
    }
}
