//! The gallery: a tile for every pattern, with a picture of what it does.

use crate::draw::Theme;
use crate::sketch::pattern::{OwnPattern, Pattern};
use crate::ui::theme::{self, GRID};
use crate::ui::thumbs::{Runs, Thumbs};
use egui::{Align2, CornerRadius, FontId, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui};
use glam::DVec3;

/// Width and height of a picture [points].
pub(super) const PICTURE: f32 = 88.0;

macro_rules! strips {
    ($($id:literal),*) => {
        /// What each pattern does, as a strip of pictures in a PNG file.
        const STRIPS: &[(&str, &[u8])] =
            &[$(($id, include_bytes!(concat!("../../../assets/patterns/", $id, ".png")))),*];
    };
}

strips!(
    "vertical",
    "slanted",
    "helix_left",
    "helix_right",
    "cross",
    "frame",
    "c_shape",
    "s_shape",
    "radial",
    "vein",
    "spiral",
    "short_fibres",
    "worm",
    "tail",
    "finger",
    "rings",
    "starfish",
    "tentacle",
    "trunk",
    "spokes"
);

/// Paints what a pattern does into a place.
pub(super) fn paint_strip(ui: &Ui, strips: &mut Thumbs, pattern: &Pattern, place: Rect, plays: bool) {
    ui.painter().rect_filled(place, CornerRadius::same(4), theme::color(Theme::gallery().background_top));
    if let Some((name, png)) = STRIPS.iter().find(|(id, _)| *id == pattern.id) {
        let runs = if pattern.is_acting() { Runs::Round } else { Runs::ForthAndBack };
        strips.paint_strip(ui, name, png, place, runs, plays);
    }
}

/// One row of the gallery: a place for the picture, the name and what it does. Gives the place, and the row to be
/// clicked.
pub(super) fn tile(ui: &mut Ui, title: &str, does: &str) -> (Option<Rect>, Response) {
    let (place, tile) = ui.allocate_exact_size(egui::vec2(ui.available_width(), PICTURE), Sense::click());
    tile.widget_info(|| egui::WidgetInfo::labeled(Role::Button, true, title));
    if !ui.is_rect_visible(place) {
        return (None, tile);
    }
    if tile.hovered() || tile.has_focus() {
        ui.painter().rect_filled(place, CornerRadius::same(4), ui.visuals().widgets.hovered.weak_bg_fill);
    }
    let words = Pos2::new(place.min.x + PICTURE + 2.0 * GRID, place.min.y + GRID);
    let room = (place.max.x - words.x).max(GRID);
    write(ui.painter(), words, room, title, does, [ui.visuals().strong_text_color(), ui.visuals().weak_text_color()]);
    (Some(Rect::from_min_size(place.min, egui::Vec2::splat(PICTURE))), tile)
}

fn write(painter: &Painter, at: Pos2, room: f32, title: &str, does: &str, [strong, weak]: [egui::Color32; 2]) {
    let title = painter.layout(title.to_owned(), FontId::proportional(13.0), strong, room);
    let below = at + egui::vec2(0.0, title.size().y + 0.5 * GRID);
    painter.galley(at, title, strong);
    let does = painter.layout(does.to_owned(), FontId::proportional(11.0), weak, room);
    painter.galley(below, does, weak);
}

/// From where an own pattern's fibres are seen: to the right and from above.
const EYE: [DVec3; 2] = [DVec3::new(0.88, 0.0, -0.47), DVec3::new(-0.13, 0.96, -0.25)];

/// Paints an own pattern's fibres in their box into a place.
pub(super) fn paint_own(ui: &Ui, own: &OwnPattern, place: Rect) {
    let look = Theme::gallery();
    let painter = ui.painter_at(place);
    painter.rect_filled(place, CornerRadius::same(4), theme::color(look.background_top));
    let seen = |point: DVec3| {
        let aside = point - DVec3::splat(0.5);
        let [right, up] = EYE.map(|axis| axis.dot(aside) as f32);
        place.center() + egui::vec2(right, -up) * 0.58 * place.width()
    };
    let edge = Stroke::new(1.0, theme::color(look.text).gamma_multiply(0.25));
    for k in 0..8_u8 {
        for axis in (0..3).filter(|axis| k >> axis & 1 == 0) {
            let corner = |k: u8| DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2 & 1));
            painter.line_segment([seen(corner(k)), seen(corner(k | 1 << axis))], edge);
        }
    }
    for (k, line) in own.lay(DVec3::ZERO, DVec3::ONE).iter().enumerate() {
        let points = line.iter().map(|&point| seen(point)).collect();
        painter.add(Shape::line(points, Stroke::new(2.0, theme::color(look.fibre(k)))));
    }
}

/// A tile's words alone, beside a picture of the same height.
pub(super) fn paint_words(ui: &Ui, place: Rect, does: &str) {
    let ink = ui.visuals().text_color();
    let words = ui.painter().layout(does.to_owned(), FontId::proportional(13.0), ink, place.width());
    let at = Align2::LEFT_TOP.align_size_within_rect(words.size(), place).min;
    ui.painter().galley(at, words, ink);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sketch::pattern::PATTERNS;
    use crate::ui::thumbs::frames_of;

    #[test]
    fn every_pattern_has_its_strip_and_all_are_small() {
        for pattern in &PATTERNS {
            let (_, png) = STRIPS.iter().find(|(id, _)| *id == pattern.id).unwrap_or_else(|| panic!("{}", pattern.id));
            assert_eq!(frames_of(png, 1.0), Some(10), "{}", pattern.id);
        }
        assert_eq!(STRIPS.len(), PATTERNS.len());
        let bytes: usize = STRIPS.iter().map(|(_, png)| png.len()).sum();
        assert!(bytes < 2_500_000, "{bytes}");
    }
}
