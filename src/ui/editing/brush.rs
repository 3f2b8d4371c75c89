//! Painting the volume fraction with a brush on the result.

use crate::edit::Command;
use crate::scene::{Dab, Extra, MAX_DABS, add_dab};
use crate::ui::app::{App, Gravity};
use crate::ui::field::Field;
use crate::ui::pane::{Frame, PaneKind, View3d};
use crate::ui::theme;
use egui::{Pos2, Response, Stroke, Ui};
use glam::DVec3;

const RADIUS: Field = Field::new("Brush radius", "m", 1e-5..=10.0, None, "Beyond it the brush does nothing");
const VALUE: Field = Field::new(
    "Painted fraction",
    "",
    0.0..=1.0,
    Some(1.0),
    "l_i (eq. 18): 1 leaves no matrix there, 0 all of it whatever fibres run through",
);
const STRENGTH: Field =
    Field::new("Strength", "", 0.0..=1.0, Some(1.0), "How much of the way to that fraction one stroke goes");

/// Radius of a new brush, as a share of the body's diagonal.
const USUAL_RADIUS: f64 = 0.12;
/// A dab follows the last one after this share of the radius.
const APART: f64 = 0.25;

/// The brush, while it is in use.
#[derive(Clone, Debug)]
pub(in crate::ui) struct Brush {
    radius: f64,
    value: f64,
    strength: f64,
    /// Where the last dab of this stroke lies [m].
    last: Option<DVec3>,
    /// Changes of one stroke are one step of undo.
    gesture: u64,
    /// Dabs that are not in the document yet.
    waiting: Vec<Dab>,
}

impl App {
    /// Takes up the brush, or puts it down.
    pub(super) fn toggle_brush(&mut self) {
        self.editing.brush = match self.editing.brush.take() {
            Some(_) => None,
            None => Some(Brush {
                radius: USUAL_RADIUS * self.model_diagonal(),
                value: 1.0,
                strength: 1.0,
                last: None,
                gesture: 0,
                waiting: Vec::new(),
            }),
        };
    }

    /// The brush's own panel, while it is in use.
    pub(in crate::ui) fn brush_panel(&mut self, ui: &mut Ui) {
        let Some(brush) = &mut self.editing.brush else { return };
        ui.heading("Brush");
        RADIUS.show(ui, &mut brush.radius);
        VALUE.show(ui, &mut brush.value);
        STRENGTH.show(ui, &mut brush.strength);
        ui.label("Drag over the body in the result view.");
        let Some((body, painted)) = self.active_body().map(|body| (body.id.clone(), !body.paint.is_empty())) else {
            return;
        };
        ui.horizontal(|ui| {
            if ui.add_enabled(painted, egui::Button::new("Clear paint")).clicked() {
                self.gesture += 1;
                self.apply(&Command::SetPaint { body, paint: Vec::new() });
            }
            if ui.button("Done").clicked() {
                self.editing.brush = None;
            }
        });
    }

    /// Puts waiting dabs into the document, once the simulation has taken up those before, or `now`.
    fn paint_waiting(&mut self, now: bool) {
        if !now && !self.is_up_to_date() {
            return;
        }
        let Some(brush) = &mut self.editing.brush else { return };
        let (waiting, gesture) = (std::mem::take(&mut brush.waiting), brush.gesture);
        let Some(body) = self.active_body().filter(|_| !waiting.is_empty()) else { return };
        let (id, mut paint) = (body.id.clone(), body.paint.clone());
        for dab in waiting {
            add_dab(&mut paint, dab);
        }
        if paint.len() > MAX_DABS {
            self.say(
                Gravity::Warning,
                format!("There is room for {MAX_DABS} dabs; use a larger brush or clear the paint"),
            );
            return;
        }
        self.apply_in(&Command::SetPaint { body: id, paint }, gesture);
    }
}

