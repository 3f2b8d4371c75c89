//! Where fibres, their vertices and sheets are seen in a view, and which of them lies under the pointer.

use crate::draw::Bounds;
use crate::scene::Body;
use crate::ui::context::Context;
use crate::ui::views::{DisplayedState, PaneKind, ViewFrame};
use egui::Pos2;
use glam::{DMat3, DVec3};

/// How near a click must come to a fibre [points].
const NEAR_FIBRE: f64 = 9.0;
/// And to a vertex.
const NEAR_VERTEX: f64 = 10.0;

/// Fibres as a view shows them, with their identifiers; hidden ones are not.
pub(super) fn courses(kind: PaneKind, cx: &Context) -> Vec<(String, Vec<DVec3>)> {
    let shown = DisplayedState::of(kind, cx);
    let hidden: Vec<&str> = cx
        .active_body()
        .into_iter()
        .flat_map(|body: &Body| body.fibres.iter().filter(|fibre| fibre.hidden).map(|fibre| fibre.id.as_str()))
        .collect();
    let fibres = shown.bodies.get(shown.active(cx)).into_iter().flat_map(|body| body.fibres.iter());
    fibres
        .filter(|fibre| !hidden.contains(&fibre.id.as_str()))
        .map(|fibre| (fibre.id.clone(), fibre.vertices.clone()))
        .collect()
}

/// The fibre under the pointer.
pub(super) fn fibre_at(frame: &ViewFrame, at: Pos2, cx: &Context) -> Option<String> {
    let near = courses(frame.kind, cx).into_iter().filter_map(|(id, vertices)| {
        let seen: Vec<Pos2> = vertices.iter().filter_map(|&point| frame.screen(point)).collect();
        let nearest = seen.windows(2).map(|ends| distance_to(at, [ends[0], ends[1]])).fold(f64::INFINITY, f64::min);
        (nearest <= NEAR_FIBRE).then_some((id, nearest))
    });
    near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(id, _)| id)
}

/// The sheet under the pointer: where it ends, and in a drawing view anywhere on it.
pub(super) fn sheet_at(frame: &ViewFrame, at: Pos2, cx: &Context) -> Option<String> {
    let shown = DisplayedState::of(frame.kind, cx);
    let hidden = |id: &str| cx.active_body().is_some_and(|body| body.sheets.iter().any(|of| of.hidden && of.id == id));
    let sheets = shown.bodies.get(shown.active(cx)).into_iter().flat_map(|body| body.sheets.iter());
    let near = sheets.filter(|sheet| !hidden(&sheet.id)).filter_map(|sheet| {
        let seen: Option<Vec<Pos2>> = sheet.vertices.iter().map(|&point| frame.screen(point)).collect();
        let seen = seen?;
        let rims = sheet.rim.iter().flat_map(|rim| rim.windows(2));
        let to_rim = rims.map(|ends| distance_to(at, [seen[ends[0] as usize], seen[ends[1] as usize]]));
        let nearest = to_rim.fold(f64::INFINITY, f64::min);
        let on_it = || sheet.triangles.iter().any(|of| is_in(at, of.map(|k| seen[k as usize])));
        let is_met = nearest <= NEAR_FIBRE || (frame.kind != PaneKind::Result && on_it());
        is_met.then(|| (sheet.id.clone(), nearest))
    });
    near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(id, _)| id)
}

/// Whether a point lies in a triangle, whichever way that turns.
fn is_in(at: Pos2, [a, b, c]: [Pos2; 3]) -> bool {
    let side = |from: Pos2, to: Pos2| (to - from).rot90().dot(at - from);
    let sides = [side(a, b), side(b, c), side(c, a)];
    sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
}

/// Where a view shows the active fibre's vertices; none in the result unless it shows the same ones.
pub(super) fn vertex_marks(kind: PaneKind, cx: &Context) -> Vec<DVec3> {
    let vertices = cx.active_vertices();
    if kind != PaneKind::Result {
        return vertices;
    }
    let Some(id) = cx.selection.active() else { return Vec::new() };
    let course = courses(kind, cx).into_iter().find(|(known, _)| known == id).map(|(_, course)| course);
    course.filter(|course| course.len() == vertices.len()).unwrap_or_default()
}

/// The vertex under the pointer, while vertices are edited.
pub(super) fn vertex_at(frame: &ViewFrame, at: Pos2, cx: &Context) -> Option<usize> {
    cx.selection.vertices()?;
    let near = vertex_marks(frame.kind, cx).into_iter().enumerate().filter_map(|(k, point)| {
        let away = f64::from(frame.screen(point)?.distance(at));
        (away <= NEAR_VERTEX).then_some((k, away))
    });
    near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(k, _)| k)
}

/// Turn from the model frame to what a view shows.
pub(super) fn view_from_model(kind: PaneKind, cx: &Context) -> DMat3 {
    match (kind, cx.active_body()) {
        (PaneKind::Result, Some(body)) => DMat3::from_quat(body.placement.rotation.quaternion()),
        _ => DMat3::IDENTITY,
    }
}

/// Where a view shows the middle of what is selected, which lies at `pivot` in the model frame.
pub(super) fn seen_pivot(kind: PaneKind, pivot: DVec3, cx: &Context) -> DVec3 {
    if kind != PaneKind::Result {
        return pivot;
    }
    if cx.selection.is_body() {
        // It may have moved from where it starts.
        let bodies = &cx.simulation.published().snapshot.bodies;
        let now = bodies.get(cx.active.index).and_then(|body| Bounds::of(body.particles.iter().copied()));
        return now.map_or(pivot, |bounds| bounds.center());
    }
    let points: Vec<DVec3> = if let Some(id) = cx.selection.sheet() {
        let shown = DisplayedState::of(kind, cx);
        let sheets = shown.bodies.get(shown.active(cx)).into_iter().flat_map(|body| &body.sheets);
        sheets.filter(|sheet| sheet.id == *id).flat_map(|sheet| sheet.vertices.iter().copied()).collect()
    } else if let Some(chosen) = cx.selection.vertices() {
        let marks = vertex_marks(kind, cx);
        chosen.iter().filter_map(|&k| marks.get(k).copied()).collect()
    } else {
        let selected = courses(kind, cx).into_iter().filter(|(id, _)| cx.selection.contains(id));
        selected.flat_map(|(_, course)| course).collect()
    };
    if points.is_empty() {
        let placement = cx.active_body().map(|body| DVec3::from_array(body.placement.translation));
        return view_from_model(kind, cx) * pivot + placement.unwrap_or_default();
    }
    points.iter().sum::<DVec3>() / points.len() as f64
}

/// Distance of a point from a segment [points].
pub(super) fn distance_to(at: Pos2, [a, b]: [Pos2; 2]) -> f64 {
    let (along, offset) = (b - a, at - a);
    let share = (offset.dot(along) / along.length_sq().max(1e-12)).clamp(0.0, 1.0);
    f64::from((offset - share * along).length())
}
