//! Choosing fibres and vertices in the views: by a click, or by a box around them.

use super::BoxDrag;
use super::gizmo::Handle;
use super::moving::{Asked, Kind, seen_angle};
use crate::scene::Body;
use crate::ui::pane::{Frame, PaneKind, View3d};
use crate::ui::theme;
use egui::{CursorIcon, Pos2, Rect, Response, Stroke, StrokeKind, Ui};
use glam::{DMat3, DVec3};

/// How near a click must come to a fibre [points].
const NEAR_FIBRE: f64 = 9.0;
/// And to a vertex.
const NEAR_VERTEX: f64 = 10.0;
/// Radius of a vertex's mark.
const VERTEX_RADIUS: f32 = 4.0;

impl View3d<'_> {
    /// Takes clicks, handles and gestures of editing; called before strokes and pulls, which leave the pointer alone then.
    pub(in crate::ui) fn edit(&mut self, ui: &Ui, response: &Response, frame: Frame) {
        if self.app.active_body().is_none() {
            return;
        }
        let (at, press, modifiers) =
            ui.input(|input| (input.pointer.latest_pos(), input.pointer.press_origin(), input.modifiers));
        if self.moves(ui, response, frame) || self.boxes(ui, response, frame) || self.brush(ui, response, frame) {
            return;
        }
        let here = at.filter(|at| frame.rect.contains(*at) && response.hovered());
        // Where a press began counts, not where the pointer has slid to since.
        let aimed = if response.is_pointer_button_down_on() { press } else { here };
        let handle = aimed.and_then(|at| self.handle_at(frame, at));
        if response.hovered() || response.is_pointer_button_down_on() {
            self.app.editing.hovered = handle;
        }
        if handle.is_some() {
            ui.ctx().set_cursor_icon(CursorIcon::Grab);
        }
        if response.drag_started_by(egui::PointerButton::Primary)
            && !modifiers.alt
            && let (Some(handle), Some(start)) = (handle, press)
        {
            let (kind, axis) = match handle {
                Handle::Axis(axis) => (Kind::Move, Some(axis)),
                Handle::Middle => (Kind::Move, None),
                Handle::Ring => (Kind::Turn, None),
                Handle::Vertex(vertex) => {
                    if !self.app.editing.selection.vertices().is_some_and(|chosen| chosen.contains(&vertex)) {
                        self.app.editing.selection.click_vertex(Some(vertex), modifiers.shift);
                    }
                    (Kind::Move, None)
                }
            };
            self.app.begin_moving(kind, axis, self.pane.kind, start, true);
            self.app.editing.hovered = None;
        } else if response.clicked_by(egui::PointerButton::Primary)
            && let Some(at) = at
        {
            self.click(frame, at, modifiers.shift);
        }
    }

    fn click(&mut self, frame: Frame, at: Pos2, adding: bool) {
        if self.app.editing.selection.vertices().is_some() {
            let vertex = self.vertex_at(frame, at);
            self.app.editing.selection.click_vertex(vertex, adding);
            return;
        }
        let fibre = self.fibre_at(frame, at);
        self.app.editing.selection.click(fibre.as_deref(), adding);
    }

    /// Follows a move or turn in the view in which it goes on; whether there is one here.
    fn moves(&mut self, ui: &Ui, response: &Response, frame: Frame) -> bool {
        let Some((moving, view)) = &self.app.editing.moving else { return false };
        if *view != self.pane.kind {
            return false;
        }
        let (at, modifiers, pressed, other, released) = ui.input(|input| {
            let pointer = &input.pointer;
            (
                pointer.latest_pos(),
                input.modifiers,
                pointer.primary_pressed(),
                pointer.secondary_pressed(),
                pointer.primary_released(),
            )
        });
        let Some(at) = at else { return true };
        let size = frame.size();
        let to_world = self.to_view();
        let pivot = self.seen(moving.pivot);
        if let Some(seen) = frame.camera.project(pivot, size) {
            let place = |at: Pos2| frame.camera.point_at(frame.pixel(at), seen.depth, size);
            let by = to_world.transpose() * (place(at) - place(moving.start));
            let asked = Asked {
                to: moving.pivot + by,
                angle: seen_angle(frame.pixel(moving.start), frame.pixel(at), seen.pixel),
                toward_eye: to_world.transpose() * frame.camera.world_from_view().z_axis,
                fine: modifiers.shift,
                snap: modifiers.command,
            };
            self.app.editing.pending = moving.transform(&asked).ok();
        }
        let by_drag = moving.by_drag;
        self.app.follow_moving();
        ui.ctx().request_repaint();
        if other {
            self.app.end_moving(false);
        } else if (by_drag && released) || (!by_drag && pressed && response.contains_pointer()) {
            self.app.end_moving(true);
        }
        true
    }

    /// Draws a box around what is to be selected; whether one is being drawn.
    fn boxes(&mut self, ui: &Ui, response: &Response, frame: Frame) -> bool {
        let Some(begun) = self.app.editing.boxed else { return false };
        let (at, origin, adding) =
            ui.input(|input| (input.pointer.latest_pos(), input.pointer.press_origin(), input.modifiers.shift));
        if response.hovered() {
            ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
            self.app.hint = "Drag a box around what is to be selected; Shift adds, Escape leaves it";
        }
        if begun.from.is_none() && response.drag_started_by(egui::PointerButton::Primary) {
            self.app.editing.boxed = Some(BoxDrag { from: origin });
        }
        if response.drag_stopped_by(egui::PointerButton::Primary)
            && let (Some(from), Some(to)) = (self.app.editing.boxed.and_then(|boxed| boxed.from), at)
        {
            self.select_in(frame, Rect::from_two_pos(from, to), adding);
            self.app.editing.boxed = None;
        }
        true
    }

    fn select_in(&mut self, frame: Frame, rect: Rect, adding: bool) {
        let inside = |point: DVec3| frame.screen(point).is_some_and(|at| rect.contains(at));
        if let Some(before) = self.app.editing.selection.vertices() {
            let mut chosen = if adding { before.to_vec() } else { Vec::new() };
            let marks = self.vertex_marks();
            chosen.extend(marks.iter().enumerate().filter(|(_, at)| inside(**at)).map(|(k, _)| k));
            self.app.editing.selection.set_vertices(chosen);
            return;
        }
        let mut chosen = if adding { self.app.editing.selection.fibres().to_vec() } else { Vec::new() };
        for (id, vertices) in self.courses() {
            if vertices.iter().any(|&at| inside(at)) && !chosen.contains(&id) {
                chosen.push(id);
            }
        }
        self.app.editing.selection.set(chosen);
    }

    /// The box that is being drawn.
    pub(in crate::ui) fn paint_editing(&self, ui: &Ui, frame: Frame) {
        let painter = ui.painter_at(frame.rect);
        let accent = theme::color(self.app.tone.pictures().accent);
        let from = self.app.editing.boxed.and_then(|boxed| boxed.from);
        if let (Some(from), Some(to)) = (from, ui.input(|input| input.pointer.latest_pos()))
            && frame.rect.contains(from)
        {
            let rect = Rect::from_two_pos(from, to);
            painter.rect(rect, 0.0, accent.gamma_multiply(0.12), Stroke::new(1.0, accent), StrokeKind::Middle);
        }
        if let Some(chosen) = self.app.editing.selection.vertices() {
            let paper = theme::color(self.app.tone.pictures().background_bottom);
            for (k, at) in self.vertex_marks().into_iter().enumerate() {
                let Some(at) = frame.screen(at) else { continue };
                let fill = if chosen.contains(&k) { accent } else { paper };
                painter.circle(at, VERTEX_RADIUS, fill, Stroke::new(1.5, accent));
            }
        }
        self.paint_gizmo(&painter, frame);
        self.paint_brush(ui, frame);
    }

    /// Fibres as they are seen here, with their identifiers; hidden ones are not.
    fn courses(&self) -> Vec<(String, Vec<DVec3>)> {
        let shown = self.snapshot();
        let index = if self.pane.kind == PaneKind::Result { self.app.active } else { 0 };
        let hidden: Vec<&str> = self
            .app
            .active_body()
            .into_iter()
            .flat_map(|body: &Body| body.fibres.iter().filter(|fibre| fibre.hidden).map(|fibre| fibre.id.as_str()))
            .collect();
        let fibres = shown.bodies.get(index).into_iter().flat_map(|body| body.fibres.iter());
        fibres
            .filter(|fibre| !hidden.contains(&fibre.id.as_str()))
            .map(|fibre| (fibre.id.clone(), fibre.vertices.clone()))
            .collect()
    }

    fn fibre_at(&self, frame: Frame, at: Pos2) -> Option<String> {
        let near = self.courses().into_iter().filter_map(|(id, vertices)| {
            let seen: Vec<Pos2> = vertices.iter().filter_map(|&point| frame.screen(point)).collect();
            let nearest = seen.windows(2).map(|ends| distance_to(at, [ends[0], ends[1]])).fold(f64::INFINITY, f64::min);
            (nearest <= NEAR_FIBRE).then_some((id, nearest))
        });
        near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(id, _)| id)
    }

    /// Where the active fibre's vertices are seen here; none in the result unless it shows the same ones.
    fn vertex_marks(&self) -> Vec<DVec3> {
        let vertices = self.app.active_vertices();
        if self.pane.kind != PaneKind::Result {
            return vertices;
        }
        let Some(id) = self.app.editing.selection.active() else { return Vec::new() };
        let course = self.courses().into_iter().find(|(known, _)| known == id).map(|(_, course)| course);
        course.filter(|course| course.len() == vertices.len()).unwrap_or_default()
    }

    pub(super) fn vertex_at(&self, frame: Frame, at: Pos2) -> Option<usize> {
        self.app.editing.selection.vertices()?;
        let near = self.vertex_marks().into_iter().enumerate().filter_map(|(k, point)| {
            let away = f64::from(frame.screen(point)?.distance(at));
            (away <= NEAR_VERTEX).then_some((k, away))
        });
        near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(k, _)| k)
    }

    /// Turn from the model frame to what this view shows.
    pub(super) fn to_view(&self) -> DMat3 {
        match (self.pane.kind, self.app.active_body()) {
            (PaneKind::Result, Some(body)) => DMat3::from_quat(body.placement.rotation.quaternion()),
            _ => DMat3::IDENTITY,
        }
    }

    /// Where this view shows the middle of what is selected, which lies at `pivot` in the model frame.
    pub(super) fn seen(&self, pivot: DVec3) -> DVec3 {
        if self.pane.kind != PaneKind::Result {
            return pivot;
        }
        let selection = &self.app.editing.selection;
        let points: Vec<DVec3> = match selection.vertices() {
            Some(chosen) => {
                let marks = self.vertex_marks();
                chosen.iter().filter_map(|&k| marks.get(k).copied()).collect()
            }
            None => self.courses().into_iter().filter(|(id, _)| selection.contains(id)).flat_map(|(_, c)| c).collect(),
        };
        if points.is_empty() {
            let placement = self.app.active_body().map(|body| DVec3::from_array(body.placement.translation));
            return self.to_view() * pivot + placement.unwrap_or_default();
        }
        points.iter().sum::<DVec3>() / points.len() as f64
    }
}

/// Distance of a point from a segment [points].
pub(super) fn distance_to(at: Pos2, [a, b]: [Pos2; 2]) -> f64 {
    let (along, offset) = (b - a, at - a);
    let share = (offset.dot(along) / along.length_sq().max(1e-12)).clamp(0.0, 1.0);
    f64::from((offset - share * along).length())
}
