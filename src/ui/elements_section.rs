//! Elements of the active body: what ties some of its points together, measure by measure, and how that acts.

use super::context::{Context, Step};
use super::drives::keyed_field;
use super::field::NumberField;
use super::motion_fields::drive_words;
use super::theme::GRID;
use crate::edit::Command;
use crate::scene::{Body, Drivable, Element, ElementActivation, ElementLaw};
use crate::text::number::compact;
use egui::{RichText, Ui};

const CONTRACTS: NumberField = NumberField::new(
    "Contracts by",
    "",
    -0.5..=0.8,
    Some(0.0),
    "Share by which it wants to measure less than it was drawn, where its drive is 1",
);
const TURNS: NumberField = NumberField::new(
    "Turns by",
    "°",
    -170.0..=170.0,
    Some(0.0),
    "By what its angle wants to be larger than it was drawn, where its drive is 1",
);

/// Shows the elements of a body, where it has any, with what they do by themselves; each can be taken away.
pub(super) fn elements_section(ui: &mut Ui, cx: &mut Context, body: &Body) {
    if body.elements.is_empty() {
        return;
    }
    ui.add_space(2.0 * GRID);
    ui.heading("Elements");
    let mut gone = None;
    let mut elements = body.elements.clone();
    for (index, element) in elements.iter_mut().enumerate() {
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
            let of = Drivable::Element { body: body.id.clone(), element: element.id.clone() };
            show_activation(ui, cx, element, &of);
        });
    }
    let mut step = Step::Present;
    if let Some(index) = gone {
        elements.remove(index);
        step = Step::Own;
    }
    if elements != body.elements {
        cx.edit(&Command::SetElements { body: body.id.clone(), elements }, step);
    }
}

/// Shows what an element does by itself.
fn show_activation(ui: &mut Ui, cx: &mut Context, element: &mut Element, of: &Drivable) {
    // As it acts once its number is another than none.
    let mut acts = element.activation.clone().unwrap_or_else(|| ElementActivation::contracting(0.0, 1.0));
    let (field, value) =
        if element.measure.is_angle() { (&TURNS, &mut acts.turn_degrees) } else { (&CONTRACTS, &mut acts.contract) };
    if keyed_field(ui, cx, field, value, of) {
        element.activation = Some(acts);
    }
    let Some(acts) = &element.activation else { return };
    let words = format!("times {}", drive_words(&acts.drive));
    let stops = ui.horizontal(|ui| {
        ui.weak(words).on_hover_text("Its lane is below the timeline, under Drives");
        ui.small_button("Acts no more").on_hover_text("It only resists again; its drive goes with it").clicked()
    });
    if stops.inner {
        element.activation = None;
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
