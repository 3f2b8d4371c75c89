//! A labelled number with its unit, range, default and the equation that it enters.

use crate::text::number::compact;
use crate::text::quantity::typed;
use egui::{Align, DragValue, Layout, Rect, Response, Ui};
use std::ops::RangeInclusive;

/// A number that a person can change.
#[derive(Clone, Debug)]
pub(super) struct NumberField {
    /// What it is called.
    pub label: &'static str,
    /// Its unit; may be empty.
    pub unit: &'static str,
    /// What it may be.
    pub range: RangeInclusive<f64>,
    /// What it is unless chosen otherwise, where there is such a value.
    pub default: Option<f64>,
    /// What it does, and the equation in which.
    pub tooltip: &'static str,
}

impl NumberField {
    /// A field.
    pub(super) const fn new(
        label: &'static str,
        unit: &'static str,
        range: RangeInclusive<f64>,
        default: Option<f64>,
        tooltip: &'static str,
    ) -> Self {
        Self { label, unit, range, default, tooltip }
    }

    /// Shows it over the width of a panel; whether it was changed.
    pub(super) fn show(&self, ui: &mut Ui, value: &mut f64) -> bool {
        self.show_beside(ui, value, |_| {}).0
    }

    /// As [`Self::show`], with something before the number; gives the place of it all, too.
    pub(super) fn show_beside(&self, ui: &mut Ui, value: &mut f64, beside: impl FnOnce(&mut Ui)) -> (bool, Rect) {
        let tooltip = self.explained();
        let shown = ui.horizontal(|ui| {
            let text = ui.label(self.label).on_hover_text(&tooltip);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let response = self.drag(ui, value).on_hover_text(&tooltip).labelled_by(text.id);
                let mut changed = response.changed();
                if let Some(default) = self.default {
                    response.context_menu(|ui| {
                        if ui.button(format!("Reset to {}", self.with_unit(default))).clicked() {
                            *value = default;
                            changed = true;
                            ui.close();
                        }
                    });
                }
                beside(ui);
                changed
            })
            .inner
        });
        (shown.inner, shown.response.rect)
    }

    fn drag(&self, ui: &mut Ui, value: &mut f64) -> Response {
        // A drag across the panel changes the value by its own size, whatever that is.
        let speed = (value.abs() * 0.01).max(1e-6);
        let suffix = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        ui.add(
            DragValue::new(value)
                .range(self.range.clone())
                // What is only shown stays as it is.
                .clamp_existing_to_range(false)
                .speed(speed)
                .suffix(suffix)
                .custom_formatter(|value, _| compact(value))
                .custom_parser(|text| typed(text, self.unit)),
        )
    }

    fn with_unit(&self, value: f64) -> String {
        format!("{} {}", compact(value), self.unit).trim_end().to_owned()
    }

    fn explained(&self) -> String {
        let [least, most] = [*self.range.start(), *self.range.end()].map(compact);
        let range = format!("{}\nFrom {least} to {most} {}", self.tooltip, self.unit);
        match self.default {
            Some(default) => format!("{}. Default {}: right click", range.trim_end(), self.with_unit(default)),
            None => range.trim_end().to_owned(),
        }
    }
}

/// Three numbers in a row, one an axis; whether one was changed.
pub(super) fn vector(ui: &mut Ui, label: &str, unit: &str, value: &mut [f64; 3], tooltip: &str) -> bool {
    let mut changed = false;
    ui.label(label).on_hover_text(tooltip);
    ui.horizontal(|ui| {
        for (axis, part) in ["X", "Y", "Z"].into_iter().zip(value) {
            let speed = (part.abs() * 0.01).max(1e-3);
            let drag = DragValue::new(part).speed(speed).prefix(format!("{axis} ")).suffix(format!(" {unit}"));
            changed |= ui
                .add(drag.custom_formatter(|value, _| compact(value)).custom_parser(|text| typed(text, unit)))
                .on_hover_text(format!("{tooltip}\nAlong {axis}"))
                .changed();
        }
    });
    changed
}
