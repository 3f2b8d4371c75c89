//! Strokes and guides over the drawing views.

use super::frame::ViewFrame;
use super::sketch_tool::{Makes, Stage};
use super::sketching::Sketching;
use crate::sketch::{Guides, Stroke as DrawnStroke, View};
use crate::ui::context::Context;
use crate::ui::theme::{self, GUIDE_WIDTH, STROKE_WIDTH};
use egui::{Color32, Painter, Pos2, Rect, Stroke, Ui};
use glam::DVec2;

/// Paints what is drawn, what helps to draw on, and the strokes of the selected fibre.
pub(super) fn paint_strokes(sketching: &Sketching, ui: &Ui, view: View, frame: &ViewFrame, cx: &Context) {
    let tool = &sketching.tool;
    let painter = ui.painter_at(frame.rect);
    let pictures = cx.tone.pictures();
    let ink = theme::color(pictures.stroke);
    let ends = [theme::color(pictures.stroke_start), theme::color(pictures.stroke_end)];
    if let Some(guides) = tool.guides(view, cx.active.diagonal()).filter(|_| sketching.makes == Makes::Fibre) {
        paint_guides(&painter, &guides, view, frame, cx);
    }
    if tool.first().is_none() {
        paint_selected(&painter, view, frame, cx);
    }
    let current = match tool.stage() {
        Stage::Drawing { stroke, .. } => Some(stroke),
        Stage::Refused { second, .. } => Some(second),
        Stage::Empty | Stage::Waiting { .. } => None,
    };
    let strokes = tool.first().into_iter().chain(current);
    for stroke in strokes.filter(|stroke: &&DrawnStroke| stroke.view == view) {
        let points: Vec<Pos2> = stroke.points.iter().filter_map(|&point| frame.shown(view, point)).collect();
        if let (Some(&first), Some(&last)) = (points.first(), points.last()) {
            painter.add(egui::Shape::line(points, Stroke::new(STROKE_WIDTH, ink)));
            painter.circle_filled(first, 1.5 * STROKE_WIDTH, ends[0]);
            painter.circle_filled(last, 1.5 * STROKE_WIDTH, ends[1]);
        }
    }
    if let Some(first) = tool.first().filter(|first| first.view == view)
        && sketching.makes == Makes::Fibre
        && let Some(follow) = tool.preview(cx.active.diagonal())
        && let Some(at) = frame.shown(first.view, follow.tick)
    {
        let accent = Stroke::new(2.0, theme::color(pictures.accent));
        painter.circle(at, 2.5 * STROKE_WIDTH, Color32::TRANSPARENT, accent);
    }
}

/// Where the second stroke has to run.
fn paint_guides(painter: &Painter, guides: &Guides, view: View, frame: &ViewFrame, cx: &Context) {
    let pictures = cx.tone.pictures();
    let horizontal = view.axes()[1] == guides.axis;
    let place = |shared: f64| {
        let point = if horizontal { DVec2::new(0.0, shared) } else { DVec2::new(shared, 0.0) };
        frame.shown(view, point)
    };
    let line = |shared: f64, colour: Color32| {
        let stroke = Stroke::new(GUIDE_WIDTH, colour);
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
        line(*turn, theme::color(pictures.stroke).gamma_multiply(0.35));
    }
    line(guides.start, theme::color(pictures.stroke_start));
    line(guides.end, theme::color(pictures.stroke_end));
}

/// The strokes of the selected fibre, what was clipped of them dashed.
fn paint_selected(painter: &Painter, view: View, frame: &ViewFrame, cx: &Context) {
    let Some(which) = cx.selected_views().iter().position(|drawn| *drawn == view) else { return };
    let Some(lift) = cx.selected_lift() else { return };
    let Some(lifted) = &lift.lifted else { return };
    let pictures = cx.tone.pictures();
    let ink = theme::color(pictures.stroke).gamma_multiply(0.7);
    let shown =
        |points: &[DVec2]| -> Vec<Pos2> { points.iter().filter_map(|&point| frame.shown(view, point)).collect() };
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
