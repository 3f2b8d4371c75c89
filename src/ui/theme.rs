//! Colours, sizes and spacing of the window: everything else refers to them.

use crate::draw::{Colour, Theme};
use egui::{Color32, CornerRadius, FontId, Margin, Stroke, TextStyle, Visuals};

/// Width of the side panels [points].
pub(crate) const SIDE_WIDTH: f32 = 240.0;
/// The grid on which everything stands [points].
pub(crate) const GRID: f32 = 4.0;

/// Strokes as they are drawn [points].
pub(crate) const STROKE_WIDTH: f32 = 2.5;
/// Guides [points].
pub(crate) const GUIDE_WIDTH: f32 = 1.0;

/// Light or dark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tone {
    /// For bright surroundings.
    Light,
    /// For dark surroundings.
    Dark,
}

impl Tone {
    /// The other one.
    #[must_use]
    pub(crate) fn other(self) -> Self {
        match self {
            Self::Light => Self::Dark,
            Self::Dark => Self::Light,
        }
    }

    /// Colours of the pictures.
    pub(crate) fn pictures(self) -> Theme {
        match self {
            Self::Light => Theme::light(),
            Self::Dark => Theme::dark(),
        }
    }

    /// What warns.
    pub(crate) fn warning(self) -> Color32 {
        match self {
            Self::Light => Color32::from_rgb(0x9a, 0x5b, 0x00),
            Self::Dark => Color32::from_rgb(0xf0, 0xb4, 0x4c),
        }
    }

    /// What failed.
    pub(crate) fn error(self) -> Color32 {
        match self {
            Self::Light => Color32::from_rgb(0xb4, 0x23, 0x18),
            Self::Dark => Color32::from_rgb(0xff, 0x7b, 0x72),
        }
    }

    /// Dresses a context.
    pub(crate) fn apply(self, ctx: &egui::Context) {
        let mut visuals = match self {
            Self::Light => Visuals::light(),
            Self::Dark => Visuals::dark(),
        };
        let accent = color(self.pictures().accent);
        visuals.selection.bg_fill = accent.gamma_multiply(0.35);
        visuals.selection.stroke = Stroke::new(1.0, visuals.strong_text_color());
        visuals.hyperlink_color = accent;
        match self {
            Self::Light => {
                visuals.panel_fill = Color32::from_gray(0xf4);
                visuals.window_fill = Color32::from_gray(0xfa);
                visuals.override_text_color = Some(Color32::from_gray(0x26));
            }
            Self::Dark => {
                visuals.panel_fill = Color32::from_gray(0x1f);
                visuals.window_fill = Color32::from_gray(0x26);
                visuals.override_text_color = Some(Color32::from_gray(0xd6));
            }
        }
        visuals.widgets.noninteractive.bg_stroke =
            Stroke::new(1.0, visuals.widgets.noninteractive.bg_stroke.color.gamma_multiply(0.6));
        let radius = CornerRadius::same(4);
        for widget in [&mut visuals.widgets.inactive, &mut visuals.widgets.hovered, &mut visuals.widgets.active] {
            widget.corner_radius = radius;
        }
        ctx.set_theme(match self {
            Self::Light => egui::Theme::Light,
            Self::Dark => egui::Theme::Dark,
        });
        ctx.set_visuals(visuals);
        ctx.all_styles_mut(|style| {
            style.spacing.item_spacing = egui::vec2(2.0 * GRID, 1.5 * GRID);
            style.spacing.button_padding = egui::vec2(2.0 * GRID, GRID);
            style.spacing.menu_margin = Margin::same(6);
            style.text_styles = [
                (TextStyle::Heading, FontId::proportional(15.0)),
                (TextStyle::Body, FontId::proportional(13.0)),
                (TextStyle::Button, FontId::proportional(13.0)),
                (TextStyle::Monospace, FontId::monospace(12.0)),
                (TextStyle::Small, FontId::proportional(11.0)),
            ]
            .into();
        });
    }
}

/// The frame of a bar or panel, without a ground of its own: the window's is behind it already, and to fill it again
/// pixel by pixel is a quarter of a frame's work where no graphics card does it.
pub(crate) fn panel(ui: &egui::Ui) -> egui::Frame {
    egui::Frame::side_top_panel(ui.style()).fill(Color32::TRANSPARENT)
}

/// A picture's colour in the window.
pub(crate) fn color(colour: Colour) -> Color32 {
    let byte = |channel: f32| (255.0 * channel.clamp(0.0, 1.0)).round() as u8;
    Color32::from_rgba_unmultiplied(byte(colour.red), byte(colour.green), byte(colour.blue), byte(colour.alpha))
}
