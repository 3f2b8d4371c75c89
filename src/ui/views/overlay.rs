//! What is painted over the pictures: the preview of a fibre or a sheet, the grab, titles and the coach's words.

use super::frame::ViewFrame;
use super::grab::grabbed_point;
use super::kind::PaneKind;
use super::outline::paint_outline;
use super::sketch_tool::Makes;
use super::sketching::Sketching;
use crate::geometry::surface_grid::grid_triangles;
use crate::scene::AnyBody;
use crate::sketch::{Sweep, View};
use crate::solver::snapshot::BodySnapshot;
use crate::ui::context::Context;
use crate::ui::theme::{self, GRID, STROKE_WIDTH};
use egui::{Align2, Color32, FontId, Mesh, Painter, Pos2, Rect, Stroke, Ui};
use glam::DVec3;

/// Opacity of the surface of a sheet that is being drawn.
const FILM: f32 = 0.18;

/// Paints what is too thin, the curve that the strokes make so far, and the grab, into the result.
pub(super) fn paint_result(sketching: &Sketching, ui: &Ui, frame: &ViewFrame, cx: &Context) {
    let painter = ui.painter_at(frame.rect);
    let accent = theme::color(cx.tone.pictures().accent);
    let bodies = &cx.simulation.published().snapshot.bodies;
    paint_thin(&painter, frame, cx);
    paint_outline(&painter, frame, cx);
    if let Some(caption) = cx.caption {
        paint_words(&painter, frame.rect, caption, cx);
    }
    if let Some(effect) = &cx.effect
        && let Some(at) = frame.screen(effect.at)
    {
        paint_effect(&painter, at, &effect.text, cx);
    }
    // The preview goes with the body, which may have moved from where it is drawn into.
    let middle = |bodies: &[BodySnapshot], index: usize| {
        let points = &bodies.get(index)?.particles;
        Some(points.iter().sum::<DVec3>() / points.len() as f64)
    };
    if let Makes::Sheet = sketching.makes
        && let Some(swept) = sketching.tool.swept_preview(cx.sampling())
        && let Some(now) = middle(bodies, cx.active.index)
        && let Some(rest) = middle(&cx.active.model.bodies, 0)
    {
        paint_swept(&painter, &swept, now - rest, frame, accent);
    }
    if let Makes::Fibre = sketching.makes
        && let Some(follow) = sketching.tool.preview(cx.active.diagonal())
        && let Some(now) = middle(bodies, cx.active.index)
        && let Some(rest) = middle(&cx.active.model.bodies, 0)
    {
        let offset = now - rest;
        let points = follow.curve.iter().filter_map(|&point| frame.screen(point + offset)).collect();
        painter.add(egui::Shape::line(points, Stroke::new(STROKE_WIDTH, accent)));
    }
    if let Some(grabbed) = cx.simulation.grabbed()
        && let Some(held) = bodies.get(grabbed.body).and_then(|body| grabbed_point(body, grabbed.vertex))
        && let (Some(from), Some(to)) = (frame.screen(held), frame.screen(grabbed.target))
    {
        painter.line_segment([from, to], Stroke::new(2.0, accent));
        painter.circle_filled(from, 4.0, accent);
        painter.circle_stroke(to, 5.0, Stroke::new(2.0, accent));
    }
}

/// A surface as its rows and columns, and faintly what lies between them.
fn paint_swept(painter: &Painter, swept: &Sweep, offset: DVec3, frame: &ViewFrame, accent: Color32) {
    let seen: Option<Vec<Pos2>> = swept.vertices.iter().map(|&at| frame.screen(at + offset)).collect();
    let Some(seen) = seen else { return };
    let mut film = Mesh::default();
    let fill = accent.gamma_multiply(FILM);
    for &at in &seen {
        film.colored_vertex(at, fill);
    }
    for [a, b, c] in grid_triangles(swept.to_a_row, swept.rows()) {
        film.add_triangle(a, b, c);
    }
    painter.add(film);
    let line = |points: Vec<Pos2>, width: f32| painter.add(egui::Shape::line(points, Stroke::new(width, accent)));
    let (columns, rows) = (swept.to_a_row, swept.rows());
    for (row, points) in seen.chunks(columns).enumerate() {
        line(points.to_vec(), if row == 0 || row + 1 == rows { STROKE_WIDTH } else { 0.5 });
    }
    for column in 0..columns {
        let points = seen.iter().skip(column).step_by(columns).copied().collect();
        line(points, if column == 0 || column + 1 == columns { STROKE_WIDTH } else { 0.5 });
    }
}

