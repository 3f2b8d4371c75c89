//! The start screen: every scene that ships, with a picture and what to look at.

mod examples;

pub use examples::{EXAMPLES, Example, Group};

use super::action::Action;
use super::app::App;
use super::dialogs::Dialog;
use super::document::Document;
use super::theme::{self, GRID};
use super::thumbs::Thumbs;
use crate::draw::Theme;
use crate::io::{IoError, put_beside};
use crate::scene::Scene;
use crate::sim::SimCommand;
use egui::{
    Align2, CornerRadius, FontId, Frame, Pos2, Rect, RichText, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui,
};
use examples::shipped;
pub(super) use examples::shipped_assets;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Width of a card, height of its picture and of what stands below [points].
const CARD: f32 = 216.0;
const PICTURE: f32 = 135.0;
const BELOW: f32 = 56.0;
/// Cards beside each other at most.
const COLUMNS: usize = 4;

/// Under this name is remembered that the start screen was shown.
const KEY: &str = "start screen";

/// What the gallery keeps.
#[derive(Default)]
pub(super) struct Gallery {
    thumbs: Thumbs,
    /// Whether the open document is an example, whose models lie in no folder.
    pub(super) shipped: bool,
    /// Whether the start screen has been shown.
    welcomed: bool,
    /// Whether it is shown over a scene that nobody has seen start.
    welcoming: bool,
}

/// What a person wants of the gallery.
pub(super) enum Choice {
    /// To go on with what is open.
    Draw,
    /// To open an example.
    Open(&'static Example),
}

impl App {
    /// Shows the start screen over the scene that runs, unless it was shown before.
    pub fn welcome(&mut self) {
        if !self.gallery.welcomed {
            self.gallery.welcomed = true;
            self.gallery.welcoming = true;
            self.dialog = Some(Dialog::Examples);
        }
    }

    /// Starts the scene anew that the start screen was shown over.
    pub(super) fn welcomed(&mut self) {
        if std::mem::take(&mut self.gallery.welcoming) {
            self.ask(SimCommand::Reset);
        }
    }

    /// Whether the examples are shown.
    pub fn shows_examples(&self) -> bool {
        matches!(self.dialog, Some(Dialog::Examples))
    }

    /// How many of the examples' pictures have been decoded.
    pub fn decoded_examples(&self) -> usize {
        EXAMPLES.iter().filter(|example| self.gallery.thumbs.has(example.name)).count()
    }

    pub(super) fn recall_welcome(&mut self, storage: &dyn eframe::Storage) {
        self.gallery.welcomed = eframe::get_value(storage, KEY).unwrap_or(false);
    }

    pub(super) fn remember_welcome(&self, storage: &mut dyn eframe::Storage) {
        eframe::set_value(storage, KEY, &self.gallery.welcomed);
    }

    /// The scene of an example as it can be saved in a folder: its models are put there beside it.
    pub(super) fn with_models_in(&mut self, folder: &Path) -> Result<Scene, IoError> {
        let mut scene = Scene::clone(self.editor.scene());
        for path in scene.model_paths_mut() {
            if let Some(bytes) = shipped(path) {
                *path = put_beside(folder, path, bytes)?;
            }
        }
        Ok(scene)
    }
}

impl Document {
    /// An example: a document without a file, whose models come with the program.
    ///
    /// # Errors
    /// None for what ships.
    pub fn of_example(example: &Example) -> Result<Self, IoError> {
        let (scene, assets) = example.load()?;
        let note = Some(format!("Opened {}: {}", example.title, example.line));
        Ok(Self { scene, assets: Arc::new(assets), path: None, folder: PathBuf::new(), note })
    }
}

impl Gallery {
    /// The scene that the start screen was shown over is there no more.
    pub(super) fn forget_welcome(&mut self) {
        self.welcoming = false;
    }

    /// Shows everything; what was chosen, if something was.
    pub(super) fn show(&mut self, ui: &mut Ui) -> Option<Choice> {
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
