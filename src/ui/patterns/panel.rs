//! The tab: the gallery, or the chosen pattern with its numbers and where it goes.

use super::question::PatternQuestion;
use super::state::{Chosen, Fit, Patterns};
use super::tiles::{PICTURE, paint_own, paint_strip, paint_words, tile};
use crate::sketch::pattern::{OwnPattern, PATTERNS, Parameter, Pattern};
use crate::text::number::compact;
use crate::ui::action::Action;
use crate::ui::context::{Context, Request};
use crate::ui::controls::button;
use crate::ui::dialogs::Dialog;
use crate::ui::field::NumberField;
use crate::ui::theme::GRID;
use egui::{Button, Rect, RichText, Ui};
use std::path::{Path, PathBuf};

impl Patterns {
    /// The tab. With `strips_play` strips play by themselves: where a graphics card draws. Where that is work, only the
    /// one under the pointer does.
    pub(crate) fn tab(&mut self, ui: &mut Ui, cx: &mut Context, strips_play: bool) {
        self.own.look();
        if cx.active_body().is_none() {
            ui.label("Patterns go into fibre solids: choose one in the list of bodies, or open an example (Ctrl+E).");
            return;
        }
        match self.chosen.clone() {
            Some(chosen) => self.chosen_tab(ui, cx, &chosen, strips_play),
            None => self.gallery(ui, cx, strips_play),
        }
    }

    fn gallery(&mut self, ui: &mut Ui, cx: &mut Context, strips_play: bool) {
        ui.label(RichText::new("Layouts of fibres to start from, each with what it does to a soft solid.").weak());
        ui.add_space(GRID);
        let mut chosen = None;
        for acting in [false, true] {
            if acting {
                ui.add_space(2.0 * GRID);
                ui.heading("That act by themselves");
            }
            for pattern in PATTERNS.iter().filter(|pattern| pattern.is_acting() == acting) {
                let (place, tile) = tile(ui, pattern.title, pattern.does);
                if let Some(place) = place {
                    let plays = strips_play || tile.hovered() || tile.has_focus();
                    paint_strip(ui, &mut self.strips, pattern, place, plays);
                }
                if tile.on_hover_text("Shows its fibres in the views and what can be changed about them").clicked() {
                    chosen = Some(Chosen::Shipped(pattern.id));
                }
            }
        }
        ui.add_space(2.0 * GRID);
        ui.heading("Yours");
        let own: Vec<(PathBuf, OwnPattern)> =
            self.own.patterns().map(|(path, own)| (path.to_owned(), own.clone())).collect();
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
        for problem in self.own.problems() {
            ui.colored_label(cx.tone.error(), problem);
            ui.label(RichText::new("The file is left as it is.").weak());
        }
        ui.add_space(GRID);
        button(ui, cx, Action::KeepPattern, "Save selection as pattern…");
        if chosen.is_some() {
            self.chosen = chosen;
        }
    }

    fn chosen_tab(&mut self, ui: &mut Ui, cx: &mut Context, chosen: &Chosen, strips_play: bool) {
        let tooltip = "Back to the gallery; nothing is added";
        if ui.button("Back to all patterns").on_hover_text(tooltip).clicked() {
            self.chosen = None;
            return;
        }
        ui.add_space(GRID);
        match chosen {
            Chosen::Shipped(id) => {
                let Some(pattern) = Pattern::by_id(id) else { return };
                ui.heading(pattern.title);
                let picture = beside(ui, pattern.does);
                let plays = strips_play || ui.rect_contains_pointer(picture);
                paint_strip(ui, &mut self.strips, pattern, picture, plays);
                ui.add_space(GRID);
                self.parameters(ui, pattern);
            }
            Chosen::Own(path) => {
                let Some(own) = self.own.get(path).cloned() else {
                    self.chosen = None;
                    return;
                };
                ui.heading(own.title());
                let picture = beside(ui, own.does());
                paint_own(ui, &own, picture);
                ui.add_space(GRID);
                own_buttons(ui, cx, path, own.title());
            }
        }
        ui.separator();
        self.fitted_to(ui, cx);
        ui.separator();
        self.add_button(ui, cx);
    }

    fn parameters(&mut self, ui: &mut Ui, pattern: &'static Pattern) {
        let mut values = self.values_of(pattern);
        for (parameter, value) in pattern.parameters.iter().zip(&mut values) {
            field(parameter).show(ui, value);
            *value = parameter.held(*value);
        }
        let changed = values != pattern.defaults();
        let tooltip = "Every number as it was at first; a right click on one resets it alone";
        if ui.add_enabled(changed, Button::new("Reset all")).on_hover_text(tooltip).clicked() {
            values = pattern.defaults();
        }
        self.values.insert(pattern.id, values);
    }

