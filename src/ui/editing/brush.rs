//! Painting with a brush on the result: the volume fraction, or how much follows a motion.

use super::state::{Brush, Editing, Paints};
use crate::draw::Slice;
use crate::edit::Command;
use crate::scene::{AnyBody, Dab, MAX_DABS, add_dab};
use crate::ui::context::{Context, Severity, Step};
use crate::ui::theme;
use crate::ui::views::{PaneKind, ViewFrame, seen_on};
use egui::{Pos2, Response, Stroke, Ui};
use glam::DVec3;

/// Radius of a new brush, as a share of the body's diagonal.
const USUAL_RADIUS: f64 = 0.12;
/// A dab follows the last one after this share of the radius.
const APART: f64 = 0.25;

/// What can be painted of the active body, and what each is called.
pub(super) fn paintable(cx: &Context) -> Vec<(Paints, String)> {
    let Some(body) = cx.scene().any_body(cx.active.index) else { return Vec::new() };
    let fraction = matches!(body, AnyBody::Solid(_)).then(|| (Paints::Fraction, "Volume fraction".to_owned()));
    let follow = |id: &String| (Paints::Follow(id.clone()), format!("What follows \"{id}\""));
    fraction.into_iter().chain(body.follows().iter().map(|of| follow(&of.id))).collect()
}

/// Whether anything can be painted of the active body.
pub(crate) fn can_paint(cx: &Context) -> bool {
    !paintable(cx).is_empty()
}

/// Takes up the brush, or puts it down.
pub(crate) fn toggle_brush(editing: &mut Editing, cx: &Context) {
    let first = paintable(cx).into_iter().next();
    editing.brush = match (editing.brush.take(), first) {
        (None, Some((paints, _))) => Some(Brush {
            paints,
            radius: USUAL_RADIUS * cx.active.diagonal(),
            value: 1.0,
            strength: 1.0,
            last: None,
            gesture: 0,
            waiting: Vec::new(),
        }),
        _ => None,
    };
}

/// The dabs that there are of what is painted; none where the active body has no such thing.
pub(super) fn dabs(paints: &Paints, cx: &Context) -> Option<Vec<Dab>> {
    match paints {
        Paints::Fraction => cx.active_body().map(|body| body.paint.clone()),
        Paints::Follow(id) => {
            let body = cx.scene().any_body(cx.active.index)?;
            body.follows().iter().find(|of| of.id == *id).map(|of| of.paint.clone())
        }
    }
}

/// The change that puts these dabs in the place of those that there are.
pub(super) fn repainted(paints: &Paints, paint: Vec<Dab>, cx: &Context) -> Option<Command> {
    let body = cx.scene().any_body(cx.active.index)?;
    let id = body.id().to_owned();
    match paints {
        Paints::Fraction => Some(Command::SetPaint { body: id, paint }),
        Paints::Follow(of) => {
            let mut follows = body.follows().to_vec();
            follows.iter_mut().find(|one| one.id == *of)?.paint = paint;
            Some(Command::SetFollows { body: id, follows })
        }
    }
}

/// Puts waiting dabs into the document, once the simulation has taken up those before, or `now`.
fn paint_waiting(brush: &mut Brush, now: bool, cx: &mut Context) {
    if !now && !cx.simulation.is_up_to_date() {
        return;
    }
    let waiting = std::mem::take(&mut brush.waiting);
    let Some(mut paint) = dabs(&brush.paints, cx).filter(|_| !waiting.is_empty()) else { return };
    for dab in waiting {
        add_dab(&mut paint, dab);
    }
    if paint.len() > MAX_DABS {
        let said = format!("There is room for {MAX_DABS} dabs; use a larger brush or clear the paint");
        cx.say(Severity::Warning, said);
        return;
    }
    if let Some(command) = repainted(&brush.paints, paint, cx) {
        cx.edit(&command, Step::Of(brush.gesture));
    }
}

