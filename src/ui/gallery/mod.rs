//! The examples: every scene that ships, with a picture and what to look at.

mod examples;
mod models;

pub(crate) use examples::shipped_assets;
pub use examples::{EXAMPLES, Example, Group};
pub(crate) use models::{is_shipped, shipped_beside, shipped_bytes, with_models_in};

use super::theme::{self, GRID};
use super::thumbs::{Runs, Thumbs};
use crate::draw::Theme;
use egui::{
    Align2, CornerRadius, FontId, Frame, Pos2, Rect, RichText, Role, ScrollArea, Sense, Stroke, StrokeKind, TextEdit,
    Ui,
};

/// Width of a card, height of its picture and of what stands below [points].
const CARD: f32 = 216.0;
const PICTURE: f32 = 135.0;
const BELOW: f32 = 56.0;
/// Cards beside each other at most.
const COLUMNS: usize = 4;

/// The examples, with the pictures that have been seen.
#[derive(Default)]
pub(crate) struct Gallery {
    thumbs: Thumbs,
    /// Whether strips play by themselves, and not only under the pointer.
    strips_play: bool,
    /// What is searched for.
    search: String,
}

/// What a person wants of the gallery.
pub(crate) enum Choice {
    /// To go on with what is open.
    Close,
    /// To open an example.
    Open(&'static Example),
}

impl Gallery {
    /// Whether the picture of an example, by its name, has been decoded.
    pub(crate) fn has_decoded(&self, example: &str) -> bool {
        self.thumbs.has(example)
    }

    /// Lets strips play by themselves, or only under the pointer.
    pub(crate) fn let_play(&mut self, strips_play: bool) {
        self.strips_play = strips_play;
    }

    /// Shows everything; what was chosen, if something was.
    pub(crate) fn show(&mut self, ui: &mut Ui) -> Option<Choice> {
        Frame::NONE.inner_margin(2.0 * GRID).show(ui, |ui| self.sections(ui)).inner
    }

    fn sections(&mut self, ui: &mut Ui) -> Option<Choice> {
        // Of one size, whatever is found: no button moves away under the pointer.
        let room =
            (ui.ctx().content_rect().size() - egui::vec2(16.0 * GRID, 48.0 * GRID)).max(egui::vec2(CARD, PICTURE));
        let gap = 3.0 * GRID;
        let columns = (((room.x + gap) / (CARD + gap)).floor() as usize).clamp(1, COLUMNS);
        ui.set_width(columns as f32 * (CARD + gap) + gap);
        let mut choice = None;
        ui.horizontal(|ui| {
            ui.heading("Examples");
            ui.add_space(2.0 * GRID);
            let hint = "Search: twist, leaf, figure 8…";
            let search = ui.add(TextEdit::singleline(&mut self.search).hint_text(hint).desired_width(CARD));
            let search = search.on_hover_text("Shows the examples whose words have these in them");
            if ui.memory(|memory| memory.focused().is_none()) {
                search.request_focus();
            }
        });
        ui.add_space(GRID);
        let wanted: Vec<String> = self.search.to_lowercase().split_whitespace().map(str::to_owned).collect();
        let mut found = 0;
        ScrollArea::vertical().max_height(room.y).min_scrolled_height(room.y).auto_shrink(false).show(ui, |ui| {
            for group in Group::ALL {
                let is_meant = |example: &&&'static Example| example.group == group && is_found(example, &wanted);
                let of_group: Vec<&'static Example> = EXAMPLES.iter().filter(|example| is_meant(&example)).collect();
                if of_group.is_empty() {
                    continue;
                }
                found += of_group.len();
                ui.label(RichText::new(group.title()).strong());
                ui.add_space(GRID);
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
            if found == 0 {
                ui.label(RichText::new("No example has these words").weak());
            }
        });
        ui.add_space(GRID);
        if ui.button("Close").on_hover_text("Goes on with the scene that is open").clicked() {
            choice = Some(Choice::Close);
        }
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
            let plays = self.strips_play || card.hovered() || card.has_focus();
            self.thumbs.paint_strip(ui, example.name, example.picture, picture, Runs::Round, plays);
            if card.hovered() || card.has_focus() {
                let stroke = Stroke::new(2.0, ui.visuals().hyperlink_color);
                painter.rect_stroke(picture, CornerRadius::same(4), stroke, StrokeKind::Inside);
            }
            let title = Pos2::new(place.min.x, picture.max.y + GRID);
            let ink = ui.visuals().strong_text_color();
            painter.text(title, Align2::LEFT_TOP, example.title, FontId::proportional(13.0), ink);
            let weak = ui.visuals().weak_text_color();
            let source = picture.max - egui::vec2(1.5 * GRID, GRID);
            let pale = theme::color(Theme::gallery().text).gamma_multiply(0.7);
            painter.text(source, Align2::RIGHT_BOTTOM, example.source, FontId::proportional(11.0), pale);
            let line = painter.layout(example.line.to_owned(), FontId::proportional(11.0), weak, CARD);
            painter.galley(title + egui::vec2(0.0, 4.5 * GRID), line, weak);
        }
        card.on_hover_text(example.line).clicked()
    }
}

/// Whether what is said of an example has all of these words in it.
fn is_found(example: &Example, wanted: &[String]) -> bool {
    let said = format!("{} {} {}", example.title, example.source, example.line).to_lowercase();
    wanted.iter().all(|word| said.contains(word.as_str()))
}
