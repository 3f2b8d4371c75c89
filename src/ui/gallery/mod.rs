//! The start screen: every scene that ships, with a picture and what to look at.

mod examples;
mod models;

pub(crate) use examples::shipped_assets;
pub use examples::{EXAMPLES, Example, Group};
pub(crate) use models::with_models_in;

use super::action::Action;
use super::theme::{self, GRID};
use super::thumbs::Thumbs;
use crate::draw::Theme;
use egui::{
    Align2, CornerRadius, FontId, Frame, Pos2, Rect, RichText, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui,
};

/// Width of a card, height of its picture and of what stands below [points].
const CARD: f32 = 216.0;
const PICTURE: f32 = 135.0;
const BELOW: f32 = 56.0;
/// Cards beside each other at most.
const COLUMNS: usize = 4;

/// The start screen, with the pictures that have been seen.
#[derive(Default)]
pub(crate) struct Gallery {
    thumbs: Thumbs,
    /// Whether the start screen has been shown.
    welcomed: bool,
    /// Whether it is shown over a scene that nobody has seen start.
    welcoming: bool,
}

/// What a person wants of the gallery.
pub(crate) enum Choice {
    /// To go on with what is open.
    Draw,
    /// To open an example.
    Open(&'static Example),
}

impl Gallery {
    /// Whether the start screen is to be shown now, over the scene that runs: it is unless it was shown before.
    pub(crate) fn begin_welcome(&mut self) -> bool {
        let is_first = !self.welcomed;
        if is_first {
            self.welcomed = true;
            self.welcoming = true;
        }
        is_first
    }

    /// The start screen was closed: whether the scene that it was shown over is to be started anew.
    pub(crate) fn end_welcome(&mut self) -> bool {
        std::mem::take(&mut self.welcoming)
    }

    /// The scene that the start screen was shown over is there no more.
    pub(crate) fn forget_welcome(&mut self) {
        self.welcoming = false;
    }

    /// Goes on from whether the start screen was shown the last time.
    pub(crate) fn recall(&mut self, welcomed: bool) {
        self.welcomed = welcomed;
    }

    /// Whether the start screen has been shown, to be remembered.
    pub(crate) fn was_welcomed(&self) -> bool {
        self.welcomed
    }

    /// Whether the picture of an example, by its name, has been decoded.
    pub(crate) fn has_decoded(&self, example: &str) -> bool {
        self.thumbs.has(example)
    }

    /// Shows everything; what was chosen, if something was.
    pub(crate) fn show(&mut self, ui: &mut Ui) -> Option<Choice> {
        Frame::NONE.inner_margin(2.0 * GRID).show(ui, |ui| self.sections(ui)).inner
    }

    fn sections(&mut self, ui: &mut Ui) -> Option<Choice> {
        let room = ui.ctx().content_rect().size() - egui::vec2(16.0 * GRID, 48.0 * GRID);
        let gap = 3.0 * GRID;
        let columns = (((room.x + gap) / (CARD + gap)).floor() as usize).clamp(1, COLUMNS);
        ui.set_width(columns as f32 * (CARD + gap) + gap);
        let mut choice = None;
        ui.heading("Examples");
        ui.label(
            RichText::new("Open one to watch, pull and change it, or draw into the solid that is open now.").weak(),
        );
        ui.add_space(GRID);
        ScrollArea::vertical().max_height(room.y.max(120.0)).auto_shrink(false).show(ui, |ui| {
            for group in Group::ALL {
                ui.label(RichText::new(group.title()).strong());
                ui.add_space(GRID);
                let of_group: Vec<&'static Example> =
                    EXAMPLES.iter().filter(|example| example.group == group).collect();
                for row in of_group.chunks(columns) {
                    ui.horizontal(|ui| {
                        ui.spacing_mut().item_spacing.x = gap;
                        for example in row {
                            if self.card(ui, example) {
                                choice = Some(Choice::Open(example));
                            }
                        }
                    });
                    ui.add_space(GRID);
                }
                ui.add_space(2.0 * GRID);
            }
        });
        ui.add_space(GRID);
        ui.horizontal(|ui| {
            let start = egui::Button::new(RichText::new("Start drawing").strong());
            if ui.add(start).on_hover_text("Closes this and goes on with the scene that is open").clicked() {
                choice = Some(Choice::Draw);
            }
            let key = Action::Examples.shortcuts().first().map(|shortcut| ui.ctx().format_shortcut(shortcut));
            let again = format!("{} or the File menu shows this again", key.unwrap_or_default());
            ui.label(RichText::new(again).weak());
        });
        choice
    }

    /// One example; whether it was clicked.
    fn card(&mut self, ui: &mut Ui, example: &'static Example) -> bool {
        let (place, card) = ui.allocate_exact_size(egui::vec2(CARD, PICTURE + BELOW), Sense::click());
        card.widget_info(|| egui::WidgetInfo::labeled(Role::Button, true, example.title));
        // What is not seen is not decoded.
        if ui.is_rect_visible(place) {
            let picture = Rect::from_min_size(place.min, egui::vec2(CARD, PICTURE));
            let painter = ui.painter();
            painter.rect_filled(picture, CornerRadius::same(4), theme::color(Theme::gallery().background_top));
            self.thumbs.paint(ui, example.name, example.picture, picture);
            if card.hovered() || card.has_focus() {
                let stroke = Stroke::new(2.0, ui.visuals().hyperlink_color);
                painter.rect_stroke(picture, CornerRadius::same(4), stroke, StrokeKind::Inside);
            }
            let title = Pos2::new(place.min.x, picture.max.y + GRID);
            let ink = ui.visuals().strong_text_color();
            painter.text(title, Align2::LEFT_TOP, example.title, FontId::proportional(13.0), ink);
            let weak = ui.visuals().weak_text_color();
            let line = painter.layout(example.line.to_owned(), FontId::proportional(11.0), weak, CARD);
            painter.galley(title + egui::vec2(0.0, 4.5 * GRID), line, weak);
        }
        card.on_hover_text(example.line).clicked()
    }
}
