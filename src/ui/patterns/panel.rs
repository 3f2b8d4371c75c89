//! The tab: the gallery, or the chosen pattern with its numbers and where it goes.

use super::own::Question;
use super::tiles::{PICTURE, paint_own, paint_strip, paint_words, tile};
use super::{Chosen, Fit};
use crate::sketch::pattern::{OwnPattern, PATTERNS, Parameter, Pattern};
use crate::text::number::compact;
use crate::ui::action::Action;
use crate::ui::app::App;
use crate::ui::dialogs::Dialog;
use crate::ui::field::Field;
use crate::ui::theme::GRID;
use egui::{Button, Rect, RichText, Ui};
use std::path::PathBuf;

impl App {
    pub(in crate::ui) fn patterns_tab(&mut self, ui: &mut Ui) {
        self.patterns.own.look();
        if self.active_body().is_none() {
            ui.label("Patterns go into fibre solids: choose one in the list of bodies, or open an example (Ctrl+E).");
            return;
        }
        match self.patterns.chosen.clone() {
            Some(chosen) => self.chosen_tab(ui, &chosen),
            None => self.pattern_gallery(ui),
        }
    }

    fn pattern_gallery(&mut self, ui: &mut Ui) {
        ui.label(RichText::new("Layouts of fibres to start from, each with what it does to a soft solid.").weak());
        ui.add_space(GRID);
        let all_play = self.strips_play();
        let mut chosen = None;
        for pattern in &PATTERNS {
            let (place, tile) = tile(ui, pattern.title, pattern.does);
            if let Some(place) = place {
                let plays = all_play || tile.hovered() || tile.has_focus();
                paint_strip(ui, &mut self.patterns.strips, pattern, place, plays);
            }
            if tile.on_hover_text("Shows its fibres in the views and what can be changed about them").clicked() {
                chosen = Some(Chosen::Shipped(pattern.id));
            }
        }
        ui.add_space(2.0 * GRID);
        ui.heading("Yours");
        let own: Vec<(PathBuf, OwnPattern)> =
            self.patterns.own.patterns().map(|(path, own)| (path.to_owned(), own.clone())).collect();
        if own.is_empty() {
            ui.label(
                RichText::new("None yet: fibres of your own can be kept as a pattern and fitted to other bodies.")
                    .weak(),
            );
        }
        for (path, own) in own {
            let (place, tile) = tile(ui, own.title(), own.does());
            if let Some(place) = place {
                paint_own(ui, &own, place);
            }
            if tile.on_hover_text("Shows its fibres in the views").clicked() {
                chosen = Some(Chosen::Own(path));
            }
        }
        for problem in self.patterns.own.problems() {
            ui.colored_label(self.tone.error(), problem);
            ui.label(RichText::new("The file is left as it is.").weak());
        }
        ui.add_space(GRID);
        self.control(ui, Action::KeepPattern, "Save selection as pattern…");
        if chosen.is_some() {
            self.patterns.chosen = chosen;
        }
    }

    /// Whether strips play by themselves: where a graphics card draws. Where that is work, only the one under the pointer does.
    fn strips_play(&self) -> bool {
        self.painter.as_ref().is_some_and(|painter| !painter.saves_work())
    }

    fn chosen_tab(&mut self, ui: &mut Ui, chosen: &Chosen) {
        let tooltip = "Back to the gallery; nothing is added";
        if ui.button("Back to all patterns").on_hover_text(tooltip).clicked() {
            self.patterns.chosen = None;
            return;
        }
        ui.add_space(GRID);
        match chosen {
            Chosen::Shipped(id) => {
                let Some(pattern) = Pattern::by_id(id) else { return };
                ui.heading(pattern.title);
                let picture = beside(ui, pattern.does);
                let plays = self.strips_play() || ui.rect_contains_pointer(picture);
                paint_strip(ui, &mut self.patterns.strips, pattern, picture, plays);
                ui.add_space(GRID);
                self.parameters(ui, pattern);
            }
            Chosen::Own(path) => {
                let Some(own) = self.patterns.own.get(path).cloned() else {
                    self.patterns.chosen = None;
                    return;
                };
                ui.heading(own.title());
                let picture = beside(ui, own.does());
                paint_own(ui, &own, picture);
                ui.add_space(GRID);
                self.own_buttons(ui, path, own.title());
            }
        }
        ui.separator();
        self.fitted_to(ui);
        ui.separator();
        self.add_button(ui);
    }

