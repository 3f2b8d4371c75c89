//! What the pointer does to fibres, vertices and bodies in the views: clicks, handles, boxes; and what is painted over
//! them.

use super::allowed::Allowed;
use super::brush::{brush, paint_brush};
use super::courses::{courses, fibre_at, sheet_at, vertex_at, vertex_marks};
use super::gizmo::{handle_at, paint_gizmo};
use super::handle::Handle;
use super::motion::{begin_moving, follow_pointer};
use super::moving::Kind;
use super::state::{BoxDrag, Editing};
use crate::draw::Slice;
use crate::ui::context::{Context, Request};
use crate::ui::theme;
use crate::ui::views::{PaneKind, ViewFrame, body_at};
use egui::{CursorIcon, Pos2, Rect, Response, Stroke, StrokeKind, Ui};
use glam::DVec3;

/// Radius of a vertex's mark [points].
const VERTEX_RADIUS: f32 = 4.0;

/// Takes clicks, handles, boxes and gestures of editing; called before strokes and grabs, which leave the pointer alone
/// then.
pub(crate) fn take_pointer(
    editing: &mut Editing,
    ui: &Ui,
    response: &Response,
    frame: &ViewFrame,
    slice: Option<Slice>,
    allowed: Allowed,
    cx: &mut Context,
) {
    let (at, press, modifiers) =
        ui.input(|input| (input.pointer.latest_pos(), input.pointer.press_origin(), input.modifiers));
    if follow_pointer(editing, ui, response, frame, cx)
        || follow_box(editing, ui, response, frame, cx)
        || brush(editing, ui, response, frame, slice, cx)
    {
        return;
    }
    let here = at.filter(|at| frame.rect.contains(*at) && response.hovered());
    // Where a press began counts, not where the pointer has slid to since.
    let aimed = if response.is_pointer_button_down_on() { press } else { here };
    let handle = aimed.and_then(|at| handle_at(editing, frame, at, allowed, cx));
    if response.hovered() || response.is_pointer_button_down_on() {
        editing.hovered = handle;
    }
    if allowed.boxes && response.hovered() {
        cx.status.hint = "Click selects, a drag moves by the handles or draws a box; E takes up the pen";
    }
    if handle.is_some() {
        ui.ctx().set_cursor_icon(CursorIcon::Grab);
    }
    let starts = response.drag_started_by(egui::PointerButton::Primary) && !modifiers.alt;
    if starts && let (Some(handle), Some(start)) = (handle, press) {
        let (kind, axis) = match handle {
            Handle::Axis(axis) => (Kind::Move, Some(axis)),
            Handle::Middle => (Kind::Move, None),
            Handle::Ring => (Kind::Turn, None),
            Handle::Corner => (Kind::Scale, None),
            Handle::Vertex(vertex) => {
                if !cx.selection.vertices().is_some_and(|chosen| chosen.contains(&vertex)) {
                    cx.selection.click_vertex(Some(vertex), modifiers.shift);
                }
                (Kind::Move, None)
            }
        };
        begin_moving(editing, kind, axis, frame.kind, start, true, cx);
        editing.hovered = None;
    } else if starts && allowed.boxes && cx.active_body().is_some() {
        editing.boxed = Some(BoxDrag { from: press });
    } else if response.clicked_by(egui::PointerButton::Primary)
        && let Some(at) = at
    {
        click(frame, at, modifiers.shift, slice, cx);
    }
}

/// Chooses the fibre at a point, or else the body, unless it is chosen already, for the menu of what lies there.
pub(crate) fn choose_at(frame: &ViewFrame, at: Pos2, slice: Option<Slice>, cx: &mut Context) {
    if cx.selection.vertices().is_some() {
        return;
    }
    match fibre_at(frame, at, cx) {
        Some(fibre) if cx.selection.contains(&fibre) => {}
        Some(fibre) => cx.selection.only(fibre),
        None if cx.selection.active().is_none() => {
            if let Some(sheet) = sheet_at(frame, at, cx) {
                cx.selection.choose_sheet(sheet);
            } else {
                choose_body_at(frame, at, slice, cx);
            }
        }
        None => {}
    }
}

