//! The right panel: the body's properties, the world around it, integrators compared, layouts of fibres.

use super::body_tab::body_tab;
use super::comparison::Comparison;
use super::context::Context;
use super::patterns::Patterns;
use super::theme::{self, GRID, SIDE_WIDTH};
use super::world_tab::WorldTab;
use egui::{Panel, ScrollArea, Ui};

/// Tabs of the right panel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) enum PropertyTab {
    /// What the active body is made of.
    #[default]
    Body,
    /// What surrounds the bodies.
    World,
    /// The scene under several integrators.
    Comparison,
    /// Layouts of fibres.
    Patterns,
}

/// The right panel.
#[derive(Default)]
pub(super) struct RightPanel {
    tab: PropertyTab,
    world: WorldTab,
}

impl RightPanel {
    /// The tab that is shown.
    pub(super) fn tab(&self) -> PropertyTab {
        self.tab
    }

    /// Shows another tab.
    pub(super) fn show_tab(&mut self, tab: PropertyTab) {
        self.tab = tab;
    }

    /// Shows the panel; `strips_play` tells whether pictures of patterns move by themselves.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        cx: &mut Context,
        comparison: &mut Comparison,
        patterns: &mut Patterns,
        strips_play: bool,
    ) {
        Panel::right("properties").default_size(SIDE_WIDTH).frame(theme::panel(ui)).show(ui, |ui| {
            ui.set_min_width(ui.available_width());
            ui.add_space(GRID);
            ui.horizontal(|ui| self.tabs(ui));
            ui.separator();
            // The tab may be another one than when the frame began.
            cx.pattern = patterns.preview(self.tab == PropertyTab::Patterns, cx);
            // Each tab, and a pattern that is chosen, begins at its own top.
            let place = (self.tab, cx.pattern.is_shown);
            ScrollArea::vertical().id_salt(place).auto_shrink(false).show(ui, |ui| match self.tab {
                PropertyTab::Body => body_tab(ui, cx),
                PropertyTab::World => self.world.show(ui, cx),
                PropertyTab::Comparison => comparison.tab(ui, cx),
                PropertyTab::Patterns => patterns.tab(ui, cx, strips_play),
            });
        });
    }

    fn tabs(&mut self, ui: &mut Ui) {
        // All of them stand beside each other.
        ui.spacing_mut().item_spacing.x = 0.5 * GRID;
        ui.spacing_mut().button_padding.x = 0.75 * GRID;
        ui.selectable_value(&mut self.tab, PropertyTab::Body, "Material");
        ui.selectable_value(&mut self.tab, PropertyTab::World, "World");
        ui.selectable_value(&mut self.tab, PropertyTab::Comparison, "Compare");
        ui.selectable_value(&mut self.tab, PropertyTab::Patterns, "Patterns")
            .on_hover_text("Layouts of fibres to start from, and your own");
    }
}
