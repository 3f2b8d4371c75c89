//! A row of the left panel: colour, visibility and name of something.

use super::context::{Context, Step};
use crate::edit::{Command, Item};
use egui::{Color32, Id, Pos2, Rect, Role, Sense, Shape, Stroke, TextEdit, Ui, WidgetInfo};

/// Name and visibility of something; whether its name was clicked. A second click renames it.
pub(super) fn row(ui: &mut Ui, cx: &mut Context, item: &Item, name: &str, hidden: bool, chosen: bool) -> bool {
    let (spot, eye) = ui.allocate_exact_size(egui::vec2(16.0, 16.0), Sense::click());
    let eye = eye.on_hover_text(if hidden { "Show" } else { "Hide; it acts all the same" });
    eye.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, !hidden, format!("Show {name}")));
    paint_eye(ui, spot, hidden, eye.hovered());
    if eye.clicked() {
        cx.edit(&Command::SetHidden { items: vec![item.clone()], hidden: !hidden }, Step::Own);
    }
    let id = Id::unique(("rename", item));
    if let Some(mut text) = ui.data(|data| data.get_temp::<String>(id)) {
        let edit = ui.add(TextEdit::singleline(&mut text).desired_width(f32::INFINITY));
        let escaped = ui.input(|input| input.key_pressed(egui::Key::Escape));
        if edit.lost_focus() || ui.input(|input| input.key_pressed(egui::Key::Enter)) || escaped {
            // Or else keys would go on meaning text.
            edit.surrender_focus();
            ui.data_mut(|data| data.remove::<String>(id));
            if !escaped && text != name {
                cx.edit(&Command::SetName { item: item.clone(), name: text }, Step::Own);
            }
        } else {
            edit.request_focus();
            ui.data_mut(|data| data.insert_temp(id, text));
        }
        return false;
    }
    let label = ui.selectable_label(chosen, name).on_hover_text("Double-click renames it");
    if label.double_clicked() {
        ui.data_mut(|data| data.insert_temp(id, name.to_owned()));
    }
    label.clicked()
}

/// The colour of a fibre, a sheet or a body, which can be changed; that of the theme unless it has its own.
pub(super) fn colour(ui: &mut Ui, cx: &mut Context, item: &Item, own: Option<[u8; 3]>, usual: Color32) {
    let now = own.map_or(usual, |[r, g, b]| Color32::from_rgb(r, g, b));
    let mut color = [now.r(), now.g(), now.b()];
    ui.scope(|ui| {
        ui.spacing_mut().interact_size = egui::vec2(14.0, 14.0);
        let button = ui.color_edit_button_srgb(&mut color).on_hover_text("Colour; right click: that of the theme");
        if button.changed() {
            cx.edit(&Command::SetColor { items: vec![item.clone()], color: Some(color) }, Step::Present);
        } else if button.secondary_clicked() {
            cx.edit(&Command::SetColor { items: vec![item.clone()], color: None }, Step::Own);
        }
    });
}

/// An eye, open or shut.
fn paint_eye(ui: &Ui, spot: Rect, hidden: bool, hovered: bool) {
    let color = if hovered { ui.visuals().strong_text_color() } else { ui.visuals().weak_text_color() };
    let stroke = Stroke::new(1.2, color);
    let (middle, half) = (spot.center(), egui::vec2(6.0, 4.0));
    let lid = |side: f32| -> Vec<Pos2> {
        (0..=12)
            .map(|k| k as f32 / 6.0 - 1.0)
            .map(|x| middle + egui::vec2(half.x * x, side * half.y * (1.0 - x * x)))
            .collect()
    };
    ui.painter().add(Shape::line(lid(1.0), stroke));
    if !hidden {
        ui.painter().add(Shape::line(lid(-1.0), stroke));
        ui.painter().circle_filled(middle, 1.8, color);
    }
}