fn click(frame: &ViewFrame, at: Pos2, adding: bool, slice: Option<Slice>, cx: &mut Context) {
    if cx.selection.vertices().is_some() {
        let vertex = vertex_at(frame, at, cx);
        cx.selection.click_vertex(vertex, adding);
        return;
    }
    let fibre = fibre_at(frame, at, cx);
    if fibre.is_none()
        && !adding
        && let Some(sheet) = sheet_at(frame, at, cx)
    {
        cx.selection.choose_sheet(sheet);
        return;
    }
    if fibre.is_none() && !adding && choose_body_at(frame, at, slice, cx) {
        return;
    }
    cx.selection.click(fibre.as_deref(), adding);
}

/// Selects the body that is seen at a point of the result view; false where there is none.
fn choose_body_at(frame: &ViewFrame, at: Pos2, slice: Option<Slice>, cx: &mut Context) -> bool {
    if frame.kind != PaneKind::Result || cx.simulation.is_comparing() {
        return false;
    }
    let found = body_at(frame, slice, at, &cx.simulation.published().snapshot.bodies);
    let id = found.and_then(|index| cx.scene().any_body(index)).map(|body| body.id().to_owned());
    let is_there = id.is_some();
    if let Some(id) = id {
        cx.request(Request::ChooseBody(id));
    }
    is_there
}

/// Draws a box around what is to be selected; whether one is being drawn.
fn follow_box(editing: &mut Editing, ui: &Ui, response: &Response, frame: &ViewFrame, cx: &mut Context) -> bool {
    let Some(begun) = editing.boxed else { return false };
    let (at, origin, adding) =
        ui.input(|input| (input.pointer.latest_pos(), input.pointer.press_origin(), input.modifiers.shift));
    if response.hovered() {
        ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
        cx.status.hint = "Drag a box around what is to be selected; Shift adds, Escape leaves it";
    }
    if begun.from.is_none() && response.drag_started_by(egui::PointerButton::Primary) {
        editing.boxed = Some(BoxDrag { from: origin });
    }
    if response.drag_stopped_by(egui::PointerButton::Primary)
        && let (Some(from), Some(to)) = (editing.boxed.and_then(|boxed| boxed.from), at)
    {
        select_in(frame, Rect::from_two_pos(from, to), adding, cx);
        editing.boxed = None;
    }
    true
}

fn select_in(frame: &ViewFrame, rect: Rect, adding: bool, cx: &mut Context) {
    let inside = |point: DVec3| frame.screen(point).is_some_and(|at| rect.contains(at));
    if let Some(before) = cx.selection.vertices() {
        let mut chosen = if adding { before.to_vec() } else { Vec::new() };
        let marks = vertex_marks(frame.kind, cx);
        chosen.extend(marks.iter().enumerate().filter(|(_, at)| inside(**at)).map(|(k, _)| k));
        cx.selection.set_vertices(chosen);
        return;
    }
    let mut chosen = if adding { cx.selection.fibres().to_vec() } else { Vec::new() };
    for (id, vertices) in courses(frame.kind, cx) {
        if vertices.iter().any(|&at| inside(at)) && !chosen.contains(&id) {
            chosen.push(id);
        }
    }
    cx.selection.set(chosen);
}

/// The box that is being drawn, marks of vertices, the gizmo and the brush.
pub(crate) fn paint(
    editing: &Editing,
    ui: &Ui,
    frame: &ViewFrame,
    slice: Option<Slice>,
    allowed: Allowed,
    cx: &Context,
) {
    let painter = ui.painter_at(frame.rect);
    let accent = theme::color(cx.tone.pictures().accent);
    let from = editing.boxed.and_then(|boxed| boxed.from);
    if let (Some(from), Some(to)) = (from, ui.input(|input| input.pointer.latest_pos()))
        && frame.rect.contains(from)
    {
        let rect = Rect::from_two_pos(from, to);
        painter.rect(rect, 0.0, accent.gamma_multiply(0.12), Stroke::new(1.0, accent), StrokeKind::Middle);
    }
    if let Some(chosen) = cx.selection.vertices() {
        let paper = theme::color(cx.tone.pictures().background_bottom);
        for (k, at) in vertex_marks(frame.kind, cx).into_iter().enumerate() {
            let Some(at) = frame.screen(at) else { continue };
            let fill = if chosen.contains(&k) { accent } else { paper };
            painter.circle(at, VERTEX_RADIUS, fill, Stroke::new(1.5, accent));
        }
    }
    paint_gizmo(editing, &painter, frame, allowed, cx);
    paint_brush(editing, ui, frame, slice, cx);
}
