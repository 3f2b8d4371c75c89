//! Choices that several of the questions offer: a place, a unit and axes, the size of pictures.

use super::question::PlaceField;
use crate::export::Space;
use crate::geometry::model::UpAxis;
use crate::text::number::compact;
use egui::{ComboBox, DragValue, TextEdit, Ui};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, channel};

/// Units by their names, and how many of each make a metre.
const UNITS: [(&str, f64); 4] =
    [("Metres", 1.0), ("Centimetres", 100.0), ("Millimetres", 1000.0), ("Inches", 1.0 / 0.0254)];

/// A line for a path over the width that there is, and a button for the desktop's own dialog, which `pick` opens.
pub(super) fn place(
    ui: &mut Ui,
    label: &str,
    hint: &str,
    field: &mut PlaceField,
    pick: impl FnOnce() -> Option<PathBuf> + Send + 'static,
) {
    ui.horizontal(|ui| {
        let name = ui.label(label);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui.add_enabled(field.browsing.is_none(), egui::Button::new("Browse…")).clicked() {
                field.browsing = Some(browse(ui.ctx().clone(), pick));
            }
            let line = TextEdit::singleline(&mut field.text).hint_text(hint).desired_width(ui.available_width());
            ui.add(line).labelled_by(name.id);
        });
    });
    if let Some(Ok(picked)) = field.browsing.as_ref().map(Receiver::try_recv) {
        field.browsing = None;
        if let Some(path) = picked {
            field.text = path.display().to_string();
        }
    }
}

/// Opens a dialog of the desktop without holding the window up.
fn browse(ctx: egui::Context, pick: impl FnOnce() -> Option<PathBuf> + Send + 'static) -> Receiver<Option<PathBuf>> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        // The window may be gone by now.
        sender.send(pick()).ok();
        ctx.request_repaint();
    });
    receiver
}

/// A unit and the axis that points up.
pub(super) fn unit_and_axis(ui: &mut Ui, space: &mut Space) {
    let known = UNITS.iter().find(|(_, scale)| *scale == space.scale).map_or("Own unit", |(name, _)| name);
    let label = ui.label("Unit");
    let choice = ComboBox::from_id_salt("unit").selected_text(known).show_ui(ui, |ui| {
        for (name, scale) in UNITS {
            ui.selectable_value(&mut space.scale, scale, name);
        }
    });
    choice.response.labelled_by(label.id);
    let scale = DragValue::new(&mut space.scale).range(1e-6..=1e9).speed(0.1).suffix(" to a metre");
    ui.add(scale.custom_formatter(|value, _| compact(value))).on_hover_text("How many units make a metre");
    for (axis, name) in [(UpAxis::Y, "Y up"), (UpAxis::Z, "Z up")] {
        ui.selectable_value(&mut space.up, axis, name);
    }
}

/// A unit and axes in words.
pub(super) fn told(space: Space) -> String {
    let unit = UNITS.iter().find(|(_, scale)| *scale == space.scale);
    let unit =
        unit.map_or_else(|| format!("{} units to a metre", compact(space.scale)), |(name, _)| (*name).to_owned());
    format!("{unit}, {:?} up", space.up)
}

/// The size of pictures.
pub(super) fn picture_size(ui: &mut Ui, size: &mut [u32; 2], offered: &[[u32; 2]]) {
    let text = |[width, height]: [u32; 2]| format!("{width} × {height}");
    ui.horizontal(|ui| {
        let name = ui.label("Picture size");
        let choice = ComboBox::from_id_salt("picture size").selected_text(text(*size)).show_ui(ui, |ui| {
            for &offered in offered {
                ui.selectable_value(size, offered, text(offered));
            }
        });
        choice.response.labelled_by(name.id).on_hover_text("Width and height in pixels; the first is that of the view");
    });
}

/// A number of things.
pub(super) fn counted(count: usize, one: &str, many: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{} {many}", grouped(count)) }
}

/// A whole number in groups of three.
fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let first = digits.len() % 3;
    let mut text = digits[..first].to_owned();
    for group in digits.as_bytes()[first..].chunks(3) {
        if !text.is_empty() {
            // Narrow, and no place to break a line.
            text.push('\u{202f}');
        }
        text.extend(group.iter().map(|&digit| char::from(digit)));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_numbers_are_grouped() {
        let all = [0, 12, 345, 6789, 1_234_567].map(grouped);
        assert_eq!(all, ["0", "12", "345", "6\u{202f}789", "1\u{202f}234\u{202f}567"]);
    }
}