impl View3d<'_> {
    /// Paints with the brush; whether it is in use here.
    pub(super) fn brush(&mut self, ui: &Ui, response: &Response, frame: Frame) -> bool {
        if self.app.editing.brush.is_none() || self.pane.kind != PaneKind::Result {
            return false;
        }
        let primary = egui::PointerButton::Primary;
        let alt = ui.input(|input| input.modifiers.alt);
        let at = ui.input(|input| input.pointer.latest_pos());
        let down = response.is_pointer_button_down_on() && ui.input(|input| input.pointer.primary_down()) && !alt;
        let place = at.filter(|_| down).and_then(|at| self.rest_point(frame, at));
        if ui.input(|input| input.pointer.primary_pressed()) {
            self.app.gesture += 1;
            if let Some(brush) = &mut self.app.editing.brush {
                brush.gesture = self.app.gesture;
            }
        }
        if let (Some(brush), Some(place)) = (&mut self.app.editing.brush, place)
            && brush.last.is_none_or(|last| last.distance(place) > APART * brush.radius)
        {
            brush.last = Some(place);
            let Brush { radius, value, strength, .. } = *brush;
            brush.waiting.push(Dab { center: place.to_array(), radius, value, strength, extra: Extra::new() });
        }
        let ends = response.drag_stopped_by(primary) || response.clicked_by(primary);
        self.app.paint_waiting(ends);
        if let Some(brush) = self.app.editing.brush.as_mut().filter(|_| !down) {
            brush.last = None;
        }
        if down {
            ui.ctx().request_repaint();
        }
        if response.hovered() {
            self.app.hint =
                "Drag to paint the volume fraction; Alt + drag turns the view, V or Escape puts the brush down";
        }
        true
    }

    /// The circle in which the brush acts.
    pub(super) fn paint_brush(&self, ui: &Ui, frame: Frame) {
        let Some(brush) = self.app.editing.brush.as_ref().filter(|_| self.pane.kind == PaneKind::Result) else {
            return;
        };
        let Some(at) = ui.input(|input| input.pointer.latest_pos()).filter(|at| frame.rect.contains(*at)) else {
            return;
        };
        let Some((point, _)) = self.touched(frame, at) else { return };
        let Some(seen) = frame.camera.project(point, frame.size()) else { return };
        let beside = frame.camera.point_at(frame.pixel(at) + glam::DVec2::X, seen.depth, frame.size());
        let here = frame.camera.point_at(frame.pixel(at), seen.depth, frame.size());
        let radius = brush.radius / beside.distance(here).max(f64::MIN_POSITIVE);
        let accent = theme::color(self.app.tone.pictures().accent);
        ui.painter_at(frame.rect).circle_stroke(at, radius.min(4000.0) as f32, Stroke::new(1.5, accent));
    }

    /// The point of the active body's skin under the pointer: where it is now, and where it was at rest [m, model frame].
    fn touched(&self, frame: Frame, at: Pos2) -> Option<(DVec3, DVec3)> {
        let (now, rest) = (self.app.published.snapshot.bodies.get(self.app.active)?, self.app.model.bodies.first()?);
        let (skin, still) = (now.surface(), rest.surface());
        let (triangle, point) = self.seen_on(&skin, &now.triangles, frame, at)?;
        let corners = now.triangles.get(triangle)?.map(|k| k as usize);
        let [a, b, c] = corners.map(|k| skin[k]);
        let normal = (b - a).cross(c - a);
        let share = |p: DVec3, q: DVec3| (p - point).cross(q - point).dot(normal) / normal.length_squared();
        let shares = [share(b, c), share(c, a), share(a, b)];
        let rest = corners.iter().zip(shares).map(|(&k, share)| Some(share * *still.get(k)?)).sum::<Option<DVec3>>()?;
        rest.is_finite().then_some((point, rest))
    }

    fn rest_point(&self, frame: Frame, at: Pos2) -> Option<DVec3> {
        self.touched(frame, at).map(|(_, rest)| rest)
    }
}