/// Paints with the brush; whether it is in use here.
pub(super) fn brush(
    editing: &mut Editing,
    ui: &Ui,
    response: &Response,
    frame: &ViewFrame,
    slice: Option<Slice>,
    cx: &mut Context,
) -> bool {
    let Some(brush) = editing.brush.as_mut().filter(|_| frame.kind == PaneKind::Result) else { return false };
    let primary = egui::PointerButton::Primary;
    let alt = ui.input(|input| input.modifiers.alt);
    let at = ui.input(|input| input.pointer.latest_pos());
    let down = response.is_pointer_button_down_on() && ui.input(|input| input.pointer.primary_down()) && !alt;
    let place = at.filter(|_| down).and_then(|at| touched(frame, at, slice, cx)).map(|(_, rest)| rest);
    if ui.input(|input| input.pointer.primary_pressed()) {
        brush.gesture = cx.begin_gesture();
    }
    if let Some(place) = place
        && brush.last.is_none_or(|last| last.distance(place) > APART * brush.radius)
    {
        brush.last = Some(place);
        let Brush { radius, value, strength, .. } = *brush;
        brush.waiting.push(Dab { strength, ..Dab::new(place, radius, value) });
    }
    let ends = response.drag_stopped_by(primary) || response.clicked_by(primary);
    paint_waiting(brush, ends, cx);
    if !down {
        brush.last = None;
    }
    if down {
        ui.ctx().request_repaint();
    }
    if response.hovered() {
        cx.status.hint = match brush.paints {
            Paints::Fraction => {
                "Drag to paint the volume fraction; Alt + drag turns the view, V or Escape puts the brush down"
            }
            Paints::Follow(_) => {
                "Drag to paint how much follows; Alt + drag turns the view, V or Escape puts the brush down"
            }
        };
    }
    true
}

/// The circle in which the brush acts.
pub(super) fn paint_brush(editing: &Editing, ui: &Ui, frame: &ViewFrame, slice: Option<Slice>, cx: &Context) {
    let Some(brush) = editing.brush.as_ref().filter(|_| frame.kind == PaneKind::Result) else { return };
    let Some(at) = ui.input(|input| input.pointer.latest_pos()).filter(|at| frame.rect.contains(*at)) else {
        return;
    };
    let Some((point, _)) = touched(frame, at, slice, cx) else { return };
    let Some(seen) = frame.camera.project(point, frame.size()) else { return };
    let beside = frame.camera.point_at(frame.pixel(at) + glam::DVec2::X, seen.depth, frame.size());
    let here = frame.camera.point_at(frame.pixel(at), seen.depth, frame.size());
    let radius = brush.radius / beside.distance(here).max(f64::MIN_POSITIVE);
    let accent = theme::color(cx.tone.pictures().accent);
    ui.painter_at(frame.rect).circle_stroke(at, radius.min(4000.0) as f32, Stroke::new(1.5, accent));
}

/// The point of the active body's skin under the pointer: where it is now, and where it was at rest [m, model frame].
fn touched(frame: &ViewFrame, at: Pos2, slice: Option<Slice>, cx: &Context) -> Option<(DVec3, DVec3)> {
    let published = cx.simulation.published();
    let (now, rest) = (published.snapshot.bodies.get(cx.active.index)?, cx.active.model.bodies.first()?);
    let (skin, still) = (now.surface(), rest.surface());
    let (triangle, point) = seen_on(&skin, &now.triangles, slice, frame, at)?;
    let corners = now.triangles.get(triangle)?.map(|k| k as usize);
    let [a, b, c] = corners.map(|k| skin[k]);
    let normal = (b - a).cross(c - a);
    let share = |p: DVec3, q: DVec3| (p - point).cross(q - point).dot(normal) / normal.length_squared();
    let shares = [share(b, c), share(c, a), share(a, b)];
    let rest = corners.iter().zip(shares).map(|(&k, share)| Some(share * *still.get(k)?)).sum::<Option<DVec3>>()?;
    rest.is_finite().then_some((point, rest))
}
