//! The line of status below the views.

use super::context::{Context, Request, Severity, Step};
use super::stroke_choices::stroke_choices;
use super::theme::{self, GRID};
use crate::edit::Command;
use crate::scene::TimeStep;
use crate::sim::SimCommand;
use egui::{Label, Panel, RichText, Ui};

/// Shows what stopped the simulation, or what was said last and what can be done now.
pub(super) fn status_bar(ui: &mut Ui, cx: &mut Context) {
    Panel::bottom("status").frame(theme::panel(ui)).show(ui, |ui| {
        ui.add_space(0.5 * GRID);
        ui.horizontal(|ui| line(ui, cx));
        ui.add_space(0.5 * GRID);
    });
}

fn line(ui: &mut Ui, cx: &mut Context) {
    let status = &cx.simulation.published().status;
    if let Some(failure) = &status.failure {
        ui.colored_label(cx.tone.error(), format!("Stopped: {}", cx.scene().with_names(failure)));
        return;
    }
    if let Some(divergence) = status.divergence.clone() {
        offer_fix(ui, cx);
        ui.colored_label(cx.tone.error(), format!("Stopped: {}", cx.scene().with_names(&divergence)));
        return;
    }
    offer_after_sketch(ui, cx);
    if let Some((severity, text)) = &cx.status.message {
        let (mark, color) = match severity {
            Severity::Note => ("", ui.visuals().text_color()),
            Severity::Warning => ("Warning: ", cx.tone.warning()),
            Severity::Error => ("Error: ", cx.tone.error()),
        };
        let text = format!("{mark}{text}");
        ui.add(Label::new(RichText::new(&text).color(color)).truncate()).on_hover_text(text);
        ui.separator();
    }
    let hint = cx.status.gesture.as_deref().unwrap_or(cx.status.hint);
    ui.add(Label::new(RichText::new(hint).weak()).truncate());
}

/// What takes a body that was stopped on again.
fn offer_fix(ui: &mut Ui, cx: &mut Context) {
    let mut time = cx.scene().time.clone();
    let (text, tooltip) = match &mut time.step {
        TimeStep::Manual(_) => {
            time.step = TimeStep::default();
            ("Step automatically and restart", "Chooses the time step from the stable one that is measured")
        }
        TimeStep::Automatic(step) => {
            step.safety = (0.5 * step.safety).max(0.01);
            ("Halve the step and restart", "Halves the share of the stable time step that is used")
        }
    };
    if ui.button(text).on_hover_text(tooltip).clicked() {
        cx.edit(&Command::SetTime(time), Step::Own);
        cx.ask(SimCommand::Reset);
        cx.ask(SimCommand::Play);
    }
}

/// What may be meant otherwise by the strokes that were drawn last.
fn offer_after_sketch(ui: &mut Ui, cx: &mut Context) {
    if cx.status.offers_stretch
        && ui.button("Stretch instead").on_hover_text("Stretches the second stroke onto the first").clicked()
    {
        cx.request(Request::StretchStrokes);
    }
    if cx.status.drawn_fibre.is_some() && cx.status.drawn_fibre.as_ref() == cx.selection.active() {
        stroke_choices(ui, cx);
    }
}