    fn parameters(&mut self, ui: &mut Ui, pattern: &'static Pattern) {
        let mut values = self.patterns.values_of(pattern);
        for (parameter, value) in pattern.parameters.iter().zip(&mut values) {
            field(parameter).show(ui, value);
            *value = parameter.held(*value);
        }
        let changed = values != pattern.defaults();
        let tooltip = "Every number as it was at first; a right click on one resets it alone";
        if ui.add_enabled(changed, Button::new("Reset all")).on_hover_text(tooltip).clicked() {
            values = pattern.defaults();
        }
        self.patterns.values.insert(pattern.id, values);
    }

    fn own_buttons(&mut self, ui: &mut Ui, path: &std::path::Path, title: &str) {
        let (path, title) = (path.to_owned(), title.to_owned());
        ui.horizontal(|ui| {
            if ui.button("Rename…").on_hover_text("Gives the pattern another name").clicked() {
                self.dialog = Some(Dialog::Pattern(Question::Rename { path: path.clone(), title: title.clone() }));
            }
            if ui.button("Delete…").on_hover_text("Removes the pattern; asks first").clicked() {
                self.dialog = Some(Dialog::Pattern(Question::Delete { path, title }));
            }
        });
    }

    fn fitted_to(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            ui.label("Fit to");
            let fit = &mut self.patterns.fit;
            ui.selectable_value(fit, Fit::Whole, "Whole model").on_hover_text("Fills the box around the body at rest");
            ui.selectable_value(fit, Fit::Region, "Region")
                .on_hover_text("Fills a box that you drag in the drawing views: each drag sets its two axes");
        });
        let Some([min, max]) = self.pattern_box() else { return };
        let text = if self.patterns.fit == Fit::Region && self.patterns.region.is_none() {
            "Drag a box in a drawing view".to_owned()
        } else {
            let [x, y, z] = (1e3 * (max - min)).to_array().map(short_length);
            format!("{x} × {y} × {z} mm")
        };
        ui.label(RichText::new(text).weak()).on_hover_text("Width, height and depth of what is filled");
    }

    fn add_button(&mut self, ui: &mut Ui) {
        let there = self.active_body().map_or(0, |body| body.fibres.len());
        ui.add_enabled_ui(there > 0, |ui| {
            let tooltip = "Takes away the fibres that the body has, in the same step";
            ui.checkbox(&mut self.patterns.replaces, "Replace the body's fibres").on_hover_text(tooltip);
        });
        let count = self.pattern_preview().len();
        let text = if self.patterns.replaces && there > 0 { "Replace fibres" } else { "Add fibres" };
        ui.horizontal(|ui| {
            let button = Button::new(RichText::new(text).strong()).min_size(egui::vec2(28.0 * GRID, 7.0 * GRID));
            let tooltip = "Puts the fibres into the solid, in one step; they can be edited as any fibre then";
            if ui.add_enabled(count > 0, button).on_hover_text(tooltip).clicked() {
                self.add_pattern();
            }
            ui.label(RichText::new(if count == 1 { "1 fibre".to_owned() } else { format!("{count} fibres") }).weak());
        });
    }
}

/// Makes room for a picture with words beside it; gives the place of the picture.
fn beside(ui: &mut Ui, does: &str) -> Rect {
    let (place, _) = ui.allocate_exact_size(egui::vec2(ui.available_width(), PICTURE), egui::Sense::hover());
    let words = Rect::from_min_max(egui::pos2(place.min.x + PICTURE + 2.0 * GRID, place.min.y), place.max);
    paint_words(ui, words, does);
    Rect::from_min_size(place.min, egui::Vec2::splat(PICTURE))
}

fn field(parameter: &Parameter) -> Field {
    let [least, most] = parameter.range;
    Field::new(parameter.title, parameter.unit, least..=most, Some(parameter.default), parameter.tip)
}

/// A length [mm] to a tenth.
fn short_length(length: f64) -> String {
    compact((10.0 * length).round() / 10.0)
}
