//! The left panel: bodies and fibres by name, colour and visibility, and colliders.

use super::context::{Context, Request, Step};
use super::editing::{Editing, brush_panel};
use super::inspector::inspector;
use super::theme::{self, GRID, SIDE_WIDTH};
use crate::edit::{Command, Item};
use crate::scene::{AnyBody, Collider, Fibre};
use crate::solver::snapshot::{FibreSnapshot, SpringKind};
use egui::{
    Color32, Id, Panel, Pos2, Rect, RichText, Role, ScrollArea, Sense, Shape, Stroke, TextEdit, Ui, WidgetInfo,
};

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

/// Name and visibility of something; whether its name was clicked. A second click renames it.
fn row(ui: &mut Ui, cx: &mut Context, item: &Item, name: &str, hidden: bool, chosen: bool) -> bool {
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

/// The colour of a fibre or a body, which can be changed; that of the theme unless it has its own.
fn colour(ui: &mut Ui, cx: &mut Context, item: &Item, own: Option<[u8; 3]>, usual: Color32) {
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
