//! Where a pattern goes: a box dragged in a drawing view, and the fibres shown before they are there.

use super::affine::Affine;
use super::frame::ViewFrame;
use super::kind::PaneKind;
use crate::sketch::View;
use crate::ui::context::{Context, Request, Severity};
use crate::ui::theme;
use egui::{CursorIcon, PointerButton, Pos2, Rect, Response, Shape, Stroke, StrokeKind, Ui};
use glam::{DVec2, DVec3};

/// Fibres and the region as they are shown before they are there [points].
const PREVIEW_WIDTH: f32 = 2.0;
const REGION_WIDTH: f32 = 1.0;
/// A region has at least this share of the body's extent along each axis.
const LEAST_SHARE: f64 = 0.02;

/// Drags a box around the part of the body that a pattern fills.
#[derive(Debug, Default)]
pub(super) struct RegionTool {
    /// Where the box begins, and in which view.
    begun: Option<(View, DVec2)>,
}

impl RegionTool {
    /// Follows a box around the region that a pattern fills; whether the pointer is for that here.
    pub(super) fn follow(&mut self, ui: &Ui, response: &Response, frame: &ViewFrame, cx: &mut Context) -> bool {
        let PaneKind::Drawing(view) = frame.kind else { return false };
        if !cx.pattern.takes_region {
            self.begun = None;
            return false;
        }
        let (at, origin, alt) =
            ui.input(|input| (input.pointer.latest_pos(), input.pointer.press_origin(), input.modifiers.alt));
        if response.hovered() {
            ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
            cx.status.hint =
                "Drag a box around the part of the body that the pattern is to fill; Escape fills all of it";
        }
        if response.drag_started_by(PointerButton::Primary) && !alt {
            self.begun = origin.map(|origin| (view, frame.drawn(view, origin)));
        }
        let Some((_, from)) = self.begun.filter(|(begun, _)| *begun == view) else { return true };
        let (Some([low, high]), Some([mut min, mut max])) = (cx.active.corners(), cx.pattern.bounds) else {
            return true;
        };
        if let Some(to) = at.map(|at| frame.drawn(view, at)) {
            let (from, to) = (from.min(to), from.max(to));
            for (axis, [from, to]) in view.axes().into_iter().zip([[from.x, to.x], [from.y, to.y]]) {
                min[axis] = from.clamp(low[axis], high[axis]);
                max[axis] = to.clamp(low[axis], high[axis]);
            }
            let flat = (max - min).cmplt(LEAST_SHARE * (high - low)).any();
            if !flat {
                cx.request(Request::FillRegion([min, max]));
            } else if response.drag_stopped_by(PointerButton::Primary) {
                cx.say(Severity::Warning, "That box has hardly anything of the body in it: drag it over the body");
            }
        }
        if response.drag_stopped_by(PointerButton::Primary) {
            self.begun = None;
        }
        true
    }
}

/// The chosen pattern's fibres where they would be, and the region that they fill.
pub(super) fn paint_pattern(ui: &Ui, frame: &ViewFrame, cx: &Context) {
    if cx.pattern.lines.is_empty() {
        return;
    }
    let painter = ui.painter_at(frame.rect);
    let accent = theme::color(cx.tone.pictures().accent);
    let seen = seen_from_rest(frame.kind, cx);
    let shown =
        |points: &[DVec3]| -> Vec<Pos2> { points.iter().filter_map(|&point| frame.screen(seen.at(point))).collect() };
    for line in &cx.pattern.lines {
        painter.add(Shape::line(shown(line), Stroke::new(PREVIEW_WIDTH, accent)));
    }
    let Some([min, max]) = cx.pattern.bounds.filter(|_| cx.pattern.takes_region) else { return };
    let corner = |k: usize| DVec3::new([min, max][k & 1].x, [min, max][k >> 1 & 1].y, [min, max][k >> 2].z);
    let corners: Vec<DVec3> = (0..8).map(corner).collect();
    if let PaneKind::Drawing(_) = frame.kind {
        let rect = Rect::from_points(&shown(&corners));
        painter.rect(rect, 0.0, accent.gamma_multiply(0.08), Stroke::new(REGION_WIDTH, accent), StrokeKind::Middle);
        return;
    }
    for k in 0..8_usize {
        for axis in [1, 2, 4].into_iter().filter(|axis| k & axis == 0) {
            let ends = shown(&[corners[k], corners[k | axis]]);
            painter.add(Shape::line(ends, Stroke::new(REGION_WIDTH, accent.gamma_multiply(0.7))));
        }
    }
}

/// From the model frame to where a view shows the body now: as it lies there at rest, or turned and stretched with it.
fn seen_from_rest(kind: PaneKind, cx: &Context) -> Affine {
    let rest = cx.active.model.bodies.first();
    let now = cx.simulation.published().snapshot.bodies.get(cx.active.index);
    match (kind, rest, now) {
        (PaneKind::Result, Some(rest), Some(now)) => Affine::between(&rest.particles, &now.particles),
        _ => Affine::default(),
    }
}
