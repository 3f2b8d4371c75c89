//! Elements of the active body: what ties some of its points together, measure by measure.

use super::context::{Context, Step};
use super::theme::GRID;
use crate::edit::Command;
use crate::scene::{Body, Element, ElementLaw};
use crate::text::number::compact;
use egui::{RichText, Ui};

/// Shows the elements of a body, where it has any; each can be taken away.
pub(super) fn elements_section(ui: &mut Ui, cx: &mut Context, body: &Body) {
    if body.elements.is_empty() {
        return;
    }
    ui.add_space(2.0 * GRID);
    ui.heading("Elements");
    let mut gone = None;
    for (index, element) in body.elements.iter().enumerate() {
        ui.push_id(("element", index), |ui| {
            ui.horizontal(|ui| {
                ui.label(element.title().to_owned());
                if ui.button("Remove").on_hover_text("Takes this element out of the body").clicked() {
                    gone = Some(index);
                }
                if !is_in_body(cx, element) {
                    let why = "A point of this element lies outside of the material, and so it does nothing";
                    ui.label(RichText::new("outside").small().color(cx.tone.warning())).on_hover_text(why);
                }
            });
            ui.label(RichText::new(in_words(element)).weak().small());
        });
    }
    if let Some(index) = gone {
        let mut elements = body.elements.clone();
        elements.remove(index);
        cx.edit(&Command::SetElements { body: body.id.clone(), elements }, Step::Own);
    }
}

/// Whether an element does anything: the solid was put together with it, or is still to be.
fn is_in_body(cx: &Context, element: &Element) -> bool {
    let status = &cx.simulation.published().status;
    let is_settled = cx.simulation.is_up_to_date() && status.baking.is_none() && !status.stopped;
    let known = cx.active.model.bodies.first().map(|body| &body.elements);
    let is_there = known.is_none_or(|known| known.iter().any(|shown| shown.id == element.id));
    !is_settled || status.failure.is_some() || is_there
}

/// What it measures and what it does about that.
fn in_words(element: &Element) -> String {
    let (measure, unit) = (element.measure.word(), element.measure.unit());
    let law = match &element.law {
        ElementLaw::Spring(of) => format!("spring of {} {unit}", compact(of.stiffness)),
        ElementLaw::TensionOnly(of) => format!("{} {unit}, pulled only", compact(of.stiffness)),
        ElementLaw::Muscle(of) => format!("muscle of {} {unit}", compact(of.force)),
        ElementLaw::Table(points) => format!("table of {} points", points.len()),
    };
    let acts = if element.activation.is_some() { ", acts" } else { "" };
    format!("{measure}: {law}{acts}")
}
