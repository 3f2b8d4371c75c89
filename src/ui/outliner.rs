//! The left panel: bodies, fibres and sheets by name, colour and visibility, and colliders.

use super::context::{Context, Request};
use super::editing::{Editing, brush_panel};
use super::inspector::inspector;
use super::outline_row::{colour, row};
use super::sheets_section::sheets_section;
use super::theme::{self, GRID, SIDE_WIDTH};
use crate::edit::Item;
use crate::scene::{AnyBody, Collider, Fibre};
use crate::solver::snapshot::{FibreSnapshot, SpringKind};
use egui::{Panel, RichText, ScrollArea, Ui};

/// Shows what the document consists of, the selected fibres' properties, and the brush while it is in use.
pub(super) fn left_panel(ui: &mut Ui, cx: &mut Context, editing: &mut Editing) {
    Panel::left("outliner").default_size(SIDE_WIDTH).frame(theme::panel(ui)).show(ui, |ui| {
        // The same width whatever stands in it: the views must not jump when a fibre is selected.
        ui.set_min_width(ui.available_width());
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            ui.add_space(GRID);
            bodies(ui, cx);
            layers(ui, cx);
            fibres(ui, cx);
            sheets_section(ui, cx);
            colliders(ui, cx);
            brush_panel(editing, ui, cx);
        });
    });
}

fn bodies(ui: &mut Ui, cx: &mut Context) {
    let listed = |body: AnyBody<'_>| (body.id().to_owned(), body.title().to_owned(), body.hidden(), body.color());
    let bodies: Vec<_> = cx.scene().all_bodies().map(listed).collect();
    if bodies.is_empty() {
        ui.label(
            "The scene has no body. Add one by the menu Body, drop a model here, or start from the soft bar (Ctrl+N).",
        );
        return;
    }
    ui.heading("Bodies");
    let usual = cx.tone.pictures().skin;
    for (index, (id, name, hidden, color)) in bodies.into_iter().enumerate() {
        ui.horizontal(|ui| {
            let item = Item::Body(id.clone());
            colour(ui, cx, &item, color, theme::color(usual));
            if row(ui, cx, &item, &name, hidden, index == cx.active.index) {
                cx.request(Request::ChooseBody(id));
            }
        });
    }
    ui.add_space(2.0 * GRID);
}

/// What a two-layer body is made of.
fn layers(ui: &mut Ui, cx: &Context) {
    let (Some(body), Some(shown)) = (cx.active_two_layer(), cx.active.model.bodies.first()) else { return };
    ui.heading(body.title());
    let Some(layers) = &shown.layers else { return };
    ui.label(format!("Two-layer body of {} dimensions", body.shape.dimension()));
    ui.label(format!("{} particles outside, {} inside", layers.outer, shown.particles.len() - layers.outer));
    let theme = cx.tone.pictures();
    for (kind, range) in &layers.kinds {
        let (name, colour) = match kind {
            SpringKind::Structural => ("structural", theme.text),
            SpringKind::Radius => ("radius", theme.axes[1]),
            SpringKind::ShearLeft => ("shear-left", theme.axes[0]),
            SpringKind::ShearRight => ("shear-right", theme.axes[2]),
        };
        ui.colored_label(theme::color(colour), format!("{} {name} springs", range.len()));
    }
}

fn fibres(ui: &mut Ui, cx: &mut Context) {
    let Some(body) = cx.active_body() else { return };
    let (fibres, id) = (body.fibres.clone(), body.id.clone());
    ui.heading("Fibres");
    if fibres.is_empty() {
        ui.label("None yet: draw one stroke in each of the two drawing views.");
    }
    for (k, fibre) in fibres.iter().enumerate() {
        let item = Item::Fibre { body: id.clone(), fibre: fibre.id.clone() };
        ui.horizontal(|ui| {
            let hue = theme::color(cx.tone.pictures().fibre(k));
            colour(ui, cx, &item, fibre.color, hue);
            let chosen = cx.selection.contains(&fibre.id);
            let is_in = is_in_solid(cx, fibre);
            if row(ui, cx, &item, fibre.title(), fibre.hidden, chosen) {
                let adding = ui.input(|input| input.modifiers.shift || input.modifiers.command);
                if chosen && !adding && cx.selection.fibres().len() == 1 {
                    cx.selection.clear();
                } else {
                    cx.selection.click(Some(&fibre.id), adding);
                }
            }
            if !is_in {
                let why = "Too little of this fibre lies in the solid for it to act: move it in, or delete it";
                ui.label(RichText::new("outside").small().color(cx.tone.warning())).on_hover_text(why);
            }
        });
    }
    ui.add_space(2.0 * GRID);
    if cx.selection.active().is_some() {
        ui.separator();
        inspector(ui, cx, &id);
    }
}

/// The colliders by name: a click chooses one and shows what it is.
fn colliders(ui: &mut Ui, cx: &mut Context) {
    let listed = |of: &Collider| (of.id.clone(), of.title().to_owned(), of.shape.word());
    let colliders: Vec<_> = cx.scene().colliders.iter().map(listed).collect();
    if colliders.is_empty() {
        return;
    }
    ui.heading("Colliders");
    for (id, name, kind) in colliders {
        let chosen = cx.selection.collider() == Some(&id);
        let label = ui.selectable_label(chosen, name);
        if label.on_hover_text(format!("A {kind} that bodies touch; its numbers stand under World")).clicked() {
            cx.selection.choose_collider(id);
            cx.request(Request::ShowWorld);
        }
    }
    ui.add_space(2.0 * GRID);
}

/// Whether a fibre acts: the solid was put together with it, or is still to be.
fn is_in_solid(cx: &Context, fibre: &Fibre) -> bool {
    let status = &cx.simulation.published().status;
    let is_settled = cx.simulation.is_up_to_date() && status.baking.is_none() && !status.stopped;
    let known = cx.active.model.bodies.first().map(|body| &body.fibres);
    let is_there = |known: &Vec<_>| known.iter().any(|shown: &FibreSnapshot| shown.id == fibre.id);
    !is_settled || status.failure.is_some() || known.is_none_or(is_there)
}
