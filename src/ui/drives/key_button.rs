//! The button beside a field that can be driven: hollow where it does not change in time, half full where it does, and
//! full, in another colour, where it has a key in the frame that is shown.

use super::actions::{KeyState, key_state, toggle_key};
use crate::scene::Drivable;
use crate::ui::context::Context;
use crate::ui::field::NumberField;
use egui::{Color32, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo};

/// Side of the button, and half the diagonal of what it shows [points].
const BUTTON: f32 = 18.0;
const DIAMOND: f32 = 4.5;

/// A diamond about a point.
pub(super) fn diamond(at: Pos2, half: f32, fill: Color32, line: Stroke) -> Shape {
    let corners = [Vec2::new(0.0, -half), Vec2::new(half, 0.0), Vec2::new(0.0, half), Vec2::new(-half, 0.0)];
    Shape::convex_polygon(corners.map(|corner| at + corner).to_vec(), fill, line)
}

/// The button for something that a drive can move.
pub(crate) fn key_button(ui: &mut Ui, cx: &mut Context, of: &Drivable) {
    let state = key_state(of, cx);
    let title = of.source(cx.scene()).title(cx.scene());
    let (name, tooltip) = match state {
        KeyState::Keyed(_) => (format!("Remove the key of {title}"), "There is a key in this frame: takes it away"),
        KeyState::Driven => {
            (format!("Set a key of {title}"), "It changes in time: sets a key in this frame to what it is now (I)")
        }
        KeyState::Still => (
            format!("Set a key of {title}"),
            "It stays as it is: sets a key in this frame, from which it can change (I)",
        ),
    };
    let (place, response) = ui.allocate_exact_size(Vec2::splat(BUTTON), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    if ui.is_rect_visible(place) {
        let visuals = ui.style().interact(&response);
        if response.hovered() || response.has_focus() {
            ui.painter().rect_filled(place, visuals.corner_radius, visuals.weak_bg_fill);
        }
        let (at, ink) = (place.center(), visuals.text_color());
        let line = Stroke::new(1.0, ink);
        match state {
            KeyState::Keyed(_) => {
                ui.painter().add(diamond(at, DIAMOND + 0.5, cx.tone.error(), Stroke::new(1.0, cx.tone.error())));
            }
            KeyState::Driven => {
                let half = [Vec2::new(0.0, -DIAMOND), Vec2::new(0.0, DIAMOND), Vec2::new(-DIAMOND, 0.0)];
                ui.painter().add(Shape::convex_polygon(half.map(|corner| at + corner).to_vec(), ink, Stroke::NONE));
                ui.painter().add(diamond(at, DIAMOND, Color32::TRANSPARENT, line));
            }
            KeyState::Still => {
                ui.painter().add(diamond(at, DIAMOND, Color32::TRANSPARENT, line));
            }
        }
    }
    if response.on_hover_text(tooltip).clicked() {
        toggle_key(of, cx);
    }
}

/// A number with the button of what drives it; whether the number was changed. `I` over it does as the button.
pub(crate) fn keyed_field(ui: &mut Ui, cx: &mut Context, field: &NumberField, value: &mut f64, of: &Drivable) -> bool {
    let (changed, place) = field.show_beside(ui, value, |ui| key_button(ui, cx, of));
    point_at(ui, cx, place, of);
    changed
}

/// Notes that the pointer is over a field of something that a drive can move, if it is.
pub(crate) fn point_at(ui: &Ui, cx: &mut Context, place: Rect, of: &Drivable) {
    if ui.rect_contains_pointer(place) {
        cx.pointed = Some(of.clone());
    }
}
