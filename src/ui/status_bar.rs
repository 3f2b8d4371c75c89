//! The line of status below the views.

use super::action::Action;
use super::context::{Context, Request, Severity};
use super::remedy::Remedy;
use super::said::Said;
use super::stroke_choices::stroke_choices;
use super::theme::{self, GRID};
use egui::{Label, Panel, RichText, Ui};

/// A message has so much room at least, however long the hint [points].
const LEAST_ROOM: f32 = 160.0;

/// Shows what stopped the simulation or can no longer be drawn, or what was said last and what can be done now.
pub(super) fn status_bar(ui: &mut Ui, cx: &mut Context, said: &mut Said, remedy: &mut Remedy) {
    said.review(ui, cx);
    Panel::bottom("status").frame(theme::panel(ui)).show(ui, |ui| {
        ui.add_space(0.5 * GRID);
        ui.horizontal(|ui| {
            // As high with buttons as without: the views above must not jump.
            let text = ui.text_style_height(&egui::TextStyle::Button);
            ui.set_min_height((text + 2.0 * ui.spacing().button_padding.y).max(ui.spacing().interact_size.y));
            line(ui, cx, remedy);
        });
        ui.add_space(0.5 * GRID);
    });
}

fn line(ui: &mut Ui, cx: &mut Context, remedy: &mut Remedy) {
    let status = &cx.simulation.published().status;
    if let Some(failure) = &status.failure {
        one_line(ui, format!("Stopped: {}", cx.scene().with_names(failure)), cx.tone.error());
        return;
    }
    if let Some(lost) = &status.lost {
        one_line(ui, format!("Stopped: {}", cx.scene().with_names(lost)), cx.tone.error());
        return;
    }
    if let Some(divergence) = status.divergence.clone() {
        remedy.offer(ui, cx);
        one_line(ui, format!("Stopped: {}", cx.scene().with_names(&divergence)), cx.tone.error());
        return;
    }
    offer_after_sketch(ui, cx);
    let hint = cx.status.gesture.as_deref().unwrap_or(cx.status.hint);
    let font = egui::TextStyle::Body.resolve(ui.style());
    let hint_width = ui.painter().layout_no_wrap(hint.to_owned(), font, egui::Color32::WHITE).size().x;
    if let Some((severity, text)) = &cx.status.message {
        let (mark, color) = match severity {
            Severity::Note => ("", ui.visuals().text_color()),
            Severity::Warning => ("Warning: ", cx.tone.warning()),
            Severity::Error => ("Error: ", cx.tone.error()),
        };
        // What can be done now is never cut off by what was said.
        let room = ui.available_width() - hint_width - 6.0 * GRID;
        ui.scope(|ui| {
            ui.set_max_width(room.max(LEAST_ROOM));
            one_line(ui, format!("{mark}{text}"), color);
        });
        ui.separator();
    }
    ui.add(Label::new(RichText::new(hint).weak()).truncate());
}

/// Words on one line, all of them in the tooltip where they do not fit.
fn one_line(ui: &mut Ui, text: String, color: egui::Color32) {
    ui.add(Label::new(RichText::new(&text).color(color)).truncate()).on_hover_text(text);
}

/// What may be meant otherwise by the strokes that were drawn last.
fn offer_after_sketch(ui: &mut Ui, cx: &mut Context) {
    if cx.status.offers_stretch
        && ui.button("Stretch instead").on_hover_text("Stretches the second stroke onto the first").clicked()
    {
        cx.request(Request::StretchStrokes);
    }
    if !cx.status.offers_stretch
        && cx.status.drawn_fibre.is_some()
        && cx.status.drawn_fibre.as_ref() == cx.selection.active()
    {
        let tooltip = "Plays it from the start, beside itself without this fibre, and tells what differs";
        if ui.button("Show what it does").on_hover_text(tooltip).clicked() {
            cx.request(Request::Do(Action::ShowEffect));
        }
        stroke_choices(ui, cx);
    }
}
