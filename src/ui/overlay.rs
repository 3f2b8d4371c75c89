//! What is painted over the pictures: strokes and guides, the preview, the pull, titles.

use super::pane::{Frame, PaneKind, View3d};
use super::theme::{self, GRID, GUIDE_WIDTH, STROKE_WIDTH};
use crate::sketch::{Stroke as DrawnStroke, View};
use crate::solver::snapshot::BodySnapshot;
use egui::{Align2, Color32, FontId, Pos2, Rect, Stroke, Ui};
use glam::{DVec2, DVec3};

impl View3d<'_> {
    pub(super) fn paint_strokes(&self, ui: &Ui, view: View, frame: Frame) {
        let painter = ui.painter_at(frame.rect);
        let pictures = self.app.tone.pictures();
        let ink = theme::color(pictures.stroke);
        let ends = [theme::color(pictures.stroke_start), theme::color(pictures.stroke_end)];
        let diagonal = self.app.model_diagonal();
        if let Some(guides) =
            self.app.tool.first().filter(|first| first.view != view).and_then(|_| self.app.tool.guides(view, diagonal))
        {
            let horizontal = view.axes()[1] == guides.axis;
            let place = |shared: f64| {
                let point = if horizontal { DVec2::new(0.0, shared) } else { DVec2::new(shared, 0.0) };
                frame.shown(view, point)
            };
            let line = |shared: f64, stroke: Stroke| {
                if let Some(at) = place(shared) {
                    if horizontal {
                        painter.hline(frame.rect.x_range(), at.y, stroke);
                    } else {
                        painter.vline(at.x, frame.rect.y_range(), stroke);
                    }
                }
            };
            if let [Some(a), Some(b)] = guides.band.map(place) {
                let band = if horizontal {
                    Rect::from_x_y_ranges(frame.rect.x_range(), a.y.min(b.y)..=a.y.max(b.y))
                } else {
                    Rect::from_x_y_ranges(a.x.min(b.x)..=a.x.max(b.x), frame.rect.y_range())
                };
                painter.rect_filled(band, 0.0, theme::color(pictures.accent).gamma_multiply(0.10));
            }
            for turn in &guides.turns {
                line(*turn, Stroke::new(GUIDE_WIDTH, ink.gamma_multiply(0.35)));
            }
            line(guides.start, Stroke::new(GUIDE_WIDTH, ends[0]));
            line(guides.end, Stroke::new(GUIDE_WIDTH, ends[1]));
        }
        self.paint_selected(&painter, view, frame);
        let strokes: Vec<DrawnStroke> = {
            use super::sketch_tool::Stage;
            let current = match self.app.tool.stage() {
                Stage::Drawing { stroke, .. } => Some(stroke.clone()),
                Stage::Refused { second, .. } => Some(second.clone()),
                _ => None,
            };
            self.app.tool.first().cloned().into_iter().chain(current).collect()
        };
        for stroke in strokes.iter().filter(|stroke| stroke.view == view) {
            let points: Vec<Pos2> = stroke.points.iter().filter_map(|&point| frame.shown(view, point)).collect();
            if let (Some(&first), Some(&last)) = (points.first(), points.last()) {
                painter.add(egui::Shape::line(points, Stroke::new(STROKE_WIDTH, ink)));
                painter.circle_filled(first, 1.5 * STROKE_WIDTH, ends[0]);
                painter.circle_filled(last, 1.5 * STROKE_WIDTH, ends[1]);
            }
        }
        if let Some(follow) = self.app.tool.preview(diagonal)
            && let Some(first) = self.app.tool.first().filter(|first| first.view == view)
            && let Some(at) = frame.shown(first.view, follow.tick)
        {
            painter.circle(
                at,
                2.5 * STROKE_WIDTH,
                Color32::TRANSPARENT,
                Stroke::new(2.0, theme::color(pictures.accent)),
            );
        }
    }

    pub(super) fn paint_result(&self, ui: &Ui, frame: Frame) {
        let painter = ui.painter_at(frame.rect);
        let pictures = self.app.tone.pictures();
        let accent = theme::color(pictures.accent);
        // The preview goes with the body, which may have moved from where it is drawn into.
        let middle = |bodies: &[BodySnapshot], index: usize| {
            let points = &bodies.get(index)?.particles;
            Some(points.iter().sum::<DVec3>() / points.len() as f64)
        };
        if let Some(follow) = self.app.tool.preview(self.app.model_diagonal())
            && let Some(now) = middle(&self.app.published.snapshot.bodies, self.app.active)
            && let Some(rest) = middle(&self.app.model.bodies, 0)
        {
            let offset = now - rest;
            let points = follow.curve.iter().filter_map(|&point| frame.screen(point + offset)).collect();
            painter.add(egui::Shape::line(points, Stroke::new(STROKE_WIDTH, accent)));
        }
        if let Some(pull) = self.app.pull
            && let Some(held) =
                self.app.published.snapshot.bodies.get(pull.body).and_then(|body| handle(body, pull.vertex))
            && let (Some(from), Some(to)) = (frame.screen(held), frame.screen(pull.target))
        {
            painter.line_segment([from, to], Stroke::new(2.0, accent));
            painter.circle_filled(from, 4.0, accent);
            painter.circle_stroke(to, 5.0, Stroke::new(2.0, accent));
        }
    }

    pub(super) fn paint_title(&self, ui: &Ui, rect: Rect) {
        let painter = ui.painter_at(rect);
        let text = theme::color(self.app.tone.pictures().text);
        let at = rect.min + egui::vec2(3.0 * GRID, 2.5 * GRID);
        let axes = match self.pane.kind {
            PaneKind::Drawing(View::Front) => "X right, Y up",
            PaneKind::Drawing(View::Side) => "Z right, Y up",
            PaneKind::Drawing(View::Top) => "X right, Z down",
            PaneKind::Result => return,
        };
        let below = at + egui::vec2(GRID, 6.0 * GRID);
        painter.text(below, Align2::LEFT_TOP, axes, FontId::proportional(11.0), text.gamma_multiply(0.7));
        if let Some(coach) = self.coach() {
            let room = rect.width() - 12.0 * GRID;
            let words = painter.layout(coach.to_owned(), FontId::proportional(13.0), text, room);
            let size = words.size() + egui::vec2(4.0 * GRID, 2.0 * GRID);
            let at = rect.center_bottom() - egui::vec2(0.5 * size.x, size.y + 10.0 * GRID);
            let accent = theme::color(self.app.tone.pictures().accent);
            let paper = theme::color(self.app.tone.pictures().background_top).gamma_multiply(0.9);
            painter.rect(
                Rect::from_min_size(at, size),
                GRID,
                paper,
                Stroke::new(1.0, accent),
                egui::StrokeKind::Inside,
            );
            painter.galley(at + egui::vec2(2.0 * GRID, GRID), words, text);
        }
    }

    /// What the first fibre takes, step by step, in the view where the next step is.
    fn coach(&self) -> Option<&'static str> {
        let PaneKind::Drawing(view) = self.pane.kind else { return None };
        let elsewhere = self.app.dialog.is_some() || self.app.lays_pattern();
        if !self.app.coach || elsewhere || self.app.active_body().is_none() {
            return None;
        }
        match self.app.tool.first() {
            None if view == View::Front => Some("1  Drag a stroke here, the fibre as seen from this side"),
            Some(first) if first.view != view => Some("2  Draw the same fibre as seen from here, between the guides"),
            _ => None,
        }
    }

    /// The strokes of the selected fibre, what was clipped of them dashed.
    fn paint_selected(&self, painter: &egui::Painter, view: View, frame: Frame) {
        let Some((_, lifted)) = self.app.selected_lift().filter(|_| self.app.tool.first().is_none()) else { return };
        let pictures = self.app.tone.pictures();
        let ink = theme::color(pictures.stroke).gamma_multiply(0.7);
        let shown =
            |points: &[DVec2]| -> Vec<Pos2> { points.iter().filter_map(|&point| frame.shown(view, point)).collect() };
        let Some(which) = self.app.selected_views().iter().position(|drawn| *drawn == view) else { return };
        let points = shown(&lifted.strokes[which]);
        if let (Some(&first), Some(&last)) = (points.first(), points.last()) {
            painter.add(egui::Shape::line(points, Stroke::new(1.5, ink)));
            painter.circle_filled(first, 3.5, theme::color(pictures.stroke_start));
            painter.circle_filled(last, 3.5, theme::color(pictures.stroke_end));
        }
        for part in &lifted.clipped[which] {
            painter.extend(egui::Shape::dashed_line(&shown(part), Stroke::new(1.5, ink), 5.0, 4.0));
        }
    }
}

/// Where a body is held by a vertex of its skin, or by a particle where it has none.
pub(super) fn handle(body: &BodySnapshot, vertex: usize) -> Option<DVec3> {
    let surface = body.surface();
    if surface.is_empty() { body.particles.get(vertex).copied() } else { surface.get(vertex).copied() }
}
