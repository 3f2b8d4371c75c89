//! Handles at the middle of what is selected: arrows along the axes, a square to move freely, a ring to turn, a square
//! on it to scale.

use super::allowed::Allowed;
use super::courses::{distance_to, seen_pivot, vertex_at, view_from_model};
use super::handle::Handle;
use super::moving::{Change, Kind};
use super::state::Editing;
use crate::ui::context::Context;
use crate::ui::theme;
use crate::ui::views::{PaneKind, ViewFrame};
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2};
use glam::DMat3;

/// Sizes [points].
const ARROW: f32 = 52.0;
const HEAD: f32 = 9.0;
const MIDDLE: f32 = 6.0;
const RING: f32 = 66.0;
const NEAR: f64 = 6.0;
/// An axis that is seen shorter than this share of its length has no arrow.
const SHORTEST: f32 = 0.25;

/// Where the gizmo stands and where its arrows end; none if nothing is selected or a gesture goes on elsewhere, nor
/// where it is not allowed, but for a gesture of keys.
fn gizmo(editing: &Editing, frame: &ViewFrame, allowed: Allowed, cx: &Context) -> Option<(Pos2, [Option<Pos2>; 3])> {
    if editing.boxed.is_some() || (!allowed.handles && editing.moving.is_none()) {
        return None;
    }
    let pivot = match &editing.moving {
        Some((_, view)) if *view != frame.kind => return None,
        Some((moving, _)) => moving.pivot,
        // A body is drawn into where it lies in its own frame: it is moved where it is seen among others.
        None if cx.selection.is_body() && frame.kind != PaneKind::Result => return None,
        None => cx.pivot()?,
    };
    let is_body = cx.selection.is_body();
    let seen = match (&editing.moving, editing.pending) {
        (Some((moving, _)), pending) if is_body && frame.kind == PaneKind::Result => match pending {
            Some(Change::Move(by)) => moving.pivot + by,
            _ => moving.pivot,
        },
        _ => seen_pivot(frame.kind, cx.pivot().unwrap_or(pivot), cx),
    };
    let middle = frame.screen(seen)?;
    // A length that is about as long as an arrow where the pivot is.
    let reach = f64::from(ARROW) * frame.camera.metres_per_pixel(frame.size().y);
    let axes = if is_body { DMat3::IDENTITY } else { view_from_model(frame.kind, cx) };
    let ends = [0, 1, 2].map(|axis| {
        let along = frame.screen(seen + reach * axes.col(axis))? - middle;
        (along.length() > SHORTEST * ARROW).then(|| middle + along.normalized() * ARROW)
    });
    Some((middle, ends))
}

/// The handle at a point of the window.
pub(super) fn handle_at(
    editing: &Editing,
    frame: &ViewFrame,
    at: Pos2,
    allowed: Allowed,
    cx: &Context,
) -> Option<Handle> {
    if !allowed.handles {
        return None;
    }
    if let Some(vertex) = vertex_at(frame, at, cx) {
        return Some(Handle::Vertex(vertex));
    }
    let (middle, ends) = gizmo(editing, frame, allowed, cx)?;
    if Rect::from_center_size(middle, Vec2::splat(2.0 * MIDDLE + 2.0)).contains(at) {
        return Some(Handle::Middle);
    }
    if Rect::from_center_size(corner(middle), Vec2::splat(2.0 * MIDDLE + 2.0)).contains(at) {
        return Some(Handle::Corner);
    }
    let near = |axis: &usize| ends[*axis].is_some_and(|end| distance_to(at, [middle, end]) <= NEAR);
    if let Some(axis) = (0..3).find(near) {
        return Some(Handle::Axis(axis));
    }
    ((f64::from(at.distance(middle)) - f64::from(RING)).abs() <= NEAR).then_some(Handle::Ring)
}

/// Where the handle that scales lies: on the ring, where no arrow usually is.
fn corner(middle: Pos2) -> Pos2 {
    middle + RING * Vec2::new(0.8, 0.6)
}

/// Paints the gizmo.
pub(super) fn paint_gizmo(editing: &Editing, painter: &Painter, frame: &ViewFrame, allowed: Allowed, cx: &Context) {
    let Some((middle, ends)) = gizmo(editing, frame, allowed, cx) else { return };
    let pictures = cx.tone.pictures();
    let moving = editing.moving.as_ref().map(|(moving, _)| (moving.kind, moving.axis));
    // During a gesture what it goes along stands out; otherwise what would be taken hold of.
    let weight = |handle: Handle| match moving {
        Some((Kind::Move, Some(axis))) if handle == Handle::Axis(axis) => 3.0,
        Some((Kind::Move, None)) if handle == Handle::Middle => 3.0,
        Some((Kind::Turn, _)) if handle == Handle::Ring => 3.0,
        Some((Kind::Scale, _)) if handle == Handle::Corner => 3.0,
        Some(_) => 1.0,
        None if editing.hovered == Some(handle) => 3.0,
        None => 2.0,
    };
    let text = theme::color(pictures.text);
    painter.circle_stroke(middle, RING, Stroke::new(0.6 * weight(Handle::Ring), text.gamma_multiply(0.55)));
    if let Some((Kind::Move | Kind::Turn, Some(axis))) = moving
        && let Some(end) = ends[axis]
    {
        let along = (end - middle).normalized() * 4000.0;
        let colour = theme::color(pictures.axes[axis]).gamma_multiply(0.5);
        painter.line_segment([middle - along, middle + along], Stroke::new(1.0, colour));
    }
    for (axis, end) in ends.into_iter().enumerate() {
        let Some(end) = end else { continue };
        let colour = theme::color(pictures.axes[axis]);
        let along = (end - middle).normalized();
        let neck = end - HEAD * along;
        painter.line_segment([middle + MIDDLE * along, neck], Stroke::new(weight(Handle::Axis(axis)), colour));
        let side = 0.5 * HEAD * along.rot90();
        painter.add(Shape::convex_polygon(vec![end, neck + side, neck - side], colour, Stroke::NONE));
    }
    let scales = Rect::from_center_size(corner(middle), Vec2::splat(1.6 * MIDDLE));
    let is_bright = weight(Handle::Corner) > 2.5;
    let fill = if is_bright { text } else { theme::color(pictures.background_bottom) };
    painter.rect(scales, 1.0, fill, Stroke::new(1.5, text), egui::StrokeKind::Middle);
    let square = Rect::from_center_size(middle, Vec2::splat(2.0 * MIDDLE));
    let fill = if weight(Handle::Middle) > 2.5 { text.gamma_multiply(0.5) } else { Color32::TRANSPARENT };
    painter.rect(square, 1.0, fill, Stroke::new(1.5, text), egui::StrokeKind::Middle);
}
