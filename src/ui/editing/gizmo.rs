//! Handles at the middle of what is selected: arrows along the axes, a square to move freely, a ring to turn.

use super::moving::Kind;
use super::picking::distance_to;
use crate::ui::pane::{Frame, View3d};
use crate::ui::theme;
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2};

/// A place to take hold of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Handle {
    /// Moves along an axis.
    Axis(usize),
    /// Moves in the plane of the view.
    Middle,
    /// Turns about the line of sight.
    Ring,
    /// A vertex that is edited.
    Vertex(usize),
}

/// Sizes [points].
const ARROW: f32 = 52.0;
const HEAD: f32 = 9.0;
const MIDDLE: f32 = 6.0;
const RING: f32 = 66.0;
const NEAR: f64 = 6.0;
/// An axis that is seen shorter than this share of its length has no arrow.
const SHORTEST: f32 = 0.25;

impl View3d<'_> {
    /// Where the gizmo stands and where its arrows end; none if nothing is selected or a gesture goes on.
    fn handles(&self, frame: Frame) -> Option<(Pos2, [Option<Pos2>; 3])> {
        if self.app.editing.boxed.is_some() || self.app.tool.first().is_some() {
            return None;
        }
        let pivot = match &self.app.editing.moving {
            Some((_, view)) if *view != self.pane.kind => return None,
            Some((moving, _)) => moving.pivot,
            None => self.app.pivot()?,
        };
        let seen = self.seen(self.app.pivot().unwrap_or(pivot));
        let middle = frame.screen(seen)?;
        // A length that is about as long as an arrow where the pivot is.
        let reach = f64::from(ARROW) * frame.camera.metres_per_pixel(frame.size().y);
        let axes = self.to_view();
        let ends = [0, 1, 2].map(|axis| {
            let along = frame.screen(seen + reach * axes.col(axis))? - middle;
            (along.length() > SHORTEST * ARROW).then(|| middle + along.normalized() * ARROW)
        });
        Some((middle, ends))
    }

    /// The handle at a point of the window.
    pub(super) fn handle_at(&self, frame: Frame, at: Pos2) -> Option<Handle> {
        if let Some(vertex) = self.vertex_at(frame, at) {
            return Some(Handle::Vertex(vertex));
        }
        let (middle, ends) = self.handles(frame)?;
        if Rect::from_center_size(middle, Vec2::splat(2.0 * MIDDLE + 2.0)).contains(at) {
            return Some(Handle::Middle);
        }
        let near = |axis: &usize| ends[*axis].is_some_and(|end| distance_to(at, [middle, end]) <= NEAR);
        if let Some(axis) = (0..3).find(near) {
            return Some(Handle::Axis(axis));
        }
        ((f64::from(at.distance(middle)) - f64::from(RING)).abs() <= NEAR).then_some(Handle::Ring)
    }

    pub(super) fn paint_gizmo(&self, painter: &Painter, frame: Frame) {
        let Some((middle, ends)) = self.handles(frame) else { return };
        let pictures = self.app.tone.pictures();
        let editing = &self.app.editing;
        let moving = editing.moving.as_ref().map(|(moving, _)| (moving.kind, moving.axis));
        // During a gesture what it goes along stands out; otherwise what would be taken hold of.
        let weight = |handle: Handle| match moving {
            Some((Kind::Move, Some(axis))) if handle == Handle::Axis(axis) => 3.0,
            Some((Kind::Move, None)) if handle == Handle::Middle => 3.0,
            Some((Kind::Turn, _)) if handle == Handle::Ring => 3.0,
            Some(_) => 1.0,
            None if editing.hovered == Some(handle) => 3.0,
            None => 2.0,
        };
        let text = theme::color(pictures.text);
        painter.circle_stroke(middle, RING, Stroke::new(0.6 * weight(Handle::Ring), text.gamma_multiply(0.55)));
        if let Some((_, Some(axis))) = moving
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
        let square = Rect::from_center_size(middle, Vec2::splat(2.0 * MIDDLE));
        let fill = if weight(Handle::Middle) > 2.5 { text.gamma_multiply(0.5) } else { Color32::TRANSPARENT };
        painter.rect(square, 1.0, fill, Stroke::new(1.5, text), egui::StrokeKind::Middle);
    }
}