    fn fitted_to(&mut self, ui: &mut Ui, cx: &Context) {
        ui.horizontal(|ui| {
            ui.label("Fit to");
            let fit = &mut self.fit;
            ui.selectable_value(fit, Fit::Whole, "Whole model").on_hover_text("Fills the box around the body at rest");
            ui.selectable_value(fit, Fit::Region, "Region")
                .on_hover_text("Fills a box that you drag in the drawing views: each drag sets its two axes");
        });
        let Some([min, max]) = self.filled_box(cx) else { return };
        let text = if self.fit == Fit::Region && self.region.is_none() {
            "Drag a box in a drawing view".to_owned()
        } else {
            let [x, y, z] = (1e3 * (max - min)).to_array().map(short_length);
            format!("{x} × {y} × {z} mm")
        };
        ui.label(RichText::new(text).weak()).on_hover_text("Width, height and depth of what is filled");
        let laid = self.laid(cx);
        if let Some([low, high]) = laid.further_in {
            let [x, y, z] = (1e3 * (high - low)).to_array().map(short_length);
            let tooltip = "The solid leaves the rest of the box empty: further out fibres would not lie in it";
            let text = format!("Laid into its inner {x} × {y} × {z} mm");
            ui.label(RichText::new(text).weak()).on_hover_text(tooltip);
        }
        if laid.outside > 0 {
            let text = format!("{} of {} fibres stick out of the solid", laid.outside, laid.fibres.len());
            ui.label(text).on_hover_text("What sticks out is cut off when they are added; drag a region for them");
        }
    }

    fn add_button(&mut self, ui: &mut Ui, cx: &mut Context) {
        let there = cx.active_body().map_or(0, |body| body.fibres.len());
        ui.add_enabled_ui(there > 0, |ui| {
            let tooltip = "Takes away the fibres that the body has, in the same step";
            ui.checkbox(&mut self.replaces, "Replace the body's fibres").on_hover_text(tooltip);
        });
        let count = self.lines(cx).len();
        let text = if self.replaces && there > 0 { "Replace fibres" } else { "Add fibres" };
        ui.horizontal(|ui| {
            let button = Button::new(RichText::new(text).strong()).min_size(egui::vec2(28.0 * GRID, 7.0 * GRID));
            let tooltip = "Puts the fibres into the solid, in one step; they can be edited as any fibre then";
            if ui.add_enabled(count > 0, button).on_hover_text(tooltip).clicked() {
                self.add(cx);
            }
            let tooltip = "Puts the pattern on the clipboard, to be pasted into another body, scene or window";
            if ui.add_enabled(count > 0, Button::new("Copy")).on_hover_text(tooltip).clicked() {
                self.copy(ui.ctx(), cx);
            }
            ui.label(RichText::new(if count == 1 { "1 fibre".to_owned() } else { format!("{count} fibres") }).weak());
        });
    }
}

/// What can be done with a person's own pattern.
fn own_buttons(ui: &mut Ui, cx: &mut Context, path: &Path, title: &str) {
    let (path, title) = (path.to_owned(), title.to_owned());
    ui.horizontal(|ui| {
        if ui.button("Rename…").on_hover_text("Gives the pattern another name").clicked() {
            let question = PatternQuestion::Rename { path: path.clone(), title: title.clone() };
            cx.request(Request::Open(Dialog::Pattern(question)));
        }
        if ui.button("Delete…").on_hover_text("Removes the pattern; asks first").clicked() {
            cx.request(Request::Open(Dialog::Pattern(PatternQuestion::Delete { path, title })));
        }
    });
}

/// Makes room for a picture with words beside it; gives the place of the picture.
fn beside(ui: &mut Ui, does: &str) -> Rect {
    let (place, _) = ui.allocate_exact_size(egui::vec2(ui.available_width(), PICTURE), egui::Sense::hover());
    let words = Rect::from_min_max(egui::pos2(place.min.x + PICTURE + 2.0 * GRID, place.min.y), place.max);
    paint_words(ui, words, does);
    Rect::from_min_size(place.min, egui::Vec2::splat(PICTURE))
}

fn field(parameter: &Parameter) -> NumberField {
    let [least, most] = parameter.range;
    NumberField::new(parameter.title, parameter.unit, least..=most, Some(parameter.default), parameter.tip)
}

/// A length [mm] to a tenth.
fn short_length(length: f64) -> String {
    compact((10.0 * length).round() / 10.0)
}