/// Words on a ground of their own above a place.
fn paint_effect(painter: &Painter, at: Pos2, words: &str, cx: &Context) {
    let pictures = cx.tone.pictures();
    let font = FontId::proportional(15.0);
    let galley = painter.layout_no_wrap(words.to_owned(), font, theme::color(pictures.text));
    let ground = Align2::CENTER_BOTTOM.anchor_size(at - egui::vec2(0.0, 4.0 * GRID), galley.size());
    let fill = theme::color(pictures.background_bottom).gamma_multiply(0.85);
    painter.rect_filled(ground.expand(1.5 * GRID), GRID, fill);
    painter.galley(ground.min, galley, theme::color(pictures.text));
}

/// Marks on the parts of bodies that are thinner than their particles resolve, at most for each, and their radius
/// [points].
const MARKS: usize = 300;
const MARK: f32 = 3.0;

/// Marks what the notes call too thin, as long as they do.
fn paint_thin(painter: &Painter, frame: &ViewFrame, cx: &Context) {
    let published = cx.simulation.published();
    if !published.compared.is_empty() {
        return;
    }
    let edge = Stroke::new(1.0, cx.tone.warning());
    for (index, (body, thin)) in published.snapshot.bodies.iter().zip(published.thin.iter()).enumerate() {
        if cx.scene().any_body(index).is_some_and(AnyBody::hidden) {
            continue;
        }
        for at in thin.places(&body.particles, MARKS).into_iter().filter_map(|at| frame.screen(at)) {
            painter.circle_stroke(at, MARK, edge);
        }
    }
}

/// Names the axes of a drawing view and what it shows, and says what the first fibre takes.
pub(super) fn paint_title(sketching: &Sketching, ui: &Ui, frame: &ViewFrame, cx: &Context) {
    let rect = frame.rect;
    let painter = ui.painter_at(rect);
    let pictures = cx.tone.pictures();
    let text = theme::color(pictures.text);
    let at = rect.min + egui::vec2(3.0 * GRID, 2.5 * GRID);
    let axes = match frame.kind {
        PaneKind::Drawing(View::Front) => "Rest shape, X right, Y up",
        PaneKind::Drawing(View::Side) => "Rest shape, Z right, Y up",
        PaneKind::Drawing(View::Top) => "Rest shape, X right, Z down",
        PaneKind::Result => return,
    };
    let below = at + egui::vec2(GRID, 6.0 * GRID);
    painter.text(below, Align2::LEFT_TOP, axes, FontId::proportional(11.0), text.gamma_multiply(0.7));
    if let Some(coach) = coach(sketching, frame.kind, cx) {
        paint_words(&painter, rect, coach, cx);
    }
}

/// Words on a ground of their own, at the foot of a view.
fn paint_words(painter: &Painter, rect: Rect, words: &str, cx: &Context) {
    let pictures = cx.tone.pictures();
    let text = theme::color(pictures.text);
    let room = rect.width() - 12.0 * GRID;
    let words = painter.layout(words.to_owned(), FontId::proportional(13.0), text, room);
    let size = words.size() + egui::vec2(4.0 * GRID, 2.0 * GRID);
    let at = rect.center_bottom() - egui::vec2(0.5 * size.x, size.y + 10.0 * GRID);
    let accent = theme::color(pictures.accent);
    let paper = theme::color(pictures.background_top).gamma_multiply(0.9);
    let edge = Stroke::new(1.0, accent);
    painter.rect(Rect::from_min_size(at, size), GRID, paper, edge, egui::StrokeKind::Inside);
    painter.galley(at + egui::vec2(2.0 * GRID, GRID), words, text);
}

/// What the first fibre takes, step by step, in the view where the next step is.
fn coach(sketching: &Sketching, kind: PaneKind, cx: &Context) -> Option<&'static str> {
    let PaneKind::Drawing(view) = kind else { return None };
    let elsewhere = cx.has_dialog || cx.pattern.is_shown;
    if !sketching.coach || elsewhere || cx.active_body().is_none() {
        return None;
    }
    match sketching.tool.first() {
        _ if sketching.makes == Makes::Sheet => None,
        None if view == View::Front => Some("1  Drag a stroke here, the fibre as seen from this side"),
        Some(first) if first.view != view => Some("2  Draw the same fibre as seen from here, between the guides"),
        _ => None,
    }
}
