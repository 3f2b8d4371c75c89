//! Where a pattern goes: a box dragged in a drawing view, and the fibres shown before they are there.

use super::Fit;
use crate::ui::app::{App, Gravity};
use crate::ui::pane::{Frame, PaneKind, View3d};
use crate::ui::theme;
use egui::{CursorIcon, PointerButton, Pos2, Rect, Response, Shape, Stroke, StrokeKind, Ui};
use glam::{DMat3, DVec3};

/// Fibres and the region as they are shown before they are there [points].
const PREVIEW_WIDTH: f32 = 2.0;
const REGION_WIDTH: f32 = 1.0;
/// A region has at least this share of the body's extent along each axis.
const LEAST_SHARE: f64 = 0.02;

impl App {
    /// Whether boxes are dragged around a region rather than strokes drawn.
    pub(in crate::ui) fn takes_region(&self) -> bool {
        self.lays_pattern() && self.patterns.fit == Fit::Region
    }
}

impl View3d<'_> {
    /// Follows a box around the region that a pattern fills; whether the pointer is for that here.
    pub(in crate::ui) fn region(&mut self, ui: &Ui, response: &Response, frame: Frame) -> bool {
        let PaneKind::Drawing(view) = self.pane.kind else { return false };
        if !self.app.takes_region() {
            return false;
        }
        let (at, origin, alt) =
            ui.input(|input| (input.pointer.latest_pos(), input.pointer.press_origin(), input.modifiers.alt));
        if response.hovered() {
            ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
            self.app.hint =
                "Drag a box around the part of the body that the pattern is to fill; Escape fills all of it";
        }
        if response.drag_started_by(PointerButton::Primary) && !alt {
            self.app.patterns.drag = origin.map(|origin| (view, frame.drawn(view, origin)));
        }
        let Some((_, from)) = self.app.patterns.drag.filter(|(begun, _)| *begun == view) else { return true };
        let Some([low, high]) = self.app.body_box() else { return true };
        if let Some(to) = at.map(|at| frame.drawn(view, at)) {
            let (from, to) = (from.min(to), from.max(to));
            let [mut min, mut max] = self.app.patterns.region.unwrap_or([low, high]);
            for (axis, [from, to]) in view.axes().into_iter().zip([[from.x, to.x], [from.y, to.y]]) {
                min[axis] = from.clamp(low[axis], high[axis]);
                max[axis] = to.clamp(low[axis], high[axis]);
            }
            let flat = (max - min).cmplt(LEAST_SHARE * (high - low)).any();
            if !flat {
                self.app.patterns.region = Some([min, max]);
            } else if response.drag_stopped_by(PointerButton::Primary) {
                self.app.say(Gravity::Warning, "That box has hardly anything of the body in it: drag it over the body");
            }
        }
        if response.drag_stopped_by(PointerButton::Primary) {
            self.app.patterns.drag = None;
        }
        true
    }

    /// The chosen pattern's fibres where they would be, and the region that they fill.
    pub(in crate::ui) fn paint_pattern(&self, ui: &Ui, frame: Frame) {
        let lines = self.app.pattern_preview();
        if lines.is_empty() {
            return;
        }
        let painter = ui.painter_at(frame.rect);
        let accent = theme::color(self.app.tone.pictures().accent);
        let seen = self.seen_from_rest();
        let shown = |points: &[DVec3]| -> Vec<Pos2> {
            points.iter().filter_map(|&point| frame.screen(seen.at(point))).collect()
        };
        for line in &lines {
            painter.add(Shape::line(shown(line), Stroke::new(PREVIEW_WIDTH, accent)));
        }
        let Some([min, max]) = self.app.pattern_box().filter(|_| self.app.takes_region()) else { return };
        let corner = |k: usize| DVec3::new([min, max][k & 1].x, [min, max][k >> 1 & 1].y, [min, max][k >> 2].z);
        let corners: Vec<DVec3> = (0..8).map(corner).collect();
        if let PaneKind::Drawing(_) = self.pane.kind {
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

    /// From the model frame to where this view shows the body now: as it lies there at rest, or turned and stretched with
    /// it.
    fn seen_from_rest(&self) -> Affine {
        let rest = self.app.model.bodies.first();
        let now = self.app.published.snapshot.bodies.get(self.app.active);
        match (self.pane.kind, rest, now) {
            (PaneKind::Result, Some(rest), Some(now)) => Affine::between(&rest.particles, &now.particles),
            _ => Affine::default(),
        }
    }
}

/// A move, turn and stretch of space.
struct Affine {
    matrix: DMat3,
    offset: DVec3,
}

impl Default for Affine {
    fn default() -> Self {
        Self { matrix: DMat3::IDENTITY, offset: DVec3::ZERO }
    }
}

impl Affine {
    fn at(&self, point: DVec3) -> DVec3 {
        self.matrix * point + self.offset
    }

    /// The one that comes nearest to taking `rest` to `now` in the mean of squares; a move alone where these are not
    /// the same points or lie in a plane.
    fn between(rest: &[DVec3], now: &[DVec3]) -> Self {
        let mean = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len().max(1) as f64;
        let (from, to) = (mean(rest), mean(now));
        let outer = |a: DVec3, b: DVec3| DMat3::from_cols(a * b.x, a * b.y, a * b.z);
        let (mut moved, mut spread) = (DMat3::ZERO, DMat3::ZERO);
        for (&rest, &now) in rest.iter().zip(now) {
            moved += outer(now - to, rest - from);
            spread += outer(rest - from, rest - from);
        }
        let size = (spread.x_axis.x + spread.y_axis.y + spread.z_axis.z) / 3.0;
        let solid = rest.len() == now.len() && spread.determinant() > 1e-9 * size.powi(3) && moved.is_finite();
        let matrix = if solid { moved * spread.inverse() } else { DMat3::IDENTITY };
        Self { matrix, offset: to - matrix * from }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_preview_goes_with_a_body_that_turned_and_stretched() {
        let rest: Vec<DVec3> =
            (0..27).map(|k| DVec3::new(f64::from(k % 3), f64::from(k / 3 % 3), f64::from(k / 9))).collect();
        let (matrix, offset) =
            (DMat3::from_rotation_y(0.7) * DMat3::from_diagonal(DVec3::new(1.0, 0.8, 1.1)), DVec3::Y);
        let now: Vec<DVec3> = rest.iter().map(|&point| matrix * point + offset).collect();
        let map = Affine::between(&rest, &now);
        let point = DVec3::new(0.3, 1.7, 0.9);
        assert!(map.at(point).distance(matrix * point + offset) < 1e-12);
        // Points in a plane say nothing of what leaves it.
        let flat: Vec<DVec3> = rest.iter().map(|point| point.with_z(0.0)).collect();
        assert!(Affine::between(&flat, &flat).at(point).distance(point) < 1e-12);
        assert!(Affine::between(&[], &[]).at(point).is_finite());
    }
}
